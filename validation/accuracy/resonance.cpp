#include "accuracy/resonance.hpp"

#include <cmath>

#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit::validation::accuracy {

Resonances::Resonances(const Problem& problem) : problem_(problem) {
  if (!problem->mass || problem->drive_network() == nullptr) return;
  drive_ = *problem->drive_network();
  tangential_ = tangential_network(problem);
}

double Resonances::excess(ResonanceKind balance, const Values& values, double omega) const {
  double stiffness = dynamic_stiffness(drive_->reduction(), values, omega).real();
  if (balance == ResonanceKind::antiresonance)
    stiffness += tangential_->factor *
                 dynamic_stiffness(tangential_->network.reduction(), values, omega).real();
  return stiffness - values.at(problem_->mass->symbol) * omega * omega;
}

std::optional<double> Resonances::find(ResonanceKind balance, const Values& values) const {
  if (!exist()) return std::nullopt;
  const double omega = values.at(problem_->angular_frequency.symbol);
  double low = 1e-9 * omega, high = 1e9 * omega;
  if (!(excess(balance, values, low) > 0) || !(excess(balance, values, high) < 0))
    return std::nullopt;
  // 18 decades are 2^60 times a rounding error of the first decade.
  for (int i = 0; i < 64; ++i) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    (excess(balance, values, middle) > 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace vcrit::validation::accuracy
