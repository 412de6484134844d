#include "options.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <algorithm>

#include "streams.hpp"

#include "base/errors.hpp"
#include "base/messages.hpp"
#include "base/numbers.hpp"
#include "base/rounded.hpp"
#include "base/trimmed.hpp"
#include "base/unit_advice.hpp"
#include "problem/variants.hpp"
#include "record/json_text.hpp"
#include "scene/settings.hpp"
#include "scene/stiffness_data.hpp"

namespace vcrit::app {

void SceneOptions::add_to(CLI::App& command) {
  command.add_option("SCENE", file, "scene file (TOML)")->required();
  // One value an option, so that a scene may follow.
  command
      .add_option("--set", settings,
                  "give or replace a value: k0=8e6, \"frequency=25 kHz\", k[3]=1e5")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

Settings SceneOptions::split_settings() const {
  Settings result;
  for (const std::string& text : settings) result.push_back(parse_setting(text));
  return result;
}

Problem SceneOptions::read(Frequency frequency) const {
  return read([frequency](const Problem&) { return frequency; });
}

Problem SceneOptions::read(const std::function<Frequency(const Problem&)>& frequency) const {
  const Problem problem = read_problem(file, split_settings());
  std::vector<std::string> warnings = problem->source->warnings;
  const std::optional<double>& omega = problem->angular_frequency.value;
  if (frequency(problem) == Frequency::varied && omega)
    if (const auto own = beyond_fitted_range(problem, *omega, *omega)) std::erase(warnings, *own);
  for (const std::string& warning : warnings) warn(warning);
  return warning_of(problem, std::move(warnings));
}

double ratio_of(const std::string& text, const char* option, const char* expected) {
  const bool percent = text.ends_with('%');
  const auto number = to_double(trimmed(text.substr(0, text.size() - (percent ? 1 : 0)), " "));
  if (!number) {
    const std::size_t comma = text.find(',');
    const std::string advice =
        advice_on_comma(text.substr(0, comma), text.substr(std::min(comma, text.size())));
    throw InputError({option}, fmt::format("\"{}\"", printable(text)), expected, advice);
  }
  return percent ? *number / 100 : *number;
}

double speed_ratio_of(const std::string& text) {
  return ratio_of(text, "--velocity-ratio", "a multiple of v*: 0.5 or 50%");
}

void add_digits(CLI::App& command, int& digits) {
  command
      .add_option("--digits", digits,
                  fmt::format("significant digits of the text, {} for all", all_digits))
      ->check(CLI::Range(1, all_digits))
      ->capture_default_str();
}

void print_row(const std::string& heading, const std::string& text) {
  constexpr int room = 20;  // of the headings
  if (!text.empty()) fmt::print("  {:<{}}{}\n", heading, room, text);
}

void print(const nlohmann::ordered_json& object) {
  fmt::print("{}\n", record::json_text(object, 2));
}

}  // namespace vcrit::app
