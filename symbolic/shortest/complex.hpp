// Complex numbers and their quotients with real and imaginary parts as expressions.
#pragma once

#include <vector>

#include "shortest/expressions.hpp"

namespace vcrit::symbolic::shortest {

struct RealPair {
  Ex re = Expressions::number(0), im = Expressions::number(0);
  bool is_zero() const { return re.is_zero() && im.is_zero(); }
  bool is_real() const { return im.is_zero(); }
  bool is_one() const { return im.is_zero() && re.is_one(); }
  friend bool operator==(const RealPair&, const RealPair&) = default;
};

inline RealPair pair_of(const Ex& re) { return {re, Expressions::number(0)}; }
inline RealPair imaginary(const Ex& im) { return {Expressions::number(0), im}; }

/// over/under: one of the ways to write a stiffness, a compliance or their like.
struct PairQuotient {
  RealPair over, under = pair_of(Expressions::number(1));
  friend bool operator==(const PairQuotient&, const PairQuotient&) = default;
};

inline PairQuotient inverted(const PairQuotient& q) { return {q.under, q.over}; }

class ComplexAlgebra {
 public:
  explicit ComplexAlgebra(Expressions& all) : all_(all) {}

  RealPair add(const RealPair& a, const RealPair& b);
  RealPair multiply(const RealPair& a, const RealPair& b);
  RealPair multiply(const RealPair& a, const Ex& real);
  PairQuotient multiply(const PairQuotient& a, const Ex& real) {
    return {multiply(a.over, real), a.under};
  }
  /// |a|, common factors of both parts in front of the root.
  Ex modulus(const RealPair& a);
  Ex modulus(const PairQuotient& a) { return all_.divide(modulus(a.over), modulus(a.under)); }
  /// Storage and loss: with 1 below the bar.
  PairQuotient cartesian(const PairQuotient& a);
  /// In each of the ways in which 1/(a + i b) = (a - i b)/(a^2 + b^2) = (1 - i b/a)/(a + b b/a).
  std::vector<PairQuotient> cartesians(const PairQuotient& a);

 private:
  Expressions& all_;
};

}  // namespace vcrit::symbolic::shortest
