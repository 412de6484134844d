#include "analysis/separation.hpp"

#include "base/errors.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// What the contact point does for each unit of mu0 times the normal deformation.
ex following(const SymbolicModel& model) {
  const ex ratio = model.per_friction();
  const auto stiffnesses = model.multiplied_out(ratio);
  return stiffnesses ? ratio.subs(*stiffnesses).normal() : ratio;
}

// Whether the formula is v* of the scene, as far as its values are there to tell.
bool holds(const Problem& problem) {
  if (!rules::answer(rules::Question::closed_form, problem)) return false;
  try {
    return bool{rules::answer(rules::Question::formula, problem)};
  } catch (const InputError&) {
    return true;  // as long as the contact is closed there, as the line says
  } catch (const ModelError&) {
    return true;
  }
}

}  // namespace

std::vector<Line> separation_lines(const Derivation& derivation) {
  const AlgebraLock lock;
  const Problem& problem = derivation.problem;
  if (!problem->separation || !holds(problem)) return {};
  const bool always{rules::answer(rules::Question::formula_of_all_values, problem)};
  const ex ratio = following(*derivation.model);
  for (const char* name : {"s", "K_n", "K_t", "K_d"})
    ensure(!ratio.has(quantity(name)), "the contact point follows without memory");
  const ex z = quantity("z"), mu0 = symbol({"mu0"});
  Factors swing;
  swing.multiply_rational(ratio * mu0 * symbol({"du_z"}));
  swing.cancel();
  const ex velocity = omega() * swing.modulus();
  ensure((velocity - derivation.critical_velocity).normal().is_zero(),
         "v* of a contact that opens is that of a closed one");
  const bool mounted = problem->mount.has_value();  // without mass: in series with the contact
  const Prose closed{
      "While the contact is closed, ",
      z,
      mounted ? " is what the vibrator prescribes" : " is the indentation",
      "; where it grows fastest",
      always ? " the contact is closed, and" : ", as long as the contact is closed there,",
      " the contact point is slowest, as without separation"};
  return {{{"In sliding contact force and friction balance at all times, also while the contact is "
            "open and both are 0; so the contact point follows the normal deformation ",
            z, mounted ? " of mount and contact together" : "", " without memory"},
           quantity("y"),
           ratio * mu0 * z},
          {closed, quantity("v*"), velocity}};
}

}  // namespace vcrit::symbolic
