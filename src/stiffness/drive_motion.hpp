// What a body sees of a drive with masses, as a linear motion of as few numbers as that takes,
//   x' = A x - F/m e_1,   x_1 = u, the velocity of the body's end,
// the realisation of the receptance R_b of drive_structure.hpp. The numbers are velocities and
// elongations, measured so that m |x|^2/2 is the energy: with v = sqrt(M) q', the elongations h of
// K = G G^T and those of the branches,
//   A = | -C  -G |   in these units, T the diagonal of 1/t_j,
//       | G^T -T |
// and A + A^T <= 0: the drive is passive in this form, whatever is rounded. Of this the reachable
// part is kept, by an orthonormal basis of F, A F, A^2 F, ... A mode that the body cannot move,
// such as that of two equal absorbers against each other or one with a node at the body, is left
// out. It would neither be driven nor felt, but it might ring for ever.
#pragma once

#include <complex>
#include <vector>

#include "stiffness/drive_structure.hpp"

namespace vcrit {

struct DriveMotion {
  double mass = 0;           ///< m: F/m is the acceleration of the body's end at once (kg)
  Dense<long double> rates;  ///< A (1/s)
  std::vector<double> rest;  ///< x where everything moves by 1 (m/s)
  double fluidity = 0;  ///< velocity at which a constant force of 1 N drags it; 0 with a spring
  std::vector<std::complex<long double>> poles;  ///< eigenvalues of A (1/s), those of R_b
};

/// Throws ModelError where only masses lead to the far end, InputError for sizes that do not fit.
DriveMotion drive_motion(const DriveStructure& structure);

}  // namespace vcrit
