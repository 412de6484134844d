#include "analysis/retardation.hpp"

#include <string>

#include "analysis/rheology.hpp"
#include "derivation/factors.hpp"
#include "formula/symbols.hpp"
#include "network/masses.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

ex retardation_symbol(const char* letter, std::size_t i) {
  return positive_quantity(letter + std::to_string(i));
}

/// s^power of a polynomial; 0 beyond its degree.
ex coefficient_of(const ex& polynomial, int power) { return polynomial.coeff(laplace(), power); }

class RetardationMaker {
 public:
  /// Whether the part has a closed form.
  bool add(const Network& part) {
    const Fraction k = stiffness_in_lowest_terms(part);
    const int low = k.numerator.ldegree(laplace()), high = k.numerator.degree(laplace());
    if (high - low > 2) return false;
    if (high == k.denominator.degree(laplace()))
      result_.glassy += factored(k.denominator.lcoeff(laplace()) / k.numerator.lcoeff(laplace()));
    if (low == 1)
      result_.fluidity +=
          factored(coefficient_of(k.denominator, 0) / coefficient_of(k.numerator, 1));
    if (high - low == 1) add_single(k, low);
    if (high - low == 2) add_pair(k, low);
    return true;
  }
  RetardationSpectrum result() && { return std::move(result_); }

 private:
  void add_single(const Fraction& k, int low) {
    const ex at_rest = coefficient_of(k.numerator, low);
    const ex time = factored(coefficient_of(k.numerator, low + 1) / at_rest);
    put(time, compliance(k, low, time, at_rest));
  }

  /// N(-1/lambda) = 0 is a0 lambda^2 - a1 lambda + a2 = 0; the longer time comes first.
  void add_pair(const Fraction& k, int low) {
    const ex a0 = coefficient_of(k.numerator, low), a1 = coefficient_of(k.numerator, low + 1),
             a2 = coefficient_of(k.numerator, low + 2);
    const ex root = GiNaC::sqrt(a1 * a1 - 4 * a0 * a2);
    const std::size_t first = result_.lines.size() + 1;
    const ex one = retardation_symbol("lambda_", first),
             two = retardation_symbol("lambda_", first + 1);
    // From N = a0 s^low (1 + lambda_1 s)(1 + lambda_2 s).
    put((a1 + root) / (2 * a0), compliance(k, low, one, a0 * (one - two) / one));
    put((a1 - root) / (2 * a0), compliance(k, low, two, a0 * (two - one) / two));
  }

  /// (1 + lambda s)/K at s = -1/lambda, where N = s^low (1 + lambda s) `rest`.
  static ex compliance(const Fraction& k, int low, const ex& lambda, const ex& rest) {
    const ex s = -1 / lambda;
    return factored(k.denominator.subs(laplace() == s) / (GiNaC::pow(s, low) * rest));
  }

  void put(const ex& time, const ex& compliance) {
    const std::size_t i = result_.lines.size() + 1;
    result_.lines.push_back({{"", retardation_symbol("lambda_", i), time},
                             {"", retardation_symbol("j_", i), compliance}});
  }

  RetardationSpectrum result_;
};

}  // namespace

ex RetardationSpectrum::sum() const {
  const AlgebraLock lock;
  ex result = glassy + fluidity / laplace();
  for (const auto& [time, compliance] : lines)
    result += compliance.left / (1 + time.left * laplace());
  return result;
}

std::optional<RetardationSpectrum> retardation_spectrum(const Network& network) {
  const AlgebraLock lock;
  if (!of_springs_and_dampers(network)) return std::nullopt;
  RetardationMaker maker;
  const auto* series = std::get_if<Series>(&network.form);
  for (const Network& part : series != nullptr ? series->parts : std::vector{network})
    if (!maker.add(part)) return std::nullopt;
  return std::move(maker).result();
}

}  // namespace vcrit::symbolic
