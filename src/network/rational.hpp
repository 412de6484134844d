// Rational functions of s with exact coefficients, by FLINT: a stiffness K(s) as one types it.
#pragma once

#include <flint/fmpq_poly.h>

#include <string>
#include <utility>

namespace vcrit {

/// A polynomial in s with rational coefficients. Frees itself.
class ExactPolynomial {
 public:
  ExactPolynomial() { fmpq_poly_init(value_); }
  /// A decimal number, "4e6" or "0.25", as it is written.
  explicit ExactPolynomial(const std::string& decimal);
  static ExactPolynomial variable();
  ExactPolynomial(const ExactPolynomial& other) : ExactPolynomial() {
    fmpq_poly_set(value_, other.value_);
  }
  ExactPolynomial(ExactPolynomial&& other) noexcept : ExactPolynomial() {
    fmpq_poly_swap(value_, other.value_);
  }
  ExactPolynomial& operator=(ExactPolynomial other) noexcept {
    fmpq_poly_swap(value_, other.value_);
    return *this;
  }
  ~ExactPolynomial() { fmpq_poly_clear(value_); }

  bool is_zero() const { return fmpq_poly_is_zero(value_) != 0; }
  long degree() const { return fmpq_poly_degree(value_); }  ///< -1 of 0
  /// Of a number a/b: "a" and "b", integers without a common factor.
  std::pair<std::string, std::string> fraction() const;
  long bits() const;  ///< of the largest coefficient, with its denominator

  ExactPolynomial operator-() const;
  friend ExactPolynomial operator+(const ExactPolynomial& a, const ExactPolynomial& b);
  friend ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b);
  friend bool operator==(const ExactPolynomial& a, const ExactPolynomial& b) {
    return fmpq_poly_equal(a.value_, b.value_) != 0;
  }

  fmpq_poly_struct* raw() { return value_; }
  const fmpq_poly_struct* raw() const { return value_; }

 private:
  fmpq_poly_t value_;
};

/// above/below.
struct RationalFunction {
  ExactPolynomial above, below;

  /// Without common factors; `below` is not 0.
  RationalFunction reduced() const;
};

}  // namespace vcrit
