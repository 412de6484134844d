// Logarithmic derivatives of a product of powers.
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <string>
#include <vector>

#include "formula/line.hpp"
#include "network/polynomial.hpp"
#include "polynomial/symbol_ring.hpp"

namespace vcrit::symbolic {

/// Of a positive product of powers, roots and absolute values of real polynomials. It may be
/// written in letters, polynomials in other symbols.
class LogarithmicDerivatives {
 public:
  explicit LogarithmicDerivatives(const GiNaC::ex& product, const std::vector<Line>& letters = {});

  /// (x/f) df/dx of the product f: as one fraction, or as a sum of one for each factor where that
  /// is much shorter; nothing if that is too long to read.
  std::optional<GiNaC::ex> by(const GiNaC::ex& x) const;

 private:
  class Sum;

  struct Power {
    GiNaC::ex base;
    GiNaC::ex number;  ///< base = number * polynomial
    Polynomial polynomial;
    long twice;  ///< the exponent
  };
  struct PowerSlope {
    const Power* power;
    Polynomial value;  ///< x f' of the base f
    bool of_itself;    ///< where f is x
  };
  struct Letter {
    std::string name;
    Polynomial meaning;
  };

  /// |f| and f have one logarithmic derivative; numbers have none.
  void put(const GiNaC::ex& factor, const GiNaC::numeric& exponent);
  /// x f'
  Polynomial slope_of(const Polynomial& f, const std::string& x) const;

  SymbolRing symbols_;
  std::vector<Power> powers_;
  std::vector<Letter> letters_;
};

}  // namespace vcrit::symbolic
