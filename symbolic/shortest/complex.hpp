// Complex numbers and their quotients with real and imaginary parts as expressions.
#pragma once

#include <vector>

#include "shortest/expressions.hpp"

namespace vcrit::symbolic::shortest {

struct ComplexEx {
  Ex re = Expressions::number(0), im = Expressions::number(0);
  bool is_zero() const { return re.is_zero() && im.is_zero(); }
  bool is_real() const { return im.is_zero(); }
  bool is_one() const { return im.is_zero() && re.is_one(); }
  friend bool operator==(const ComplexEx&, const ComplexEx&) = default;
};

inline ComplexEx from_real(const Ex& re) { return {re, Expressions::number(0)}; }
inline ComplexEx from_imaginary(const Ex& im) { return {Expressions::number(0), im}; }

/// over/under: one of the ways to write a stiffness, a compliance or their like.
struct ComplexQuotient {
  ComplexEx over, under = from_real(Expressions::number(1));
  friend bool operator==(const ComplexQuotient&, const ComplexQuotient&) = default;
};

inline ComplexQuotient reciprocal(const ComplexQuotient& q) { return {q.under, q.over}; }

class ComplexAlgebra {
 public:
  explicit ComplexAlgebra(Expressions& all) : all_(all) {}

  ComplexEx add(const ComplexEx& a, const ComplexEx& b);
  ComplexEx multiply(const ComplexEx& a, const ComplexEx& b);
  ComplexEx multiply(const ComplexEx& a, const Ex& real);
  ComplexQuotient multiply(const ComplexQuotient& a, const Ex& real) {
    return {multiply(a.over, real), a.under};
  }
  /// |a|, common factors of both parts in front of the root.
  Ex modulus(const ComplexEx& a);
  Ex modulus(const ComplexQuotient& a) { return all_.divide(modulus(a.over), modulus(a.under)); }
  /// Storage and loss: with 1 below the bar.
  ComplexQuotient cartesian(const ComplexQuotient& a);
  /// In each of the ways in which 1/(a + i b) = (a - i b)/(a^2 + b^2) = (1 - i b/a)/(a + b b/a).
  std::vector<ComplexQuotient> cartesians(const ComplexQuotient& a);

 private:
  Expressions& all_;
};

}  // namespace vcrit::symbolic::shortest
