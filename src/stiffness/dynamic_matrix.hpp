// A drive with masses at one s: M s^2 + C s + K with what relaxes, and what rounding takes of it.
#pragma once

#include <complex>
#include <vector>

#include "stiffness/drive_structure.hpp"

namespace vcrit {

/// Displacement of each of the masses for a force on the body's end, q(s)/F (m/N). Their sum
/// weighted by p is the receptance of the drive with the body, without the lead. Throws InputError
/// for sizes that do not fit.
std::vector<std::complex<long double>> displacements(const DriveStructure& structure,
                                                     std::complex<long double> s);

struct RoundedReceptance {
  std::complex<long double> value;  ///< p.q(s)/F (m/N)
  /// What the rounding of the structure's numbers may take of it: much where a part is very much
  /// stiffer than what moves, as a rigid link between masses. Infinite where nothing is left.
  long double error;
};

/// Throws InputError for sizes that do not fit.
RoundedReceptance rounded_receptance(const DriveStructure& structure, std::complex<long double> s);

}  // namespace vcrit
