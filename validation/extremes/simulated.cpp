#include "extremes/simulated.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/resonance.hpp"
#include "critical/conditioning.hpp"
#include "extremes/comparing.hpp"

namespace vcrit::validation::extremes {

namespace {

// The speeds asked for are a relative 1e-6 beside v*; a tenth of it may be rounding.
constexpr double largest_rounding = 1e-7;
constexpr double most_swings = 1e4;

struct Asking {
  const accuracy::Cells& cells;
  const Known& known;
  accuracy::Resonances resonances;
  Simulated result;

  void mark(std::size_t i, const std::string& words) {
    const bool map = !cells.omega.empty();
    result.marks.push_back({map ? cells.omega_of(i) : 0, map ? cells.factor_of(i) : 0, words});
  }

  /// Why the simulator is not asked; empty if it is.
  std::string why_not(std::size_t i, double omega) const {
    if (!std::isnormal(known.right[i])) return "v* is no normal double";
    if (!(formula_tolerance(known.condition[i]) < largest_rounding))
      return "too near to resonance for 10⁻⁶ of v*";
    if (resonances.above(accuracy::ResonanceKind::antiresonance, cells.values[i],
                         most_swings * omega))
      return "the stuck body swings over 10,000 times in a period";
    return {};
  }

  void take(std::size_t i, const accuracy::SimulatedCell& cell) {
    ++result.asked;
    result.digits[i] = accuracy::digits_lost(cell.threshold, known.right[i]);
    if (cell.wrong.empty()) {
      ++result.right;
      return;
    }
    const bool silent = cell.wrong.starts_with("no answer");
    ++(silent ? result.silent : result.wrong);
    result.worst.push_back(
        {cell.wrong, known.inputs[i], cell.threshold, known.right[i], silent ? 0.0 : 1.0});
    mark(i, cell.wrong);
  }
};

}  // namespace

Simulated simulate(const Problem& problem, const accuracy::Cells& cells, const Known& known,
                   const std::vector<std::size_t>& which, const Ask& ask) {
  Asking asking{cells, known, accuracy::Resonances(problem), {}};
  asking.result.digits.assign(cells.values.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<bool> wanted(cells.values.size(), false);
  for (const std::size_t i : which) wanted.at(i) = true;
  cells.for_each(problem, [&](const Problem& each, std::size_t i) {
    if (!wanted[i]) return;
    const std::string reason = asking.why_not(i, each->angular_frequency.value.value());
    if (reason.empty()) {
      asking.take(i, ask(each, known.right[i]));
    } else {
      ++asking.result.left_out;
      asking.mark(i, "not asked: " + reason);
    }
  });
  keep_worst(asking.result.worst);
  return asking.result;
}

Comparison stick_found(const Simulated& simulated, const std::string& where) {
  const std::string detail = simulated.wrong == 0 ? ""
                                                  : simulated.worst.front().words + " at " +
                                                        simulated.worst.front().inputs;
  return at_most({"simulation", where + ": simulator sticks below v* and slides above",
                  "v* correctly rounded, times 1 ∓ 10⁻⁶",
                  "the number of wrong answers, of which there may be none"},
                 static_cast<double>(simulated.wrong), 0, detail);
}

}  // namespace vcrit::validation::extremes
