// Where the search for a series of some length begins: neighbours in a dense nonnegative spectrum
// merged, or a branch added where the residual asks for one.
#pragma once

#include <optional>
#include <vector>

#include "fit/refine.hpp"

namespace vcrit::fit {

/// Relaxation times as dense as a continuum, over the range that the data speak of, s.
std::vector<double> grid_of_times(const Weighed& data);

/// The nonnegative spectrum over a dense grid of relaxation times, without its zeros.
Relaxation dense_spectrum(const Weighed& data, const Terms& terms);

/// Its branches merged, nearest first, until `branches` are left; nothing where it has fewer.
std::optional<Relaxation> merged(Relaxation spectrum, int branches);

/// The fit with the branch that lowers its misfit most, to first order. Nothing where none does.
std::optional<Relaxation> with_another_branch(const Weighed& data, const Terms& terms,
                                              const Refined& fit);

}  // namespace vcrit::fit
