// Polynomials with integer coefficients, by FLINT: multiplied out, in one order of terms, fast.
#pragma once

#include <flint/fmpz_mpoly.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vcrit {

/// The variables of polynomials, the first one leading in the order of terms. Must outlive its
/// polynomials.
class Ring {
 public:
  explicit Ring(const std::vector<std::string>& names);
  ~Ring();
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  const std::vector<std::string>& names() const { return names_; }
  std::size_t size() const { return names_.size(); }
  std::size_t index(const std::string& name) const;
  bool holds(const std::string& name) const { return index_.contains(name); }
  const fmpz_mpoly_ctx_struct* context() const { return context_; }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> index_;
  fmpz_mpoly_ctx_t context_;
};

class Polynomial {
 public:
  Polynomial(const Ring& ring, long constant);
  static Polynomial variable(const Ring& ring, const std::string& name);
  static Polynomial power(const Ring& ring, const std::string& name, unsigned long exponent);
  Polynomial(const Polynomial& other);
  Polynomial(Polynomial&& other) noexcept;
  Polynomial& operator=(Polynomial other) noexcept;
  ~Polynomial();

  const Ring& ring() const { return *ring_; }
  bool is_zero() const;
  bool is_one() const;
  bool is_number() const;
  std::size_t terms() const;
  /// Exponents of term i, one for each variable, and its coefficient as text.
  std::vector<unsigned long> exponents(std::size_t i) const;
  std::string coefficient(std::size_t i) const;
  unsigned long degree(const std::string& variable) const;
  Polynomial derivative(const std::string& variable) const;
  /// The largest power of the variable that divides every term; of 0 none does.
  unsigned long lowest_degree(const std::string& variable) const;
  /// Divided by variable^power, which must divide every term.
  Polynomial without_power(const std::string& variable, unsigned long power) const;

  /// As a polynomial in one variable, divided by the greatest common divisor of its coefficients;
  /// the leading term positive.
  Polynomial primitive(const std::string& variable) const;

  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator-=(const Polynomial& other);
  Polynomial& operator*=(const Polynomial& other);
  /// Adds coefficient (an integer as text) times the product of the variables' powers.
  void add_term(const std::string& coefficient, const std::vector<unsigned long>& exponents);

  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return std::move(a += b); }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return std::move(a -= b); }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend bool operator==(const Polynomial& a, const Polynomial& b);

  fmpz_mpoly_struct* raw() { return value_; }
  const fmpz_mpoly_struct* raw() const { return value_; }

 private:
  const Ring* ring_;
  fmpz_mpoly_t value_;
};

/// constant * product of factor^exponent: none divides another, and none is a product.
struct FactoredPolynomial {
  std::string constant;
  std::vector<std::pair<Polynomial, unsigned long>> factors;
};
/// Of a polynomial other than 0; takes seconds for thousands of terms.
FactoredPolynomial polynomial_factors(const Polynomial& polynomial);

/// a = factor * a_left, b = factor * b_left, the leading coefficient of the factor positive.
struct SharedFactor {
  Polynomial factor, a_left, b_left;
};
/// Of a and b, the greatest.
SharedFactor shared_factor(const Polynomial& a, const Polynomial& b);

/// over/under
struct PolynomialQuotient {
  Polynomial over, under;
};

/// Without common factors, the leading coefficient below the bar positive.
PolynomialQuotient cancelled(const PolynomialQuotient& quotient);

PolynomialQuotient operator+(const PolynomialQuotient& a, const PolynomialQuotient& b);
PolynomialQuotient operator*(const PolynomialQuotient& a, const PolynomialQuotient& b);
PolynomialQuotient turned_over(const PolynomialQuotient& a);

}  // namespace vcrit
