// The arithmetic of a batch: dynamic stiffnesses of `lanes` scenes at once, storage and loss
// stiffness in columns of their own. Compiled once for each level of the processor; all levels give
// the same bits, as nothing but correctly rounded operations is in them.
#pragma once

#include <cstddef>
#include <span>

namespace vcrit::kernels {

/// A column of doubles is 1 kB, and the dozen that a kernel takes stay in the nearest cache.
inline constexpr std::size_t lanes = 128;

/// Storage and loss stiffness of `lanes` scenes (N/m).
struct StiffnessLanes {
  const double* storage;
  const double* loss;
};

struct LanesResult {
  double* storage;
  double* loss;
};

/// What v* needs beside the stiffnesses, a column each.
struct Drive {
  StiffnessLanes network;
  const double* mass;  ///< kg; null without a body
  const double* omega;
  bool exact_contact, exact_drive;  ///< a single spring: its stiffness has no error
};

struct Kernels {
  void (*multiply)(double* out, const double* a, const double* b);
  void (*divide)(double* out, const double* a, const double* b);
  void (*add)(double* out, const double* a, const double* b);
  /// k i x/(1 + i x), x = omega tau
  void (*maxwell)(LanesResult out, const double* k, const double* tau, const double* omega);
  /// a b/(a + b), sums of nonnegatives throughout
  void (*series)(LanesResult out, StiffnessLanes a, StiffnessLanes b);
  /// a b/total
  void (*mesh)(LanesResult out, StiffnessLanes a, StiffnessLanes b, StiffnessLanes total);
  /// 2 (1 - nu)/(2 - nu); lost[i] becomes 1 where nu is not above -1 and up to 0.5.
  void (*isotropic)(double* out, double* lost, const double* poisson);
  /// out = |a|/|b|
  void (*modulus_ratio)(double* out, StiffnessLanes a, StiffnessLanes b);
  /// out = |K_t + K_d - m omega^2|/|K_d - m omega^2|; lost[i] becomes 1 where more than the factor
  /// `worst_cancellation` of the stiffnesses' accuracy is lost.
  void (*drive_factor)(double* out, double* lost, StiffnessLanes tangential, const Drive& drive);
  /// lost[i] becomes 1 where x is not within the usual range.
  void (*outside_range)(double* lost, const double* x);
};

/// Parameters from 1e-20 to 1e20 in SI: no product of the kernels leaves the normal doubles then.
inline constexpr double least_usual = 1e-20, most_usual = 1e20;

/// Six bits. Lanes that lose more are computed again in more digits.
inline constexpr double worst_cancellation = 64;

/// All that the processor can run, the best one last.
std::span<const Kernels* const> all_kernels();

/// The best of them.
const Kernels& kernels();

}  // namespace vcrit::kernels
