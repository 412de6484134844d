// A measured drive as what moves: the structure that was fitted to its table
// (realisation/structure.hpp), with the body in place of its coordinate without mass.
#pragma once

#include <optional>

#include "realisation/structure.hpp"
#include "scene/receptance.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulation {

/// Lets a structure (SI) hold the contact in place of drive and mass of the system: with a body of
/// `mass` (kg), or without one, for which the structure's damping is not Damping::coupled.
void hold_by_structure(System& system, const realisation::Structure& structure,
                       std::optional<double> mass);

/// The same for the realisation of a table.
void hold_by_table(System& system, const Receptance& table, std::optional<double> mass);

}  // namespace vcrit::simulation
