// The two arithmetics in which formulas.hpp is evaluated.
#pragma once

#include <acb.h>
#include <flint/ulong_extras.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "base/errors.hpp"

namespace vcrit::bounds {

/// Complex balls of one precision. Values live until the next begin(), in places that are used
/// again and again: nothing is allocated in the long run.
class BallArithmetic {
 public:
  using Value = acb_srcptr;

  BallArithmetic() : places_(2048) {
    arb_init(omega_);
    for (acb_struct& each : places_) acb_init(&each);
  }
  ~BallArithmetic() {
    for (acb_struct& each : places_) acb_clear(&each);
    arb_clear(omega_);
  }
  BallArithmetic(const BallArithmetic&) = delete;
  BallArithmetic& operator=(const BallArithmetic&) = delete;

  void begin(double omega, slong precision) {
    used_ = 0;
    arb_set_d(omega_, omega);
    precision_ = precision;
  }

  acb_ptr place() {
    ensure(used_ < places_.size(), "a network of a few elements fits into the places");
    return &places_[used_++];
  }
  Value element(double x) {
    const acb_ptr z = place();
    acb_set_d(z, x);
    return z;
  }
  Value rate(double x) {
    const acb_ptr z = place();
    arb_zero(acb_realref(z));
    arb_set_d(acb_imagref(z), x);
    arb_mul(acb_imagref(z), acb_imagref(z), omega_, precision_);
    return z;
  }
  Value add(Value a, Value b) { return apply(acb_add, a, b); }
  Value subtract(Value a, Value b) { return apply(acb_sub, a, b); }
  Value multiply(Value a, Value b) { return apply(acb_mul, a, b); }
  Value divide(Value a, Value b) { return apply(acb_div, a, b); }
  static bool is_zero(Value a) { return acb_is_zero(a) != 0; }

 private:
  Value apply(void (*operation)(acb_ptr, acb_srcptr, acb_srcptr, slong), Value a, Value b) {
    const acb_ptr z = place();
    operation(z, a, b, precision_);
    return z;
  }

  std::vector<acb_struct> places_;
  std::size_t used_ = 0;
  arb_t omega_{};
  slong precision_ = 64;
};

/// Integers modulo a prime p with p = 3 (mod 4), and i, the root of -1 that is none of them: a
/// field. A double is an integer over a power of 2 and lies in it; what is zero is zero here.
class ModularArithmetic {
 public:
  struct Value {
    ulong re, im;
  };

  ModularArithmetic(ulong prime, double omega) : p_(prime), omega_(number(omega)) {}

  Value element(double x) const { return {number(x), 0}; }
  Value rate(double x) const { return {0, product(number(x), omega_)}; }
  Value add(const Value& a, const Value& b) const {
    return {n_addmod(a.re, b.re, p_), n_addmod(a.im, b.im, p_)};
  }
  Value subtract(const Value& a, const Value& b) const {
    return {n_submod(a.re, b.re, p_), n_submod(a.im, b.im, p_)};
  }
  Value multiply(const Value& a, const Value& b) const {
    return {n_submod(product(a.re, b.re), product(a.im, b.im), p_),
            n_addmod(product(a.re, b.im), product(a.im, b.re), p_)};
  }
  Value divide(const Value& a, const Value& b) const {
    const ulong norm = n_addmod(product(b.re, b.re), product(b.im, b.im), p_);
    const ulong inverse = n_invmod(norm, p_);
    const Value q = multiply(a, {b.re, n_negmod(b.im, p_)});
    return {product(q.re, inverse), product(q.im, inverse)};
  }
  static bool is_zero(const Value& a) { return a.re == 0 && a.im == 0; }

 private:
  ulong product(ulong a, ulong b) const { return n_mulmod2(a, b, p_); }

  ulong number(double x) const {
    int exponent = 0;
    const double fraction = std::frexp(std::abs(x), &exponent);
    const auto digits = static_cast<ulong>(std::ldexp(fraction, 53));
    exponent -= 53;
    ulong power = n_powmod2(2, std::abs(exponent), p_);
    if (exponent < 0) power = n_invmod(power, p_);
    const ulong size = product(digits, power);
    return x < 0 ? n_negmod(size, p_) : size;
  }

  ulong p_, omega_;
};

}  // namespace vcrit::bounds
