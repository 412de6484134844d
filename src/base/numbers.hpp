// Numbers as text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace vcrit {

/// The shortest decimal that reads back to the same double; "inf", "-inf", "nan".
std::string to_text(double value);

/// A number at the beginning of a text, as long as it goes.
struct LeadingNumber {
  std::optional<double> value;  ///< nothing beyond the range of doubles, on either side
  std::size_t length = 0;       ///< characters that it takes; 0 where there is no number
};
LeadingNumber leading_number(std::string_view text);

/// The whole of `text` as a double, independent of the locale.
std::optional<double> to_double(std::string_view text);

}  // namespace vcrit
