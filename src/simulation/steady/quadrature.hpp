// Integrals over pieces of motion, each with modes of a spectrum of its own.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/interruption.hpp"
#include "modes/spectrum.hpp"
#include "normal/quadrature_rules.hpp"

namespace vcrit::simulation {

// Integrates over pieces by Gauss's rule on panels that grow by 2 from the piece's start, where
// fast modes decay, up to the radian or two that 30 nodes follow a product of two swings over: that
// of the oscillation, which is 1, and while it lasts the one of the body. A product of two modes
// e^{-rate t} with 2 rate * panel <= 40 is integrated to 1e-20 (the rule is exact to degree 59), so
// that the first panel reaches 20/rate of the fastest; beyond it that one is gone.
class Quadrature {
 public:
  explicit Quadrature(const Spectrum& spectrum) {
    double fastest = 0;
    for (Index i = 0; i < spectrum.rates.size(); ++i)
      fastest = std::max(fastest, spectrum.rates[i]);
    for (const ModePair& pair : spectrum.pairs) {
      fastest = std::max(fastest, pair.decay + std::sqrt(std::max(pair.q, 0.0)));
      if (pair.q >= 0) continue;
      swing_ = std::max(swing_, std::sqrt(-pair.q));
      lasts_ = std::max(lasts_, 40 / pair.decay);
    }
    first_ = std::clamp(20 / fastest, shortest, 2 / std::max(1.0, swing_));
  }

  bool can_follow(double duration) const {
    return std::min(duration, lasts_) * swing_ < 2 * most_panels;
  }

  template <class Rate>
  void over(double duration, const Rate& rate) const {
    double begin = 0;
    while (begin < duration) {
      hear_interruption();
      const double longest = begin < lasts_ ? 2 / std::max(1.0, swing_) : 2;
      const double panel = begin == 0 ? first_ : std::min(begin, longest);
      const double end = std::min(begin + panel, duration);
      rule(0.5 * (begin + end), 0.5 * (end - begin), rate);
      begin = end;
    }
  }

 private:
  // Longer ones are seconds of computing.
  static constexpr double most_panels = 50'000;

  // Of the first panel, within which nothing decays; the next ones double.
  static constexpr double shortest = 1e-14;

  template <class Rate>
  static void rule(double middle, double half, const Rate& rate) {
    const auto [nodes, weights] = gauss_30();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (const double side : {-1.0, 1.0})
        rate(middle + side * half * nodes[i], half * weights[i]);
  }

  double swing_ = 0, lasts_ = 0, first_ = shortest;
};

}  // namespace vcrit::simulation
