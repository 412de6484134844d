#include "analysis/rheology.hpp"

#include <string>

#include "derivation/factors.hpp"
#include "derivation/stiffness_forms.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/form.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"
#include "network/reduction.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

/// s^power of a polynomial; 0 beyond its degree.
ex coefficient(const ex& polynomial, int power) { return polynomial.coeff(laplace(), power); }

ex leading_ratio(const Fraction& k) {
  return factored(k.numerator.lcoeff(laplace()) / k.denominator.lcoeff(laplace()));
}

int degree_in_s(const ex& polynomial) { return polynomial.degree(laplace()); }

/// The networks side by side that make up this one.
std::vector<Network> parts_of(const Network& network) {
  if (const auto* parallel = std::get_if<Parallel>(&network.form)) return parallel->parts;
  return {network};
}

/// tau_j, h_j: j counts from 1.
ex numbered(const char* letter, std::size_t j) {
  return positive_quantity(letter + std::to_string(j));
}

class SpectrumMaker {
 public:
  /// Whether the part has a closed form.
  bool add(const Network& part) {
    const auto* element = std::get_if<Element>(&part.form);
    if (element != nullptr && element->kind == ElementKind::maxwell && is_plain(*element))
      return add_given(*element);
    const Fraction k = stiffness_in_lowest_terms(part);
    const StiffnessExtremes ends = extremes(part);
    spectrum_.equilibrium += ends.equilibrium;
    spectrum_.damper += ends.damper;
    if (degree_in_s(k.denominator) > 2) return false;
    if (degree_in_s(k.denominator) == 1) add_single(k);
    if (degree_in_s(k.denominator) == 2) add_pair(k);
    return true;
  }
  RelaxationSpectrum result() && { return std::move(spectrum_); }

 private:
  bool add_given(const Element& branch) {
    const ex time = symbol(branch.second.symbol()), strength = symbol(branch.coefficient.symbol());
    spectrum_.lines.push_back({{"", time, time}, {"", strength, strength}});
    return true;
  }

  void add_single(const Fraction& k) {
    const ex slope = coefficient(k.denominator, 1);
    const ex time = factored(slope / coefficient(k.denominator, 0));
    put(time, strength(k, time, slope));
  }

  /// D(-1/tau) = 0 is d0 tau^2 - d1 tau + d2 = 0; the longer time comes first.
  void add_pair(const Fraction& k) {
    const ex d0 = coefficient(k.denominator, 0), d1 = coefficient(k.denominator, 1),
             d2 = coefficient(k.denominator, 2);
    const ex root = GiNaC::sqrt(d1 * d1 - 4 * d0 * d2);
    const std::size_t first = spectrum_.lines.size() + 1;
    const ex one = numbered("tau_", first), two = numbered("tau_", first + 1);
    // From D = d0 (1 + tau_1 s)(1 + tau_2 s).
    put((d1 + root) / (2 * d0), strength(k, one, d0 * (one - two)));
    put((d1 - root) / (2 * d0), strength(k, two, d0 * (two - one)));
  }

  /// The residue of K/s at s = -1/tau, where `slope` is D'.
  static ex strength(const Fraction& k, const ex& tau, const ex& slope) {
    return factored(-tau * k.numerator.subs(laplace() == -1 / tau) / slope);
  }

  void put(const ex& time, const ex& strength) {
    const std::size_t j = spectrum_.lines.size() + 1;
    spectrum_.lines.push_back({{"", numbered("tau_", j), time}, {"", numbered("h_", j), strength}});
  }

  RelaxationSpectrum spectrum_;
};

/// Re and Im of N(i omega) conj(D(i omega)), polynomials in omega.
struct ComplexParts {
  ex real, imaginary;
};

ComplexParts product_with_conjugate(const Fraction& k) {
  const ex s = laplace(), w = omega();
  const ex product =
      (k.numerator.subs(s == GiNaC::I * w) * k.denominator.subs(s == -GiNaC::I * w)).expand();
  return {product.real_part().expand(), product.imag_part().expand()};
}

/// over/|D|^2, where |D|^2 stays a sum of two squares.
ex over_square(const ex& over, const ex& denominator) {
  if (over.is_zero()) return 0;
  Factors above, below;
  above.multiply(over, 1);
  below.multiply(denominator, -1);
  return above.value() * GiNaC::pow(below.modulus(), 2);
}

Response as_one_fraction(const Fraction& k) {
  const ComplexParts product = product_with_conjugate(k);
  return {factored(k.numerator / k.denominator), over_square(product.real, k.denominator),
          over_square(product.imaginary, k.denominator)};
}

}  // namespace

Fraction stiffness_in_lowest_terms(const Network& network) {
  const AlgebraLock lock;
  const Fraction k = fraction(reduce(network), {}).value;
  const ex parts = (k.numerator / k.denominator).normal().numer_denom();
  const int sign = leads_with_minus(parts.op(1)) ? -1 : 1;
  return {(sign * parts.op(0)).expand(), (sign * parts.op(1)).expand()};
}

ex RelaxationSpectrum::sum() const {
  const AlgebraLock lock;
  const ex s = laplace();
  ex result = equilibrium + damper * s;
  for (const auto& [time, strength] : lines)
    result += strength.left * time.left * s / (1 + time.left * s);
  return result;
}

ex RelaxationSpectrum::in_elements(const ex& expression) const {
  const AlgebraLock lock;
  GiNaC::exmap strengths, times;
  for (const auto& [time, strength] : lines) {
    strengths[strength.left] = strength.right;
    times[time.left] = time.right;
  }
  return expression.subs(strengths).subs(times);
}

std::optional<RelaxationSpectrum> spectrum(const Network& network) {
  const AlgebraLock lock;
  if (!of_springs_and_dampers(network)) return std::nullopt;
  SpectrumMaker maker;
  for (const Network& part : parts_of(network))
    if (!maker.add(part)) return std::nullopt;
  return std::move(maker).result();
}

Response response(const Network& network) {
  const AlgebraLock lock;
  // Terms that one line of a page has.
  constexpr std::size_t readable = 12;
  const Fraction whole = stiffness_in_lowest_terms(network);
  if (whole.numerator.nops() <= readable) {
    Response one = as_one_fraction(whole);
    std::vector<Line> inside;  // with i in the place of s/omega
    if (!is_rational(network)) one.stiffness = nested(reduce(network), {}, inside).value;
    return one;
  }
  Response sum;
  for (const Network& part : parts_of(network)) {
    const Response one = as_one_fraction(stiffness_in_lowest_terms(part));
    sum.stiffness += one.stiffness;
    sum.storage += one.storage;
    sum.loss += one.loss;
  }
  return sum;
}

// A spring-damper network has neither a pole at rest nor more than a damper's growth.
StiffnessExtremes extremes(const Network& network) {
  const AlgebraLock lock;
  const Fraction k = stiffness_in_lowest_terms(network);
  const ex under = coefficient(k.denominator, 0);
  const ex at_rest = factored(coefficient(k.numerator, 0) / under);
  if (!is_rational(network)) return {at_rest, 0, 0, 0};
  const bool flows = at_rest.is_zero();
  const bool damped = degree_in_s(k.numerator) > degree_in_s(k.denominator);
  return {at_rest, flows ? factored(coefficient(k.numerator, 1) / under) : ex(0),
          damped ? ex(0) : leading_ratio(k), damped ? leading_ratio(k) : ex(0)};
}

}  // namespace vcrit::symbolic
