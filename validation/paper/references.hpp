// Numbers that others found, typed in with their sources.
#pragma once

#include <array>
#include <span>

namespace vcrit::validation::paper {

/// Steady friction of the full motion at a = 0.9, rounded from 25 digits of
/// tests/data/paper_friction.csv: Newton's method in 40 digits on the two equations of stick and
/// slip, by a script that shares nothing with this program. Rows that
/// tests/data/stickslip_reference.csv has, too (event-driven, 30 against 50 digits), are the same.
struct FrictionValue {
  double delta, ratio, friction;
};
std::span<const FrictionValue> friction_references();
constexpr double reference_amplitude = 0.9;  ///< a of all of them

/// The same at delta = 0, of tests/data/stickslip_reference.csv.
std::span<const FrictionValue> elastic_references();

/// What the reduced model (47)-(51) gives at a = 0.9, in 13 digits: docs/physics.md.
std::span<const FrictionValue> reduced_references();

/// Its limit as v0 -> 0, at a = 1, in 13 digits.
struct RestReference {
  double delta, friction;
};
std::span<const RestReference> rest_references();

/// G(v0/v*) of the elastic contact, 20 digits of a computation with 50.
struct PunchReference {
  double ratio, g;
};
std::span<const PunchReference> punch_references();

/// Reduction of mu/mu0 by the full motion, per a; 15 digits: tests/data/paper_viscosity.csv.
struct ViscosityReference {
  double delta, ratio, per_a;
};
std::span<const ViscosityReference> viscosity_references();

/// v_c/v*, most weakening and most strengthening per a; 15 digits: tests/data/paper_crossings.csv.
struct CrossingReference {
  double delta, ratio, weakening, strengthening;
};
std::span<const CrossingReference> crossing_references();

/// Largest amplitudes printed in the paper with Fig. 4, and half a unit of their last digit.
struct PrintedLimit {
  double delta, amplitude, half_unit;
};
std::span<const PrintedLimit> printed_limits();

inline constexpr std::array figure4_deltas{1.0, 2.0, 10.0, 100.0};

}  // namespace vcrit::validation::paper
