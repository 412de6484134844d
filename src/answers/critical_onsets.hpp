// The critical velocity of any scene for columns of parameters: Eq. (24) by the batch where it
// holds, and where the contact opens and it does not, one simulation a lane.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "critical/batch.hpp"
#include "problem/problem.hpp"

namespace vcrit {

class CriticalOnsets {
 public:
  /// `varying`: parameters by their names for --set. Throws InputError for names that the scene
  /// does not have, two names of one quantity, and values that are missing.
  CriticalOnsets(const Problem& problem, std::vector<std::string> varying,
                 Grade grade = Grade::doubles);

  /// v* in m/s, as critical_onset() has it of each lane and CriticalVelocities promises it of Eq.
  /// (24); NaN also where the scene of a lane is outside the model. Columns as there; `out` may be
  /// one of them. A simulated lane takes some milliseconds. May be called from several threads at
  /// once. Throws InputError as CriticalVelocities does.
  void operator()(std::span<const std::span<const double>> columns, std::span<double> out) const;

  /// The first lane with values that the scene may not have, so that nothing is evaluated in vain.
  struct Refused {
    std::size_t lane = 0;
    std::string why;  ///< the message of the InputError
  };
  std::optional<Refused> first_refused(std::span<const std::span<const double>> columns,
                                       std::size_t lanes) const;

 private:
  class Lanes;

  Problem problem_;
  std::vector<std::string> names_;
  CriticalVelocities formula_;
};

}  // namespace vcrit
