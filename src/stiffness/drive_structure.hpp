// A drive that holds masses, as a structure: displacements q of its masses, in the frame of the far
// end, which moves uniformly, and a force F that pulls the body's end back,
//   M q'' + C q' + K q + sum_j g_j f_j = -F p,   f_j' = k_j g_j.q' - f_j/t_j,
// with p.q the displacement of that end. A mass acts against inertial ground; ground and far end
// differ by a uniform motion, so that in this frame both stand still. Inner nodes without a mass
// are eliminated: their relaxation is among the f_j, and all k_j are > 0.
#pragma once

#include <optional>
#include <vector>

#include "network/network.hpp"
#include "stiffness/dense.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit {

/// One relaxing force between the masses.
struct DriveBranch {
  long double stiffness = 0;      ///< k_j > 0 (N/m)
  long double time = 0;           ///< t_j > 0 (s)
  std::vector<long double> pull;  ///< g_j
};

/// A mass that the scene names, and which of the displacements is its own.
struct NamedMass {
  Symbol symbol;
  std::size_t place = 0;
};

struct DriveStructure {
  std::vector<double> mass;               ///< M, diagonal (kg), all > 0
  Dense<long double> damping, stiffness;  ///< C (N s/m) and K (N/m), positive semidefinite
  std::vector<DriveBranch> branches;
  std::vector<long double> port;      ///< p
  std::vector<long double> together;  ///< q where everything moves by 1
  /// What holds the body's end if that has no mass of its own, in series with the contact.
  std::optional<Relaxation> lead = {};
  std::vector<NamedMass> named = {};
};

/// Of a drive's network with masses: `body` (kg), if above 0, is one more mass at its first end,
/// called `body_symbol`. Throws InputError for missing values or values that no element may have,
/// ModelError where the first end has no mass and is held by several parts that do not move it in
/// proportion: its displacement is no combination of those of the masses then.
DriveStructure drive_structure(const Network& drive, const Values& values, double body = 0,
                               const Symbol& body_symbol = {});

/// The same masses with all that holds them so many times as stiff, but for the lead.
DriveStructure stiffer(DriveStructure structure, double times);

}  // namespace vcrit
