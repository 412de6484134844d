// How no event is missed: a march with steps during which f provably stays below zero. From a point
// t on, f(t + x) is bounded from above, for 0 <= x <= h, by a polynomial in x:
//   * slow terms (rate h <= 2): Taylor's, with the largest derivative on the interval in place of
//   the
//     last coefficient; for a decaying exponential it is taken at the end where it is largest, for
//     a pair of modes or the sinusoid from the next derivative's amplitude;
//   * fast decays (rate h > 2): as intervals. Their integral from t is monotone, so it lies between
//     0 and its limit; a negative one is convex, so it lies below its chord;
//   * fast pairs: by their amplitude.
// In Bernstein's form the polynomial lies below the hull of its coefficients; the step goes to the
// hull's first zero. As the bound is exact to fifth order, steps converge on a simple zero of f in
// a few evaluations, always from below; at a maximum below zero they pass over it.
#pragma once

#include <optional>

#include "modes/event_function.hpp"

namespace vcrit::simulation {

/// The first t in (0, end] where f, negative before, reaches 0; nothing if it stays negative. With
/// `leaving`, f(0) = 0 does not count. Zeros at which f only touches 0 within rounding are passed.
std::optional<double> first_zero(EventFunction& f, double end, bool leaving);

/// The same where f leaves 0 at t = 0 and has to be below it at once. Where its slope there says
/// that it is not, but f is below a touch later, that slope is what a mode that relaxes at once
/// left of its rounding, and does not count: nothing is gained or lost over so short a time.
std::optional<double> first_zero_after_leaving(EventFunction& f, double end);

}  // namespace vcrit::simulation
