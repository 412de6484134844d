// Where the search for a structure starts: from the poles of a causal fit, with as many modes as
// take energy (nonnegative least squares for phi^2: Coelho, Phillips and Silveira 2004), and from a
// structure with one mode less.
#pragma once

#include <random>
#include <vector>

#include "realisation/structure.hpp"

namespace vcrit::realisation {

/// Random numbers that are the same in every run and with every library.
class Deviates {
 public:
  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
  double normal();

 private:
  std::mt19937_64 engine_{36};
};

/// The structure without a mode: alpha^2/(1 + tau s).
Structure series_spring(const Rows& rows);

/// Starts with that many modes, each with modal damping: from causal fits; `less`, the best with
/// one mode less, with one added where the misfit is worst, above, below and within the rows.
std::vector<Structure> first_starts(const Rows& rows, Eigen::Index modes, const Structure* less);

/// Starts with that many modes whose springs and dampers reach the end itself: from causal fits of
/// 1/R.
std::vector<Structure> absorber_starts(const Rows& rows, Eigen::Index modes);

/// `structure` with one mode more, as large as the rows' misfit says.
Structure with_mode(const Rows& rows, const Structure& structure, double frequency, double damping);

/// The frequencies at which one is worth trying.
std::vector<double> places_of_new_mode(const Rows& rows, const Structure& structure);

/// Every parameter moved at random: frequencies by a fifth.
Structure shaken(const Structure& structure, Deviates& deviates);

}  // namespace vcrit::realisation
