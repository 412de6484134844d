#include "sweep/axis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/numbers.hpp"
#include "base/trimmed.hpp"
#include "problem/variation.hpp"
#include "scene/settings.hpp"

namespace vcrit {

namespace {

constexpr const char* axis_form =
    "NAME=lin|log:FROM:TO:N, such as velocity_ratio=lin:0.1:1:10, or NAME=list:FILE";

constexpr std::string_view of_list = "list:";

// They are kept in memory; more points come from more axes.
constexpr std::size_t most_values = 10'000'000;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  for (std::string& part : parts) part = trimmed(part, " ");
  return parts;
}

Dimension dimension_of(const std::string& name, const Problem& problem, const Place& place) {
  refuse_expression(*problem->source, name, place);
  std::map<std::string, Dimension> known = problem->source->settable;
  known.emplace("velocity", Dimension::velocity);
  known.emplace("velocity_ratio", Dimension::none);
  return known_dimension(name, known, place, problem->source->named);
}

/// "lin", "log", or what else begins like one of them: "linear", "Log", "logspace".
std::string spacing_of(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* spacing : {"lin", "log"})
    if (word.starts_with(spacing)) return spacing;
  return "";
}

/// An axis that lacks its lin or log, or writes it out, or that lacks the number of its values.
std::string meant_axis(const std::string& name, std::vector<std::string> parts) {
  if (parts.size() == 3 && !spacing_of(parts[0]).empty())
    return fmt::format("say how many values: \"{}={}:{}:{}:11\"", name, spacing_of(parts[0]),
                       parts[1], parts[2]);
  if (parts.size() == 3 && spacing_of(parts[0]).empty()) parts.insert(parts.begin(), "lin");
  if (parts.size() != 4 || spacing_of(parts[0]).empty()) return "";
  return fmt::format("did you mean \"{}={}:{}:{}:{}\"?", name, spacing_of(parts[0]), parts[1],
                     parts[2], parts[3]);
}

std::size_t count(const std::string& text, const Place& place) {
  std::size_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size() || n == 0 || n > most_values)
    throw InputError(place, fmt::format("{} values", text.empty() ? "no number of" : text),
                     fmt::format("a whole number from 1 to {}", most_values));
  return n;
}

// The ends as given; between them 15 digits, so that round numbers come out round, but never beyond
// the ends (nor, there, beyond the largest double).
std::vector<double> spaced(bool logarithmic, double from, double to, std::size_t n) {
  const double a = logarithmic ? std::log10(from) : from, b = logarithmic ? std::log10(to) : to;
  std::vector<double> values{from};
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n - 1);
    const double value = a * (1 - share) + b * share;
    const double exact = logarithmic ? std::pow(10, value) : value;
    const double round = to_double(fmt::format("{:.15g}", exact)).value_or(exact);
    values.push_back(std::clamp(round, std::min(from, to), std::max(from, to)));
  }
  if (n > 1) values.push_back(to);
  return values;
}

}  // namespace

std::vector<double> parse_list(const std::string& text, const std::string& file,
                               Dimension dimension) {
  CsvLines lines(text, file);
  std::vector<double> values;
  while (lines.next()) {
    const std::string& entry = lines.line();
    const std::string_view value =
        trimmed(std::string_view(entry).substr(0, entry.find('#')), " \t\r");
    if (value.empty()) continue;
    values.push_back(parse_quantity(value, dimension, lines.place()));
    if (values.size() > most_values)
      throw InputError(lines.place(), "too many values", fmt::format("at most {}", most_values));
  }
  if (values.empty()) throw InputError({file}, "no values", "at least one");
  return values;
}

std::optional<std::string> list_file(const std::string& axis) {
  const std::string range(trimmed(axis.substr(axis.find('=') + 1), " "));
  if (!range.starts_with(of_list)) return std::nullopt;
  return range.substr(of_list.size());
}

Axis parse_axis(const std::string& text, const Problem& problem) {
  const Place whole = argument("over " + text);
  const auto equals = text.find('=');
  if (equals == text.npos) throw InputError(whole, fmt::format("\"{}\"", text), axis_form);
  const std::string name(trimmed(text.substr(0, equals), " ")),
      range(trimmed(text.substr(equals + 1), " "));
  const Place place = argument("over " + name);
  if (const auto file = list_file(text)) {
    const Dimension dimension = dimension_of(name, problem, place);
    return {name, parse_list(read_file(*file), *file, dimension), dimension};
  }
  const auto parts = split(range, ':');
  if (parts.size() != 4 || (parts[0] != "lin" && parts[0] != "log"))
    throw InputError(whole, fmt::format("\"{}\"", text), axis_form, meant_axis(name, parts));
  const Dimension dimension = dimension_of(name, problem, place);
  const double from = parse_quantity(parts[1], dimension, place);
  const double to = parse_quantity(parts[2], dimension, place);
  const bool logarithmic = parts[0] == "log";
  if (logarithmic && !(from > 0 && to > 0))
    throw InputError(place, fmt::format("log from {} to {}", from, to), "both ends above 0");
  return {name, spaced(logarithmic, from, to, count(parts[3], place)), dimension};
}

Axis axis_of(const std::string& name, std::vector<double> values, const Problem& problem) {
  const Place place = argument("over " + name);
  if (values.empty() || values.size() > most_values)
    throw InputError(place, fmt::format("{} values", values.size()),
                     fmt::format("from 1 to {}", most_values));
  return {name, std::move(values), dimension_of(name, problem, place)};
}

Problem completed(Problem problem, const std::vector<Axis>& axes) {
  for (const Axis& axis : axes) {
    if (!problem->source->settable.contains(axis.name) || axis.values.empty()) continue;
    const Variation varied(problem, {axis.name});
    const Variation::Target& target = varied.targets().front();
    if (target.is_left_out || problem.known_values().contains(target.symbol)) continue;
    const auto above = std::find_if(axis.values.begin(), axis.values.end(),
                                    [](double value) { return value > 0 && std::isfinite(value); });
    const bool any = target.is_poisson || above == axis.values.end();
    const double value = any ? axis.values.front() : *above;
    problem = varied.at({&value, 1});
  }
  return problem;
}

}  // namespace vcrit
