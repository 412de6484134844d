#include "sweep/axis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "base/identifiers.hpp"
#include "base/numbers.hpp"

namespace vcrit {

namespace {

constexpr const char* form = "NAME=lin|log:FROM:TO:N, such as velocity_ratio=lin:0.1:1:10";

// A table that long fills any disk.
constexpr std::size_t most_values = 1'000'000'000;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

Dimension dimension_of(const std::string& name, const Scene& scene, const Place& place) {
  std::map<std::string, Dimension> known = scene.settable;
  known.emplace("velocity", Dimension::velocity);
  known.emplace("velocity_ratio", Dimension::none);
  if (const auto found = known.find(name); found != known.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known_name, dimension] : known) names.push_back(known_name);
  const auto meant = nearest(name, names);
  throw InputError(
      place, fmt::format("\"{}\", which this scene does not have", name),
      meant ? fmt::format("\"{}\"", *meant) : fmt::format("one of {}", fmt::join(names, ", ")));
}

std::size_t count(const std::string& text, const Place& place) {
  std::size_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size() || n == 0 || n > most_values)
    throw InputError(place, fmt::format("{} values", text.empty() ? "no number of" : text),
                     fmt::format("a whole number from 1 to {}", most_values));
  return n;
}

// The ends as given; between them 15 digits, so that round numbers come out round.
std::vector<double> spaced(bool logarithmic, double from, double to, std::size_t n) {
  const double a = logarithmic ? std::log10(from) : from, b = logarithmic ? std::log10(to) : to;
  std::vector<double> values{from};
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n - 1);
    const double value = a * (1 - share) + b * share;
    values.push_back(*to_double(fmt::format("{:.15g}", logarithmic ? std::pow(10, value) : value)));
  }
  if (n > 1) values.push_back(to);
  return values;
}

}  // namespace

Axis parse_axis(const std::string& text, const Scene& scene) {
  const Place whole{fmt::format("--over {}", text)};
  const auto equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const auto parts = split(equals == text.npos ? "" : text.substr(equals + 1), ':');
  if (equals == text.npos || parts.size() != 4 || (parts[0] != "lin" && parts[0] != "log"))
    throw InputError(whole, fmt::format("\"{}\"", text), form);
  const Place place{fmt::format("--over {}", name)};
  const Dimension dimension = dimension_of(name, scene, place);
  const double from = parse_quantity(parts[1], dimension, place);
  const double to = parse_quantity(parts[2], dimension, place);
  const bool logarithmic = parts[0] == "log";
  if (logarithmic && !(from > 0 && to > 0))
    throw InputError(place, fmt::format("log from {} to {}", from, to), "both ends above 0");
  return {name, spaced(logarithmic, from, to, count(parts[3], place))};
}

}  // namespace vcrit
