// Formulas as plain text that most programs read: k_n*(k_t + k_d - m*omega^2)/k_t.
#include <fmt/core.h>

#include "base/joined.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

namespace {

class TextDialect : public Dialect {
  std::string number(const std::string& digits) const override { return digits; }
  std::string name(const std::string& symbol) const override { return printed_name(symbol); }
  std::string negative(const std::string& term) const override { return "-" + term; }
  std::string added(const std::string& left, bool minus, const std::string& right) const override {
    return left + (minus ? " - " : " + ") + right;
  }
  std::string product(const std::vector<std::string>& factors) const override {
    return factors.empty() ? "1" : joined(factors, "*");
  }
  PrintedPart fraction(const std::vector<PrintedPart>& over,
                       const std::vector<PrintedPart>& under) const override {
    return slashed(over, under, "/");
  }
  std::string power(const std::string& base, int exponent) const override {
    return fmt::format("{}^{}", base, exponent);
  }
  std::string root(const std::string& argument) const override { return "sqrt(" + argument + ")"; }
  std::string call(const std::string& function, const std::string& argument) const override {
    return function + "(" + argument + ")";
  }
  std::string wrapped(const std::string& text) const override { return "(" + text + ")"; }
  std::string related(const std::string& left, bool asymptotic,
                      const std::string& right) const override {
    return left + (asymptotic ? " ~ " : " = ") + right;
  }
};

}  // namespace

const Dialect& text_dialect() {
  static const TextDialect dialect;
  return dialect;
}

}  // namespace vcrit::symbolic
