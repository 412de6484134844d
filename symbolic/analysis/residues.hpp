// v*^2 evaluated in the integers modulo the prime p = 2^61 - 1, at a point that the names of its
// symbols decide. Two formulas that are one function agree at every point; two functions of degree
// d in numerator and denominator agree at a random one with a chance of at most 2 d/p (Schwartz,
// Zippel). No network is too large, and nothing depends on how a formula is written.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "derivation/model.hpp"

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
  /// Throws NoInverse for 0.
  friend Residue inverse(Residue a);
  friend bool operator==(Residue, Residue) = default;

 private:
  std::uint64_t value_ = 0;
};

struct NoInverse {};

/// The value of each symbol at a point.
using Point = std::function<Residue(const std::string& symbol)>;

/// The point of that number: each symbol's value is a hash of its name.
Point named_point(std::uint64_t number);

/// v*^2/(mu0 du_z)^2 with s for i omega; nothing where a division by 0 is met on the way.
std::optional<Residue> square_at(const Model& model, const Point& point);

/// A bound on the chance that two functions of these models that differ agree at a random point.
double chance_of_agreement(const Model& a, const Model& b);

/// 32 hexadecimal digits that are the same for formulas that are one function of the same symbols,
/// and differ otherwise, but for a chance below 1e-30.
std::string fingerprint(const Model& model);

}  // namespace vcrit::symbolic
