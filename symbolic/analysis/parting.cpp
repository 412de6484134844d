#include "analysis/parting.hpp"

#include "base/errors.hpp"
#include "derivation/derivation.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// What the contact point does for each unit of mu0 times the normal deformation.
ex following(const Model& model) {
  const ex ratio = model.per_friction();
  const auto stiffnesses = model.multiplied_out(ratio);
  return stiffnesses ? ratio.subs(*stiffnesses).normal() : ratio;
}

bool remembers(const ex& following) {
  for (const char* name : {"s", "K_n", "K_t", "K_d"})
    if (following.has(quantity(name))) return true;
  return false;
}

}  // namespace

std::vector<Line> parting_lines(const Scene& scene) {
  if (scene.receptance) return {};
  const Model model(scene);
  const ex ratio = following(model);
  if (remembers(ratio)) return {};
  const ex z = quantity("z"), mu0 = symbol({"mu0"});
  Factors swing;
  swing.multiply_rational(ratio * mu0 * symbol({"du_z"}));
  swing.cancel();
  const ex velocity = omega() * swing.modulus();
  ensure((velocity - derive(scene).critical_velocity).normal().is_zero(),
         "v* of surfaces that part is that of a closed contact");
  return {{"In sliding contact force and friction balance at all times, also apart, where both are "
           "0; so the contact point follows the normal deformation z without memory",
           quantity("y"), ratio * mu0 * z},
          {"While they touch z is the indentation; where it grows fastest, and they touch there, "
           "the contact is slowest, as without parting",
           quantity("v*"), velocity}};
}

}  // namespace vcrit::symbolic
