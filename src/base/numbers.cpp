#include "base/numbers.hpp"

#include <fmt/format.h>

#include <charconv>

namespace vcrit {

std::string to_text(double value) { return fmt::format("{}", value); }

std::optional<double> to_double(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace vcrit
