#include "stiffness/dynamic_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/complex.hpp"
#include "network/wiring.hpp"

namespace vcrit {

namespace {

// Products of storage and loss stiffness over the square of a sum: first scaled by a power of two
// to the size of the sum, so that squares neither overflow nor vanish.
template <class Real>
struct Pairs {
  using Complex = std::complex<Real>;
  using Value = Complex;
  const Values& values;
  Real omega;

  Complex of(const Symbol& symbol) const {
    return {static_cast<Real>(value_of(values, symbol)), 0};
  }
  static Complex constant(const TypedNumber& number) { return static_cast<Real>(number.value); }
  static Complex plus(Complex a, Complex b) { return a.real() + b.real(); }
  static Complex times(Complex a, Complex b) { return a.real() * b.real(); }
  static Complex over(Complex a, Complex b) { return a.real() / b.real(); }
  // Without a 0 below 0.
  Complex times_s(Complex k) const { return {0 - k.imag() * omega, k.real() * omega}; }
  Complex relaxing(Complex k, Complex tau) const {
    const Real x = omega * tau.real(), stiffness = k.real();
    // k x/(1 + x^2) (x + i), from the smaller of x and 1/x.
    if (x > 1) return {stiffness / (1 + 1 / x / x), stiffness / (x + 1 / x)};
    return {stiffness * x / (1 + x * x) * x, stiffness * x / (1 + x * x)};
  }
  static Complex lossy(Complex k, Complex eta) { return {k.real(), k.real() * eta.real()}; }

  static Real scale_of(Complex z) {
    // ilogb(0), where a mass cancels a spring, and of infinity have no negative or no power.
    constexpr int most = std::numeric_limits<Real>::max_exponent - 1;
    const int exponent = std::ilogb(std::max(std::abs(z.real()), std::abs(z.imag())));
    return std::ldexp(Real(1), -std::clamp(exponent, -most, most));
  }

  static Complex parallel(Complex a, Complex b) { return a + b; }

  // 1/(1/a + 1/b) = (a |b|^2 + b |a|^2)/|a + b|^2 in both components: without masses only sums of
  // nonnegatives.
  static Complex series(Complex a, Complex b) {
    const Complex sum = a + b;
    const Real scale = scale_of(sum);
    const Real sum_norm = std::norm(sum * scale);
    const Real a_share = std::norm(a * scale) / sum_norm, b_share = std::norm(b * scale) / sum_norm;
    return {a.real() * b_share + b.real() * a_share, a.imag() * b_share + b.imag() * a_share};
  }

  static Complex mesh(Complex a, Complex b, Complex total) {
    const Real scale = scale_of(total);
    const Complex t = total * scale;
    const Real norm = std::norm(t);
    const Complex share{(a.real() * t.real() + a.imag() * t.imag()) / norm,
                        (a.imag() * t.real() - a.real() * t.imag()) / norm};
    return {(share.real() * b.real() - share.imag() * b.imag()) * scale,
            (share.real() * b.imag() + share.imag() * b.real()) * scale};
  }
};

/// K(s) where all parts are positive.
struct OnRealAxis {
  using Value = long double;
  const Values& values;
  long double s;

  Value of(const Symbol& symbol) const { return value_of(values, symbol); }
  static Value constant(const TypedNumber& number) { return number.value; }
  static Value plus(Value a, Value b) { return a + b; }
  static Value times(Value a, Value b) { return a * b; }
  static Value over(Value a, Value b) { return a / b; }
  Value times_s(Value k) const { return k * s; }
  Value relaxing(Value k, Value tau) const { return k / (1 + 1 / (s * tau)); }
  static Value parallel(Value a, Value b) { return a + b; }
  static Value series(Value a, Value b) { return 1 / (1 / a + 1 / b); }
  static Value mesh(Value a, Value b, Value total) { return a / total * b; }
};

/// A value and the change of it by errors up to here.
struct Uncertain {
  ComplexDouble k;
  double error;
};

/// The reduction with the first-order error of each result, its own rounding among them.
struct Uncertainties {
  using Value = Uncertain;
  Pairs<double> pairs;

  static Value rounded(ComplexDouble k) { return {k, std::abs(k)}; }
  Value of(const Symbol& symbol) const { return rounded(pairs.of(symbol)); }
  static Value constant(const TypedNumber& number) { return rounded(number.value); }
  static Value plus(const Value& a, const Value& b) {
    const ComplexDouble k = a.k + b.k;
    return {k, a.error + b.error + std::abs(k)};
  }
  static Value times(const Value& a, const Value& b) {
    const double k = a.k.real() * b.k.real();
    return {k, a.error * b.k.real() + b.error * a.k.real() + k};
  }
  static Value over(const Value& a, const Value& b) {
    const double k = a.k.real() / b.k.real();
    return {k, a.error / b.k.real() + b.error / b.k.real() * k + k};
  }
  Value times_s(const Value& k) const { return rounded(pairs.times_s(k.k)); }
  Value relaxing(const Value& k, const Value& tau) const {
    return rounded(pairs.relaxing(k.k, tau.k));
  }
  static Value lossy(const Value& k, const Value& eta) {
    return rounded(Pairs<double>::lossy(k.k, eta.k));
  }
  static Value parallel(const Value& a, const Value& b) {
    const ComplexDouble k = a.k + b.k;
    return {k, a.error + b.error + std::abs(k)};
  }
  static Value series(const Value& a, const Value& b) {
    const ComplexDouble k = Pairs<double>::series(a.k, b.k);
    // b/(a + b): where a mass cancels its springs, all of it.
    const auto share = [&](ComplexDouble part) { return part == 0.0 ? 1 : std::norm(k / part); };
    const double share_a = share(a.k), share_b = share(b.k);
    return {k, share_a * a.error + share_b * b.error + std::abs(k)};
  }
  static Value mesh(const Value& a, const Value& b, const Value& total) {
    const ComplexDouble k = Pairs<double>::mesh(a.k, b.k, total.k);
    if (a.k == 0.0 || b.k == 0.0)
      return {k, (a.error * std::abs(b.k) + b.error * std::abs(a.k)) / std::abs(total.k)};
    const double relative =
        a.error / std::abs(a.k) + b.error / std::abs(b.k) + total.error / std::abs(total.k);
    return {k, std::abs(k) * (relative + 1)};
  }
};

}  // namespace

ComplexDouble dynamic_stiffness(const Reduction& reduction, const Values& values, double omega) {
  Pairs<double> pairs{values, omega};
  return evaluate(reduction, pairs);
}

ComplexDouble dynamic_stiffness(const Network& network, const Values& values, double omega) {
  return dynamic_stiffness(reduce(network), values, omega);
}

std::complex<long double> wide_dynamic_stiffness(const Reduction& reduction, const Values& values,
                                                 double omega) {
  Pairs<long double> pairs{values, omega};
  return evaluate(reduction, pairs);
}

long double stiffness_on_real_axis(const Reduction& reduction, const Values& values, double s) {
  OnRealAxis algebra{values, s};
  return evaluate(reduction, algebra);
}

double sensitivity(const Reduction& reduction, const Values& values, double omega) {
  Uncertainties uncertainties{{values, omega}};
  return evaluate(reduction, uncertainties).error;
}

}  // namespace vcrit
