#include "rules/kinds.hpp"

#include <complex>

#include "base/constants.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"
#include "normal/mean_indentation.hpp"
#include "normal/mount.hpp"
#include "normal/normal_force.hpp"
#include "rules/rulebook.hpp"
#include "stiffness/at_rest.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit::rules {

namespace {

bool has_lossy_spring(const Problem& problem) {
  bool found = false;
  for_each_element(problem, [&](const Element& element) {
    found = found || (!is_rational(element) && !follows_table(element));
  });
  return found;
}

bool isotropic(const Problem& problem) {
  return std::holds_alternative<Isotropic>(problem->tangential);
}

// A path without mass, damper and branches: the contact velocity is v0 less the rate of the
// friction bound over a stiffness, and the bound is steepest where the closed contact has it; as
// long as it is closed there, which no load makes sure of: its indentation may be below 0.
bool elastic(const Problem& problem) {
  bool only_springs = !problem->mass && problem->receptance() == nullptr;
  for_each_element(
      problem, [&](const Element& element) { only_springs = only_springs && is_elastic(element); });
  return only_springs;
}

// Eq. 24 holds on for an isotropic contact under a rigid drive: in sliding the tangential
// deformations are mu0 K_n/K_t times the normal ones, while closed and while open, so that the
// contact velocity is v0 - mu0 (K_n/K_t) du_z/dt whatever the network; as long as the contact
// is closed where u_z rises fastest, which a surface that creeps back too slowly does not. Below a
// mount what gives along the normal is another network than along the friction.
bool follows_without_memory(const Problem& problem) {
  return problem->indenter || (isotropic(problem) && problem->rigid() && !problem->mount);
}

// Whether the contact may open and its motion is known when it does. It is not known for a vibrator
// on a mount that holds a mass or carries no load, nor for an indenter on a drive that gives: the
// rulebook refuses those, so they are neither kind of separation.
bool parts_with_a_motion(const Problem& problem) {
  return problem->separation && !(problem->mount && (problem->mount_mass || !problem->load)) &&
         !cells_move_one_another(problem);
}

bool all_springs(const ReducedNetwork& network) {
  bool only_springs = true;
  for_each_element(network.network(), [&](const Element& element) {
    only_springs = only_springs && is_elastic(element);
  });
  return only_springs;
}

// u_z = u_z0 + du_z cos(omega t) rises fastest there.
constexpr double steepest_phase = 1.5 * pi;

}  // namespace

const char* name_of(SceneKind kind) {
  switch (kind) {
    case SceneKind::measured_drive:
      return "measured_drive";
    case SceneKind::masses_in_drive:
      return "masses_in_drive";
    case SceneKind::lossy_spring:
      return "lossy_spring";
    case SceneKind::indenter:
      return "indenter";
    case SceneKind::no_indenter:
      return "no_indenter";
    case SceneKind::separating:
      return "separating";
    case SceneKind::separating_without_memory:
      return "separating_without_memory";
    case SceneKind::separating_with_memory:
      return "separating_with_memory";
    case SceneKind::no_static_load:
      return "no_static_load";
    case SceneKind::no_static_load_below_indenter:
      return "no_static_load_below_indenter";
    case SceneKind::no_friction:
      return "no_friction";
    case SceneKind::no_indentation:
      return "no_indentation";
    case SceneKind::tapping:
      return "tapping";
    case SceneKind::never_closing:
      return "never_closing";
    case SceneKind::amplitude_too_large:
      return "amplitude_too_large";
    case SceneKind::deep_amplitude:
      return "deep_amplitude";
    case SceneKind::opening:
      return "opening";
    case SceneKind::opening_below_indenter:
      return "opening_below_indenter";
    case SceneKind::opening_with_memory:
      return "opening_with_memory";
    case SceneKind::open_where_steepest:
      return "open_where_steepest";
    case SceneKind::sinking:
      return "sinking";
    case SceneKind::sinking_opening:
      return "sinking_opening";
    case SceneKind::mount:
      return "mount";
    case SceneKind::separating_mount:
      return "separating_mount";
    case SceneKind::separating_with_mass:
      return "separating_with_mass";
    case SceneKind::indenter_on_drive:
      return "indenter_on_drive";
    case SceneKind::viscoelastic_indenter_on_drive:
      return "viscoelastic_indenter_on_drive";
    case SceneKind::measured_contact:
      return "measured_contact";
  }
  throw Bug("a kind of scene without a name");
}

bool Facts::is(SceneKind kind) const {
  const bool separating = problem_->separation;
  switch (kind) {
    case SceneKind::measured_drive:
      return problem_->receptance() != nullptr;
    case SceneKind::masses_in_drive:
      return drive_resonates(problem_);
    case SceneKind::lossy_spring:
      return has_lossy_spring(problem_);
    case SceneKind::indenter:
      return cells_move(problem_);
    case SceneKind::no_indenter:
      return !cells_move(problem_);
    case SceneKind::separating:
      return separating;
    case SceneKind::separating_without_memory:
      return parts_with_a_motion(problem_) &&
             (elastic(problem_) ? problem_->load.has_value() : follows_without_memory(problem_));
    case SceneKind::separating_with_memory:
      return parts_with_a_motion(problem_) && !elastic(problem_) &&
             !follows_without_memory(problem_);
    case SceneKind::no_static_load:
      return !problem_->indenter && !problem_->load && static_stiffness() == 0;
    case SceneKind::no_static_load_below_indenter:
      return problem_->indenter && static_stiffness() == 0;
    case SceneKind::no_friction:
      return !(value(problem_->coefficient) > 0);
    case SceneKind::no_indentation:
      return !separating && static_stiffness() > 0 && !(mean_force() > 0);
    case SceneKind::tapping:
      return separating && !(indentation() > 0) && contact_amplitude(problem_) > 0;
    case SceneKind::never_closing:
      return !(indentation() + contact_amplitude(problem_) > 0);
    case SceneKind::amplitude_too_large:
      return !separating && !(contact_amplitude(problem_) < indentation());
    case SceneKind::deep_amplitude:
      return separating && !(contact_amplitude(problem_) < indentation());
    case SceneKind::opening:
      return !separating && !problem_->indenter && mean_force() > 0 &&
             !(oscillating_force() < mean_force());
    case SceneKind::opening_below_indenter:
      return !separating && problem_->indenter && mean_force() > 0 &&
             !(oscillating_force() < mean_force());
    case SceneKind::opening_with_memory:
      return is(SceneKind::separating_with_memory) && opens() && !is(SceneKind::no_friction);
    case SceneKind::open_where_steepest:
      return is(SceneKind::separating_without_memory) && opens() && !is(SceneKind::no_friction) &&
             !sinks() && open_where_steepest();
    case SceneKind::sinking:
      return sinks();
    case SceneKind::sinking_opening:
      return sinks() && separating && opens();
    case SceneKind::mount:
      return problem_->mount.has_value();
    case SceneKind::separating_mount:
      return separating && problem_->mount && !problem_->mount_mass && !problem_->load;
    case SceneKind::separating_with_mass:
      return separating && problem_->mount && problem_->mount_mass;
    case SceneKind::indenter_on_drive:
      return cells_move_one_another(problem_);
    case SceneKind::viscoelastic_indenter_on_drive:
      return cells_move_one_another(problem_) &&
             problem_->indenter->shape != Indenter::Shape::flat && !all_springs(problem_->normal);
    case SceneKind::measured_contact:
      return !problem_->measured.empty();
  }
  throw Bug("a kind of scene without a rule");
}

bool Facts::sinks() const { return load_is_mean_force(problem_) && static_stiffness() == 0; }

bool Facts::depth_falls_with_amplitude() const { return problem_->load && problem_->indenter; }

bool Facts::open_where_steepest() const {
  require(Question::normal_motion, problem_);
  if (oscillating_force() <=
      (1 + simulation::least_separation(problem_->indenter.has_value())) * mean_force())
    return false;
  return !simulation::touches_at(simulation::opening_motion(problem_),
                                 value(problem_->angular_frequency), steepest_phase);
}

long double Facts::static_stiffness() const {
  if (!static_stiffness_)
    static_stiffness_ = at_rest(problem_->normal.reduction(), problem_.values()).stiffness();
  return *static_stiffness_;
}

long double Facts::mean_force() const {
  if (load_is_mean_force(problem_)) return value(*problem_->load);
  return static_stiffness() * indentation();
}

double Facts::indentation() const {
  if (!problem_->load) return value(problem_->indentation);
  if (problem_->indenter)
    return static_stiffness() > 0 ? simulation::mean_indentation(problem_) : 0;
  return static_cast<double>(value(*problem_->load) / static_stiffness());
}

long double Facts::oscillating_force() const {
  if (!oscillating_)
    oscillating_ = std::abs(wide_dynamic_stiffness(problem_->normal.reduction(), problem_.values(),
                                                   value(problem_->angular_frequency))) *
                   contact_amplitude(problem_);
  return *oscillating_;
}

bool cells_move(const Problem& problem) { return problem->indenter.has_value(); }

bool cells_move_one_another(const Problem& problem) {
  return cells_move(problem) && !problem->rigid();
}

bool load_is_mean_force(const Problem& problem) { return problem->load && !cells_move(problem); }

bool drive_resonates(const Problem& problem) { return problem->has_masses(); }

bool may_open(const Problem& problem) { return problem->separation || cells_move(problem); }

}  // namespace vcrit::rules
