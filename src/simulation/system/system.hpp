// What the simulator knows of a scene: relaxation forms, inertia, friction and the normal force.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "normal/normal_motion.hpp"
#include "problem/problem.hpp"
#include "simulation/system/effort.hpp"
#include "stiffness/drive_motion.hpp"
#include "stiffness/drive_structure.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::simulation {

class KnownModes;

/// A drive that holds masses, with the body: as it is built, and what the body sees of it.
struct DriveWithMasses {
  DriveStructure structure;
  DriveMotion motion;
  double rounding = 0;  ///< drive_rounding() of both
};

/// A body drawn through the drive with its contact below; what the scene lacks is absent.
struct System {
  Relaxation contact;               ///< tangential network between body and contact point
  std::optional<Relaxation> drive;  ///< rigid without, unless it holds masses
  std::optional<double> mass;       ///< kg, only with a drive
  double omega = 0;                 ///< rad/s
  double friction = 0;              ///< mu0
  double mean_normal_force = 0;     ///< N
  std::complex<double>
      normal_force_amplitude;  ///< N; F_n(t) = mean + Re[amplitude e^{i omega t}] >= 0
  std::optional<NormalMotion> opening = {};  ///< in place of both forces: F_n = max(0, reaction)
  std::shared_ptr<const DriveWithMasses> masses =
      {};  ///< in place of drive and mass; see hold_by()
  SharedEffort* effort =
      nullptr;  ///< that all searches on it share; without one each has its own alone
  KnownModes* known_modes =
      nullptr;  ///< that systems of one drive share, one thread at a time (general_modes.hpp)
};

/// Numbers that differ by so many of their roundings are equal, but for rounding.
inline constexpr double equal_in_roundings = 16;

/// n where a body on an undamped drive swings freely at the n-th harmonic of the oscillation,
/// K_d = m (n omega)^2, to the share `within`; 0 where it does not. The difference itself is right
/// to 30 digits.
int free_harmonic(const Relaxation& drive, double mass, double omega, double within);
/// But for rounding, where the contact never opens. Where it does, its force drives every harmonic:
/// only a drive at one as exact numbers, to 30 digits, is known to be in resonance.
int free_harmonic(const System& system);

/// n where a body swings nearly freely at the n-th harmonic, on a drive of any network: springs and
/// inertia cancel there and losses are faint, |K_d(i n omega) - m (n omega)^2| is at most the share
/// `within` of m (n omega)^2.
int nearly_free_harmonic(const Relaxation& drive, double mass, double omega, double within);
/// Of the system's body, within a part in 1e5. A share d off a free harmonic, a cycle with sticks
/// that die away repeats to within d of itself: below 1e-5, rounding and a search's own error of
/// some 1e-12 take it for a steady one.
int nearly_free_harmonic(const System& system);

/// Why the sticks of a closed contact never end but become ever shorter, "the body swings freely at
/// harmonic 2 ...": for such a system, or within a part in 1e5 of one. Empty elsewhere.
std::string why_sticks_linger(const System& system);

/// Harmonics at which a system with masses in its drive swings freely, n >= 1: undamped poles of
/// what the body sees of the drive at n omega, but for rounding.
std::vector<int> undamped_harmonics(const System& system);

/// Lets a drive with masses, the body among them, hold the contact in place of drive and mass of
/// the system. Its lead, if it has one, is in series with the contact from then on. compliance:
/// 1/K(s) in m/N of body and drive at s = omega, of a network that the structure was made of.
/// Throws InputError for a structure that is none, ModelError where nothing but masses leads to the
/// far end, and where rounding hides what moves the body.
void hold_by(System& system, DriveStructure structure, std::optional<double> compliance = {});

/// Throws InputError for missing values, ModelError unless the normal network carries the mean
/// load, the normal force stays positive or the contact may open, and forces and stiffnesses are
/// doubles.
System system_of(const Problem& problem);

}  // namespace vcrit::simulation
