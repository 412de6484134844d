// What is wrong with a measured table, with the rows that show it: rows that give energy, rows that
// no causal response has, resonances between the rows.
#pragma once

#include <string>
#include <vector>

#include "realisation/causal_fit.hpp"
#include "realisation/structure.hpp"
#include "scene/receptance.hpp"

namespace vcrit::realisation {

/// Rows that follow one another, counted from 0.
struct RowRange {
  Eigen::Index first = 0, last = 0;
  double size = 0;  ///< the greatest of what is wrong there, relative to |R|
};

/// Where Im R exceeds what noise explains: `noise` is the standard deviation of real and imaginary
/// part each, relative to |R|.
std::vector<RowRange> giving_energy(const Rows& rows, double noise);
/// Where it is below 0 by as much.
std::vector<RowRange> taking_energy(const Rows& rows, double noise);

/// Where what is left of the best causal fit is more than noise: single rows beyond the level that
/// one table in a thousand passes by chance, and runs of five of one sign beyond twice the noise.
std::vector<RowRange> not_causal(const CausalFit& fit, double noise);

/// A mode within the rows, as high as noise at least, that has fewer than three rows within its
/// half-power width.
struct Unresolved {
  double omega = 0;  ///< in the unit of Rows
  int rows = 0;
};
std::vector<Unresolved> unresolved(const Rows& rows, const Structure& structure, double noise);

/// A line for each stretch or resonance, naming file, rows and frequencies.
std::string energy_words(const Receptance& table, const RowRange& stretch);
std::string causality_words(const Receptance& table, const RowRange& stretch, double noise);
/// `omega` in rad/s.
std::string resolution_words(const Receptance& table, double omega, int rows);

}  // namespace vcrit::realisation
