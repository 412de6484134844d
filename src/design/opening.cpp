#include "design/opening.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <cstdint>

#include "answers/critical_onset.hpp"
#include "answers/effect.hpp"
#include "base/constants.hpp"
#include "normal/mean_indentation.hpp"
#include "normal/mount.hpp"
#include "normal/pressed_cells.hpp"
#include "problem/variants.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit::design {

namespace {

// Any value will do where none is asked for.
Problem complete(const Problem& problem) {
  Values any;
  const auto complete = [&any](const Quantity& quantity) {
    if (!quantity.value) any[quantity.symbol] = 1;
  };
  complete(problem->amplitude);
  complete(problem->angular_frequency);
  if (problem->load) complete(*problem->load);
  return problem.with(any);
}

double at_infinity(const Relaxation& form) {
  if (form.damper > 0) return infinity;
  double sum = form.equilibrium;
  for (const MaxwellBranch& branch : form.branches) sum += branch.stiffness;
  return sum;
}

}  // namespace

NormalContact::NormalContact(const Problem& problem) : problem_(complete(problem)) {
  const Values& values = problem_.values();
  normal_ = relaxation_form(problem->normal.network(), values);
  mean_force_ = simulation::closed_mean_force(problem_, normal_.equilibrium);
  // Whatever the amplitude: below an indenter it changes what is found of a load, and may be none
  // yet.
  rules::require(rules::Question::mean_load, with_amplitude(problem_, 0));
}

double NormalContact::largest_amplitude(double omega) const {
  if (pressed_tip()) {
    const auto most = largest_closed_amplitude(with_angular_frequency(problem_, omega));
    return most.value_or(0);
  }
  return mean_force_ /
         (std::abs(dynamic_stiffness(normal_, omega)) * mount_factor(problem_, omega));
}

// At no amplitude, so that none is too large: what is left to say is of the scene's structure.
bool NormalContact::closes_up_to_a_frequency() const {
  const rules::Answer found =
      rules::answer(rules::Question::closed_range, with_amplitude(problem_, 0));
  return found.verdict != rules::Ruling::left_out;
}

std::optional<double> NormalContact::largest_angular_frequency(double amplitude) const {
  rules::require(rules::Question::closed_range, with_amplitude(problem_, amplitude));
  if (pressed_tip()) return largest_of_pressed_tip(amplitude);
  // Below the amplitude, the indentation may round to it.
  const double allowed =
      std::max(mean_force_ / amplitude, std::nextafter(normal_.equilibrium, infinity));
  if (at_infinity(normal_) <= allowed) return std::nullopt;
  const auto above = [&](double logarithm) {
    return std::log(std::abs(dynamic_stiffness(normal_, std::exp(logarithm))) / allowed);
  };
  double low = 0, high = 0;
  for (double step = 1; above(low) >= 0; step *= 2) low -= step;
  for (double step = 1; above(high) <= 0 && high < 700; step *= 2) high += step;
  if (high >= 700) return std::nullopt;
  std::uintmax_t steps = 200;
  return std::exp(boost::math::tools::toms748_solve(
                      above, low, high, boost::math::tools::eps_tolerance<double>(50), steps)
                      .first);
}

bool NormalContact::pressed_tip() const {
  return rules::Facts(problem_).depth_falls_with_amplitude();
}

// The depth under the load depends on the frequency, too, as the rim opens. |E| never falls.
std::optional<double> NormalContact::largest_of_pressed_tip(double amplitude) const {
  if (at_infinity(normal_) <= normal_.equilibrium) return std::nullopt;
  const Problem problem = with_amplitude(problem_, amplitude);
  const auto above = [&](double logarithm) {
    const rules::Facts facts(with_angular_frequency(problem, std::exp(logarithm)));
    return static_cast<double>(facts.oscillating_force() / facts.mean_force()) - 1;
  };
  constexpr double decades = 12 * 2.3;  // to either side, as far as branches are worth a thought
  const double here = std::log(problem.value(problem->angular_frequency));
  double low = here, high = here;
  for (double step = 1; above(low) >= 0; step *= 2)
    if ((low -= step) < here - decades)
      throw ModelError("the contact opens at its centre at all frequencies");
  for (double step = 1; above(high) <= 0; step *= 2)
    if ((high += step) > here + decades) return std::nullopt;
  constexpr int bits = 40;  // a depth is known to some 33
  std::uintmax_t steps = 100;
  return std::exp(boost::math::tools::toms748_solve(
                      above, low, high, boost::math::tools::eps_tolerance<double>(bits), steps)
                      .first);
}

double NormalContact::least_force(double amplitude, double omega) const {
  if (pressed_tip()) {
    const double depth =
        amplitude * std::abs(dynamic_stiffness(normal_, omega)) / normal_.equilibrium;
    const Problem there = with_angular_frequency(with_amplitude(problem_, amplitude), omega);
    return simulation::mean_force_of_cells(at_depth(there, depth));
  }
  return amplitude * std::abs(dynamic_stiffness(normal_, omega)) * mount_factor(problem_, omega);
}

double NormalContact::oscillating_part(double amplitude, double omega) const {
  return amplitude / largest_amplitude(omega);
}

// What a search came to is no mistake of the scene's numbers.

Problem with_amplitude(const Problem& problem, double amplitude) {
  require_si_doubles(std::isfinite(amplitude));
  return problem.with({{problem->amplitude.symbol, amplitude}});
}

Problem with_load(const Problem& problem, double force) {
  if (!problem->load)
    throw InputError(argument("for force"), "a scene without [load]",
                     "[load] with force = \"20 N\", in place of the indentation");
  require_si_doubles(std::isfinite(force) && force > 0);
  return problem.with({{problem->load->symbol, force}});
}

Problem with_angular_frequency(const Problem& problem, double omega) {
  return problem.with({{problem->angular_frequency.symbol, omega}});
}

double reduced_up_to(const Problem& problem) { return critical_onset(problem).drive_velocity; }

}  // namespace vcrit::design
