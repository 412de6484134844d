// The paper's reduced model (47)-(52) against the full motion, over delta = omega c/k of an
// isotropic Kelvin contact under a rigid drive and v0/v*. The model drops the transient after each
// stick: it is right for delta -> 0 and for v0 -> v*, and says too much friction elsewhere.
//
// The normal force is mean (1 + a cos): a = (du_z/u_z0) sqrt(1 + delta^2), the paper's D times the
// root. Both models are linear in a: the difference at another amplitude follows by proportion.
#pragma once

#include <optional>
#include <vector>

#include "compare/scene_report.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation {

/// The contact as the simulator takes it, with k = 1, omega = 1, mu0 <F_n> = 1; the phase of the
/// normal force only shifts time. delta >= 0, 0 <= a < 1.
simulation::System kelvin_contact(double delta, double a);

/// delta >= 0, 0 < ratio = v0/v* < 1, 0 < a < 1.
ReducedAndFull reduced_and_full(double delta, double ratio, double a);

ReducedTable reduced_table(double a, const std::vector<double>& deltas,
                           const std::vector<double>& ratios);

/// The least of the ratios 0.01, 0.02 ... 0.99 from which on the difference stays below
/// `tolerance`; nothing if it does not even at 0.99.
std::optional<double> usable_from(double delta, double a, double allowed);

/// Nothing unless the scene is an isotropic Kelvin contact (with a damper) under a rigid drive.
/// Throws InputError for missing values.
std::optional<ReducedModel> reduced_model(const Problem& problem);

}  // namespace vcrit::validation
