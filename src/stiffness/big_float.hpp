// Real numbers with any number of bits (Arb's arf_t). Results are truncated, exponents are
// unbounded, and errors are not tracked.
#pragma once

#include <arf.h>

#include <algorithm>
#include <compare>

namespace vcrit {

/// A result has as many bits as its longer operand. A double has 53.
class BigFloat {
 public:
  BigFloat(double value = 0) : BigFloat(value, 53) {}
  BigFloat(double value, slong bits) : bits_(bits) {
    arf_init(x_);
    arf_set_d(x_, value);
  }
  BigFloat(const arf_struct& value, slong bits) : bits_(bits) {
    arf_init(x_);
    arf_set(x_, &value);
  }
  BigFloat(const BigFloat& other) : BigFloat(*other.x_, other.bits_) {}
  BigFloat(BigFloat&& other) noexcept : bits_(other.bits_) {
    arf_init(x_);
    arf_swap(x_, other.x_);
  }
  BigFloat& operator=(const BigFloat& other) {
    bits_ = other.bits_;
    arf_set(x_, other.x_);
    return *this;
  }
  BigFloat& operator=(BigFloat&& other) noexcept {
    bits_ = other.bits_;
    arf_swap(x_, other.x_);
    return *this;
  }
  ~BigFloat() { arf_clear(x_); }

  arf_srcptr get() const { return x_; }
  bool is_finite() const { return arf_is_finite(x_) != 0; }
  slong bits() const { return bits_; }
  /// The smallest n with |x| < 2^n, for a number other than 0.
  slong exponent() const { return arf_abs_bound_lt_2exp_si(x_); }
  /// Rounds to 128 bits first: if the exact number is halfway between two doubles, the small error
  /// of this number must not decide between them.
  double to_double() const {
    BigFloat shorter(0, 128);
    arf_set_round(shorter.x_, x_, shorter.bits_, ARF_RND_NEAR);
    return arf_get_d(shorter.x_, ARF_RND_NEAR);
  }

  friend BigFloat operator+(const BigFloat& a, const BigFloat& b) { return by(arf_add, a, b); }
  friend BigFloat operator-(const BigFloat& a, const BigFloat& b) { return by(arf_sub, a, b); }
  friend BigFloat operator*(const BigFloat& a, const BigFloat& b) {
    return by(arf_mul_rnd_any, a, b);
  }
  friend BigFloat operator/(const BigFloat& a, const BigFloat& b) { return by(arf_div, a, b); }
  BigFloat operator-() const { return 0 - *this; }
  BigFloat& operator+=(const BigFloat& b) { return *this = *this + b; }
  BigFloat& operator-=(const BigFloat& b) { return *this = *this - b; }

  /// Adds or subtracts a * b in place, for inner loops.
  void add_product(const BigFloat& a, const BigFloat& b) {
    arf_addmul(x_, a.x_, b.x_, bits_, ARF_RND_DOWN);
  }
  void subtract_product(const BigFloat& a, const BigFloat& b) {
    arf_submul(x_, a.x_, b.x_, bits_, ARF_RND_DOWN);
  }

  friend BigFloat sqrt(const BigFloat& a) {
    BigFloat root(0, a.bits_);
    arf_sqrt(root.x_, a.x_, a.bits_, ARF_RND_DOWN);
    return root;
  }
  friend BigFloat abs(const BigFloat& a) {
    BigFloat size(a);
    arf_abs(size.x_, a.x_);
    return size;
  }
  /// a 2^exponent, exact.
  friend BigFloat ldexp(const BigFloat& a, slong exponent) {
    BigFloat shifted(a);
    arf_mul_2exp_si(shifted.x_, a.x_, exponent);
    return shifted;
  }
  friend bool operator==(const BigFloat& a, const BigFloat& b) {
    return arf_equal(a.x_, b.x_) != 0;
  }
  friend std::strong_ordering operator<=>(const BigFloat& a, const BigFloat& b) {
    return arf_cmp(a.x_, b.x_) <=> 0;
  }

 private:
  using Operation = int(arf_ptr, arf_srcptr, arf_srcptr, slong, arf_rnd_t);

  static BigFloat by(Operation* operation, const BigFloat& a, const BigFloat& b) {
    BigFloat c(0, std::max(a.bits_, b.bits_));
    operation(c.x_, a.x_, b.x_, c.bits_, ARF_RND_DOWN);
    return c;
  }

  slong bits_;
  arf_t x_{};
};

}  // namespace vcrit
