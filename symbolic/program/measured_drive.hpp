// A measured drive in a Program: 1/K_d as src/critical/drive_response.cpp takes it from the table,
// linear between the row at or below omega and the next one,
//   Q = R_below (omega_above - omega) + R_above (omega - omega_below),  T = omega_above -
//   omega_below.
// Outside of the table all of these numbers are NaN.
#pragma once

#include "program/drive_pair.hpp"
#include "scene/receptance.hpp"

namespace vcrit::symbolic {

DrivePair measured_pair(Program& program, NodeId omega, const Receptance& receptance);

}  // namespace vcrit::symbolic
