// Complex ball arithmetic (Arb): numbers with a rigorous bound on their error.
#pragma once

#include <acb.h>
#include <arb.h>

#include "base/units.hpp"
#include "network/network.hpp"

namespace vcrit {

/// A ball that frees itself.
class Ball {
 public:
  Ball() { acb_init(z_); }
  explicit Ball(double value) : Ball() { acb_set_d(z_, value); }
  Ball(const Ball& other) : Ball() { acb_set(z_, other.z_); }
  Ball(Ball&& other) noexcept : Ball() { acb_swap(z_, other.z_); }
  Ball& operator=(const Ball& other) {
    acb_set(z_, other.z_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    acb_swap(z_, other.z_);
    return *this;
  }
  ~Ball() { acb_clear(z_); }
  acb_ptr get() { return z_; }
  acb_srcptr get() const { return z_; }

 private:
  acb_t z_{};
};

/// Ball arithmetic of one precision.
struct Arithmetic {
  slong precision;

  using Operation = void(acb_ptr, acb_srcptr, acb_srcptr, slong);
  Ball apply(Operation* operation, const Ball& a, const Ball& b) const {
    Ball c;
    operation(c.get(), a.get(), b.get(), precision);
    return c;
  }
  Ball add(const Ball& a, const Ball& b) const { return apply(acb_add, a, b); }
  Ball subtract(const Ball& a, const Ball& b) const { return apply(acb_sub, a, b); }
  Ball multiply(const Ball& a, const Ball& b) const { return apply(acb_mul, a, b); }
  Ball divide(const Ball& a, const Ball& b) const { return apply(acb_div, a, b); }
  Ball times_i(const Ball& a) const {
    Ball c;
    acb_mul_onei(c.get(), a.get());
    return c;
  }
  Ball modulus(const Ball& a) const {
    Ball c;
    acb_abs(acb_realref(c.get()), a.get(), precision);
    return c;
  }
};

inline Ball read_decimal(const TypedNumber& number, slong precision) {
  Ball exactly;
  arb_set_str(acb_realref(exactly.get()), number.decimal.c_str(), precision);
  return exactly;
}

class ReadDecimals;

/// One number of a scene, times a factor.
struct Shift {
  Symbol symbol;
  Ball factor;
};

/// The arithmetic with a scene's numbers, as the algebra that a reduction runs in.
struct Balls : Arithmetic {
  using Value = Ball;
  const Values& values;
  Ball omega;
  const Shift* shift = nullptr;
  const BySymbol<TypedNumber>* typed = nullptr;  ///< of the scene; none: doubles
  ReadDecimals* decimals = nullptr;              ///< that were read before

  Ball of(const Symbol& symbol) const { return shifted(symbol, values.at(symbol)); }
  Ball shifted(const Symbol& symbol, double value) const {
    const bool changed = shift != nullptr && shift->symbol == symbol;
    const Ball own = exact(symbol, value);
    return changed ? multiply(own, shift->factor) : own;
  }

  Ball constant(const TypedNumber& number) const { return decimal(number); }
  Ball plus(const Ball& a, const Ball& b) const { return add(a, b); }
  Ball times(const Ball& a, const Ball& b) const { return multiply(a, b); }
  Ball over(const Ball& a, const Ball& b) const { return divide(a, b); }

  /// As it was typed, where that is still the value.
  Ball exact(const Symbol& symbol, double value) const {
    const TypedNumber* const found = typed == nullptr ? nullptr : typed->find(symbol);
    return found == nullptr || found->value != value ? Ball(value) : exact(*found);
  }
  Ball exact(const TypedNumber& number) const {
    return number.decimal.empty() ? Ball(number.value) : decimal(number);
  }

  Ball decimal(const TypedNumber& number) const;

  /// m omega^2
  Ball inertia(const Symbol& mass) const { return multiply(of(mass), multiply(omega, omega)); }

  Ball times_s(const Ball& k) const { return times_i(multiply(k, omega)); }
  Ball relaxing(const Ball& k, const Ball& tau) const {
    const Ball x = times_i(multiply(omega, tau));
    return divide(multiply(k, x), add(Ball(1), x));
  }
  Ball lossy(const Ball& k, const Ball& eta) const { return add(k, times_i(multiply(k, eta))); }
  Ball parallel(const Ball& a, const Ball& b) const { return add(a, b); }
  Ball series(const Ball& a, const Ball& b) const { return mesh(a, b, add(a, b)); }
  Ball mesh(const Ball& a, const Ball& b, const Ball& total) const {
    return divide(multiply(a, b), total);
  }
};

}  // namespace vcrit
