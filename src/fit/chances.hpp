// What noise alone does to a fit: how often it lowers a misfit, or raises a mean loss, and how far
// it moves what is fitted to few rows.
#pragma once

#include "fit/data.hpp"

namespace vcrit::fit {

/// The chance that `more` further parameters lower a sum of squares from `before` to `after` by
/// noise alone; `degrees`: of freedom after. With known errors the fall is chi-squared distributed,
/// else its ratio to the rest is F distributed.
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

/// Whether the losses, as parts of |K|, are above 0 on average by more than their scatter explains:
/// Student's test, by one side (Gauss's where errors are given).
bool shows_loss(const Data& data);

/// The same chance for the first branch: one too many is told as poorly known, one too few loses
/// all loss.
constexpr double first_level = 0.01;
/// And where few rows leave more than `usual_noise` (of |K|, root mean square) to a lone spring:
/// stiffness is measured better than that.
constexpr double doubtful_level = 0.3, usual_noise = 0.02;
/// For any series that would have to put so much (of |K|) down to noise: the larger it is beyond
/// the usual, the less is it to be believed.
double level_at(double noise);

/// One standard deviation is estimated from few degrees of freedom: what it must be multiplied by
/// so that 1.96 of it hold the truth in 95 of 100 cases, Student's quantile over Gauss's.
double widening(int degrees);

/// The chance that noise alone makes the mean of the losses times `sign`, as parts of |K|, so
/// large: by Student, or by Gauss where errors are given.
double chance_of_mean(const Data& data, double sign);

}  // namespace vcrit::fit
