// Formulas in LaTeX's mathematics mode, with nothing but standard commands.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "base/joined.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/notation.hpp"

namespace vcrit::symbolic {

namespace {

std::string latex_index_part(const std::string& part) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  if (is_greek(part)) return "\\" + part;
  const bool word = part.size() > 2 && std::count_if(part.begin(), part.end(), letter) > 2;
  return word ? "\\mathrm{" + part + "}" : part;
}

std::string letter_by_letter(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '_' ? std::string("\\_") : std::string(1, c);
  return "\\mathrm{" + escaped + "}";
}

class LatexDialect : public Dialect {
 protected:
  std::string number(const std::string& digits) const override {
    const std::size_t bar = digits.find('/');
    if (bar == std::string::npos) return digits;
    return "\\frac{" + digits.substr(0, bar) + "}{" + digits.substr(bar + 1) + "}";
  }
  std::string name(const std::string& symbol) const override { return set(printed_name(symbol)); }
  static std::string set(const std::string& text) {
    if (is_set_apart(text)) return letter_by_letter(text);
    if (is_sensitivity(text)) return "S_{" + set(text.substr(2)) + "}";
    const Notation n = notation(text, has_bare_entry(text));
    std::string result = is_greek(n.base)    ? "\\" + n.base
                         : n.base.size() > 1 ? "\\mathrm{" + n.base + "}"
                                             : n.base;
    const auto dots = std::count(n.above.begin(), n.above.end(), '\'');
    if (dots > 0) result = (dots == 1 ? "\\dot{" : "\\ddot{") + result + "}";
    if (!n.index.empty()) {
      std::vector<std::string> parts;
      for (const std::string& part : n.index) parts.push_back(latex_index_part(part));
      result += fmt::format("_{{{}}}", joined(parts, ","));
    }
    if (n.above == "*") result += "^{*}";
    result += n.primes;
    if (n.before == "d") return "\\mathrm{d}" + result;
    return n.before.empty() ? result : "\\" + n.before + " " + result;
  }
  std::string negative(const std::string& term) const override { return "-" + term; }
  std::string added(const std::string& left, bool minus, const std::string& right) const override {
    return left + (minus ? " - " : " + ") + right;
  }
  std::string product(const std::vector<std::string>& factors) const override {
    return factors.empty() ? "1" : joined(factors, " ");
  }
  PrintedPart fraction(const std::vector<PrintedPart>& over,
                       const std::vector<PrintedPart>& under) const override {
    return {fmt::format("\\frac{{{}}}{{{}}}", product(factors(over, true)),
                        product(factors(under, true))),
            PrintedPart::Tightness::product};
  }
  PrintedPart inner_fraction(const std::vector<PrintedPart>& over,
                             const std::vector<PrintedPart>& under) const override {
    return slashed(over, under, "/");
  }
  std::string power(const std::string& base, int exponent) const override {
    // TeX takes no second exponent of one base, as of v^{*}.
    const bool raised = base.find('^') != std::string::npos && !base.starts_with("\\left");
    return fmt::format("{}^{{{}}}", raised ? "\\left(" + base + "\\right)" : base, exponent);
  }
  std::string root(const std::string& argument) const override {
    return "\\sqrt{" + argument + "}";
  }
  std::string call(const std::string& function, const std::string& argument) const override {
    if (function == "abs") return "\\left|" + argument + "\\right|";
    if (function == "exp" && printed_name(own_name("e")) == "e") return "e^{" + argument + "}";
    return (function == "sin" || function == "cos" ? "\\" + function
                                                   : "\\operatorname{" + function + "}") +
           wrapped(argument);
  }
  std::string wrapped(const std::string& text) const override {
    return "\\left(" + text + "\\right)";
  }
  std::string related(const std::string& left, bool asymptotic,
                      const std::string& right) const override {
    return left + (asymptotic ? " \\sim " : " = ") + right;
  }
  std::string tending(const std::string& left, const std::string& right) const override {
    return left + " \\to " + right;
  }
  std::string nothing() const override { return "{}"; }
  std::string infinity() const override { return "\\infty"; }
  std::string range(const std::string& index, int first, int last) const override {
    return fmt::format("{} = {}, \\ldots, {}", index, first, last);
  }
  std::string series(const std::string& term, const std::string& index, int first,
                     int last) const override {
    return fmt::format("\\sum_{{{}={}}}^{{{}}} {}", index, first, last, term);
  }
  PrintedPart::Tightness series_tightness() const override { return PrintedPart::Tightness::sum; }
  bool roots_stand_behind() const override { return true; }
};

/// Within a line of words, where a bar would be small and spread the lines.
class LatexWithinWords : public LatexDialect {
  PrintedPart fraction(const std::vector<PrintedPart>& over,
                       const std::vector<PrintedPart>& under) const override {
    return slashed(over, under, "/");
  }
  std::string number(const std::string& digits) const override { return digits; }
};

}  // namespace

const Dialect& latex_within_words() {
  static const LatexWithinWords dialect;
  return dialect;
}

const Dialect& latex_dialect() {
  static const LatexDialect dialect;
  return dialect;
}

}  // namespace vcrit::symbolic
