// Positive roots of polynomials with integer coefficients, isolated and refined without rounding.
#pragma once

#include <arf.h>
#include <flint/fmpz_poly.h>

#include <optional>
#include <vector>

namespace vcrit {

/// A number m 2^e. Frees itself.
class Dyadic {
 public:
  Dyadic() { arf_init(x_); }
  Dyadic(const Dyadic& other) : Dyadic() { arf_set(x_, other.x_); }
  Dyadic(Dyadic&& other) noexcept : Dyadic() { arf_swap(x_, other.x_); }
  Dyadic& operator=(Dyadic other) noexcept {
    arf_swap(x_, other.x_);
    return *this;
  }
  ~Dyadic() { arf_clear(x_); }
  static Dyadic power_of_two(slong exponent);
  static Dyadic between(const Dyadic& a, const Dyadic& b);
  arf_ptr get() { return x_; }
  arf_srcptr get() const { return x_; }

 private:
  arf_t x_{};
};

/// Holds one root, inside or, where both ends are one, there.
struct RootInterval {
  Dyadic low, high;
};

/// Of a polynomial without repeated roots, by Descartes' rule of signs on intervals that are halved
/// (Vincent, Collins and Akritas).
class PositiveRoots {
 public:
  explicit PositiveRoots(const fmpz_poly_struct* polynomial);
  PositiveRoots(const PositiveRoots&) = delete;
  PositiveRoots& operator=(const PositiveRoots&) = delete;
  ~PositiveRoots();

  /// In no order; nothing where some agree in very many digits, or nearly meet beside the axis.
  std::optional<std::vector<RootInterval>> isolated() const;
  /// Until it is as narrow as 2^-bits of itself.
  void refine(RootInterval& interval, slong bits) const;

 private:
  int most_roots(const Dyadic& low, const Dyadic& high) const;
  int sign_right_of(const Dyadic& x) const;
  int exact_sign(const fmpz_poly_struct* polynomial, const Dyadic& x) const;

  fmpz_poly_t polynomial_;
};

}  // namespace vcrit
