// What a causal response can have in common with a table, whatever its signs: relaxed vector
// fitting (Gustavsen and Semlyen, IEEE Trans. Power Delivery 14, 1999; Gustavsen, 21, 2006),
// weighted by 1/|R_i|. Residues are free, so what is left of a row is noise or at fault: the linear
// test of Boukamp (1995), with resonances in place of relaxations.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "realisation/rows.hpp"

namespace vcrit::realisation {

struct CausalFit {
  std::vector<std::complex<double>> poles;  ///< those with Im >= 0, all with Re < 0
  Eigen::VectorXcd left;                    ///< (R_i - fit)/|R_i|
  double sum = 0;                           ///< of |left|^2
};

/// With that many pairs of poles, which may become real. From poles spaced evenly, or by a factor.
CausalFit causal_fit(const Rows& rows, Eigen::Index pairs, bool by_factor);

/// With as many pairs as lessen Schwarz's criterion, and but for rows at fault: those count little,
/// and resonances that only a few rows show, or that give energy, are no part of it where they are
/// narrower than the rows' distance.
CausalFit best_causal_fit(const Rows& rows);

/// Standard deviation of real and imaginary part of `left` each, by the median: a tenth of the rows
/// may be at fault.
double robust_noise(const Eigen::VectorXcd& left);

}  // namespace vcrit::realisation
