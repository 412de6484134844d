// v* of a case to more than 110 bits, by Eq. 24 in balls, from formulas written by hand.
#pragma once

#include <optional>
#include <span>

#include "bounds/arithmetics.hpp"
#include "bounds/systems.hpp"

namespace vcrit::bounds {

/// A number is (high + low) 2^exponent but for 2^-110 of it, 1/2 <= high <= 1.
struct Exact {
  enum class Kind { number, zero, pole, undefined };
  Kind kind = Kind::undefined;
  double high = 0, low = 0;
  int exponent = 0;
};

class ExactReference {
 public:
  explicit ExactReference(const TrialSystem& system);
  ~ExactReference();
  ExactReference(const ExactReference&) = delete;
  ExactReference& operator=(const ExactReference&) = delete;

  /// 0, a pole and 0/0 are told from tiny numbers: where the balls cannot, by arithmetic modulo two
  /// primes of 61 bits. (A numerator of 10^5 bits has no more than 2000 such divisors.)
  Exact velocity(std::span<const double> x);

  /// The mass (a double) at which Re K_d, or Re(K_t + K_d), exceeds m omega^2 by `part` of itself.
  double mass_near_resonance(std::span<const double> x, bool with_tangential, double part);

 private:
  /// Nothing where the balls are too wide.
  std::optional<Exact> at(slong precision, std::span<const double> x);
  Exact rounded();

  const TrialSystem& system_;
  BallArithmetic balls_;
  arb_t above_, below_, factor_, velocity_;
  arf_t rest_, high_;
};

}  // namespace vcrit::bounds
