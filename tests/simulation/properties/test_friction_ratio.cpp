// What holds for the friction ratio of every system, whatever its networks.
#include <cmath>

#include "property.hpp"
#include "random_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_friction_ratio)

namespace {

using namespace vcrit;
using namespace vcrit::properties;
using namespace vcrit::simulation;

constexpr double u = 1.1e-16;

rc::Gen<Draw> any_draw() { return draws(*rc::gen::element(1, 3, 6)); }

System scaled(System system, double stiffness, double force) {
  system.contact = scaled(system.contact, stiffness);
  if (system.drive) system.drive = scaled(*system.drive, stiffness);
  if (system.mass) *system.mass *= stiffness;
  system.mean_normal_force *= force;
  system.normal_force_amplitude *= force;
  return system;
}

// Sum of the sizes of d(friction ratio)/d ln(contact, drive, mass, speed).
double steepness(const System& system, double velocity, double ratio) {
  constexpr double step = 1e-6;
  const auto slope = [&](const System& changed, double speed) {
    return std::abs(steady_state(changed, speed).friction_ratio - ratio) / step;
  };
  System contact = system, drive = system, mass = system;
  contact.contact = scaled(system.contact, 1 + step);
  if (drive.drive) drive.drive = scaled(*system.drive, 1 + step);
  if (mass.mass) *mass.mass *= 1 + step;
  return slope(contact, velocity) + slope(drive, velocity) + slope(mass, velocity) +
         slope(system, velocity * (1 - step));
}

}  // namespace

// Above, F <= mu0 F_n at every moment. Below, by the energy of one period: the drive's work v0 <F>
// is not less than what friction and free dampers take, min F_n <|w|> mu0 + phi <F>^2, with phi the
// sum of the path's fluidities 1/eta; and the contact's mean velocity is <w> = v0 - phi <F>. So (v0
// - phi <F>)(<F> - mu0 min F_n) >= 0: <F> is not below mu0 min F_n unless the contact never slips,
// where <F> = v0/phi. Bodies may swing as they like.
RC_BOOST_PROP(lies_between_the_static_bound_and_one, ()) {
  const auto draw = *any_draw();
  const auto ratio = *ratio_below_one();
  const System system = system_of(draw);
  const Onset threshold = sliding_threshold(system);
  const double velocity = drive_velocity(system, ratio);
  const SteadyState state = steady_state(system, velocity);
  const double creep = threshold.drive_velocity - threshold.contact_velocity;
  // The creep is a difference of two speeds here.
  const double rounding = 10 * u * (1 + velocity / ratio / creep);
  const double lowest =
      std::min(1 - draw.amplitude, creep > 0 ? velocity / creep * (1 - rounding) : 1);
  const double error = state.friction_ratio_error + 10 * u;
  RC_ASSERT(state.friction_ratio <= 1 + error);
  RC_ASSERT(state.friction_ratio >= lowest - error);
}

// The difference of two steady motions takes from the drive, per period, (v1 - v2)(<F1> - <F2>) =
// <(F1 - F2)(w1 - w2)> + what dampers take of it: Coulomb's law is monotone, so neither is
// negative.
RC_BOOST_PROP(never_falls_with_the_speed, ()) {
  const auto draw = *any_draw();
  const auto ratio = *ratio_below_one();
  const double slower = ratio * *rc::gen::inRange(1, 1000) / 1000.0;
  const System system = system_of(draw);
  const SteadyState fast = steady_state(system, drive_velocity(system, ratio));
  const SteadyState slow = steady_state(system, drive_velocity(system, slower));
  RC_ASSERT(slow.friction_ratio - slow.friction_ratio_error <=
            fast.friction_ratio + fast.friction_ratio_error);
}

// Coulomb friction is maximal monotone: one value, whatever the start.
RC_BOOST_PROP(is_the_same_from_rest_and_from_sliding, ()) {
  const auto draw = *any_draw();
  const auto ratio = *ratio_below_one();
  const System system = system_of(draw);
  const double velocity = drive_velocity(system, ratio);
  const SteadyState slid = steady_state(system, velocity, Start::sliding);
  const SteadyState rested = steady_state(system, velocity, Start::rest);
  RC_ASSERT(std::abs(slid.friction_ratio - rested.friction_ratio) <=
            slid.friction_ratio_error + rested.friction_ratio_error);
}

// With powers of two, every operation is the same but for its exponent.
RC_BOOST_PROP(does_not_change_with_all_stiffnesses_dampers_and_masses, ()) {
  const auto draw = *any_draw();
  const auto ratio = *ratio_below_one();
  const int exponent = *rc::gen::inRange(-20, 20);
  const double factor = std::ldexp(1, exponent);
  const System system = system_of(draw);
  const double velocity = drive_velocity(system, ratio);
  RC_ASSERT(steady_state(scaled(system, factor, 1), velocity / factor).friction_ratio ==
            steady_state(system, velocity).friction_ratio);
}

// With other factors every input is rounded anew: three roundings of some ten inputs, each of which
// moves the ratio as steeply as all of one network's stiffness, the mass or the speed do.
RC_BOOST_PROP(changes_by_rounding_with_any_factors, ()) {
  const auto draw = *draws(*rc::gen::element(1, 3));
  const auto ratio = *ratio_below_one();
  const double stiffness = 1.1 * *magnitude(9), force = 1.3 * *magnitude(9);
  const System system = system_of(draw);
  const double velocity = drive_velocity(system, ratio);
  const SteadyState one = steady_state(system, velocity);
  const SteadyState other =
      steady_state(scaled(system, stiffness, force), velocity * (force / stiffness));
  RC_ASSERT(std::abs(one.friction_ratio - other.friction_ratio) <=
            one.friction_ratio_error + other.friction_ratio_error +
                30 * u * (1 + steepness(system, velocity, one.friction_ratio)));
}

RC_BOOST_PROP(does_not_change_with_forces, ()) {
  const auto draw = *any_draw();
  const auto ratio = *ratio_below_one();
  const int exponent = *rc::gen::inRange(-20, 20);
  const double factor = std::ldexp(1, exponent);
  const System system = system_of(draw);
  const double velocity = drive_velocity(system, ratio);
  const double alone = steady_state(system, velocity).friction_ratio;
  RC_ASSERT(steady_state(scaled(system, 1, factor), velocity * factor).friction_ratio == alone);
  System rough = system;
  rough.friction *= factor;
  RC_ASSERT(steady_state(rough, velocity * factor).friction_ratio == alone);
}

BOOST_AUTO_TEST_SUITE_END()
