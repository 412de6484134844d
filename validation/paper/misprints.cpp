// (43) and (41) tried on the steady motion of an elastic contact, with F_n = 1 + a cos tau.
// Velocity of the contact point over mu0 omega du_z k_n/k_t where stick begins, at tau1:
//   (43) vbar + cos tau1 = 0;       from (42) put into (34), and (50): vbar + sin tau1 = 0.
// Force of the stuck contact less the bound where stick ends, at tau2, over a:
//   (41) vbar (tau2 - tau1) + cos tau2 - cos tau2;   (48): vbar (tau2 - tau1) + cos tau1 - cos
//   tau2.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "paper/comparing.hpp"
#include "paper/misprints.hpp"
#include "paper/motions.hpp"
#include "paper/references.hpp"

namespace vcrit::validation::paper {

namespace {

constexpr double tried_ratio = 0.5;  // of v*, where neither stick nor slip is short

/// Phase of the first event of this kind.
double phase_of(const simulation::SteadyState& state, simulation::Motion to) {
  const auto event = std::find_if(state.events.begin(), state.events.end(),
                                  [&](const auto& each) { return each.to == to; });
  if (event == state.events.end()) throw Bug("no such event below v*");
  return event->phase;
}

}  // namespace

Misprints try_misprints() {
  const auto motion = full_motion(0, reference_amplitude, tried_ratio);
  const double tau1 = phase_of(motion, simulation::Motion::stick);
  double tau2 = phase_of(motion, simulation::Motion::slip);
  if (tau2 < tau1) tau2 += two_pi;
  const double risen = tried_ratio * (tau2 - tau1);
  Misprints result;
  result.velocity_as_printed = tried_ratio + std::cos(tau1);
  result.force_as_printed = risen;
  // The simulator finds events to some roundings of a period.
  constexpr double rounding = 4e-14;
  const char* reason = "events are found to some roundings of 2π";
  result.comparisons = {
      comparison(
          {"stick_begins", "contact velocity where stick begins, (43) with sin", "0", reason},
          {0, tried_ratio + std::sin(tau1), rounding, ""}),
      comparison(
          {"stick_force", "force where stick ends less its bound, (41) with cos ωt₁", "0", reason},
          {0, risen + std::cos(tau1) - std::cos(tau2), rounding, ""})};
  return result;
}

}  // namespace vcrit::validation::paper
