// Formulas in presentation MathML, which browsers set without help.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "base/joined.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/notation.hpp"

namespace vcrit::symbolic {

namespace {

/// The characters of the greek letters; "Delta" is the only capital that occurs.
std::string letter(const std::string& word) {
  static const std::map<std::string, std::string> characters{
      {"alpha", "α"}, {"beta", "β"}, {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ε"},
      {"zeta", "ζ"},  {"eta", "η"},  {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"},
      {"mu", "μ"},    {"nu", "ν"},   {"xi", "ξ"},    {"rho", "ρ"},   {"sigma", "σ"},
      {"tau", "τ"},   {"phi", "φ"},  {"chi", "χ"},   {"psi", "ψ"},   {"omega", "ω"},
      {"pi", "π"},    {"Delta", "Δ"}};
  const auto found = characters.find(word);
  return found == characters.end() ? word : found->second;
}

/// In italics if it is a single letter; words say that they are upright, as a page's style cannot
/// tell (mathml_style()).
std::string identifier(const std::string& text) {
  const auto letters =
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return (letters == 1 ? "<mi>" : "<mi mathvariant=\"normal\">") + text + "</mi>";
}

std::string mathml_index_part(const std::string& part) {
  const bool digits = std::isdigit(static_cast<unsigned char>(part.front())) != 0;
  return digits ? "<mn>" + part + "</mn>" : identifier(letter(part));
}

class MathMlDialect : public Dialect {
 protected:
  std::string number(const std::string& digits) const override {
    const std::size_t bar = digits.find('/');
    if (bar == std::string::npos) return "<mn>" + digits + "</mn>";
    return "<mfrac>" + number(digits.substr(0, bar)) + number(digits.substr(bar + 1)) + "</mfrac>";
  }
  std::string name(const std::string& symbol) const override { return set(printed_name(symbol)); }
  static std::string set(const std::string& text) {
    if (is_set_apart(text)) return identifier(text);
    if (is_sensitivity(text))
      return "<msub><mi>S</mi><mrow>" + set(text.substr(2)) + "</mrow></msub>";
    const Notation n = notation(text, has_bare_entry(text));
    std::string result = identifier(letter(n.base));
    const auto dots = std::count(n.above.begin(), n.above.end(), '\'');
    if (dots > 0)
      result = fmt::format("<mover>{}<mo>{}</mo></mover>", result, dots == 1 ? "˙" : "¨");
    std::vector<std::string> parts;
    for (const std::string& part : n.index) parts.push_back(mathml_index_part(part));
    const std::string index = joined(parts, "<mo>,</mo>");
    const bool star = n.above == "*";
    if (!n.primes.empty())
      return fmt::format("<msubsup>{}<mrow>{}</mrow><mo>{}</mo></msubsup>", result, index,
                         n.primes.size() == 1 ? "′" : "″");
    if (!index.empty() && !star)
      result = fmt::format("<msub>{}<mrow>{}</mrow></msub>", result, index);
    if (star) result = fmt::format("<msup>{}<mo>*</mo></msup>", result);
    if (n.before.empty()) return result;
    return fmt::format("<mrow><mi mathvariant=\"normal\">{}</mi>{}</mrow>", letter(n.before),
                       result);
  }
  std::string negative(const std::string& term) const override { return "<mo>−</mo>" + term; }
  std::string added(const std::string& left, bool minus, const std::string& right) const override {
    return left + (minus ? "<mo>−</mo>" : "<mo>+</mo>") + right;
  }
  std::string product(const std::vector<std::string>& factors) const override {
    return factors.empty() ? "<mn>1</mn>" : joined(factors, "<mo>&#x2062;</mo>");
  }
  PrintedPart fraction(const std::vector<PrintedPart>& over,
                       const std::vector<PrintedPart>& under) const override {
    return {fmt::format("<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>",
                        product(factors(over, true)), product(factors(under, true))),
            PrintedPart::Tightness::product};
  }
  PrintedPart inner_fraction(const std::vector<PrintedPart>& over,
                             const std::vector<PrintedPart>& under) const override {
    return slashed(over, under, "<mo>/</mo>");
  }
  std::string power(const std::string& base, int exponent) const override {
    return fmt::format("<msup><mrow>{}</mrow><mn>{}</mn></msup>", base, exponent);
  }
  std::string root(const std::string& argument) const override {
    return "<msqrt><mrow>" + argument + "</mrow></msqrt>";
  }
  std::string call(const std::string& function, const std::string& argument) const override {
    if (function == "abs")
      return "<mrow><mo fence=\"true\">|</mo>" + argument + "<mo fence=\"true\">|</mo></mrow>";
    if (function == "exp" && printed_name(own_name("e")) == "e")
      return "<msup><mi>e</mi><mrow>" + argument + "</mrow></msup>";
    return identifier(function) + wrapped(argument);
  }
  std::string wrapped(const std::string& text) const override {
    return "<mrow><mo>(</mo>" + text + "<mo>)</mo></mrow>";
  }
  std::string related(const std::string& left, bool asymptotic,
                      const std::string& right) const override {
    return left + (asymptotic ? "<mo>∼</mo>" : "<mo>=</mo>") + right;
  }
  std::string tending(const std::string& left, const std::string& right) const override {
    return left + "<mo>→</mo>" + right;
  }
  std::string infinity() const override { return "<mi mathvariant=\"normal\">∞</mi>"; }
  std::string range(const std::string& index, int first, int last) const override {
    return fmt::format("{}<mo>=</mo><mn>{}</mn><mo>,</mo><mo>…</mo><mo>,</mo><mn>{}</mn>",
                       identifier(index), first, last);
  }
  std::string series(const std::string& term, const std::string& index, int first,
                     int last) const override {
    return fmt::format(
        "<munderover><mo>∑</mo><mrow>{}<mo>=</mo><mn>{}</mn></mrow><mn>{}</mn>"
        "</munderover>{}",
        identifier(index), first, last, term);
  }
  PrintedPart::Tightness series_tightness() const override { return PrintedPart::Tightness::sum; }
  bool roots_stand_behind() const override { return true; }
};

class MathMlWithinWords : public MathMlDialect {
  PrintedPart fraction(const std::vector<PrintedPart>& over,
                       const std::vector<PrintedPart>& under) const override {
    return slashed(over, under, "<mo>/</mo>");
  }
};

}  // namespace

const Dialect& mathml_within_words() {
  static const MathMlWithinWords dialect;
  return dialect;
}

const Dialect& mathml_dialect() {
  static const MathMlDialect dialect;
  return dialect;
}

}  // namespace vcrit::symbolic
