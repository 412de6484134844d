#include "accuracy/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "accuracy/resonance.hpp"

namespace vcrit::validation::accuracy {

namespace {

/// Own transformations, as the standard leaves those of its distributions open.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Even in [0, 1).
  double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double in_decade_around(double value) {
    const double moved = value * std::pow(10, share() - 0.5);
    return std::isinf(moved) || moved == 0 ? value : moved;
  }
  /// 1e-2 to 1e-12, of either sign.
  double offset() {
    const double size = std::pow(10, -2 - 10 * share());
    return share() < 0.5 ? -size : size;
  }

 private:
  std::mt19937_64 engine_;
};

std::size_t index_of(const std::vector<Symbol>& symbols, const Symbol& symbol) {
  return static_cast<std::size_t>(std::find(symbols.begin(), symbols.end(), symbol) -
                                  symbols.begin());
}

/// Moves omega to the balance, if there is one; whether it did.
bool move(double& omega, ResonanceKind balance, const Resonances& resonances, const Values& values,
          double offset) {
  const auto place = resonances.find(balance, values);
  if (place) omega = *place * (1 + offset);
  return place.has_value();
}

}  // namespace

Inputs draw_inputs(const Problem& problem, const std::vector<Symbol>& symbols, std::size_t size,
                   std::uint64_t seed) {
  Inputs inputs{seed, symbols, {}};
  Random random(seed);
  const Resonances resonances(problem);
  const Values& base = problem.values();
  const std::size_t omega = index_of(symbols, problem->angular_frequency.symbol);
  ensure(omega < symbols.size(), "v* depends on omega");
  for (std::size_t i = 0; i < size; ++i) {
    Values values = base;
    for (const Symbol& symbol : symbols) values[symbol] = random.in_decade_around(base.at(symbol));
    const double offset = random.offset();
    double& own = values[problem->angular_frequency.symbol];
    if (const Receptance* measured = problem->receptance())
      own = std::clamp(own, measured->rows.front().omega, measured->rows.back().omega);
    if (i % 4 == 0)
      inputs.near_resonance += move(own, ResonanceKind::resonance, resonances, values, offset);
    if (i % 4 == 1)
      inputs.near_antiresonance +=
          move(own, ResonanceKind::antiresonance, resonances, values, offset);
    std::vector<double>& set = inputs.sets.emplace_back();
    for (const Symbol& symbol : symbols) set.push_back(values.at(symbol));
  }
  return inputs;
}

}  // namespace vcrit::validation::accuracy
