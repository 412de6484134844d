// K(i omega) of any network in doubles, by the subtraction-free reduction: storage and loss
// stiffness are nonnegative throughout, so nothing cancels.
#pragma once

#include <complex>

#include "network/network.hpp"
#include "network/reduction.hpp"

namespace vcrit {

/// K(i omega) in N/m; omega in rad/s. Every symbol of the network must be in `values`, positive.
std::complex<double> dynamic_stiffness(const Reduction& reduction, const Values& values,
                                       double omega);
std::complex<double> dynamic_stiffness(const Network& network, const Values& values, double omega);

}  // namespace vcrit
