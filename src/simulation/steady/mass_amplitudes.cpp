#include "simulation/steady/mass_amplitudes.hpp"

#include <cmath>
#include <complex>
#include <optional>

#include "base/constants.hpp"
#include "simulation/steady/near_resonance.hpp"
#include "simulation/steady/quadrature.hpp"
#include "simulation/steady/steady_cycle.hpp"
#include "stiffness/dynamic_matrix.hpp"

namespace vcrit::simulation {

namespace {

// F is about F_1 cos(t + .), in the model's units: (1/pi) times the integral of F e^{-it} over a
// period. Nothing where a piece of motion is too long to be followed.
std::optional<double> first_harmonic_of_cycle(const Model& model, double velocity) {
  const SteadyCycle cycle = steady_cycle(model, velocity, sliding_start(model, velocity));
  const Quadrature stick(model.stick.modes.spectrum), slip(model.slip.modes.spectrum);
  std::complex<double> sum;
  for (const Trace::Part& part : cycle.period.parts) {
    const Quadrature& rule = part.piece.stuck() ? stick : slip;
    if (!rule.can_follow(part.duration)) return std::nullopt;
    rule.over(part.duration, [&](double time, double weight) {
      const State state = part.piece.after(time);
      sum += weight * (model.load + state.x[0]) * std::conj(state.at.turn);
    });
  }
  return std::abs(sum) / pi;
}

std::optional<double> first_harmonic(const Model& model, double velocity) {
  if (model.slides(velocity)) return model.amplitude;
  if (model.never_slips(velocity)) return 0;
  return first_harmonic_of_cycle(model, velocity);
}

}  // namespace

std::vector<MassAmplitude> mass_amplitudes(const System& system, double velocity) {
  require_forward(velocity);
  if (!system.masses) return {};
  const Model model(system);
  if (lost_in_resonance(model)) return {};
  const auto force = first_harmonic(model, model.motion_velocity(velocity / model.velocity_unit));
  if (!force) return {};
  const DriveStructure& structure = system.masses->structure;
  const auto answers = displacements(structure, {0, system.omega});
  std::vector<MassAmplitude> result;
  for (const NamedMass& mass : structure.named)
    result.push_back({mass.symbol, *force * model.force_unit *
                                       static_cast<double>(std::abs(answers[mass.place]))});
  return result;
}

}  // namespace vcrit::simulation
