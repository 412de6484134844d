// Eq. 24 in doubles for columns of parameters: the whole formula as one list of operations on
// blocks of lanes, of which those that no varying parameter reaches run once a call.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit {

/// How the values of a batch are found: in doubles, nanoseconds each, or correctly rounded.
enum class Grade { doubles, certified };

class CriticalVelocities {
 public:
  /// `varying`: parameters by their names for --set. Throws InputError for names that the scene
  /// does not have, two names of one quantity, and values that are missing.
  CriticalVelocities(const Problem& problem, std::vector<std::string> varying,
                     Grade grade = Grade::doubles);
  ~CriticalVelocities();
  CriticalVelocities(CriticalVelocities&&) noexcept;
  CriticalVelocities& operator=(CriticalVelocities&&) noexcept;

  /// v* in m/s. columns[i] holds the values of varying[i] in SI, out.size() of them or one for all;
  /// `out` may be one of the columns. Infinite at resonance and above the largest double, NaN where
  /// v* is 0/0, nothing is known of a measured drive or a value given is NaN. May be called from
  /// several threads at once. Relative error in doubles: at most 1280 u an element of the scene's
  /// networks (u = 2^-53), a few u in practice. Where cancellation would cost more, or numbers
  /// leave 1e-20 to 1e20 in SI, the answer is the correctly rounded one, at its price of
  /// microseconds, as it is for measured drives, drives that hold masses, and mounts. Throws
  /// InputError for values that the scene may not have and for columns of other lengths.
  void operator()(std::span<const std::span<const double>> columns, std::span<double> out) const;

 private:
  class Formula;
  std::unique_ptr<const Formula> formula_;
};

}  // namespace vcrit
