#include "report/answer_record.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "answers/effect_words.hpp"
#include "base/constants.hpp"
#include "report/onset_speeds.hpp"
#include "report/units.hpp"
#include "report/verdict.hpp"

namespace vcrit::validation::report {

namespace {

using record::Json;

constexpr int shown_digits = 4;

std::string in_few_digits(double value, const char* unit) {
  return quantity(value, unit, shown_digits);
}

Json key_number(const std::string& label, double value, const char* unit, const std::string& note) {
  return {{"label", label},
          {"words", unbroken(in_few_digits(value, unit))},
          {"exact", fmt::format("{}{}{}", value, *unit == 0 ? "" : " ", unit)},
          {"note", unbroken(note)}};
}

const ResonanceMark* nearest_resonance(const SceneReport& report) {
  const auto& marks = report.response.marks;
  const auto distance = [&](const ResonanceMark& mark) {
    return mark.resonance ? std::abs(std::log(mark.omega / (two_pi * frequency_of(report))))
                          : std::numeric_limits<double>::infinity();
  };
  const auto nearest =
      std::min_element(marks.begin(), marks.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return nearest == marks.end() || !nearest->resonance ? nullptr : &*nearest;
}

Json speed_key(const SceneReport& report) {
  const OnsetSpeeds onset = onset_speeds(report);
  std::string note = "no effect above it";
  if (onset.simulated) note = "by simulation";
  if (onset.contact == 0) note = "no effect at any speed";
  if (!std::isfinite(onset.contact)) note = "an effect at every speed";
  if (onset.creeps()) note = "with creep the drive runs at " + in_few_digits(onset.drive, "m/s");
  return key_number("Critical speed v*", onset.contact, "m/s", note);
}

Json closed_key(const Effect& effect) {
  return key_number(effect.below_indenter ? "Centre stays closed up to" : "Stays closed up to",
                    *effect.largest_closed_amplitude, "m",
                    "now " + in_few_digits(effect.amplitude, "m"));
}

void add_power(const SceneReport& report, Json& keys) {
  if (!report.cycle || !report.effect->mean_normal_force) return;
  const double force = report.cycle->friction_ratio * report.effect->friction_coefficient *
                       *report.effect->mean_normal_force;
  // v* + creep, half of which the cycle has, is no name for a number: the speed below it says all.
  const bool half = report.cycle->ratio == 0.5 && !onset_speeds(report).creeps();
  keys.push_back(key_number(half ? "Power at v*/2" : "Power", force * report.cycle->velocity, "W",
                            "lost at " + in_few_digits(report.cycle->velocity, "m/s")));
}

Json key_numbers(const SceneReport& report) {
  Json keys = Json::array();
  const bool outside = !report.reasons.empty();
  if (!outside) keys.push_back(speed_key(report));
  if (!outside && report.effect->lowest)
    keys.push_back(
        key_number("Lowest friction", *report.effect->lowest, "", "of the sliding value, at rest"));
  if (report.effect->largest_closed_amplitude) keys.push_back(closed_key(*report.effect));
  if (const ResonanceMark* mark = nearest_resonance(report))
    keys.push_back(key_number("Nearest resonance", mark->omega / two_pi, "Hz",
                              "now " + in_few_digits(frequency_of(report), "Hz")));
  if (!outside) add_power(report, keys);
  return keys;
}

std::string per_cent(double share) { return fmt::format("{:.2g}\u00a0%", std::abs(10 * share)); }

/// Of smaller ones the digits say nothing to a reader.
constexpr double least_per_cent = 0.001;

std::string change_words(double share) {
  if (std::abs(10 * share) < least_per_cent) return fmt::format("<\u00a0{}\u00a0%", least_per_cent);
  return (share < 0 ? "−" : "+") + per_cent(share);
}

/// Signs with the words before each: "10 % in mu0 or du_z", "k0, k1 and m".
Json signs_of(const std::vector<const Influence*>& numbers, const std::string& begin,
              const std::string& between, const std::string& last) {
  Json signs = Json::array();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    signs.push_back({{"before", i == 0                   ? begin
                                : i + 1 < numbers.size() ? between
                                                         : last},
                     {"sign", record::page_of(record::Markup{numbers[i]->sign.mathml})}});
  return signs;
}

/// "10 % in mu0 or du_z is 10 % in v*; 10 % in m, k0 and k1 together at most 1.6 %."
Json inputs_record(const SceneReport& report) {
  constexpr std::size_t most = 6;
  const std::string tenth = "10\u00a0% in ";
  std::vector<const Influence*> alike, others;
  double sum = 0;
  for (const Influence& it : report.influences) {
    if (it.meaning == "angular frequency") continue;
    const bool one = std::abs(it.share - 1) < 1e-6;
    (one ? alike : others).push_back(&it);
    if (!one) sum += std::abs(it.share);
  }
  if (alike.empty() && others.empty()) return {};
  std::string at_most, begin = (alike.empty() ? "" : "; ") + tenth;
  if (!others.empty())
    at_most = fmt::format("{} at most {}", others.size() > 1 ? " together" : "", per_cent(sum));
  if (others.size() > most) {
    at_most =
        fmt::format("{}all {} other numbers but the frequency{}", begin, others.size(), at_most);
    others.clear();
  }
  return {{"alike", signs_of(alike, tenth, " or ", " or ")},
          {"others", signs_of(others, begin, ", ", " and ")},
          {"at_most", at_most}};
}

/// What the rows leave out; nothing where that is nothing.
Json left_out_words(std::size_t count) {
  if (count == 0) return {};
  if (count == 1) return "One number of smaller influence is";
  return fmt::format("{} numbers of smaller influence are", count);
}

/// Bars from the middle, the longest to the edge.
Json influence_rows(const SceneReport& report) {
  Json rows = Json::array();
  double largest = 0;
  for (const Influence& it : report.influences) largest = std::max(largest, std::abs(it.share));
  for (const Influence& it : report.influences) {
    const double half = 50 * std::abs(it.share) / largest;
    rows.push_back({{"sign", record::page_of(record::Markup{it.sign.mathml})},
                    {"meaning", it.array ? "all entries" : it.meaning},
                    {"left", it.share < 0 ? 50 - half : 50},
                    {"length", half},
                    {"down", it.share < 0},
                    {"percent", change_words(it.share)},
                    {"share", it.share}});
  }
  return rows;
}

}  // namespace

double frequency_of(const SceneReport& report) {
  return report.problem.value(report.problem->angular_frequency) / two_pi;
}

std::optional<double> closed_up_to(const SceneReport& report) {
  return report.effect ? report.effect->largest_closed_amplitude : std::nullopt;
}

record::Json answer_record(const SceneReport& report) {
  Json rows = influence_rows(report);
  constexpr std::size_t most = 12;
  const std::size_t left_out = rows.size() > most ? rows.size() - most : 0;
  rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(rows.size() - left_out), rows.end());
  return {{"operating", unbroken(operating_point(*report.effect))},
          {"keys", key_numbers(report)},
          {"inputs", inputs_record(report)},
          {"influences", rows},
          {"left_out", left_out_words(left_out)}};
}

}  // namespace vcrit::validation::report
