// Friction as v0 -> 0. With k = omega = mu0 <F_n> = 1 and c = delta, the contact sticks nearly
// always, and slips for a short time about the minimum of its bound, 1 - a + a t^2/2. There its
// velocity is (b(t1) - b(t))/delta to leading order, and in a period it has to go 2 pi v0:
//   (2/3) a t1^3/delta = 2 pi v0   =>   t1^3 = 3 pi delta v,  v0 = v a/sqrt(1 + delta^2), so that
//   mu_macro/mu0 = 1 - a + (a/2) (3 pi sin(atan delta) v)^(2/3) + O(v),
// an approach with the power 2/3 (delta = 0: with 1, G'(0) = -pi).
// The reduced model at v = 0: stick from pi to tau2 = 2 pi + 2 atan(1/delta), hence
//   1 - D (delta + pi/2 + atan(1/delta))/pi,
// and its slope is D (x^2/2 + delta x)/(2 pi) with x <= 2 pi the length of stick.
#include <fmt/core.h>

#include <cmath>

#include "base/constants.hpp"
#include "paper/comparing.hpp"
#include "paper/limits.hpp"
#include "paper/motions.hpp"
#include "paper/references.hpp"

namespace vcrit::validation::paper {

namespace {

constexpr double near_rest = 1e-9;  // of v*; what is left goes with its power of 2/3, 1e-6

double leading(double delta, double ratio) {
  return reference_amplitude / 2 * std::pow(3 * pi * delta / std::hypot(1, delta) * ratio, 2 / 3.0);
}

double reduced_limit(double delta) {
  return 1 -
         reference_amplitude / std::hypot(1, delta) * (delta + pi / 2 + std::atan(1 / delta)) / pi;
}

StaticRow row_of(double delta, const std::vector<double>& ratios) {
  StaticRow row{delta, 1 - reference_amplitude, {}, {}, {}, reduced_limit(delta)};
  for (const double ratio : ratios) {
    row.full.push_back(full_friction(delta, reference_amplitude, ratio));
    row.reduced.push_back(reduced_friction(delta, reference_amplitude, ratio));
  }
  for (std::size_t i = 1; i < ratios.size(); ++i)
    row.slopes.push_back(std::log((row.full[i] - row.limit) / (row.full[i - 1] - row.limit)) /
                         std::log(ratios[i] / ratios[i - 1]));
  return row;
}

Comparison full_at_rest(double delta) {
  return comparison(
      {"static_full", fmt::format("full motion at v₀/v* = 10⁻⁹, δ = {}", delta),
       "min F_n/⟨F_n⟩ = 1 − D √(1 + δ²)",
       "twice the leading term of what is left at this speed, (a/2)(3π δ/√(1 + δ²) v₀/v*)^⅔"},
      {1 - reference_amplitude, full_friction(delta, reference_amplitude, near_rest),
       2 * leading(delta, near_rest), ""});
}

/// Relative to the leading term come: the rise in stick, pi D v, 2 pi/(sqrt(1 + delta^2) (3 pi
/// sin(atan delta))^(2/3)) v^(1/3); the spring's part in the slip, (4/3) t1/delta; the dip in the
/// slip, t1/5. For delta >= 1 that is at most 1.3, 2.6 and 0.5 times v^(1/3), in all below 5.
Comparison approach(double delta) {
  const double found =
      full_friction(delta, reference_amplitude, near_rest) - (1 - reference_amplitude);
  return comparison({"static_rate", fmt::format("what is left at v₀/v* = 10⁻⁹, δ = {}", delta),
                     "its leading term, of power ⅔", "the next terms, in all below 5 (v₀/v*)^⅓",
                     Comparison::Measure::relative},
                    {leading(delta, near_rest), found, 5 * std::cbrt(near_rest), ""});
}

Comparison reduced_at_rest(double delta) {
  const double ratio = 1e-6, d = reference_amplitude / std::hypot(1, delta);
  return comparison({"static_reduced", fmt::format("reduced model at v₀/v* = 10⁻⁶, δ = {}", delta),
                     "1 − D (δ + π/2 + atan 1/δ)/π", "its slope is below D (π + δ)"},
                    {reduced_limit(delta), reduced_friction(delta, reference_amplitude, ratio),
                     d * (pi + delta) * ratio, ""});
}

/// At rest and the largest amplitude, a = 1: in the full motion nothing is left.
Comparison reduced_remainder(double delta, double expected) {
  return comparison({"reduced_remainder",
                     fmt::format("what the reduced model leaves at rest and D_max, δ = {}", delta),
                     "13 digits, computed apart", "a unit of the last digit given"},
                    {expected, 1 - (1 - reduced_limit(delta)) / reference_amplitude, 1e-13, ""});
}

}  // namespace

StaticLimit approach_rest() {
  StaticLimit result{reference_amplitude, {1e-2, 1e-3, 1e-4}, {}, {}};
  for (const double delta : figure4_deltas) {
    result.rows.push_back(row_of(delta, result.ratios));
    result.comparisons.push_back(full_at_rest(delta));
    result.comparisons.push_back(approach(delta));
    result.comparisons.push_back(reduced_at_rest(delta));
  }
  for (const RestReference& row : rest_references())
    result.comparisons.push_back(reduced_remainder(row.delta, row.friction));
  return result;
}

}  // namespace vcrit::validation::paper
