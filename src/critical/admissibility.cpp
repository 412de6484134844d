#include "critical/admissibility.hpp"

#include <fmt/core.h>

#include <complex>

#include "stiffness/at_rest.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit {

namespace {

// Of the closed contact, in N.
struct NormalForce {
  long double mean, oscillating;
};

NormalForce normal_force(const Scene& scene, const Values& values) {
  const double omega = values.at(scene.angular_frequency.symbol);
  return {at_rest(scene.normal, values).stiffness() * values.at(scene.indentation.symbol),
          std::abs(wide_dynamic_stiffness(scene.normal, values, omega)) *
              values.at(scene.amplitude.symbol)};
}

}  // namespace

std::vector<std::string> inadmissible_reasons(const Scene& scene) {
  const Values values = values_of(scene);
  const double amplitude = values.at(scene.amplitude.symbol);
  const double indentation = values.at(scene.indentation.symbol);
  const NormalForce force = normal_force(scene, values);

  std::vector<std::string> reasons;
  if (!scene.separation && !(amplitude < indentation))
    reasons.push_back(beyond_indentation(scene, amplitude, indentation));
  if (force.mean == 0) {
    reasons.emplace_back("the normal network carries no static load: K_n(0) = 0");
    return reasons;
  }
  if (scene.separation || force.oscillating < force.mean) return reasons;
  if (scene.indenter)
    reasons.emplace_back(
        "the contact opens all over: at its centre, too, the pressure would oscillate beyond its "
        "mean (4)");
  else
    reasons.push_back(
        fmt::format("the contact opens: the normal force oscillates by {} |K_n| = {:.6g} N about "
                    "a mean of K_n(0) {} = {:.6g} N (4)",
                    name_in(scene, scene.amplitude), static_cast<double>(force.oscillating),
                    name_in(scene, scene.indentation), static_cast<double>(force.mean)));
  return reasons;
}

bool opens(const Scene& scene) {
  const NormalForce force = normal_force(scene, values_of(scene));
  return force.oscillating > force.mean;
}

double creep_velocity(const Scene& scene) {
  const Values values = values_of(scene);
  const ScaledNetwork tangential = tangential_network(scene);
  long double total = at_rest(*tangential.network, values).fluidity() / tangential.factor;
  if (scene.drive) total += at_rest(*scene.drive, values).fluidity();
  if (total == 0) return 0;
  const long double mean_normal_force =
      at_rest(scene.normal, values).stiffness() * values.at(scene.indentation.symbol);
  return static_cast<double>(values.at(scene.coefficient.symbol) * mean_normal_force * total);
}

}  // namespace vcrit
