#include "simulation/steady/energy.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "simulation/steady/near_resonance.hpp"
#include "simulation/steady/quadrature.hpp"
#include "simulation/steady/steady_cycle.hpp"

namespace vcrit::simulation {

namespace {

// A dissipated power and what its rounding may come to.
struct Heat {
  double power = 0, rounding = 0;

  // Of a damper that moves at `rate`: power = rate^2 * factor, rate known to a few roundings of
  // `size`.
  void add(double rate, double factor, double size) {
    power += rate * rate * factor;
    rounding += 2 * std::abs(rate) * factor * 4 * epsilon * (std::abs(rate) + size);
  }
};

// How much the rounding of its phase, up to two periods, moves what swings.
double swing_of_phase(double amplitude) { return 2 * two_pi * amplitude; }

// The same of the body's velocity on its own pair of modes.
double swing_of_body(const Model& model, const State& state) {
  double fastest = 0;
  for (const ModePair& pair : model.slip.modes.spectrum.pairs)
    fastest = std::max(fastest, pair.rate);
  return swing_of_phase(std::abs(state.x[1]) * fastest);
}

// x.losses x, a sum of squares in which nothing cancels but by rounding.
void add_heat_of_masses(const Masses& masses, ConstView x, double swing, Heat& heat) {
  Vector rates(x.size());
  add_product(masses.losses, x, rates);
  double sizes = swing;
  for (const double each : x) sizes += std::abs(each);
  for (Index i = 0; i < x.size(); ++i) {
    heat.power += masses.mass * x[i] * rates[i];
    for (Index j = 0; j < x.size(); ++j)
      heat.rounding += 8 * epsilon * masses.mass * std::abs(masses.losses(i, j)) *
                       (std::abs(x[i]) + std::abs(x[j])) * sizes;
  }
}

// Contact as Kelvin units behind a free damper, each under the same force F and creeping at r_j;
// the drive as branches beside a damper, all moving at u. A branch's damper k_j/a_j carries g_j.
Heat heat_of_dampers(const Model& model, State state) {
  const ContactModes& contact = model.contact;
  const auto swing = [&](Index j) { return swing_of_phase(std::abs(model.sliding_rates[j])); };
  Heat heat;
  model.add_steady(model.load, state.x);
  heat.add(state.x[0], contact.fluidity, swing_of_phase(model.amplitude));
  const Index units = model.units(), body = model.body_states();
  const Index first = states(model, state.motion) - units;
  for (Index j = 0; j < units; ++j)
    heat.add(state.x[first + j], 1 / contact.unit_fluidity[j], swing(body + j));
  if (!model.body) return heat;
  if (const auto& masses = model.body->masses) {
    add_heat_of_masses(*masses, ConstView(state.x).subspan(1, body),
                       swing(0) + swing_of_body(model, state), heat);
    return heat;
  }
  const PoleSum& drive = model.body->drive;
  heat.add(state.x[1], drive.direct, swing(0) + swing_of_body(model, state));
  for (Index j = 0; j + 1 < body; ++j)
    heat.add(state.x[2 + j], drive.rates[j] / drive.weights[j], swing(1 + j));
  return heat;
}

// A path that creeps and never slips: the drive works against a steady force.
EnergyBalance energy_of_creep(const Model& model, double velocity) {
  const double work = velocity * velocity / model.creep * two_pi;
  return {work, 0, work, 8 * epsilon * work};
}

// The contact velocity may be far smaller than its terms, of which each has a few rounding errors,
// and those that swing, with the oscillation or on their own, the rounding of the phase.
double rounding_of_velocity(const Model& model, double velocity, const State& state) {
  if (state.motion == Motion::stick) return 0;
  double swing = model.contact.glassy * model.amplitude;
  for (const std::complex<double>& rate : model.sliding_rates) swing += std::abs(rate);
  double size = std::abs(velocity) + model.contact.fluidity * model.force_size();
  size += swing_of_phase(swing);
  if (model.body) size += std::abs(state.x[1]) + swing_of_body(model, state);
  for (Index j = model.level_states(); j < model.slip_states(); ++j) size += std::abs(state.x[j]);
  return 4 * epsilon * size;
}

// Of a closed cycle, piece by piece. It slips as far as the drive moves, less what creeps; what is
// missing there is missing in the heat of friction.
class Account {
 public:
  Account(const Model& model, double drive_velocity)
      : model_(model),
        stick_(model.stick.modes.spectrum),
        slip_(model.slip.modes.spectrum),
        drive_velocity_(drive_velocity),
        velocity_(model.motion_velocity(drive_velocity)) {}

  bool can_follow(const Piece& piece, double duration) const {
    return of(piece).can_follow(duration);
  }

  void add(const Piece& piece, double duration) {
    of(piece).over(duration, [&](double time, double weight) {
      const State state = piece.after(time);
      const double force = model_.load + state.x[0];
      const double slip = contact_velocity(model_, velocity_, state);
      distance_ += weight * slip;
      energy_.friction += weight * force * slip;
      const Heat heat = heat_of_dampers(model_, state);
      energy_.dampers += weight * heat.power;
      energy_.error += weight * (heat.rounding +
                                 std::abs(force) * rounding_of_velocity(model_, velocity_, state));
    });
  }

  /// impulse: of F less the load; ratio_error: of <F>.
  EnergyBalance closed(double impulse, double ratio_error) const {
    EnergyBalance energy = energy_;
    energy.drive = drive_velocity_ * (model_.load * two_pi + impulse);
    const double missing = distance_ - velocity_ * two_pi + model_.creep * impulse;
    energy.error += (1 + model_.amplitude) * std::abs(missing) +
                    drive_velocity_ * two_pi * ratio_error + 32 * epsilon * std::abs(energy.drive);
    return energy;
  }

 private:
  const Quadrature& of(const Piece& piece) const { return piece.stuck() ? stick_ : slip_; }

  const Model& model_;
  Quadrature stick_, slip_;
  double drive_velocity_, velocity_;
  EnergyBalance energy_;
  double distance_ = 0;
};

std::optional<EnergyBalance> energy_of_cycle(const Model& model, double drive_velocity) {
  const double velocity = model.motion_velocity(drive_velocity);
  const SteadyCycle cycle = steady_cycle(model, velocity, sliding_start(model, velocity));
  Account account(model, drive_velocity);
  for (const Trace::Part& part : cycle.period.parts) {
    if (!account.can_follow(part.piece, part.duration)) return std::nullopt;
    account.add(part.piece, part.duration);
  }
  return account.closed(cycle.period.impulse(), cycle.error);
}

// Without end; F is the bound throughout, of which the mean is 1.
std::optional<EnergyBalance> energy_of_sliding(const Model& model, double drive_velocity) {
  const double velocity = model.motion_velocity(drive_velocity);
  Account account(model, drive_velocity);
  const Piece piece(model, velocity, sliding_start(model, velocity));
  if (!account.can_follow(piece, two_pi)) return std::nullopt;
  account.add(piece, two_pi);
  return account.closed(0, 0);
}

std::optional<EnergyBalance> energy_near_resonance(const Neighbours& neighbours, double velocity) {
  std::array<EnergyBalance, 4> balances;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto balance = energy_balance(neighbours.systems[i], velocity);
    if (!balance) return std::nullopt;
    balances[i] = *balance;
  }
  EnergyBalance result{0, 0, 0, 0};
  for (double EnergyBalance::*member :
       {&EnergyBalance::drive, &EnergyBalance::friction, &EnergyBalance::dampers}) {
    std::array<double, 4> f{};
    for (std::size_t i = 0; i < 4; ++i) f[i] = balances[i].*member;
    result.*member = neighbours.mean(f);
    result.error += neighbours.error(f);
  }
  for (std::size_t i = 0; i < 4; ++i)
    result.error += std::abs(Neighbours::weights[i]) * balances[i].error;
  return result;
}

}  // namespace

std::optional<EnergyBalance> energy_balance(const System& system, double velocity) {
  require_forward(velocity);
  const Model model(system);
  const double v = velocity / model.velocity_unit;
  if (lost_in_resonance(model) && !model.slides(model.motion_velocity(v)))
    return energy_near_resonance(neighbours(system, model, model.motion_velocity(v)), velocity);
  const double unit = model.force_unit * model.velocity_unit / system.omega;
  const std::optional<EnergyBalance> found =
      model.slides(model.motion_velocity(v))        ? energy_of_sliding(model, v)
      : model.never_slips(model.motion_velocity(v)) ? energy_of_creep(model, v)
                                                    : energy_of_cycle(model, v);
  if (!found) return std::nullopt;
  const EnergyBalance energy{unit * found->drive, unit * found->friction, unit * found->dampers,
                             unit * found->error};
  if (!std::isfinite(energy.drive + energy.friction + energy.dampers + energy.error))
    return std::nullopt;
  return energy;
}

}  // namespace vcrit::simulation
