// What the parser of a stiffness K(s) computes with: numbers alone, or numbers and names, or
// nothing, where it looks for names.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "network/amount.hpp"
#include "network/polynomial.hpp"
#include "network/rational.hpp"

namespace vcrit {

/// What the names in a stiffness stand for.
struct StiffnessNames {
  /// What [elements] calls it.
  std::function<Symbol(const Symbol&)> called;
  /// The expression that [elements] has for it; null where it has none.
  std::function<AmountTreePointer(const Symbol&)> expression;
};

/// Throws InputError, at `place`: for a stiffness that is too large.
[[noreturn]] void refuse_large_stiffness(const Place& place);

constexpr int largest_degree_of_stiffness = 40;  // beyond that, prony() with its own numbers

/// Rational functions of s with rational coefficients.
class TypedNumberAlgebra {
 public:
  using Value = RationalFunction;
  /// `place` by reference, of the text.
  explicit TypedNumberAlgebra(const Place& place) : place_(place) {}

  static Value number(const std::string& decimal) { return {ExactPolynomial(decimal), one()}; }
  static Value s() { return {ExactPolynomial::variable(), one()}; }
  static Value named(const Symbol&, const Place&) { throw Bug("a stiffness of numbers alone"); }
  static bool is_zero(const Value& a) { return a.above.is_zero(); }
  static Value negative(const Value& a) { return {-a.above, a.below}; }
  Value plus(const Value& a, const Value& b) const;
  Value times(const Value& a, const Value& b) const;
  Value over(const Value& a, const Value& b) const { return times(a, {b.below, b.above}); }

 private:
  static ExactPolynomial one() { return ExactPolynomial("1"); }
  ExactPolynomial product(const ExactPolynomial& a, const ExactPolynomial& b) const;

  const Place& place_;
};

/// Collects the names, each with what it is made of.
class NameCollector {
 public:
  struct Value {};
  /// By reference.
  explicit NameCollector(const StiffnessNames& names) : names_(names) {}

  static Value number(const std::string&) { return {}; }
  static Value s() { return {}; }
  /// Throws InputError for names whose expressions contain themselves.
  Value named(const Symbol& name, const Place& place);
  static bool is_zero(const Value&) { return false; }
  static Value negative(const Value&) { return {}; }
  static Value plus(const Value&, const Value&) { return {}; }
  static Value times(const Value&, const Value&) { return {}; }
  static Value over(const Value&, const Value&) { return {}; }
  // Of expressions.
  Value of(const Symbol& name) { return named(name, place_); }
  static Value constant(const TypedNumber&) { return {}; }

  /// Those that have no expression, in the order of writing, each once.
  const std::vector<Symbol>& leaves() const { return leaves_; }
  /// The keys of [elements] on the way to them.
  const std::set<std::string>& keys() const { return keys_; }

 private:
  const StiffnessNames& names_;
  std::vector<Symbol> leaves_, way_;
  std::set<std::string> keys_;
  std::set<Symbol> known_;
  Place place_;
};

/// Quotients of polynomials in s and the names.
class NamedAlgebra {
 public:
  using Value = PolynomialQuotient;
  /// All by reference; `leaves`: of the collector.
  NamedAlgebra(const StiffnessNames& names, const std::vector<Symbol>& leaves, const Place& place);

  Value number(const std::string& decimal) const;
  Value s() const { return {Polynomial::variable(ring_, variable()), Polynomial(ring_, 1)}; }
  Value named(const Symbol& name, const Place&) { return of(name); }
  static bool is_zero(const Value& a) { return a.over.is_zero(); }
  Value negative(const Value& a) const { return {Polynomial(ring_, -1) * a.over, a.under}; }
  Value plus(const Value& a, const Value& b) const;
  Value times(const Value& a, const Value& b) const;
  Value over(const Value& a, const Value& b) const { return times(a, {b.under, b.over}); }
  // Of expressions.
  Value of(const Symbol& name);
  Value constant(const TypedNumber& number) const { return this->number(number.decimal); }

  /// Of s among the polynomials' variables: no element is called so.
  static std::string variable() { return "(s)"; }

 private:
  Value checked(const Value& a) const;
  void refuse_large_product(const Polynomial& a, const Polynomial& b) const;

  const StiffnessNames& names_;
  Ring ring_;
  const Place& place_;
  std::map<Symbol, Value> known_;
};

}  // namespace vcrit
