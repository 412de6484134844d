// Random numbers of the tests of fits.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

namespace vcrit::test {

/// Uniform and normal deviates from a seeded engine, the same everywhere.
class Deviates {
 public:
  explicit Deviates(unsigned seed) : engine_(seed) {}
  double between(double from, double to) { return from + (to - from) * unit(); }
  double normal() {
    const double u = unit(), v = unit();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
  }

 private:
  double unit() { return (static_cast<double>(engine_() >> 11) + 0.5) / 9007199254740992.0; }
  std::mt19937_64 engine_;
};

}  // namespace vcrit::test
