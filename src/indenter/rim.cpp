#include "indenter/rim.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::indenter {

ScaledContact::ScaledContact(const HalfSpace& half_space, double tolerance)
    : gap_(half_space.gap()),
      amplitude_(half_space.amplitude()),
      modulus_(half_space.elastic() ? half_space.static_modulus() : half_space.dynamic_modulus()),
      mean_(half_space.indentation() / half_space.amplitude()) {
  if (gap_.at(gap_.end()) < half_space.indentation() + amplitude_)
    throw ModelError(
        "the contact reaches the last row of the profile's table: below an indenter with an edge, "
        "on a drive that gives, no motion is known",
        "a table up to a larger radius");
  const double ratio = half_space.shear_ratio();
  force_unit_ = physical_force(amplitude_ * (1 + mean_));
  speed_unit_ = half_space.friction() / ratio * amplitude_ * half_space.omega();
  stiffness_unit_ = ratio * force_unit_ / amplitude_;
  kinks_ = {0, pi, two_pi};
  std::vector<double> depths{0};
  for (const double x : gap_.edges()) depths.push_back(gap_.at(x) / amplitude_);
  for (const double each : depths)
    if (const double cosine = each - mean_; std::abs(cosine) < 1)
      kinks_.insert(kinks_.end(), {std::acos(cosine), two_pi - std::acos(cosine)});
  if (!half_space.elastic()) {
    memory_ = std::make_shared<const MemoryForce>(half_space, tolerance);
    kinks_.insert(kinks_.end(), memory_->kinks().begin(), memory_->kinks().end());
  }
  std::sort(kinks_.begin(), kinks_.end());
}

double ScaledContact::depth(double t) const { return mean_ + std::cos(t); }

double ScaledContact::depth_rate(double t) const { return -std::sin(t); }

/// Of cells up to there.
double ScaledContact::stiffness_of(double edge) const {
  return 2 * modulus_ * amplitude_ / force_unit_ * edge;
}

double ScaledContact::stiffness(double depth) const {
  return depth >= 0 ? stiffness_of(gap_.half_width(depth * amplitude_)) : 0;
}

double ScaledContact::physical_force(double depth) const {
  if (!(depth > 0)) return 0;
  const double edge = gap_.half_width(depth);
  return 2 * modulus_ * (depth * edge - gap_.area(edge));
}

ScaledContact::Moment ScaledContact::at(double t) const {
  Moment now = depths_at(t);
  double edge = 0;
  if (now.depth >= 0) {
    edge = gap_.half_width(now.depth * amplitude_);
    now.stiffness = stiffness_of(edge);
  }
  if (memory_) {
    const MemoryForce::Sum found = memory_->at(t);
    now.force = found.force / force_unit_;
    now.force_rate = found.rate / force_unit_;
    return now;
  }
  if (const double deep = now.depth * amplitude_; deep > 0)
    now.force = 2 * modulus_ * (deep * edge - gap_.area(edge)) / force_unit_;
  now.force_rate = now.stiffness * now.depth_rate;
  return now;
}

bool ScaledContact::touches(double t) const {
  return memory_ ? memory_->touches(t) : depth(t) >= 0;
}

ScaledHolder::ScaledHolder(const HalfSpace& half_space, const ScaledContact& contact) {
  const double omega = half_space.omega(), unit = contact.stiffness_unit();
  const Holder& holder = *half_space.holder();
  spring = holder.drive.equilibrium / unit;
  damper = holder.drive.damper * omega / unit;
  mass = holder.mass * omega * omega / unit;
  for (const MaxwellBranch& branch : holder.drive.branches)
    branches.push_back({branch.stiffness / unit, branch.time * omega});
}

double ScaledHolder::glassy() const {
  double sum = spring;
  for (const MaxwellBranch& branch : branches) sum += branch.stiffness;
  return sum;
}

}  // namespace vcrit::indenter
