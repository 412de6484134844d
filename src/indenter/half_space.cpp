#include "indenter/half_space.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/errors.hpp"

namespace vcrit::indenter {

namespace {

const Indenter& indenter_of(const Scene& scene) {
  if (!scene.indenter) throw ModelError("the scene has no indenter");
  values_of(scene);
  return *scene.indenter;
}

// Cells that part by less than this of their indentation are taken for closed, with an amplitude of
// the normal force just below its mean. They would be apart for some 1e-4 of a period, and where a
// strongly damped surface hardly parts the simulator finds no steady normal force.
constexpr double hardly_parting = 1e-8, nearly_all = 1 - 1e-15;

// Of the half-space; the reader of scenes lets no indenter stand without it.
const Isotropic& isotropic_of(const Scene& scene) {
  const auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
  ensure(isotropic != nullptr && isotropic->by == Isotropic::By::poisson,
         "an indenter's half-space has a Poisson's ratio");
  return *isotropic;
}

}  // namespace

HalfSpace::HalfSpace(const Scene& scene) : gap_(indenter_of(scene)) {
  const Values values = values_of(scene);
  const Isotropic& isotropic = isotropic_of(scene);
  const double poisson = *isotropic.quantity.value;
  normal_ = scaled(relaxation_form(scene.normal, values), 1 / ((1 - poisson) * (1 + poisson)));
  tangential_ = scaled(normal_, tangential_ratio(isotropic));
  omega_ = values.at(scene.angular_frequency.symbol);
  friction_ = values.at(scene.coefficient.symbol);
  indentation_ = values.at(scene.indentation.symbol);
  amplitude_ = values.at(scene.amplitude.symbol);
  if (!(normal_.equilibrium > 0))
    throw ModelError("the half-space carries no static load: E(0) = 0");
  response_ = dynamic_stiffness(normal_, omega_);
  swing_ = amplitude_ * std::abs(response_) / normal_.equilibrium;
  require_admissible(scene);
}

void HalfSpace::require_admissible(const Scene& scene) const {
  if (!(friction_ > 0))
    throw ModelError(fmt::format("with {} = 0 there is no friction to compare with",
                                 name_in(scene, scene.coefficient)));
  if (!(indentation_ + amplitude_ > 0)) throw ModelError("the surfaces never meet");
  if (scene.separation) return;
  if (!(amplitude_ < indentation_))
    throw ModelError(beyond_indentation(scene, amplitude_, indentation_));
  if (!(swing_ < indentation_))
    throw ModelError(fmt::format(
        "the contact opens all over: at the tip F_n oscillates by {:.6g} times its mean (4)",
        swing_ / indentation_));
}

bool HalfSpace::never_parts(double depth) const {
  return depth > 0 && depth >= swing_ * (1 - hardly_parting);
}

double HalfSpace::neglected(double depth) const {
  return never_parts(depth) ? std::max(0.0, swing_ / depth - 1) : 0;
}

simulation::System HalfSpace::cell_under(double depth) const {
  ensure(meets(depth), "the surfaces meet there");
  simulation::System system;
  system.contact = tangential_;
  system.omega = omega_;
  system.friction = friction_;
  if (never_parts(depth)) {
    system.mean_normal_force = normal_.equilibrium * depth;
    system.normal_force_amplitude =
        amplitude_ * response_ * std::min(1.0, nearly_all * depth / swing_);
  } else {
    system.opening = {normal_, depth, amplitude_};
  }
  return system;
}

}  // namespace vcrit::indenter
