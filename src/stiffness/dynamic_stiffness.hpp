// K(i omega) of any network in doubles, by the subtraction-free reduction: storage and loss
// stiffness of springs and dampers are nonnegative throughout, so nothing cancels. Masses inside a
// drive do cancel with springs, near the resonances and antiresonances of its parts.
#pragma once

#include <complex>

#include "network/network.hpp"
#include "network/reduction.hpp"

namespace vcrit {

/// K(i omega) in N/m; omega in rad/s. Every symbol of the network must be in `values`, positive;
/// throws InputError for one that is not there.
std::complex<double> dynamic_stiffness(const Reduction& reduction, const Values& values,
                                       double omega);
std::complex<double> dynamic_stiffness(const Network& network, const Values& values, double omega);

/// The same over the range of any product of doubles.
std::complex<long double> wide_dynamic_stiffness(const Reduction& reduction, const Values& values,
                                                 double omega);

/// K(s) in N/m at a real s > 0 in rad/s, with masses as with springs and dampers: nothing cancels
/// there. Throws ModelError for a spring with a loss factor, which has no law in s.
long double stiffness_on_real_axis(const Reduction& reduction, const Values& values, double s);

/// sum_j |z_j dK/dz_j| over the elements and the intermediate results of the reduction, in N/m: by
/// how much at most relative errors of 1 in all of them change K, to first order.
double sensitivity(const Reduction& reduction, const Values& values, double omega);

}  // namespace vcrit
