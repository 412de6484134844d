#include "indenter/half_space.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/rounded.hpp"
#include "normal/mean_indentation.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::indenter {

namespace {

const Indenter& indenter_of(const Problem& problem) {
  rules::require(rules::Question::motion_below_indenter, problem);
  return *problem->indenter;
}

// Cells that hardly open have an amplitude of the normal force just below its mean.
constexpr double nearly_all = 1 - 1e-15;

// Of the half-space: no problem with an indenter is without it.
const Isotropic& isotropic_of(const Problem& problem) {
  return std::get<Isotropic>(problem->tangential);
}

}  // namespace

HalfSpace::HalfSpace(const Problem& problem) : gap_(indenter_of(problem)) {
  const Values& values = problem.values();
  const Isotropic& isotropic = isotropic_of(problem);
  const double poisson = *isotropic.quantity.value;
  normal_ = scaled(relaxation_form(problem->normal.network(), values),
                   1 / ((1 - poisson) * (1 + poisson)));
  ratio_ = vcrit::tangential_ratio(isotropic);
  tangential_ = scaled(normal_, ratio_);
  if (const ReducedNetwork* drive = problem->drive_network())
    holder_ = {relaxation_form(drive->network(), values),
               problem->mass ? values.at(problem->mass->symbol) : 0};
  omega_ = values.at(problem->angular_frequency.symbol);
  friction_ = values.at(problem->coefficient.symbol);
  indentation_ = simulation::mean_indentation(problem);
  amplitude_ = values.at(problem->amplitude.symbol);
  response_ = dynamic_stiffness(normal_, omega_);
  swing_ = amplitude_ * std::abs(response_) / normal_.equilibrium;
}

HalfSpace HalfSpace::within(simulation::SharedEffort& effort) const {
  HalfSpace result = *this;
  result.effort_ = &effort;
  return result;
}

bool HalfSpace::never_opens(double depth) const {
  return depth > 0 && depth >= swing_ * (1 - simulation::least_separation(true));
}

double HalfSpace::neglected(double depth) const {
  return never_opens(depth) ? std::max(0.0, swing_ / depth - 1) : 0;
}

double HalfSpace::static_force(double depth) const {
  const double width = gap_.half_width(depth);
  return depth > 0 ? 2 * normal_.equilibrium * (depth * width - gap_.area(width)) : 0;
}

simulation::System HalfSpace::whole() const {
  const double width = 2 * edge();
  simulation::System system = cell_under(indentation_);
  system.contact = scaled(system.contact, width);
  system.mean_normal_force *= width;
  system.normal_force_amplitude *= width;
  if (system.opening) system.opening->network = scaled(system.opening->network, width);
  if (!holder_) return system;
  system.drive = holder_->drive;
  if (holder_->mass > 0) system.mass = holder_->mass;
  return system;
}

simulation::System HalfSpace::cell_under(double depth) const {
  if (!closes(depth) || !std::isfinite(depth))
    throw InputError(
        argument("x"), fmt::format("a mean indentation of {} there", rounded(depth, "m")),
        fmt::format("one above {}, so that the contact closes", rounded(-amplitude_, "m")));
  simulation::System system;
  system.contact = tangential_;
  system.omega = omega_;
  system.friction = friction_;
  system.effort = effort_;
  if (never_opens(depth)) {
    system.mean_normal_force = normal_.equilibrium * depth;
    system.normal_force_amplitude =
        amplitude_ * response_ * std::min(1.0, nearly_all * depth / swing_);
  } else {
    system.opening = {normal_, depth, amplitude_};
  }
  return system;
}

}  // namespace vcrit::indenter
