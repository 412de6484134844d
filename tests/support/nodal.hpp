// An independent way to Eq. 24: nodal analysis at many digits. Shares nothing with the reduction
// but the network's data structure.
#pragma once

#include <boost/multiprecision/cpp_complex.hpp>
#include <complex>

#include "network/network.hpp"
#include "scene/scene.hpp"

namespace vcrit::test {

// Nodal elimination subtracts, so that networks over D decades lose up to some multiples of D
// digits; 250 leave at least 50 good ones for everything the tests draw (at most 12 elements over
// 12 decades each way).
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<250>>;
using Complex = boost::multiprecision::number<
    boost::multiprecision::complex_adaptor<boost::multiprecision::cpp_bin_float<250>>>;

/// The admittance matrix of the network's elements, each series part with inner nodes of its own.
class Nodal {
 public:
  Nodal(const Values& values, const Real& omega) : values_(values), omega_(omega) {}

  Complex stiffness(const Network& network) const;

 private:
  const Values& values_;
  Real omega_;
};

/// |value - exact|/|exact|
double relative_error(std::complex<double> value, const Complex& exact);

/// Eq. 24 as printed in the paper, at many digits.
Real critical_velocity_by_nodes(const Scene& scene);

}  // namespace vcrit::test
