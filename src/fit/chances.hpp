// What noise alone does to a fit: how often it lowers a misfit, or raises a mean loss, and how far
// it moves what is fitted to few rows.
#pragma once

#include "scene/stiffness_data.hpp"

namespace vcrit::fit {

/// The chance that noise alone makes a sum of squares of so many degrees of freedom so large, each
/// over its known error: chi-squared distributed.
double chance_of_misfit(double sum_of_squares, int degrees);

/// The chance that `more` further parameters lower a sum of squares from `before` to `after` by
/// noise alone; `degrees`: of freedom after. With known errors the fall is chi-squared distributed,
/// else its ratio to the rest is F distributed.
/// Of two fits with as many parameters the nearer one is taken: 0.
double chance_of_fall(double before, double after, int more, int degrees, bool errors_known);

/// The chance below which a better fit is not put down to noise, where there are data enough.
constexpr double significance = 1e-4;
/// How far the misfit must fall, and the chance that this is noise, where there are few.
constexpr double clear_fall = 3, largest_chance = 0.05;
/// The chance below which a longer series is taken that leaves so many degrees of freedom. As the
/// noise is estimated from what is left, a misfit that falls by a factor q (with two parameters
/// more) has a chance of q^-degrees: from 9 degrees on 3 is more than enough, and for fewer rows
/// `significance` would be out of reach.
double level(int degrees);

/// What is known of the noise before any of these data are: stiffness is measured to about 1 % of
/// |K|, as well known as if `usual_degrees` of freedom had shown it. A scaled inverse chi-squared
/// distribution of that kind has 5 % of all noise above 2.4 %, and a thousandth above 6.6 %.
constexpr double usual_error = 0.01;
constexpr int usual_degrees = 4;

/// A chance, and the level below which it is too small for noise.
struct Judgement {
  double chance = 1, level = 0;
  bool clear() const { return chance < level; }
};

/// The chance of such a fall where the noise is estimated together with what is usual.
double chance_with_usual_noise(double before, double after, int more, int degrees);

/// Whether further parameters are more than a fit of noise. Unknown noise is estimated from what is
/// left, and once more together with what is usual: few rows leave too little to tell by, and would
/// pass 10 % of |K| for noise. The clearer of the two is given.
Judgement judgement_of_fall(double before, double after, int more, int degrees, bool errors_known);

/// Whether the losses are above 0 on average by two standard deviations: Student's test, by one
/// side (Gauss's where errors are given). With three or four rows `level` is enough.
bool shows_loss(const StiffnessTable& data);
/// Its chance, that of a normal deviate above 2.
constexpr double two_deviations = 0.02275;

/// The chance for the first branch: one too many is told as poorly known, one too few loses all
/// loss.
constexpr double first_level = 0.01;
/// More than this of |K|, root mean square, is not usually noise.
constexpr double usual_noise = 0.02;

/// A 95 % interval in standard deviations.
constexpr double reach = 1.959963984540054;

/// One standard deviation is estimated from few degrees of freedom: what it must be multiplied by
/// so that 1.96 of it hold the truth in 95 of 100 cases, Student's quantile over Gauss's.
double widening(int degrees);

/// The chance that noise alone makes the mean of the losses times `sign`, as parts of |K|, so
/// large: by Student, or by Gauss where errors are given.
double chance_of_mean(const StiffnessTable& data, double sign);

}  // namespace vcrit::fit
