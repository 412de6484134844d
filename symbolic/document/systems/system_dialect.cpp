#include "document/systems/system_dialect.hpp"

#include <fmt/core.h>

#include "base/errors.hpp"
#include "base/joined.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

namespace {

bool is_whole(const std::string& text) {
  return text.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

std::string SystemDialect::number(const std::string& digits) const {
  return syntax_.number(digits);
}

std::string SystemDialect::name(const std::string& symbol) const {
  return symbol == own_name("i") ? syntax_.imaginary : names_.of(symbol);
}

std::string SystemDialect::added(const std::string& left, bool minus,
                                 const std::string& right) const {
  return left + (minus ? " - " : " + ") + right;
}

std::string SystemDialect::product(const std::vector<std::string>& factors) const {
  return factors.empty() ? number("1") : joined(factors, "*");
}

// Of two natural numbers one, as where they would be divided without the system.
PrintedPart SystemDialect::fraction(const std::vector<PrintedPart>& over,
                                    const std::vector<PrintedPart>& under) const {
  const std::string above = product(factors(over, false)), below = product(factors(under, true));
  if (is_whole(above) && is_whole(below))
    return {number(above + "/" + below), PrintedPart::Tightness::product};
  const bool lone = under.size() == 1 && under[0].tightness == PrintedPart::Tightness::atom;
  return {above + "/" + (lone ? below : wrapped(below)), PrintedPart::Tightness::product};
}

std::string SystemDialect::power(const std::string& base, int exponent) const {
  // What is not an atom comes in parentheses.
  const bool wrapped = base.starts_with('(');
  const std::string argument = wrapped ? base.substr(1, base.size() - 2) : base;
  if (syntax_.power == nullptr) return fmt::format("pow({}, {})", argument, exponent);
  return fmt::format("{}{}{}", base, syntax_.power, exponent);
}

std::string SystemDialect::root(const std::string& argument) const {
  return applied(syntax_.root, argument);
}

std::string SystemDialect::call(const std::string& function, const std::string& argument) const {
  ensure(function == "abs" || function == "cabs", "the absolute value is the only function of v*");
  return applied(function == "abs" ? syntax_.absolute : syntax_.absolute_complex, argument);
}

std::string SystemDialect::applied(const Around& function, const std::string& argument) {
  return function.before + argument + function.after;
}

}  // namespace vcrit::symbolic
