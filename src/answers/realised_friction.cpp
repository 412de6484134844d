#include "answers/realised_friction.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>

#include "realisation/realisation.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/system/measured_drive.hpp"

namespace vcrit {

namespace {

using realisation::Complex;
using realisation::Realisation;
using realisation::Structure;

constexpr int harmonics = 8;
// Modes that change R_d by so much at the harmonic that they are at: second derivatives are as much
// of what comes out, and the simulator's own error of some 1e-13 a billionth.
constexpr double mode_change = 1e-4;
constexpr double added_damping = 0.05;

/// A mode more: at n omega, where it changes the phase of R_d by a quarter, and above it.
struct AddedMode {
  double frequency;

  Complex response(double omega) const {
    return 1.0 / Complex(frequency * frequency - omega * omega, 2 * added_damping * frequency * omega);
  }
};

Structure with_added(const Structure& structure, const AddedMode& mode, double share) {
  const Eigen::Index modes = structure.modes();
  Structure more = structure;
  more.phi.conservativeResize(modes + 1);
  more.frequency.conservativeResize(modes + 1);
  more.lean.conservativeResize(modes + 1);
  more.phi[modes] = std::sqrt(share);
  more.frequency[modes] = mode.frequency;
  more.lean[modes] = 0;
  more.factor = Eigen::MatrixXd::Zero(modes + 1, modes + 1);
  more.factor.topLeftCorner(modes, modes) = structure.factor;
  more.factor(modes, modes) = std::sqrt(2 * added_damping * mode.frequency);
  return more;
}

/// d ratio = sum over n of Re(conj(s_n) dR_n), s_n by 16 structures.
class Sensitivity {
 public:
  Sensitivity(const Problem& problem, const Realisation& realised, double velocity, double ratio)
      : problem_(problem), realised_(realised), velocity_(velocity), ratio_(ratio) {
    const double omega = problem.value(problem->angular_frequency);
    Eigen::MatrixXd changes(2 * harmonics, 2 * harmonics);
    Eigen::VectorXd moved(2 * harmonics);
    for (int row = 0; row < 2 * harmonics; ++row) {
      const int n = row / 2 + 1;
      const AddedMode mode{n * omega * (row % 2 == 0 ? 1 : 1 + 2 * added_damping)};
      const double share = mode_change * std::abs(realised.response(n * omega)) /
                           std::abs(mode.response(n * omega));
      for (int m = 1; m <= harmonics; ++m) {
        const Complex change = share * mode.response(m * omega);
        changes(row, 2 * m - 2) = change.real(), changes(row, 2 * m - 1) = change.imag();
      }
      moved[row] = ratio_with(with_added(realised.structure(), mode, share)) - ratio_;
    }
    slope_ = changes.partialPivLu().solve(moved);
  }

  double at(int n) const { return std::hypot(slope_[2 * n - 2], slope_[2 * n - 1]); }

 private:
  double ratio_with(const Structure& structure) const {
    simulation::System system = simulation::system_of(problem_);
    const auto mass = problem_->mass ? std::optional(problem_.value(*problem_->mass)) : std::nullopt;
    simulation::hold_by_structure(system, structure, mass);
    return simulation::steady_state(system, velocity_).friction_ratio;
  }

  const Problem& problem_;
  const Realisation& realised_;
  double velocity_, ratio_;
  Eigen::VectorXd slope_;
};

double velocity_by(const Problem& problem, const Realisation& realised) {
  const simulation::System system = simulation::system_of(problem);
  // The lead of a structure is in series with the contact of the system, if there is no body.
  const ScaledNetwork tangential = tangential_network(problem);
  const double omega = system.omega, mass = problem->mass ? problem.value(*problem->mass) : 0;
  const Complex contact = dynamic_stiffness(
      scaled(relaxation_form(tangential.network.network(), problem.values()), tangential.factor),
      omega);
  const Complex r = realised.response(omega);
  return system.friction * omega * std::abs(system.normal_force_amplitude) *
         std::abs(1.0 / contact + r / (1.0 - mass * omega * omega * r));
}

std::string range_words(const RealisedFriction& found, double omega, const Receptance& table) {
  const int first = found.outside.front();
  return fmt::format(
      "{} omega = {:.4g} rad/s lies outside the table (to {:.4g}): friction below v* rests on an "
      "extrapolation, error {:.1g}",
      first, first * omega, table.rows.back().omega, found.error);
}

}  // namespace

RealisedFriction realised_friction(const Problem& problem, double velocity,
                                   const simulation::SteadyState& state) {
  const Receptance& table = *problem->receptance();
  const auto body = problem->mass ? realisation::Body::heavy : realisation::Body::none;
  const auto realised = realisation::realised(table, body);
  const double omega = problem.value(problem->angular_frequency), ratio = state.friction_ratio;
  RealisedFriction found{.pairs = realised->pairs(),
                         .misfit = realised->misfit(),
                         .misfit_at_omega =
                             realised->error(omega) / std::abs(realised->response(omega)),
                         .critical_velocity = velocity_by(problem, *realised),
                         .outside = {},
                         .warnings = realised->warnings()};
  for (int n = 1; n <= harmonics; ++n)
    if (realised->outside(n * omega)) found.outside.push_back(n);
  // Without sticking friction is mu0 F_n, whatever the drive.
  if (state.events.empty()) return found;
  const Sensitivity sensitivity(problem, *realised, velocity, ratio);
  for (int n = 1; n <= harmonics; ++n)
    found.error += sensitivity.at(n) * realised->error(n * omega);
  found.error = std::min(found.error, std::max(ratio, 1 - ratio));
  if (!found.outside.empty()) found.warnings.push_back(range_words(found, omega, table));
  return found;
}

std::vector<std::string> unstated_error(const Problem& problem) {
  const Receptance* table = problem->receptance();
  if (table == nullptr) return {};
  return {fmt::format("{}: friction rests on a structure fitted to the table, and its error does not "
                      "hold that of the fit; vcrit simulate states it at one speed",
                      table->file)};
}

}  // namespace vcrit
