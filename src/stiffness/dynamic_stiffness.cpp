#include "stiffness/dynamic_stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"

namespace vcrit {

namespace {

// Products of storage and loss stiffness over the square of a sum: first scaled by a power of two
// to the size of the sum, so that squares neither overflow nor vanish.
struct Pairs {
  using Value = ComplexDouble;
  const Values& values;
  double omega;

  ComplexDouble element(const Element& e) const {
    const double coefficient = values.at(e.coefficient);
    if (e.kind == ElementKind::spring) return {coefficient, 0};
    if (e.kind == ElementKind::damper) return {0, coefficient * omega};
    if (e.kind == ElementKind::mass) return {-coefficient * omega * omega, 0};
    const double x = omega * values.at(e.time);
    // k x/(1 + x^2) (x + i), from the smaller of x and 1/x.
    if (x > 1) return {coefficient / (1 + 1 / x / x), coefficient / (x + 1 / x)};
    return {coefficient * x / (1 + x * x) * x, coefficient * x / (1 + x * x)};
  }

  static double scale_of(ComplexDouble z) {
    // ilogb(0), where a mass cancels a spring, and of infinity have no negative or no power.
    const int exponent = std::ilogb(std::max(std::abs(z.real()), std::abs(z.imag())));
    return std::ldexp(1.0, -std::clamp(exponent, -1023, 1023));
  }

  static ComplexDouble parallel(ComplexDouble a, ComplexDouble b) { return a + b; }

  // 1/(1/a + 1/b) = (a |b|^2 + b |a|^2)/|a + b|^2 in both components: without masses only sums of
  // nonnegatives.
  static ComplexDouble series(ComplexDouble a, ComplexDouble b) {
    const ComplexDouble sum = a + b;
    const double scale = scale_of(sum);
    const double sum_norm = std::norm(sum * scale);
    const double a_share = std::norm(a * scale) / sum_norm,
                 b_share = std::norm(b * scale) / sum_norm;
    return {a.real() * b_share + b.real() * a_share, a.imag() * b_share + b.imag() * a_share};
  }

  static ComplexDouble mesh(ComplexDouble a, ComplexDouble b, ComplexDouble total) {
    const double scale = scale_of(total);
    const ComplexDouble t = total * scale;
    const double norm = std::norm(t);
    const ComplexDouble share{(a.real() * t.real() + a.imag() * t.imag()) / norm,
                              (a.imag() * t.real() - a.real() * t.imag()) / norm};
    return {(share.real() * b.real() - share.imag() * b.imag()) * scale,
            (share.real() * b.imag() + share.imag() * b.real()) * scale};
  }
};

/// A value and the change of it by errors up to here.
struct Uncertain {
  ComplexDouble k;
  double error;
};

/// The reduction with the first-order error of each result, its own rounding among them.
struct Uncertainties {
  using Value = Uncertain;
  Pairs pairs;

  Value element(const Element& e) const {
    const ComplexDouble k = pairs.element(e);
    return {k, std::abs(k)};
  }
  static Value parallel(const Value& a, const Value& b) {
    const ComplexDouble k = a.k + b.k;
    return {k, a.error + b.error + std::abs(k)};
  }
  static Value series(const Value& a, const Value& b) {
    const ComplexDouble k = Pairs::series(a.k, b.k);
    const double share_a = std::norm(k / a.k), share_b = std::norm(k / b.k);
    return {k, share_a * a.error + share_b * b.error + std::abs(k)};
  }
  static Value mesh(const Value& a, const Value& b, const Value& total) {
    const ComplexDouble k = Pairs::mesh(a.k, b.k, total.k);
    const double relative =
        a.error / std::abs(a.k) + b.error / std::abs(b.k) + total.error / std::abs(total.k);
    return {k, std::abs(k) * (relative + 1)};
  }
};

}  // namespace

ComplexDouble dynamic_stiffness(const Reduction& reduction, const Values& values, double omega) {
  Pairs pairs{values, omega};
  return evaluate(reduction, pairs);
}

ComplexDouble dynamic_stiffness(const Network& network, const Values& values, double omega) {
  return dynamic_stiffness(reduce(network), values, omega);
}

double sensitivity(const Reduction& reduction, const Values& values, double omega) {
  Uncertainties uncertainties{{values, omega}};
  return evaluate(reduction, uncertainties).error;
}

}  // namespace vcrit
