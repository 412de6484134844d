// Problems of another structure than the one that they are made of. Each throws InputError as
// making a Problem does.
#pragma once

#include "problem/problem.hpp"

namespace vcrit {

/// As evaluators and simulators take it: no number as it was typed.
Problem as_doubles(const Problem& problem);

/// Its symbols by other names (`Resolved::names`).
Problem called_otherwise(const Problem& problem, std::map<std::string, std::string> names);

/// With these warnings.
Problem warning_of(const Problem& problem, std::vector<std::string> warnings);

/// Of a contact that must stay closed.
Problem staying_closed(const Problem& problem);

/// `normal` over one spring (N/m, 1) under a rigid drive: v* is mu0 omega du_z |K_n|/stiffness. The
/// symbol is none of the problem's; `normal` is of its elements.
Problem over_spring(const Problem& problem, ReducedNetwork normal, const Symbol& stiffness);

/// Without body, under a rigid drive.
Problem with_rigid_drive(const Problem& problem);

/// Pressed to a mean indentation (m), also where a load is given.
Problem at_depth(const Problem& problem, double indentation);

/// With an indenter of another shape.
Problem with_indenter(const Problem& problem, const Indenter& indenter);

/// With one spring (N/m; N/m^2 below an indenter) as normal network, and no other element.
Problem with_normal_spring(const Problem& problem, const Symbol& symbol, double stiffness);

/// With another isotropic contact: of another symbol, value, or way to give the ratio.
Problem with_isotropic(const Problem& problem, const Isotropic& isotropic);

}  // namespace vcrit
