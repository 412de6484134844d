#include "scene/fitted_range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "scene/quantities.hpp"

namespace vcrit {

namespace {

// Of a frequency that was converted to another unit and back, and written in decimal digits.
constexpr double rounding = 1e-9;

// "20 kHz"; omega in rad/s.
std::string in_hertz(double omega) {
  constexpr std::array units{"Hz", "kHz", "MHz", "GHz"};
  const double frequency = omega / two_pi;
  const double thousands = std::floor(std::log10(frequency) / 3 + rounding);
  const auto step = static_cast<std::size_t>(std::clamp(thousands, 0.0, 3.0));
  return fmt::format("{:.4g} {}", frequency / std::pow(1000, static_cast<double>(step)),
                     units[step]);
}

std::string in_hertz(double from, double to) {
  return from == to ? in_hertz(from) : in_hertz(from) + " to " + in_hertz(to);
}

}  // namespace

std::optional<FittedRange> read_fitted_range(const document::Section& contact) {
  constexpr const char* key = "fitted_range";
  constexpr const char* expected = "two frequencies, the lower one first: [\"10 Hz\", \"100 kHz\"]";
  const toml::node* node = contact.find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* ends = node->as_array();
  if (ends == nullptr || ends->size() != 2)
    throw InputError(contact.place(key),
                     fmt::format("{} = {}", key, document::describe_node(*node)), expected);
  const auto end = [&](std::size_t i) {
    const toml::node& item = *ends->get(i);
    const auto value = number(item, Dimension::frequency, key, contact.place(item));
    if (!value) throw InputError(contact.place(item), document::describe_node(item), expected);
    return two_pi * checked(*value, frequency_range, key, contact.place(item));
  };
  const FittedRange range{end(0), end(1)};
  if (!(range.from <= range.to))
    throw InputError(contact.place(key), in_hertz(range.from) + " before " + in_hertz(range.to),
                     expected);
  return range;
}

std::optional<std::string> beyond_fitted_range(const std::optional<FittedRange>& fitted,
                                               const std::string& file, double from, double to) {
  if (!fitted) return std::nullopt;
  const auto [least, most] = *fitted;
  if (from >= least * (1 - rounding) && to <= most * (1 + rounding)) return std::nullopt;
  return fmt::format(
      "{}: the contact was fitted to data from {} and is asked for at {}: beyond the data its "
      "stiffness is a guess",
      file, in_hertz(least, most), in_hertz(from, to));
}

}  // namespace vcrit
