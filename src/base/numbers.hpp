// Numbers as text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vcrit {

/// The shortest decimal that reads back to the same double; "inf", "-inf", "nan".
std::string to_text(double value);

/// The whole of `text` as a double, independent of the locale.
std::optional<double> to_double(std::string_view text);

}  // namespace vcrit
