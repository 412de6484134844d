#include "critical/admissibility.hpp"

#include "rules/rulebook.hpp"
#include "stiffness/at_rest.hpp"

namespace vcrit {

std::vector<std::string> inadmissible_reasons(const Scene& scene) {
  return rules::reasons(rules::Question::admissible, scene);
}

bool opens(const Scene& scene) { return rules::Facts(scene).opens(); }

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
