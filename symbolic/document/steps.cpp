#include "document/steps.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "analysis/abbreviated.hpp"
#include "analysis/by_frequency.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

/// Whether omega is a factor of it: loss factors are those of s/omega, written over one bar.
bool has_factor_omega(const EvenOdd& all) {
  return !all.even.is_zero() && all.even.expand().coeff(omega(), 0).is_zero();
}

/// even + i omega odd, in this order; over omega, where that is a factor.
Signed apart(const EvenOdd& all) {
  const bool over_omega = has_factor_omega(all);
  const ex even_part = over_omega ? (all.even / omega()).expand() : all.even;
  const EvenOdd split{by_frequency(even_part), by_frequency(all.odd)};
  Form sum{Form::Kind::sum, "", {}, {}, {}, 1};
  const Signed even = form_of(split.even);
  if (even.form.kind == Form::Kind::sum)
    sum.terms = even.form.terms;
  else if (!split.even.is_zero())
    sum.terms.push_back(even);
  sum.terms.push_back(form_of(GiNaC::I * (over_omega ? ex(1) : omega()) * split.odd));
  if (sum.terms.size() == 1) return sum.terms.front();
  return {false, std::move(sum)};
}

using Powers = std::vector<std::pair<ex, int>>;

/// Above the bar, then below it, each by how it reads: GiNaC's order is another one in each run.
Powers in_order(Powers parts) {
  const auto key = [](const std::pair<ex, int>& part) {
    return std::pair(-part.second, to_text(part.first));
  };
  std::sort(parts.begin(), parts.end(),
            [&key](const auto& a, const auto& b) { return key(a) < key(b); });
  return parts;
}

/// B as a product, with a name for each polynomial that is complex at s = i omega.
struct NamedAmplitude {
  ex whole;
  Factors product;
  std::vector<Equation> polynomials;  ///< P_1 = even + i omega odd, over omega where that can be
};

NamedAmplitude named_amplitude(const Factors& amplitude) {
  NamedAmplitude result{amplitude.value(), {}, {}};
  result.product.multiply_rational(amplitude.coefficient());
  for (const auto& [factor, exponent] : in_order(amplitude.parts())) {
    ex part = factor;
    const EvenOdd split = even_odd(factor);
    if (!GiNaC::is_a<GiNaC::symbol>(factor) && !split.odd.is_zero()) {
      part = quantity("P_" + std::to_string(result.polynomials.size() + 1));
      result.polynomials.push_back({form_of(part).form, apart(split), {}});
    }
    const bool takes_omega = !part.is_equal(factor) && has_factor_omega(split);
    for (int i = 0; i < std::abs(exponent); ++i) {
      result.product.multiply(part, exponent > 0 ? 1 : -1);
      if (takes_omega) result.product.multiply(omega(), exponent > 0 ? 1 : -1);
    }
  }
  return result;
}

/// The line of g is before it.
Prose words_of(const Statement& at, const Abbreviations& names, const NamedAmplitude& named) {
  Prose words{"Multiplied out, with even and odd powers of ", at, " separated"};
  if (names.stiffness && named.whole.has(names.stiffness->left))
    words += {", and ", stated(names.stiffness->left, names.stiffness->right)};
  return words;
}

int operations_in_steps(const NamedAmplitude& named) {
  int sum = printed_operations(named.product.value());
  for (const Equation& each : named.polynomials) sum += operations_in(each.right.form);
  return sum;
}

}  // namespace

std::vector<DocumentBlock> root_steps(const Derivation& derivation, const Abbreviations& names) {
  const ex v = quantity("v*"), a = quantity("a"), b = quantity("b");
  const ex complex = a + GiNaC::I * b;
  const Line absolute{"", GiNaC::abs(complex), GiNaC::sqrt(a * a + b * b)};
  const Statement at = stated(laplace(), GiNaC::I * omega());
  const SymbolicModel& model = *derivation.model;
  const std::optional<Factors> multiplied_out = model.multiplied_out_amplitude();
  if (!multiplied_out)
    return {{{"The absolute value of a product is the product of absolute values; each factor is ",
              complex, " with real ", a, " and ", b, " at ", at},
             {absolute}}};
  NamedAmplitude named = shortest_in(
      names, {},
      [&](const Change& change) {
        return named_amplitude(change.keeps_letters()
                                   ? *multiplied_out
                                   : model.multiplied_out_amplitude(change).value());
      },
      operations_in_steps);
  if (named.polynomials.empty()) return {};
  const ex product = named.product.value().subs(laplace() == GiNaC::I * omega());
  named.polynomials.push_back({form_of(quantity("B")).form, form_of(product), {}});
  return {{words_of(at, names, named), {}, false, named.polynomials},
          {{"The absolute value of a product is the product of absolute values, and ",
            stated(absolute.left, absolute.right), " for real ", a, " and ", b},
           {{"", v, omega() * named.product.modulus()}}}};
}

}  // namespace vcrit::symbolic
