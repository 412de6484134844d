// What rounding leaves of a drive with masses whose parts are very different.
#pragma once

#include <optional>

#include "stiffness/drive_motion.hpp"
#include "stiffness/drive_structure.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::simulation {

/// Of the compliance of contact and drive in series, the share that rounding may take of the drive:
/// of sums with a part that is very much stiffer than what moves, on the way from the network, of
/// which `compliance` (m/N) is 1/K(s) at s = omega, to the structure, which may lose a slow branch
/// beside a fast one, and on the way to the motion, which may lose a light mass. 0 for a few
/// roundings. Throws ModelError beyond 1e-4.
double drive_rounding(const DriveStructure& structure, const DriveMotion& motion,
                      const Relaxation& contact, double omega, std::optional<double> compliance);

/// Throws the ModelError of parts that are too different for the motion of the drive.
[[noreturn]] void parts_too_different();

}  // namespace vcrit::simulation
