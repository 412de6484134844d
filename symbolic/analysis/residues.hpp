// v*^2 evaluated in the integers modulo the prime p = 2^61 - 1, at a point that the names of its
// symbols decide. Two formulas that are one function agree at every point; two functions of degree
// d in numerator and denominator agree at a random one with a chance of at most 2 d/p (Schwartz,
// Zippel). No network is too large, and nothing depends on how a formula is written.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "derivation/model.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

/// A number modulo 2^61 - 1.
class Residue {
 public:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;
  Residue() = default;
  explicit Residue(std::uint64_t value) : value_(value % prime) {}
  explicit Residue(const GiNaC::numeric& rational);

  std::uint64_t value() const { return value_; }
  friend Residue operator+(Residue a, Residue b);
  friend Residue operator*(Residue a, Residue b);
  friend Residue operator-(Residue a) { return Residue(prime - a.value_); }
  friend Residue power(Residue a, std::uint64_t exponent);
  /// Throws NoInverse for 0.
  friend Residue inverse(Residue a);
  friend bool operator==(Residue, Residue) = default;

 private:
  std::uint64_t value_ = 0;
};

struct NoInverse {};

/// a + b i with residues a and b. -1 is no square modulo the prime, so that these are a field, and
/// each residue has a root in it: what is computed with complex numbers can be computed here.
struct GaussianResidue {
  Residue re, im;
  GaussianResidue() = default;
  GaussianResidue(Residue real, Residue imaginary = {}) : re(real), im(imaginary) {}
  /// real or complex
  explicit GaussianResidue(const GiNaC::numeric& number);

  friend GaussianResidue operator+(GaussianResidue a, GaussianResidue b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend GaussianResidue operator*(GaussianResidue a, GaussianResidue b) {
    return {a.re * b.re + -(a.im * b.im), a.re * b.im + a.im * b.re};
  }
  friend GaussianResidue operator-(GaussianResidue a) { return {-a.re, -a.im}; }
  friend GaussianResidue conjugate(GaussianResidue a) { return {a.re, -a.im}; }
  friend GaussianResidue inverse(GaussianResidue a);
  friend bool operator==(GaussianResidue, GaussianResidue) = default;
};

/// One of the two roots of a residue.
GaussianResidue square_root(Residue a);

/// A number and its derivative along a line of points.
struct DualResidue {
  GaussianResidue value, change;
  DualResidue() = default;
  DualResidue(GaussianResidue v, GaussianResidue d = {}) : value(v), change(d) {}
  explicit DualResidue(const GiNaC::numeric& number) : value(number) {}

  friend DualResidue operator+(DualResidue a, DualResidue b) {
    return {a.value + b.value, a.change + b.change};
  }
  friend DualResidue operator*(DualResidue a, DualResidue b) {
    return {a.value * b.value, a.value * b.change + a.change * b.value};
  }
  friend DualResidue operator-(DualResidue a) { return {-a.value, -a.change}; }
  friend DualResidue conjugate(DualResidue a) { return {conjugate(a.value), conjugate(a.change)}; }
  friend DualResidue inverse(DualResidue a) {
    const GaussianResidue over = inverse(a.value);
    return {over, -(a.change * over * over)};
  }
};

/// Of numbers that the symbols have those of stiffnesses, for evaluate(), and of rational functions
/// of both, for evaluate_rational(). Number: one of those above.
template <class Number>
struct NumberAlgebra {
  using Value = Number;
  std::function<Number(const std::string& symbol)> point;
  Number s;
  std::map<std::string, Number> known = {};  ///< besides s and the symbols

  Value of(const Symbol& symbol) const { return point(to_text(symbol)); }
  Value constant(const TypedNumber& given) const { return number(exact_decimal(given.decimal)); }
  Value plus(Value a, Value b) const { return a + b; }
  Value times(Value a, Value b) const { return a * b; }
  Value over(Value a, Value b) const { return a * inverse(b); }
  Value times_s(Value k) const { return k * s; }
  Value relaxing(Value k, Value tau) const {
    const Value turn = tau * s;
    return k * turn * inverse(number(1) + turn);
  }
  Value lossy(Value k, Value eta) const { return k + k * eta * s * inverse(point("omega")); }
  Value parallel(Value a, Value b) const { return a + b; }
  Value series(Value a, Value b) const { return a * b * inverse(a + b); }
  Value mesh(Value a, Value b, Value total) const { return a * b * inverse(total); }

  Value number(const GiNaC::numeric& value) const { return Number(value); }
  Value name(const std::string& name) const {
    if (name == own_name("s")) return s;
    const auto found = known.find(name);
    return found == known.end() ? point(name) : found->second;
  }
  Value add(Value a, Value b) const { return a + b; }
  Value multiply(Value a, Value b) const { return a * b; }
  Value invert(Value a) const { return inverse(a); }
};

/// The value of each symbol at a point.
using ResiduePoint = std::function<Residue(const std::string& symbol)>;

/// The point of that number: each symbol's value is a hash of its name.
ResiduePoint named_point(std::uint64_t number);

/// v*^2/(mu0 du_z)^2 with s for i omega; nothing where a division by 0 is met on the way.
std::optional<Residue> square_at(const SymbolicModel& model, const ResiduePoint& point);

/// A bound on the chance that two functions of these models that differ agree at a random point.
double chance_of_agreement(const SymbolicModel& a, const SymbolicModel& b);

/// 32 hexadecimal digits that are the same for formulas that are one function of the same symbols,
/// and differ otherwise, but for a chance below 1e-30.
std::string fingerprint(const SymbolicModel& model);

}  // namespace vcrit::symbolic
