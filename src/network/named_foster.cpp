#include "network/named_foster.hpp"
#include "base/joined.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace vcrit {

namespace {

constexpr std::size_t longest_integer = 40;         // digits, as of numbers in expressions
constexpr unsigned long largest_written_power = 9;  // likewise

bool is_negative(const std::string& integer) { return integer.starts_with('-'); }

Polynomial negated(const Polynomial& p) { return Polynomial(p.ring(), -1) * p; }

/// 1 or -1 where all terms have that sign, else 0.
int sign_of_terms(const Polynomial& p) {
  const bool negative = is_negative(p.coefficient(0));
  for (std::size_t i = 1; i < p.terms(); ++i)
    if (is_negative(p.coefficient(i)) != negative) return 0;
  return negative ? -1 : 1;
}

/// The coefficients of its powers of a variable, from that of power 0 on.
std::vector<Polynomial> in_powers_of(const std::string& variable, const Polynomial& p) {
  std::vector<Polynomial> all(p.degree(variable) + 1, Polynomial(p.ring(), 0));
  for (std::size_t i = 0; i < p.terms(); ++i) {
    std::vector<unsigned long> exponents = p.exponents(i);
    const unsigned long power = std::exchange(exponents[p.ring().index(variable)], 0);
    all[power].add_term(p.coefficient(i), exponents);
  }
  return all;
}

Polynomial power_of(const Polynomial& base, std::size_t exponent) {
  Polynomial all(base.ring(), 1);
  for (std::size_t i = 0; i < exponent; ++i) all *= base;
  return all;
}

std::string power_text(const std::string& base, unsigned long exponent) {
  if (exponent == 1) return base;
  if (exponent <= largest_written_power) return fmt::format("{}^{}", base, exponent);
  return fmt::format("{}^{}*{}", base, largest_written_power,
                     power_text(base, exponent - largest_written_power));
}

std::string term_text(const Polynomial& p, std::size_t i) {
  std::vector<std::string> parts;
  if (const std::string number = p.coefficient(i); number != "1") parts.push_back(number);
  const std::vector<unsigned long> exponents = p.exponents(i);
  for (std::size_t v = 0; v < exponents.size(); ++v)
    if (exponents[v] > 0) parts.push_back(power_text(p.ring().names()[v], exponents[v]));
  if (parts.empty()) return "1";
  const bool is_negated = parts.front() == "-1" && parts.size() > 1;
  if (is_negated) parts.erase(parts.begin());
  return fmt::format("{}{}", is_negated ? "-" : "", joined(parts, "*"));
}

std::string sum_text(const Polynomial& p) {
  std::string all;
  for (std::size_t i = 0; i < p.terms(); ++i) {
    std::string term = term_text(p, i);
    if (i == 0)
      all = term;
    else
      all += is_negative(term) ? " - " + term.substr(1) : " + " + term;
  }
  return all;
}

/// What it is a product of, each part ready to be multiplied; empty for 1.
std::vector<std::string> factor_texts(const Polynomial& p) {
  const FactoredPolynomial product = polynomial_factors(p);
  std::vector<std::string> parts;
  if (product.constant != "1") parts.push_back(product.constant);
  for (const auto& [factor, exponent] : product.factors) {
    const std::string sum = sum_text(factor);
    parts.push_back(power_text(factor.terms() > 1 ? "(" + sum + ")" : sum, exponent));
  }
  // Those of a sum of one sign may have terms of two: a^3 + b^3.
  const bool is_plain = std::all_of(product.factors.begin(), product.factors.end(),
                                    [](const auto& f) { return sign_of_terms(f.first) > 0; });
  if (!is_plain && sign_of_terms(p) > 0) return {"(" + sum_text(p) + ")"};
  std::sort(parts.begin() + (product.constant != "1" ? 1 : 0), parts.end());
  return parts;
}

std::string quotient_text(const PolynomialQuotient& q) {
  const auto product = [](const std::vector<std::string>& parts) {
    if (parts.empty()) return std::string("1");
    std::string all = joined(parts, "*");
    return all.starts_with("-1*") ? "-" + all.substr(3) : all;
  };
  const std::vector<std::string> above = factor_texts(q.over), below = factor_texts(q.under);
  const auto is_bracketed = [](const std::string& text) {
    return text.starts_with('(') && text.ends_with(')');
  };
  // A sum alone needs no brackets.
  const bool is_sum = below.empty() && above.size() == 1 && is_bracketed(above.front());
  if (is_sum) return above.front().substr(1, above.front().size() - 2);
  if (below.empty()) return product(above);
  const std::string under = product(below);
  const bool alone =
      below.size() == 1 && (is_bracketed(under) || under.find_first_of("*^") == std::string::npos);
  return product(above) + "/" + (alone ? under : "(" + under + ")");
}

bool is_number_alone(const Polynomial& p) {
  const std::vector<unsigned long> exponents = p.exponents(0);
  return p.terms() == 1 &&
         std::all_of(exponents.begin(), exponents.end(), [](unsigned long e) { return e == 0; });
}

bool has_long_numbers(const Polynomial& p) {
  for (std::size_t i = 0; i < p.terms(); ++i)
    if (p.coefficient(i).size() > longest_integer) return true;
  return false;
}

/// Thrown to foster(), which gives it back.
struct None {
  NoFosterForm why;
};

class NamedFoster {
 public:
  NamedFoster(const PolynomialQuotient& stiffness, std::string s, std::string name)
      : k_(cancelled(stiffness)),
        s_(std::move(s)),
        name_(std::move(name)),
        above_(in_powers_of(s_, k_.over)),
        below_(in_powers_of(s_, k_.under)) {}

  FosterForm form() {
    if (k_.over.is_zero()) throw None{{"K(s) = 0", "a stiffness other than 0"}};
    if (above_.size() > below_.size() + 1)
      throw None{{fmt::format("K(s) that grows as s^{}", above_.size() - below_.size()),
                  "a numerator of at most one degree more than the denominator",
                  "s alone is a damper; masses stand in a [drive] as mass(m)"}};
    if (below_.front().is_zero())
      throw None{{"a pole at s = 0", "poles s = -a/b below 0", "K(0) is the stiffness at rest"}};
    std::vector<Network> parts;
    if (!above_.front().is_zero()) {
      parts.push_back(spring("k0_" + name_));
      give({"k0_" + name_}, {above_.front(), below_.front()}, "the stiffness at rest");
    }
    if (above_.size() > below_.size()) {
      parts.push_back(damper("c_" + name_));
      give({"c_" + name_}, {above_.back(), below_.back()}, "a damper at high frequency,");
    }
    for (int j = 1; const Polynomial& pole : linear_factors(k_.under)) {
      parts.push_back(maxwell({"k_" + name_, j}, {"tau_" + name_, j}));
      give_branch(pole, j);
      ++j;
    }
    form_.network = parallel(std::move(parts));
    return std::move(form_);
  }

  /// Springs, dampers and Kelvin elements one behind the other: the terms of 1/K at infinity, at 0,
  /// and at the other zeros of K.
  FosterForm form_in_series() {
    if (k_.over.is_zero() || above_.size() < below_.size()) throw None{};
    std::vector<Network> parts;
    if (above_.size() == below_.size()) {
      parts.push_back(spring("k0_" + name_));
      give({"k0_" + name_}, {above_.back(), below_.back()}, "a spring");
    }
    if (above_.front().is_zero()) {
      if (above_[1].is_zero()) throw None{};
      parts.push_back(damper("c0_" + name_));
      give({"c0_" + name_}, {above_[1], below_.front()}, "a damper");
    }
    for (int j = 1; const Polynomial& zero : linear_factors(k_.over)) {
      const Symbol k{"k_" + name_, j}, c{"c_" + name_, j};
      parts.push_back(parallel({spring(k), damper(c)}));
      give_kelvin_element(zero, k, c);
      ++j;
    }
    form_.network = series(std::move(parts));
    return std::move(form_);
  }

 private:
  // a + b s, in one order whatever the factors come in; s alone is none.
  std::vector<Polynomial> linear_factors(const Polynomial& product) const {
    std::vector<Polynomial> all;
    for (const auto& [factor, exponent] : polynomial_factors(product).factors) {
      if (factor == Polynomial::variable(factor.ring(), s_)) continue;
      const unsigned long degree = factor.degree(s_);
      if (degree == 0) continue;
      if (degree > 1)
        throw None{{fmt::format("the factor {} of its denominator, whose roots are no quotients of "
                                "its names",
                                shown(factor)),
                    "a denominator that is a product of factors such as 1 + tau*s",
                    "write the network itself, as in prony(k0, k, tau), or numbers in the place of "
                    "the names"}};
      if (exponent > 1)
        throw None{
            {fmt::format("the factor {} of its denominator, {} times", shown(factor), exponent),
             "each factor once, as springs and dampers have"}};
      all.push_back(is_negative(factor.coefficient(0)) ? negated(factor) : factor);
    }
    std::sort(all.begin(), all.end(), [this](const Polynomial& a, const Polynomial& b) {
      return fmpz_mpoly_cmp(a.raw(), b.raw(), k_.under.ring().context()) > 0;
    });
    return all;
  }

  // K(s) = k0 + c s + sum k_j s/(s - p_j): at the pole p_j = -a/b of the denominator (a + b s) E(s)
  // this is k_j = -N(p_j)/(a E(p_j)), and tau_j = b/a.
  void give_branch(const Polynomial& pole, int j) {
    const std::vector<Polynomial> line = in_powers_of(s_, pole);
    const Polynomial &a = line[0], &b = line[1];
    const std::vector<Polynomial> others = others_in(k_.under, pole);
    give({"tau_" + name_, j}, {b, a}, "a relaxation time");
    give({"k_" + name_, j},
         {negated(at_pole(above_, a, b) * power_of(b, others.size())),
          a * at_pole(others, a, b) * power_of(b, above_.size())},
         "a Maxwell branch of stiffness");
  }

  // 1/K(s) = D(s)/((a + b s) E(s)) has the term 1/(k + c s) with k + c s = (a + b s) E(p)/D(p) at
  // its pole p = -a/b.
  void give_kelvin_element(const Polynomial& zero, const Symbol& k, const Symbol& c) {
    const std::vector<Polynomial> line = in_powers_of(s_, zero);
    const Polynomial &a = line[0], &b = line[1];
    const std::vector<Polynomial> others = others_in(k_.over, zero);
    const Polynomial above = at_pole(others, a, b) * power_of(b, below_.size()),
                     below = at_pole(below_, a, b) * power_of(b, others.size());
    give(k, {a * above, below}, "a spring");
    give(c, {b * above, below}, "a damper");
  }

  /// The other factors of a product, in powers of s.
  std::vector<Polynomial> others_in(const Polynomial& product, const Polynomial& factor) const {
    Polynomial rest(factor.ring(), 0);
    const int divides =
        fmpz_mpoly_divides(rest.raw(), product.raw(), factor.raw(), factor.ring().context());
    ensure(divides != 0, "a factor divides its product");
    return in_powers_of(s_, rest);
  }

  /// sum_i coefficient_i (-a)^i b^(n - i), which is b^n times the polynomial of degree n at -a/b.
  static Polynomial at_pole(const std::vector<Polynomial>& coefficients, const Polynomial& a,
                            const Polynomial& b) {
    const std::size_t n = coefficients.size() - 1;
    Polynomial sum(a.ring(), 0);
    for (std::size_t i = 0; i <= n; ++i)
      sum += coefficients[i] * power_of(negated(a), i) * power_of(b, n - i);
    return sum;
  }

  void give(const Symbol& symbol, const PolynomialQuotient& element, const char* what) {
    const PolynomialQuotient q = cancelled(element);
    const int above = sign_of_terms(q.over), below = sign_of_terms(q.under);
    if (above * below < 0)
      throw None{{fmt::format("{} {}", what, shown(q)), "springs and dampers above 0",
                  "no network of springs and dampers has this K(s): check its signs"}};
    if (above * below == 0)
      throw None{{fmt::format("{} {}", what, shown(q)),
                  "springs, dampers and times that are above 0 at all values of its names",
                  "make the larger one of the smaller in [elements], as in tau1 = \"tau2*(1 + r)\" "
                  "or k1 = \"k0 + d\""}};
    const PolynomialQuotient positive =
        above > 0 ? q : PolynomialQuotient{negated(q.over), negated(q.under)};
    if (has_long_numbers(positive.over) || has_long_numbers(positive.under))
      throw None{{"numbers of very many digits", "at most 40 digits once it is one fraction"}};
    if (!is_number_alone(positive.over) || !is_number_alone(positive.under)) {
      form_.expressions.emplace_back(symbol, quotient_text(positive));
      return;
    }
    auto value = quotient_value(positive.over.coefficient(0), positive.under.coefficient(0));
    if (!value)
      throw None{{fmt::format("an element {} = {}", to_text(symbol), shown(positive)),
                  "elements that doubles can hold"}};
    form_.values.emplace_back(symbol, *std::move(value));
  }

  // For messages: with s for its variable.
  std::string shown(const PolynomialQuotient& q) const { return as_typed(quotient_text(q)); }
  std::string shown(const Polynomial& p) const { return as_typed(sum_text(p)); }
  std::string as_typed(std::string text) const {
    constexpr std::size_t longest = 100;  // of one line
    for (std::size_t at = text.find(s_); at != text.npos; at = text.find(s_, at))
      text.replace(at, s_.size(), "s");
    return text.size() > longest ? "of many terms" : text;
  }

  PolynomialQuotient k_;  // without common factors
  std::string s_, name_;
  std::vector<Polynomial> above_, below_;  // in powers of s
  FosterForm form_;
};

}  // namespace

std::variant<FosterForm, NoFosterForm> named_foster_form(const PolynomialQuotient& stiffness,
                                                         const std::string& s,
                                                         const std::string& name) {
  try {
    return NamedFoster(stiffness, s, name).form();
  } catch (None& none) {
    try {
      return NamedFoster(stiffness, s, name).form_in_series();
    } catch (const None&) {
      return std::move(none.why);
    }
  }
}

}  // namespace vcrit
