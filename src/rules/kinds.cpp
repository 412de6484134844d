#include "rules/kinds.hpp"

#include <complex>

#include "base/constants.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"
#include "normal/normal_force.hpp"
#include "rules/rulebook.hpp"
#include "stiffness/at_rest.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit::rules {

namespace {

bool has_lossy_spring(const Scene& scene) {
  bool found = false;
  for_each_element(scene, [&](const Element& element) { found = found || !is_rational(element); });
  return found;
}

bool isotropic(const Scene& scene) { return std::holds_alternative<Isotropic>(scene.tangential); }

// A path without mass, damper and branches: the contact velocity is v0 less the rate of the
// friction bound over a stiffness, and the bound is steepest where the closed contact has it.
bool elastic(const Scene& scene) {
  bool only_springs = !scene.mass && !scene.receptance;
  for_each_element(
      scene, [&](const Element& element) { only_springs = only_springs && is_elastic(element); });
  return only_springs;
}

// Eq. 24 holds on for an isotropic contact under a rigid drive: in sliding the tangential
// deformations are mu0 K_n/K_t times the normal ones, while touching and while apart, so that the
// contact velocity is v0 - mu0 (K_n/K_t) du_z/dt whatever the network; as long as the surfaces
// touch where u_z rises fastest, which a surface that creeps back too slowly does not.
bool follows_without_memory(const Scene& scene) {
  return scene.indenter || (isotropic(scene) && !has_drive(scene));
}

// u_z = u_z0 + du_z cos(omega t) rises fastest there.
constexpr double steepest_phase = 1.5 * pi;

}  // namespace

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::measured_drive:
      return "measured_drive";
    case Kind::masses_in_drive:
      return "masses_in_drive";
    case Kind::lossy_spring:
      return "lossy_spring";
    case Kind::indenter:
      return "indenter";
    case Kind::no_indenter:
      return "no_indenter";
    case Kind::separating:
      return "separating";
    case Kind::separating_while_touching:
      return "separating_while_touching";
    case Kind::separating_with_memory:
      return "separating_with_memory";
    case Kind::no_static_load:
      return "no_static_load";
    case Kind::no_static_load_below_indenter:
      return "no_static_load_below_indenter";
    case Kind::no_friction:
      return "no_friction";
    case Kind::no_indentation:
      return "no_indentation";
    case Kind::tapping:
      return "tapping";
    case Kind::never_meeting:
      return "never_meeting";
    case Kind::jumping:
      return "jumping";
    case Kind::deep_amplitude:
      return "deep_amplitude";
    case Kind::opening:
      return "opening";
    case Kind::opening_below_indenter:
      return "opening_below_indenter";
    case Kind::opening_with_memory:
      return "opening_with_memory";
    case Kind::apart_where_steepest:
      return "apart_where_steepest";
  }
  throw Bug("a kind of scene without a name");
}

bool Facts::is(Kind kind) const {
  const bool separating = scene_.separation;
  switch (kind) {
    case Kind::measured_drive:
      return scene_.receptance.has_value();
    case Kind::masses_in_drive:
      return scene_.drive && has_masses(*scene_.drive);
    case Kind::lossy_spring:
      return has_lossy_spring(scene_);
    case Kind::indenter:
      return scene_.indenter.has_value();
    case Kind::no_indenter:
      return !scene_.indenter;
    case Kind::separating:
      return separating;
    case Kind::separating_while_touching:
      return separating && !elastic(scene_) && follows_without_memory(scene_);
    case Kind::separating_with_memory:
      return separating && !elastic(scene_) && !follows_without_memory(scene_);
    case Kind::no_static_load:
      return !scene_.indenter && static_stiffness() == 0;
    case Kind::no_static_load_below_indenter:
      return scene_.indenter && static_stiffness() == 0;
    case Kind::no_friction:
      return !(value(scene_.coefficient) > 0);
    case Kind::no_indentation:
      return !separating && static_stiffness() > 0 && !(mean_force() > 0);
    case Kind::tapping:
      return separating && !(value(scene_.indentation) > 0) && value(scene_.amplitude) > 0;
    case Kind::never_meeting:
      return !(value(scene_.indentation) + value(scene_.amplitude) > 0);
    case Kind::jumping:
      return !separating && !(value(scene_.amplitude) < value(scene_.indentation));
    case Kind::deep_amplitude:
      return separating && !(value(scene_.amplitude) < value(scene_.indentation));
    case Kind::opening:
      return !separating && !scene_.indenter && mean_force() > 0 &&
             !(oscillating_force() < mean_force());
    case Kind::opening_below_indenter:
      return !separating && scene_.indenter && mean_force() > 0 &&
             !(oscillating_force() < mean_force());
    case Kind::opening_with_memory:
      return is(Kind::separating_with_memory) && opens() && !is(Kind::no_friction);
    case Kind::apart_where_steepest:
      return is(Kind::separating_while_touching) && opens() && !is(Kind::no_friction) &&
             apart_where_steepest();
  }
  throw Bug("a kind of scene without a rule");
}

bool Facts::apart_where_steepest() const {
  require(Question::normal_motion, scene_);
  if (oscillating_force() <=
      (1 + simulation::hardly_parting(scene_.indenter.has_value())) * mean_force())
    return false;
  const simulation::NormalMotion motion{relaxation_form(scene_.normal, values()),
                                        value(scene_.indentation), value(scene_.amplitude)};
  return !simulation::touches_at(motion, value(scene_.angular_frequency), steepest_phase);
}

const Values& Facts::values() const {
  if (!values_) values_ = values_of(scene_);
  return *values_;
}

long double Facts::static_stiffness() const {
  if (!static_stiffness_) static_stiffness_ = at_rest(scene_.normal, values()).stiffness();
  return *static_stiffness_;
}

long double Facts::mean_force() const { return static_stiffness() * value(scene_.indentation); }

long double Facts::oscillating_force() const {
  if (!oscillating_)
    oscillating_ =
        std::abs(wide_dynamic_stiffness(scene_.normal, values(), value(scene_.angular_frequency))) *
        value(scene_.amplitude);
  return *oscillating_;
}

}  // namespace vcrit::rules
