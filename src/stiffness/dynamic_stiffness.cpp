#include "stiffness/dynamic_stiffness.hpp"

#include <cmath>

namespace vcrit {

namespace {

using Complex = std::complex<double>;

// Products of storage and loss stiffness over the square of a sum: first scaled by a power of two
// to the size of the sum, so that squares neither overflow nor vanish.
struct Pairs {
  using Value = Complex;
  const Values& values;
  double omega;

  Complex element(const Element& e) const {
    const double coefficient = values.at(e.coefficient);
    if (e.kind == ElementKind::spring) return {coefficient, 0};
    if (e.kind == ElementKind::damper) return {0, coefficient * omega};
    const double x = omega * values.at(e.time);
    // k x/(1 + x^2) (x + i), from the smaller of x and 1/x.
    if (x > 1) return {coefficient / (1 + 1 / x / x), coefficient / (x + 1 / x)};
    return {coefficient * x / (1 + x * x) * x, coefficient * x / (1 + x * x)};
  }

  static Complex parallel(Complex a, Complex b) { return a + b; }

  // 1/(1/a + 1/b) = (a |b|^2 + b |a|^2)/|a + b|^2 in both components: only sums of nonnegatives.
  static Complex series(Complex a, Complex b) {
    const Complex sum = a + b;
    const double scale = std::ldexp(1.0, -std::ilogb(std::max(sum.real(), sum.imag())));
    const double sum_norm = std::norm(sum * scale);
    const double a_share = std::norm(a * scale) / sum_norm,
                 b_share = std::norm(b * scale) / sum_norm;
    return {a.real() * b_share + b.real() * a_share, a.imag() * b_share + b.imag() * a_share};
  }

  static Complex mesh(Complex a, Complex b, Complex total) {
    const double scale =
        std::ldexp(1.0, -std::ilogb(std::max(std::abs(total.real()), std::abs(total.imag()))));
    const Complex t = total * scale;
    const double norm = std::norm(t);
    const Complex share{(a.real() * t.real() + a.imag() * t.imag()) / norm,
                        (a.imag() * t.real() - a.real() * t.imag()) / norm};
    return {(share.real() * b.real() - share.imag() * b.imag()) * scale,
            (share.real() * b.imag() + share.imag() * b.real()) * scale};
  }
};

}  // namespace

Complex dynamic_stiffness(const Reduction& reduction, const Values& values, double omega) {
  Pairs pairs{values, omega};
  return evaluate(reduction, pairs);
}

Complex dynamic_stiffness(const Network& network, const Values& values, double omega) {
  return dynamic_stiffness(reduce(network), values, omega);
}

}  // namespace vcrit
