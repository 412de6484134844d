#include "answers/realised_friction.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "base/rounded.hpp"
#include "linear/elimination.hpp"
#include "realisation/realisation.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "simulation/system/measured_drive.hpp"

namespace vcrit {

namespace {

using realisation::Complex;
using realisation::Mode;
using realisation::Realisation;
using realisation::Structure;

constexpr int harmonics = 8;
// Modes that change R_d by so much at the harmonic that they are at: second derivatives are as much
// of what comes out, and the simulator's own error of some 1e-13 a billionth.
constexpr double mode_change = 1e-4;
constexpr double added_damping = 0.05;

/// Of the contact alone, without what a structure has in series with it.
Relaxation contact_of(const Problem& problem) {
  const ScaledNetwork tangential = tangential_network(problem);
  return scaled(relaxation_form(tangential.network.network(), problem.values()), tangential.factor);
}

/// A number of the motion, with structures in place of the table.
class Asked {
 public:
  using Number = std::function<double(const simulation::System&)>;

  Asked(const Problem& problem, Number number)
      : system_(simulation::system_of(problem)),
        contact_(contact_of(problem)),
        number_(std::move(number)) {
    if (problem->mass) mass_ = problem.value(*problem->mass);
  }

  /// Throws ModelError where there is no such motion.
  double of_table() const { return number_(system_); }

  /// Nothing where there is no such motion.
  std::optional<double> with(const Structure& structure) const {
    simulation::System system = system_;
    system.contact = contact_;
    try {
      simulation::hold_by_structure(system, structure, mass_);
      return number_(system);
    } catch (const ModelError&) {
      return std::nullopt;
    }
  }

 private:
  simulation::System system_;
  Relaxation contact_;
  Number number_;
  std::optional<double> mass_;
};

Asked friction_at(const Problem& problem, double velocity) {
  return {problem, [velocity](const simulation::System& system) {
            return simulation::steady_state(system, velocity).friction_ratio;
          }};
}

Asked sliding_from(const Problem& problem) {
  return {problem, [](const simulation::System& system) {
            return simulation::sliding_threshold(system).contact_velocity;
          }};
}

/// d number = sum over n of Re(conj(s_n) dR_n), s_n by 16 structures.
class Sensitivity {
 public:
  Sensitivity(const Asked& asked, const Realisation& realised, double omega, double number) {
    Eigen::MatrixXd changes(2 * harmonics, 2 * harmonics);
    Eigen::VectorXd moved(2 * harmonics);
    for (int row = 0; row < 2 * harmonics; ++row) {
      const int n = row / 2 + 1;
      // At n omega, where it changes the phase of R_d by a quarter, and above it.
      Mode mode{n * omega * (row % 2 == 0 ? 1 : 1 + 2 * added_damping), added_damping, 1};
      mode.share =
          mode_change * std::abs(realised.response(n * omega)) / std::abs(mode.response(n * omega));
      for (int m = 1; m <= harmonics; ++m) {
        const Complex change = mode.response(m * omega);
        changes(row, 2 * m - 2) = change.real(), changes(row, 2 * m - 1) = change.imag();
      }
      const auto with = asked.with(plus_mode(realised.structure(), mode));
      moved[row] = with ? *with - number : std::numeric_limits<double>::infinity();
    }
    if (moved.allFinite()) slope_ = linear::Lu<double>(changes).solve(moved);
  }

  /// |s_n|; infinite where one of the structures has no steady state.
  double at(int n) const {
    if (!slope_) return std::numeric_limits<double>::infinity();
    return std::hypot((*slope_)[2 * n - 2], (*slope_)[2 * n - 1]);
  }

 private:
  std::optional<Eigen::VectorXd> slope_;
};

/// By how much structures that fit as well change the number.
struct Spread {
  double greatest = 0, deviation = 0;  ///< deviation: the root of the mean of squares
};

Spread spread_of(const Asked& asked, const std::vector<Structure>& structures, double number) {
  double squares = 0, greatest = 0;
  int count = 0;
  for (const Structure& each : structures)
    if (const auto with = asked.with(each)) {
      greatest = std::max(greatest, std::abs(*with - number));
      squares += (*with - number) * (*with - number);
      ++count;
    }
  return {greatest, std::sqrt(squares / std::max(count, 1))};
}

/// By modes at the harmonics that the rows do not show, one at each: a drive may have all of them.
/// To first order where no fit with one is found.
double change_by_hidden_mode(const Asked& asked, const Realisation& realised, double omega,
                             double number, const Sensitivity& sensitivity) {
  double sum = 0;
  for (int n = 1; n <= harmonics; ++n) {
    const auto structure = realised.with_hidden_mode(n * omega);
    const auto with = structure ? asked.with(*structure) : std::nullopt;
    sum +=
        with ? std::abs(*with - number) : sensitivity.at(n) * realised.deviation(n * omega).hidden;
  }
  return sum;
}

// Found on the 82 chains of tests/data/two_mass_chains.csv, each as four tables
// (docs/simulation.md).
double error_by_fit(const Asked& asked, const Realisation& realised, double omega, double number) {
  constexpr double of_rivals = 2, of_noise = 4, of_misfit = 0.125;
  const Sensitivity sensitivity(asked, realised, omega, number);
  double misfit = 0;
  for (int n = 1; n <= harmonics; ++n)
    misfit += sensitivity.at(n) * realised.deviation(n * omega).misfit;
  const double error = of_rivals * spread_of(asked, realised.rivals(), number).greatest +
                       of_noise * spread_of(asked, realised.refits(), number).deviation +
                       of_misfit * misfit +
                       change_by_hidden_mode(asked, realised, omega, number, sensitivity);
  return realised.caution() * error;
}

realisation::BodyMass body_of(const Problem& problem) {
  return problem->mass ? realisation::BodyMass::heavy : realisation::BodyMass::none;
}

/// Of the structure between two rows, by a straight line as the table is read.
Complex between_rows(const Realisation& realised, const Receptance& table, double omega) {
  const Bracket rows = bracket(table, omega);
  const double low = rows.below.omega, high = rows.above.omega;
  const double part = high > low ? (omega - low) / (high - low) : 0;
  return (1 - part) * realised.response(low) + part * realised.response(high);
}

std::string range_words(const RealisedFriction& found, double omega, const Receptance& table) {
  const int first = found.outside.front();
  return fmt::format(
      "harmonic {} of the oscillation, {}, lies outside the table (to {}): friction below v* rests "
      "on an extrapolation, error {:.1g}",
      first, rounded_frequency(first * omega), rounded_frequency(table.rows.back().omega),
      found.error);
}

}  // namespace

RealisedVelocity realised_velocity(const Problem& problem) {
  const Receptance& table = *problem->receptance();
  const auto realised = realisation::realised(table, body_of(problem));
  const simulation::System system = simulation::system_of(problem);
  const double omega = system.omega, mass = problem->mass ? problem.value(*problem->mass) : 0;
  if (system.opening) {
    const Asked asked = sliding_from(problem);
    const double value = asked.of_table();
    return {value, std::isfinite(value) ? error_by_fit(asked, *realised, omega, value) : 0};
  }
  const Complex contact = dynamic_stiffness(contact_of(problem), omega);
  const Complex r = realised->response(omega), free = 1.0 - mass * omega * omega * r;
  const double unit = system.friction * omega * std::abs(system.normal_force_amplitude);
  const double off = realised->error(omega) + std::abs(r - between_rows(*realised, table, omega));
  // Of r' within `off` of r, r'/free' - r/free = (r' - r)/(free free').
  const double least = std::abs(free) - mass * omega * omega * off;
  return {unit * std::abs(1.0 / contact + r / free), least > 0
                                                         ? unit * off / (std::abs(free) * least)
                                                         : std::numeric_limits<double>::infinity()};
}

namespace {

double realised_threshold(const Problem& problem) {
  const simulation::System system = simulation::system_of(problem);
  return system.opening ? simulation::sliding_threshold(system).contact_velocity
                        : realised_velocity(problem).value;
}

}  // namespace

RealisedFriction realised_friction(const Problem& problem, double velocity) {
  const Receptance& table = *problem->receptance();
  const auto realised = realisation::realised(table, body_of(problem));
  const double omega = problem.value(problem->angular_frequency);
  RealisedFriction found{
      .pairs = realised->pairs(),
      .misfit = realised->misfit(),
      .misfit_at_omega = realised->error(omega) / std::abs(realised->response(omega)),
      .critical_velocity = realised_threshold(problem),
      .outside = {},
      .warnings = realised->warnings()};
  for (int n = 1; n <= harmonics; ++n)
    if (realised->outside(n * omega)) found.outside.push_back(n);
  const Asked asked = friction_at(problem, velocity);
  const double ratio = asked.of_table();
  // More than that it cannot be off.
  found.error = std::min(error_by_fit(asked, *realised, omega, ratio), std::max(ratio, 1 - ratio));
  if (!found.outside.empty()) found.warnings.push_back(range_words(found, omega, table));
  return found;
}

std::vector<std::string> unstated_error(const Problem& problem) {
  const Receptance* table = problem->receptance();
  if (table == nullptr) return {};
  return {
      fmt::format("{}: friction rests on a structure fitted to the table, and its error does not "
                  "hold that of the fit; vcrit simulate states it at one speed",
                  table->file)};
}

}  // namespace vcrit
