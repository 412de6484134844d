#include "run/pasted.hpp"

#include <fmt/core.h>

#include <map>

#include "base/joined.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"

namespace vcrit::validation {

namespace {

using symbolic::PrintedPart;

/// C++ with the compiler's complex doubles; parameters are members of `p`.
class Pasted : public symbolic::Dialect {
 public:
  explicit Pasted(std::map<std::string, std::string> references)
      : references_(std::move(references)) {}

 private:
  std::string number(const std::string& digits) const override {
    const std::size_t bar = digits.find('/');
    if (bar == digits.npos) return digits + ".0";
    return fmt::format("({}.0/{}.0)", digits.substr(0, bar), digits.substr(bar + 1));
  }
  std::string name(const std::string& symbol) const override {
    const std::string text = symbolic::printed_name(symbol);
    const auto found = references_.find(text);
    return found == references_.end() ? text : found->second;
  }
  std::string negative(const std::string& term) const override { return "-" + term; }
  std::string added(const std::string& left, bool minus, const std::string& right) const override {
    return left + (minus ? " - " : " + ") + right;
  }
  std::string product(const std::vector<std::string>& factors) const override {
    return factors.empty() ? "1.0" : joined(factors, "*");
  }
  PrintedPart fraction(const std::vector<PrintedPart>& over,
                       const std::vector<PrintedPart>& under) const override {
    return {fmt::format("{}/({})", product(factors(over, false)), product(factors(under, true))),
            PrintedPart::Tightness::product};
  }
  std::string power(const std::string& base, int exponent) const override {
    return fmt::format("power({}, {})", base, exponent);
  }
  std::string root(const std::string& argument) const override {
    return fmt::format("std::sqrt({})", argument);
  }
  std::string call(const std::string& function, const std::string& argument) const override {
    return fmt::format("{}({})", function == "abs" ? "magnitude" : "std::" + function, argument);
  }
  std::string wrapped(const std::string& text) const override { return "(" + text + ")"; }
  std::string related(const std::string& left, bool, const std::string& right) const override {
    return left + " = " + right;
  }

  std::map<std::string, std::string> references_;
};

// What std::complex<double> is made of in the libraries of g++ and clang, with the same arithmetic;
// <complex> takes a compiler a quarter of a second.
const char* const complex_doubles = R"(using Complex = __complex__ double;
static Complex complex(double re, double im) {
  Complex z;
  __real__ z = re;
  __imag__ z = im;
  return z;
}
static double magnitude(Complex z) { return __builtin_cabs(z); }
static double magnitude(double x) { return std::fabs(x); }
template <class T> static T power(T x, int n) {
  T result = x;
  while (--n > 0) result *= x;
  return result;
}
)";

/// R_d, on a line from each row of the table to the next one.
std::string receptance_function(const Receptance& receptance) {
  std::string rows;
  for (const Receptance::Row& row : receptance.rows)
    rows += fmt::format("    {{{:a}, {:a}, {:a}}},\n", row.omega, row.re, row.im);
  return "struct Row {\n  double omega, re, im;\n};\n"
         "static Complex receptance(double omega) {\n  static const Row rows[] = {\n" +
         rows +
         "  };\n  const Row* row = rows;\n"
         "  while (row + 2 < rows + sizeof rows / sizeof *rows && row[1].omega <= omega) ++row;\n"
         "  const double share = (omega - row[0].omega) / (row[1].omega - row[0].omega);\n"
         "  return complex((1.0 - share) * row[0].re + share * row[1].re,\n"
         "                 (1.0 - share) * row[0].im + share * row[1].im);\n}\n";
}

}  // namespace

std::string pasted_function(const std::string& name, const symbolic::Derivation& derivation,
                            const symbolic::ParameterList& parameters) {
  std::map<std::string, std::string> references{
      {symbolic::printed_name(symbolic::own_name("i")), "complex(0.0, 1.0)"}};
  for (const Symbol& symbol : derivation.parameters)
    references[symbolic::printed_name(to_text(symbol))] = parameters.reference(symbol);
  const Pasted dialect(references);
  const auto print = [&](const GiNaC::ex& expression) {
    return dialect.print(symbolic::form_of(expression));
  };
  std::string text = fmt::format("static double {}(const Parameters& p) {{\n", name);
  if (!derivation.definitions.empty())
    text += fmt::format("  const Complex {} = complex(0.0, {});\n", print(symbolic::laplace()),
                        parameters.reference({"omega"}));
  if (derivation.problem->receptance() != nullptr)
    text += fmt::format("  const Complex {} = receptance({});\n", print(symbolic::quantity("R_d")),
                        parameters.reference({"omega"}));
  for (const symbolic::Line& line : derivation.definitions)
    text += fmt::format("  const Complex {} = {};\n", print(line.left), print(line.right));
  return text + fmt::format("  return {};\n}}\n", print(derivation.critical_velocity));
}

std::string pasted_preamble(const Problem& problem) {
  const std::string table =
      problem->receptance() != nullptr ? receptance_function(*problem->receptance()) : "";
  return std::string(complex_doubles) + table;
}

}  // namespace vcrit::validation
