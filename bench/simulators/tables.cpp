#include "simulators/tables.hpp"

#include <fmt/core.h>
#include <sundials/sundials_config.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/reduced_difference.hpp"
#include "record/json_text.hpp"

namespace vcrit::simulators {

namespace {

std::string failures(const SettingLine& line) {
  std::string text;
  for (const auto& [verdict, count] : line.failures)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", to_text(verdict), count);
  return text;
}

std::string factor(double value) {
  if (value == 0) return "-";
  return value < 100 ? fmt::format("{:.1f}x", value) : fmt::format("{:.0f}x", value);
}

/// "met" or "missed", or nothing to judge.
const char* verdict(bool met) { return met ? "met" : "MISSED"; }

// Seconds that one exact steady state may take, median over a problem's rows.
double time_goal(const std::string& problem) {
  if (problem == "P1") return 10e-6;
  return problem == "P2" ? 20e-6 : 40e-6;
}

std::string line_against(const std::string& name, const PeerComparison& found, double goal) {
  const double one_setting =
      found.one_setting ? found.one_setting->seconds / found.exact_median : 0;
  return fmt::format("{:<28} {:>4}  {:>10}  {:>8}  {:>8}  {:>8}  {:>7}  {:>11}  at least {}x {}\n",
                     name, found.races.size(), duration(found.exact_median),
                     fmt::format("{:.1e}", found.largest_error), factor(found.least),
                     factor(found.median), found.lost, factor(one_setting), goal,
                     verdict(found.largest_error <= 1e-13 &&
                             (found.lost == found.races.size() || found.least >= goal)));
}

std::string races_below(const PeerComparison& found, double limit) {
  std::string text;
  for (const Race& race : found.races)
    if (race.best && race.factor() < limit)
      text += fmt::format("  {:<28} {:>6} of {} {}: {} at {:.1e}, exact {} at {:.1e}\n",
                          race.row->name, factor(race.factor()), race.best->peer->name,
                          race.best->setting->name, duration(race.best->seconds), race.best->error,
                          duration(race.exact.seconds), race.exact.error);
  return text;
}

}  // namespace

std::string duration(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.1f} us", 1e6 * seconds);
  if (seconds < 1) return fmt::format("{:.2f} ms", 1e3 * seconds);
  return fmt::format("{:.2f} s", seconds);
}

std::string work_precision_table(const std::vector<SettingLine>& lines,
                                 const std::string& problem) {
  std::string text =
      fmt::format("{}\n{:<24} {:<12} {:>10}  {:>13}  {:>8}  {:>5}  {}\n", problem, "method",
                  "setting", "time", "largest error", "answered", "front", "went wrong");
  for (const SettingLine& line : lines) {
    const bool any = line.answered > 0;
    text += fmt::format("{:<24} {:<12} {:>10}  {:>13}  {:>8}  {:>5}  {}\n", line.peer->name,
                        line.setting->name, any ? duration(line.seconds) : "-",
                        any ? fmt::format("{:.1e}", line.error) : "-",
                        fmt::format("{}/{}", line.answered, line.rows),
                        line.failures.empty() ? (line.front ? "*" : "") : "out", failures(line));
  }
  return text + "\n";
}

std::string summary_table(const std::vector<Case>& cases, const std::vector<PeerSolve>& points) {
  std::string text = fmt::format("{:<28} {:>4}  {:>10}  {:>8}  {:>8}  {:>8}  {:>7}  {:>11}  {}\n",
                                 "exact against GSL and CVODE", "rows", "exact", "error", "least",
                                 "median", "no peer", "one setting", "goal for the least");
  std::string slower, chosen;
  const auto add = [&](const std::string& name, double error, double goal, const auto& taken) {
    const PeerComparison found = compare(points, error, taken);
    if (found.races.empty()) return;
    text += line_against(name, found, goal);
    slower += races_below(found, goal);
    if (found.one_setting)
      chosen += fmt::format("  {:<28} {} {}: {}, error {:.1e}\n", name,
                            found.one_setting->peer->name, found.one_setting->setting->name,
                            duration(found.one_setting->seconds), found.one_setting->error);
  };
  for (const std::string& problem : problems(cases))
    add(fmt::format("{}, peers at 1e-10", problem), 1e-10, 40,
        [&](const Case& row) { return row.problem == problem; });
  add("stiff P3, peers at 1e-6", 1e-6, 100, [](const Case& row) { return row.stiff; });
  text += "\nfastest one setting that is accurate enough on every row\n" +
          (chosen.empty() ? "  none\n" : chosen);
  text += "\nrows below a goal\n" + (slower.empty() ? "  none\n" : slower);
  text += "\none exact steady state, median over the rows\n";
  for (const std::string& problem : problems(cases)) {
    const PeerComparison found =
        compare(points, 0, [&](const Case& row) { return row.problem == problem; });
    text += fmt::format("  {}  {:>8}  goal {} {}\n", problem, duration(found.exact_median),
                        duration(time_goal(problem)),
                        verdict(found.exact_median <= time_goal(problem)));
  }
  return text + "\n";
}

std::string reduced_model_table() {
  const validation::ReducedTable table =
      validation::reduced_table(0.9, {0, 0.1, 0.3, 1, 2, 10, 100, 1000},
                                {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95});
  std::string text = "reduced model less full motion, D = 0.9/sqrt(1 + delta^2)\n  delta  v0/v*";
  for (const double ratio : table.ratios) text += fmt::format("{:>8}", ratio);
  for (std::size_t i = 0; i < table.deltas.size(); ++i) {
    text += fmt::format("\n  {:<12}", table.deltas[i]);
    for (const validation::ReducedAndFull& pair : table.rows[i])
      text += fmt::format("{:>8.4f}", std::round(1e4 * pair.difference()) / 1e4 + 0.0);
  }
  return text + "\n\n";
}

validation::Machine benchmark_machine() {
  validation::Machine machine = validation::this_machine();
  machine.versions.emplace_back("SUNDIALS", SUNDIALS_VERSION);
  machine.versions.emplace_back("flags", VCRIT_BUILD_FLAGS);
  return machine;
}

std::string machine_lines(const validation::Machine& machine) {
  std::string text = fmt::format("{}, {} cores, one used\n{}\nvcrit {}", machine.processor,
                                 machine.cores, machine.system, machine.program);
  for (const auto& [name, version] : machine.versions)
    text += fmt::format(", {} {}", name, version);
  return text + "\n";
}

std::string as_json(const std::vector<PeerSolve>& points, const validation::Machine& machine,
                    const Budget& budget) {
  nlohmann::ordered_json result{{"processor", machine.processor},
                                {"cores", machine.cores},
                                {"system", machine.system},
                                {"program", machine.program},
                                {"budget", budget.solve}};
  for (const auto& [name, version] : machine.versions) result["versions"][name] = version;
  result["points"] = nlohmann::ordered_json::array();
  for (const PeerSolve& point : points) {
    nlohmann::ordered_json entry{{"problem", point.row->problem},
                                 {"row", point.row->name},
                                 {"method", point.peer->name},
                                 {"setting", point.setting->name},
                                 {"outcome", to_text(point.verdict)}};
    if (point.answered) {
      entry["seconds"] = point.seconds;
      entry["friction_ratio"] = point.friction_ratio;
      entry["error"] = point.error;
    } else {
      entry["reason"] = point.words;
    }
    result["points"].push_back(std::move(entry));
  }
  return record::json_text(result, 1);
}

}  // namespace vcrit::simulators
