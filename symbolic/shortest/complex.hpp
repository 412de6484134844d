// Complex numbers and their quotients with real and imaginary parts as expressions.
#pragma once

#include <vector>

#include "shortest/expressions.hpp"

namespace vcrit::symbolic::shortest {

struct Complex {
  Ex re = Expressions::number(0), im = Expressions::number(0);
  bool is_zero() const { return re.is_zero() && im.is_zero(); }
  bool is_real() const { return im.is_zero(); }
  bool is_one() const { return im.is_zero() && re.is_one(); }
  friend bool operator==(const Complex&, const Complex&) = default;
};

inline Complex real(const Ex& re) { return {re, Expressions::number(0)}; }
inline Complex imaginary(const Ex& im) { return {Expressions::number(0), im}; }

/// over/under: one of the ways to write a stiffness, a compliance or their like.
struct Quotient {
  Complex over, under = real(Expressions::number(1));
  friend bool operator==(const Quotient&, const Quotient&) = default;
};

inline Quotient inverse(const Quotient& q) { return {q.under, q.over}; }

class ComplexAlgebra {
 public:
  explicit ComplexAlgebra(Expressions& all) : all_(all) {}

  Complex add(const Complex& a, const Complex& b);
  Complex multiply(const Complex& a, const Complex& b);
  Complex multiply(const Complex& a, const Ex& real);
  Quotient multiply(const Quotient& a, const Ex& real) { return {multiply(a.over, real), a.under}; }
  /// |a|, common factors of both parts in front of the root.
  Ex modulus(const Complex& a);
  Ex modulus(const Quotient& a) { return all_.divide(modulus(a.over), modulus(a.under)); }
  /// Storage and loss: with 1 below the bar.
  Quotient cartesian(const Quotient& a);
  /// In each of the ways in which 1/(a + i b) = (a - i b)/(a^2 + b^2) = (1 - i b/a)/(a + b b/a).
  std::vector<Quotient> cartesians(const Quotient& a);

 private:
  Expressions& all_;
};

}  // namespace vcrit::symbolic::shortest
