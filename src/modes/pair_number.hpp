// Numbers a + b sigma with sigma^2 = q, for two modes s = -p +- sqrt(q) that belong together:
// complex numbers for q < 0 (an oscillation), two real rates for q > 0, and smooth through q = 0,
// where the body is critically damped and eigenvectors no longer exist.
#pragma once

#include <cmath>

namespace vcrit::simulation {

struct PairNumber {
  double a = 0, b = 0, q = -1;

  friend PairNumber operator+(PairNumber x, PairNumber y) { return {x.a + y.a, x.b + y.b, x.q}; }
  friend PairNumber operator-(PairNumber x, PairNumber y) { return {x.a - y.a, x.b - y.b, x.q}; }
  friend PairNumber operator+(PairNumber x, double y) { return {x.a + y, x.b, x.q}; }
  friend PairNumber operator-(PairNumber x, double y) { return {x.a - y, x.b, x.q}; }
  friend PairNumber operator*(PairNumber x, double y) { return {x.a * y, x.b * y, x.q}; }
  friend PairNumber operator*(PairNumber x, PairNumber y) {
    return {x.a * y.a + x.q * x.b * y.b, x.a * y.b + x.b * y.a, x.q};
  }
  friend PairNumber inverse(PairNumber x) {
    const double root = std::sqrt(std::abs(x.q)) * x.b;
    const double norm = x.q < 0 ? x.a * x.a + root * root : (x.a - root) * (x.a + root);
    return {x.a / norm, -x.b / norm, x.q};
  }
  friend PairNumber operator/(PairNumber x, PairNumber y) { return x * inverse(y); }

  /// |x| for q <= 0; for q > 0 the larger of both real values.
  friend double magnitude(PairNumber x) {
    const double root = std::sqrt(std::abs(x.q)) * x.b;
    return x.q < 0 ? std::sqrt(x.a * x.a + root * root) : std::abs(x.a) + std::abs(root);
  }
};

inline PairNumber exp(PairNumber x) {
  const double root = std::sqrt(std::abs(x.q)) * x.b;
  if (root == 0) return {std::exp(x.a), std::exp(x.a) * x.b, x.q};
  if (x.q < 0) {
    const double scale = std::exp(x.a);
    return {scale * std::cos(root), scale * std::sin(root) / root * x.b, x.q};
  }
  const double slow = std::exp(x.a + std::abs(root)), drop = std::expm1(-2 * std::abs(root));
  return {0.5 * slow * (2 + drop), -0.5 * slow * drop / std::abs(root) * x.b, x.q};
}

}  // namespace vcrit::simulation
