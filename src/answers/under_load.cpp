#include "answers/under_load.hpp"

#include "normal/mean_indentation.hpp"
#include "normal/mount.hpp"
#include "normal/pressed_cells.hpp"
#include "record/fields.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "simulation/steady/normal_force.hpp"
#include "stiffness/at_rest.hpp"

namespace vcrit {

void fields(record::Fields& f, const UnderLoad& it) {
  f.some("indentation", it.indentation)("mean_normal_force", it.mean_normal_force);
  f.some("sinking_velocity", it.sinking_velocity);
}

void fields(record::Fields& f, const BelowMount& it) {
  f("amplitude", it.amplitude)("mount_phase", it.mount_phase);
}

namespace {

// The force of a contact that opens has harmonics, which move the place below a mount as well.
bool swings_with_harmonics(const Problem& problem) {
  return problem->mount && rules::Facts(problem).loses_contact();
}

}  // namespace

std::optional<BelowMount> below_mount(const Problem& problem) {
  if (!problem->mount || swings_with_harmonics(problem)) return std::nullopt;
  return BelowMount{contact_amplitude(problem), mount_phase(problem)};
}

double amplitude_at_contact(const Problem& problem) {
  if (swings_with_harmonics(problem))
    throw ModelError(
        "below its mount the contact opens: its height has harmonics, and no amplitude");
  return contact_amplitude(problem);
}

// W/eta_n: the damper through which all of the load goes.
std::optional<UnderLoad> under_load(const Problem& problem) {
  if (!problem->load && !problem->mount) return std::nullopt;
  UnderLoad found;
  if (!problem->load) {
    found.indentation = problem.value(problem->indentation);
    found.mean_normal_force = static_cast<double>(rules::Facts(problem).mean_force());
    return found;
  }
  found.mean_normal_force = problem.value(*problem->load);
  const AtRest normal = at_rest(problem->normal.reduction(), problem.values());
  if (normal.fluidity() > 0) {
    found.sinking_velocity = static_cast<double>(found.mean_normal_force * normal.fluidity());
    return found;
  }
  try {
    found.indentation = simulation::mean_indentation(problem);
  } catch (const ModelError&) {
    // The motion is not known, of which the rulebook or the simulator says why.
  }
  return found;
}

double mean_normal_force_of(const Problem& problem) {
  if (problem->load) return problem.value(*problem->load);
  if (rules::cells_move(problem)) {
    rules::require(rules::Question::motion_below_indenter, problem);
    return simulation::mean_force_of_cells(problem);
  }
  const rules::Facts facts(problem);
  if (!facts.loses_contact()) return static_cast<double>(facts.mean_force());
  return simulation::mean_normal_force(simulation::system_of(problem));
}

}  // namespace vcrit
