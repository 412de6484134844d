#include "base/numbers.hpp"

#include <fmt/core.h>

#include <charconv>

namespace vcrit {

std::string to_text(double value) { return fmt::format("{}", value); }

LeadingNumber leading_number(std::string_view text) {
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  if (text.substr(sign).starts_with('-') && sign == 1) return {};
  double value = 0;
  const char* begin = text.data() + sign;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (end == begin) return {};
  const auto length = static_cast<std::size_t>(end - text.data());
  return {error == std::errc{} ? std::optional(value) : std::nullopt, length};
}

std::optional<double> to_double(std::string_view text) {
  const LeadingNumber number = leading_number(text);
  return number.length == text.size() ? number.value : std::nullopt;
}

}  // namespace vcrit
