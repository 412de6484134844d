// Random cases: sizes of values as scenes have them, and all that may go wrong with doubles.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "bounds/reference.hpp"
#include "bounds/systems.hpp"

namespace vcrit::bounds {

enum class Draw {
  moderate,       ///< as scenes have them
  stiff,          ///< springs of 1e+-30, relaxation times of 1e+-12, omega 1e-6 to 1e15
  stiff_within,   ///< elements of one network 1e+-15 and more apart
  zeros,          ///< every fourth element is 0
  resonance,      ///< Re K_d - m omega^2 is 1e-1 to 1e-17 of Re K_d, or 0
  antiresonance,  ///< the same with K_t + K_d
  slow,           ///< omega 1e-300 to 1e-6
  any,            ///< everything 2^-1000 to 2^1000
  extreme,        ///< v* about the smallest and the largest double
  powers,         ///< everything a power of 2
};

std::string_view name_of(Draw draw);

/// Those that make sense for the system: without a mass nothing resonates.
std::vector<Draw> draws_for(const TrialSystem& system);

class Cases {
 public:
  Cases(const TrialSystem& system, ExactReference& reference, std::uint64_t seed)
      : system_(system), reference_(reference), random_(seed) {}

  /// One number for each slot.
  void fill(Draw draw, std::span<double> x);

 private:
  struct Decades;

  double uniform(double from, double to) {
    return std::uniform_real_distribution(from, to)(random_);
  }
  double decade(double from, double to);
  double power(int from, int to);
  bool chance(double p) { return uniform(0, 1) < p; }

  void ordinary(const Decades& decades, std::span<double> x);
  void stiff(std::span<double> x);
  void stretch(std::span<double> x);
  void leave_out(std::span<double> x);
  void resonate(bool with_tangential, std::span<double> x);
  bool resonate_exactly(bool with_tangential, std::span<double> x);
  void any(std::span<double> x);
  void extreme(std::span<double> x);
  void powers(std::span<double> x);
  void undamp(const SlotRange& range, std::span<double> x);
  void weaken_dampers(const SlotRange& range, std::span<double> x);

  const TrialSystem& system_;
  ExactReference& reference_;
  std::mt19937_64 random_;
};

}  // namespace vcrit::bounds
