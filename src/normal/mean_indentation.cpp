#include "normal/mean_indentation.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "base/constants.hpp"
#include "normal/mount.hpp"
#include "normal/normal_force.hpp"
#include "normal/pressed_cells.hpp"
#include "stiffness/at_rest.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::simulation {

namespace {

constexpr int most_root_steps = 200;  // with bisection alone some sixty would do

// What the mean force compresses a network by, m. Of a contact as if closed: the force that would
// open it is a question of its own.
double compressed(const Problem& problem, const ReducedNetwork& network) {
  const long double stiffness = at_rest(network.reduction(), problem.values()).stiffness();
  return static_cast<double>(problem.value(*problem->load) / stiffness);
}

bool opens_under_load(const Problem& problem) {
  const Values& values = problem.values();
  const long double swing =
      std::abs(wide_dynamic_stiffness(problem->normal.reduction(), values,
                                      values.at(problem->angular_frequency.symbol))) *
      contact_amplitude(problem);
  return problem->separation &&
         swing > (1 + least_separation(false)) * problem.value(*problem->load);
}

// Without a mass no force but theirs is on the body: mount and contact together are pressed by what
// the vibrator does.
NormalMotion unpressed_motion(const Problem& problem) {
  const Relaxation contact = relaxation_form(problem->normal.network(), problem.values());
  if (!problem->mount) return {contact, 0, problem.value(problem->amplitude)};
  const Relaxation mount = relaxation_form(problem->mount->network(), problem.values());
  return {series({mount, contact}), 0, problem.value(problem->amplitude)};
}

double pressed_mean(const Problem& problem) {
  double closed = compressed(problem, problem->normal);
  if (problem->mount) closed += compressed(problem, *problem->mount);
  if (std::isinf(closed) || !opens_under_load(problem)) return closed;
  const NormalMotion motion = unpressed_motion(problem);
  const ContactModes modes = modes_of(motion, problem.value(problem->angular_frequency));
  SharedEffort effort(effort_of_pressing);
  const auto force = [&](double mean) {
    const PressedCycle found = pressed_cycle(modes, {mean, motion.amplitude}, &effort);
    return PressedForce{found.cycle.mean, found.slope};
  };
  return pressed_by(force, problem.value(*problem->load), -motion.amplitude, closed);
}

// Of what is prescribed: with the mount's deformation under a load.
double prescribed_mean(const Problem& problem) {
  if (!problem->load) return problem.value(problem->indentation);
  return problem.found_indentation(
      [&] { return problem->indenter ? indentation_of_cells(problem) : pressed_mean(problem); });
}

}  // namespace

// In the force to the power of 2/3, in which a contact that hardly touches grows evenly.
double pressed_by(const std::function<PressedForce(double)>& force, double load, double low,
                  double high) {
  const double size = std::max(std::abs(low), std::abs(high));
  double u = high;
  for (int i = 0; i < most_root_steps; ++i) {
    const PressedForce found = force(u);
    (found.force > load ? high : low) = u;
    const double share = found.force / load;
    const double step =
        1.5 * (std::cbrt(share * share) - 1) * std::cbrt(share) * load / found.slope;
    const double next = u - step;
    if (std::abs(step) <= last_step * std::min(size, std::abs(u) + std::abs(low)))
      return std::clamp(next, low, std::max(high, next));
    if (!(high - low > epsilon * size)) return u;
    u = next > low && next < high ? next : low + 0.5 * (high - low);
  }
  throw ModelError("no mean indentation is found at which the contact carries the load");
}

double mean_indentation(const Problem& problem) {
  if (!problem->mount || !problem->load) return prescribed_mean(problem);
  if (!opens_under_load(problem)) return compressed(problem, problem->normal);
  return prescribed_mean(problem) - compressed(problem, *problem->mount);
}

NormalMotion opening_motion(const Problem& problem) {
  NormalMotion motion = unpressed_motion(problem);
  motion.mean = prescribed_mean(problem);
  return motion;
}

double closed_mean_force(const Problem& problem, double static_stiffness) {
  if (problem->load) return problem.value(*problem->load);
  return static_stiffness * problem.value(problem->indentation);
}

}  // namespace vcrit::simulation
