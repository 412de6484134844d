#include "critical/admissibility.hpp"

#include <fmt/core.h>

#include <complex>
#include <optional>

#include "network/masses.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit {

namespace {

// K(s) ~ eta s as s -> 0: the damper and the branches of the relaxation form in parallel.
double viscosity(const Relaxation& relaxation) {
  double eta = relaxation.damper;
  for (const MaxwellBranch& branch : relaxation.branches) eta += branch.stiffness * branch.time;
  return eta;
}

double fluidity(const Relaxation& relaxation) {
  return relaxation.equilibrium > 0 ? 0 : 1 / viscosity(relaxation);
}

// m s^2 is nothing beside k, and beside c s, as s -> 0.
Network resting(const Network& drive) {
  const std::optional<Network> rest = without_masses(drive);
  ensure(rest.has_value(), "a drive has a path of springs and dampers");
  return *rest;
}

// Of the closed contact, in N.
struct NormalForce {
  double mean, oscillating;
};

NormalForce normal_force(const Scene& scene, const Values& values) {
  const double omega = values.at(scene.angular_frequency.symbol);
  return {
      relaxation_form(scene.normal, values).equilibrium * values.at(scene.indentation.symbol),
      values.at(scene.amplitude.symbol) * std::abs(dynamic_stiffness(scene.normal, values, omega))};
}

}  // namespace

std::vector<std::string> inadmissible_reasons(const Scene& scene) {
  const Values values = values_of(scene);
  const double amplitude = values.at(scene.amplitude.symbol);
  const double indentation = values.at(scene.indentation.symbol);
  const double equilibrium = relaxation_form(scene.normal, values).equilibrium;

  std::vector<std::string> reasons;
  if (!scene.separation && !(amplitude < indentation))
    reasons.push_back(
        fmt::format("the amplitude du_z = {} m is not below the indentation u_z0 = {} m (3)",
                    amplitude, indentation));
  if (equilibrium == 0) {
    reasons.emplace_back("the normal network carries no static load: K_n(0) = 0");
    return reasons;
  }
  const NormalForce force = normal_force(scene, values);
  if (scene.separation || force.oscillating < force.mean) return reasons;
  if (scene.indenter)
    reasons.emplace_back(
        "the contact opens all over: at its centre, too, the pressure would oscillate beyond its "
        "mean (4)");
  else
    reasons.push_back(
        fmt::format("the contact opens: the normal force oscillates by du_z |K_n| = {:.6g} N about "
                    "a mean of K_n(0) u_z0 = {:.6g} N (4)",
                    force.oscillating, force.mean));
  return reasons;
}

bool opens(const Scene& scene) {
  const NormalForce force = normal_force(scene, values_of(scene));
  return force.oscillating > force.mean;
}

double creep_velocity(const Scene& scene) {
  const Values values = values_of(scene);
  const ScaledNetwork tangential = tangential_network(scene);
  double total = fluidity(relaxation_form(*tangential.network, values)) / tangential.factor;
  if (scene.drive) total += fluidity(relaxation_form(resting(*scene.drive), values));
  if (total == 0) return 0;
  const double mean_normal_force =
      relaxation_form(scene.normal, values).equilibrium * values.at(scene.indentation.symbol);
  return values.at(scene.coefficient.symbol) * mean_normal_force * total;
}

}  // namespace vcrit
