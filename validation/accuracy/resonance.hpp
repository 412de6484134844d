// Where the storage stiffness balances the body's inertia: the resonance Re K_d = m omega^2 and the
// antiresonance Re(K_t + K_d) = m omega^2, near which Eq. 24 cancels.
#pragma once

#include <optional>

#include "network/reduction.hpp"
#include "problem/problem.hpp"

namespace vcrit::validation::accuracy {

enum class ResonanceKind { resonance, antiresonance };

class Resonances {
 public:
  explicit Resonances(const Problem& problem);

  /// Whether there is a body on a drive that is a network; elsewhere find() finds nothing.
  bool exist() const { return drive_.has_value(); }
  /// The angular frequency within nine decades of the scene's own (in `values`), to a rounding
  /// error; one of them, if there are several. Nothing if there is none.
  std::optional<double> find(ResonanceKind balance, const Values& values) const;

  /// Whether stiffness outweighs inertia at `omega` (rad/s): the balance lies above it. Not without
  /// a body.
  bool above(ResonanceKind balance, const Values& values, double omega) const {
    return exist() && excess(balance, values, omega) > 0;
  }

 private:
  double excess(ResonanceKind balance, const Values& values, double omega) const;

  Problem problem_;
  std::optional<ReducedNetwork> drive_;
  std::optional<ScaledNetwork> tangential_;
};

}  // namespace vcrit::validation::accuracy
