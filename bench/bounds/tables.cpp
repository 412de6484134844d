#include "bounds/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "record/json_text.hpp"

namespace vcrit::bounds {

namespace {

using Row = bench::TextRow;

/// Rounded down, so that 100 % means all.
std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "-";
  if (part == whole) return "100 %";
  return fmt::format(
      "{:.3f} %", std::floor(1e5 * static_cast<double>(part) / static_cast<double>(whole)) / 1e3);
}

std::string number_text(double x) {
  return x < 1000 ? fmt::format("{:.6f}", x) : fmt::format("{:.1e}", x);
}

Row head(const std::string& first) {
  return {first,       "cases",       "0/0",        "v* a double",      "certified",
          "worst ulp", "error/bound", "fast bound", "fast error/bound", "violations"};
}

std::string violations(const TrialTally& tally) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < violation_kinds; ++i)
    if (tally.violations[i] > 0)
      parts.push_back(fmt::format("{} {}", tally.violations[i], name_of(Violation(i))));
  return parts.empty() ? "0" : fmt::format("{}", fmt::join(parts, ", "));
}

Row row(const std::string& name, const TrialTally& tally) {
  return {name,
          std::to_string(tally.cases),
          std::to_string(tally.undefined),
          percent(tally.doubles, tally.cases),
          percent(tally.certified, tally.doubles),
          number_text(tally.ulps),
          number_text(tally.ratio),
          percent(tally.fast_bounded, tally.doubles),
          number_text(tally.fast_ratio),
          violations(tally)};
}

/// All systems together, by the kind of draw.
Tallies by_draw(const std::vector<SystemResult>& results) {
  Tallies all;
  for (const SystemResult& result : results)
    for (const auto& [draw, tally] : result.tallies) all[draw] += tally;
  return all;
}

nlohmann::ordered_json tally_json(const TrialTally& tally) {
  nlohmann::ordered_json out{{"cases", tally.cases},
                             {"undefined", tally.undefined},
                             {"doubles", tally.doubles},
                             {"certified", tally.certified},
                             {"bounded", tally.bounded},
                             {"fast_bounded", tally.fast_bounded},
                             {"worst_certified_ulp", tally.ulps},
                             {"worst_error_over_bound", tally.ratio},
                             {"worst_fast_error_over_bound", tally.fast_ratio}};
  for (std::size_t i = 0; i < violation_kinds; ++i) {
    const std::string name(name_of(Violation(i)));
    out["violations"][name] = tally.violations[i];
    if (tally.firsts[i]) out["first_violations"][name] = tally.firsts[i]->text;
  }
  return out;
}

}  // namespace

std::string tables(const std::vector<SystemResult>& results, bench::TableStyle style) {
  std::vector<Row> systems{head("system")}, draws{head("values")};
  for (const SystemResult& result : results)
    systems.push_back(row(result.system, sum_of(result.tallies)));
  for (const auto& [draw, tally] : by_draw(results))
    draws.push_back(row(std::string(name_of(draw)), tally));
  return bench::text_table(systems, style) + "\n" + bench::text_table(draws, style);
}

std::string as_json(const std::vector<SystemResult>& results, const TrialOptions& options) {
  nlohmann::ordered_json out{{"cases", options.cases}, {"seed", options.seed}};
  for (const SystemResult& result : results) {
    nlohmann::ordered_json& system = out["systems"][result.system];
    system["all"] = tally_json(sum_of(result.tallies));
    for (const auto& [draw, tally] : result.tallies)
      system["draws"][std::string(name_of(draw))] = tally_json(tally);
  }
  return record::json_text(out, 1);
}

std::string first_violations(const std::vector<SystemResult>& results) {
  std::string out;
  for (const SystemResult& result : results)
    for (const auto& first : sum_of(result.tallies).firsts)
      if (first) out += first->text + "\n";
  return out;
}

}  // namespace vcrit::bounds
