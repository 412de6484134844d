#include "extremes/examine.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "compare/evaluators.hpp"
#include "critical/conditioning.hpp"
#include "critical/critical_velocity.hpp"
#include "derivation/derivation.hpp"
#include "extremes/comparing.hpp"
#include "extremes/limits.hpp"
#include "run/driver.hpp"

namespace vcrit::validation::extremes {

using accuracy::Cells;

namespace {

// Near resonance the multiplied-out formula loses twice the digits of the distance, and over 60
// decades of stiffness twice these.
constexpr long derived_digits = 200;
// Of each region, about so many cells for the derived formula.
constexpr std::size_t derived_cells = 32;

Claimed by_library(const Problem& problem, const Cells& cells) {
  Claimed claimed{"library", {}, {}};
  cells.for_each(problem, [&](const Problem& each, std::size_t) {
    claimed.values.push_back(critical_velocity(each));
  });
  return claimed;
}

std::vector<std::vector<double>> sets_of(const Cells& cells, const std::vector<Symbol>& symbols) {
  std::vector<std::vector<double>> sets;
  for (const Values& values : cells.values) {
    std::vector<double>& set = sets.emplace_back();
    for (const Symbol& symbol : symbols) set.push_back(values.at(symbol));
  }
  return sets;
}

/// The generated library promises the same of its single and batch calls.
std::vector<Claimed> by_driver(const Driver& driver, const Cells& cells) {
  const auto sets = sets_of(cells, driver.symbols());
  const std::vector<double> accurate = driver.bounds(sets, "certified");
  const std::vector<double> fast = driver.bounds(sets, "fast");
  std::vector<Claimed> all;
  for (const WayAnswers& answers :
       driver.run(sets, {"fast", "fast_batch", "accurate", "accurate_batch", "certified"}))
    all.push_back(
        {answers.way.key, answers.values, answers.way.key.starts_with("fast") ? fast : accurate});
  return all;
}

std::string inputs_of(const Problem& problem, const Values& values) {
  std::string text = fmt::format("omega = {:a}", values.at(problem->angular_frequency.symbol));
  for (const auto& [symbol, value] : values)
    if (symbol != problem->angular_frequency.symbol && symbol != pressing(problem).symbol)
      text += fmt::format(", {} = {:a}", to_text(symbol), value);
  return text;
}

Known known_of(const Problem& problem, const Cells& cells) {
  Known known{cells.right, {}, {}};
  for (const Values& values : cells.values) {
    known.condition.push_back(condition_number(problem, values));
    known.inputs.push_back(inputs_of(problem, values));
  }
  return known;
}

/// Both are rounded once.
Comparison by_algebra(const symbolic::Derivation& derivation, const Cells& cells,
                      const Known& known, const std::string& where) {
  const Words words{"derived",
                    fmt::format("{}: the derived formula in {} digits", where, derived_digits),
                    "v* correctly rounded", "both are rounded once"};
  std::vector<Comparison> all;
  const std::size_t step = std::max<std::size_t>(1, cells.values.size() / derived_cells);
  for (std::size_t i = 0; i < cells.values.size(); i += step) {
    if (!std::isnormal(cells.right[i])) continue;
    const double found = derived_velocity(derivation, cells.values[i], derived_digits);
    all.push_back(relative(words, cells.right[i], found, 2 * 0x1p-53, known.inputs[i]));
  }
  return worst(words, all);
}

/// Every so many columns and rows of a map, all cells elsewhere.
std::vector<std::size_t> asked_cells(const CellsOf& made, std::size_t every) {
  std::vector<std::size_t> which;
  const std::size_t columns = made.cells.omega.size();
  for (std::size_t i = 0; i < made.cells.values.size(); ++i) {
    const bool on_map = columns > 0;
    if (!on_map || (i % columns % every == every / 2 && i / columns % every == every / 2))
      which.push_back(i);
  }
  return which;
}

Region examined(const Family& family, const symbolic::Derivation& derivation,
                const Subjects& subjects, const CellsOf& made, const Fineness& fineness) {
  const Problem& problem = derivation.problem;
  const std::string where = fmt::format("{}, {}", family.title, made.region);
  const Known known = known_of(problem, made.cells);
  Region region{made.region, made.cells.omega, made.cells.factor, known.condition, {}, {}, {}};
  if (!made.distances.empty()) region.x = made.distances;
  std::vector<double> best = made.cells.right;
  for (const Claimed& claimed : subjects.evaluate(made.cells)) {
    region.tallies.push_back(tally(claimed, known));
    if (!claimed.bounds.empty())
      region.comparisons.push_back(bounds_hold(region.tallies.back(), where));
    if (claimed.way == "accurate") best = claimed.values;
  }
  if (!subjects.generated)
    region.comparisons.push_back(
        not_compared({"accurate", where + ": generated evaluators", {}, {}},
                     "there is no C++ compiler on the PATH"));
  region.comparisons.push_back(by_algebra(derivation, made.cells, known, where));
  if (!made.approach.empty()) {
    const auto limits = compare_limits(family, derivation, made, best,
                                       subjects.generated ? way_name("accurate") : "v*");
    region.comparisons.insert(region.comparisons.end(), limits.begin(), limits.end());
    return region;
  }
  region.simulated = simulate(problem, made.cells, known,
                              asked_cells(made, fineness.simulated_every), subjects.ask);
  region.comparisons.push_back(stick_found(*region.simulated, where));
  return region;
}

}  // namespace

Subjects subjects_of(const symbolic::Derivation& derivation,
                     const std::optional<std::filesystem::path>& compiler) {
  std::shared_ptr<const Driver> driver;
  if (compiler) driver = std::make_shared<Driver>(derivation, *compiler);
  const Evaluate evaluate = [derivation, driver](const Cells& cells) {
    std::vector<Claimed> all{by_library(derivation.problem, cells)};
    if (driver == nullptr) return all;
    const std::vector<Claimed> generated = by_driver(*driver, cells);
    all.insert(all.end(), generated.begin(), generated.end());
    return all;
  };
  return {evaluate, accuracy::simulated_cell, driver != nullptr};
}

FamilyResult examine(const Family& family, const symbolic::Derivation& derivation,
                     const Subjects& subjects, const Fineness& fineness, const Progress& progress) {
  FamilyResult result{family.key, family.title, {}};
  progress("v* correctly rounded");
  for (const CellsOf& made : all_cells(family, derivation.problem, fineness)) {
    progress(made.region);
    result.regions.push_back(examined(family, derivation, subjects, made, fineness));
  }
  return result;
}

}  // namespace vcrit::validation::extremes
