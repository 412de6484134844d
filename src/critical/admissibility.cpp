#include "critical/admissibility.hpp"

#include "rules/rulebook.hpp"
#include "stiffness/at_rest.hpp"

namespace vcrit {

std::vector<std::string> inadmissible_reasons(const Problem& problem) {
  return rules::reasons(rules::Question::admissible, problem);
}

bool opens(const Problem& problem) { return rules::Facts(problem).opens(); }

double creep_velocity(const Problem& problem) {
  const Values& values = problem.values();
  const ScaledNetwork tangential = tangential_network(problem);
  long double total =
      at_rest(tangential.network.reduction(), values).fluidity() / tangential.factor;
  if (problem->drive_network() != nullptr)
    total += at_rest(problem->drive_network()->reduction(), values).fluidity();
  if (total == 0) return 0;
  const long double mean_normal_force = rules::Facts(problem).mean_force();
  return static_cast<double>(values.at(problem->coefficient.symbol) * mean_normal_force * total);
}

}  // namespace vcrit
