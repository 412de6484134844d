// Columns of values that somebody hands to a batch.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace vcrit {

/// Throws InputError unless there is one column for each name, of so many `values` or of one for
/// all.
void check_columns(const std::vector<std::string>& names,
                   std::span<const std::span<const double>> columns, std::size_t values);

}  // namespace vcrit
