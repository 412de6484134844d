#include "simulation/steady/far_apart.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace vcrit::simulation {

namespace {

// By how much a force is at most, for a displacement that oscillates by 1. All in one unit.
struct PartSize {
  const char* of;
  double value = 0;
};

double largest_stiffness(double first, ConstView others) {
  for (const double other : others) first = std::max(first, other);
  return first;
}

List<PartSize> sizes(const Model& model) {
  List<PartSize> all{{"the stiffness of the contact",
                      largest_stiffness(model.contact.damper, model.contact.branch_stiffness)}};
  if (!model.body) return all;
  const PoleSum& drive = model.body->drive;
  all.push_back({"the body's inertia m omega^2", model.body->mass});
  if (!model.body->masses)
    all.push_back({"the stiffness of the drive", largest_stiffness(drive.direct, drive.weights)});
  return all;
}

}  // namespace

void no_motion_found(const Model& model, const ModelError& last) {
  const auto all = sizes(model);
  const auto [least, most] =
      std::minmax_element(all.begin(), all.end(),
                          [](const PartSize& a, const PartSize& b) { return a.value < b.value; });
  const double orders = std::log10(most->value) - std::log10(least->value);
  if (!(least->value > 0 && orders > -std::log10(epsilon))) throw ModelError(last);
  throw ModelError(
      fmt::format("no steady state found: {} lies {:.0f} orders of magnitude below {}, so rounding "
                  "hides what it does",
                  least->of, orders, most->of),
      "leave out what does not matter, or give values fewer orders of magnitude apart");
}

void no_motion_found(const Model& model, double velocity, const ModelError& last) {
  // Cycles close within a thousand roundings of the swing, of which so slow a drive moves less.
  constexpr double slowest = 1e4 * epsilon;
  const double share = velocity / std::abs(model.sliding_velocity);
  if (model.creep == 0 && share < slowest)
    throw ModelError(
        fmt::format("no steady state found: the drive is so slow, {:.1g} of the contact's velocity "
                    "in steady sliding, that rounding hides how far it moves in a period",
                    share),
        "take a higher speed: so far below v* friction is hardly above its limit at rest");
  no_motion_found(model, last);
}

}  // namespace vcrit::simulation
