// The rows of a measured receptance as the fit uses them: in units in which frequencies and values
// are about 1, each weighted by its own size, since a measurement's error is relative.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "scene/receptance.hpp"

namespace vcrit::realisation {

using Complex = std::complex<double>;

struct Rows {
  double frequency_unit = 1;  ///< rad/s
  double value_unit = 1;      ///< m/N
  Eigen::VectorXd omega;      ///< in frequency_unit, increasing
  Eigen::VectorXcd value;     ///< R_i in value_unit
  Eigen::VectorXd weight;     ///< 1/|R_i|; 0 leaves a row out

  Eigen::Index size() const { return omega.size(); }
  double first() const;  ///< the least frequency above 0
  double last() const { return omega[size() - 1]; }
};

/// Throws InputError for a table without a value that is finite and not 0.
Rows rows_of(const Receptance& table);

/// At most `most` rows: more of them where the curve bends, elsewhere evenly spaced.
Rows thinned(const Rows& rows, Eigen::Index most);

/// The rows with these indices, in their order.
Rows chosen(const Rows& rows, const std::vector<Eigen::Index>& places);

}  // namespace vcrit::realisation
