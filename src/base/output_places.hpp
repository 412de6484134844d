// Where results may be written.
#pragma once

#include <filesystem>
#include <vector>

namespace vcrit {

/// Throws InputError for the place of a folder, a device, a pipe or a socket, which a file renamed
/// there would fail to replace, or would put an end to.
void check_place(const std::filesystem::path& place);

/// Throws InputError where a file of results would take the place of one of those that were `read`
/// for them.
void refuse_input_as_output(const std::filesystem::path& place,
                            const std::vector<std::filesystem::path>& read);

}  // namespace vcrit
