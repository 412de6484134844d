// C99: one function of doubles, with complex ones where the formula has them.
#include <fmt/core.h>

#include "base/errors.hpp"
#include "document/systems/system.hpp"
#include "formula/c_names.hpp"

namespace vcrit::symbolic {

namespace {

// As many digits of a natural number no double has.
constexpr std::size_t too_many_digits = 309;

// Macros, and the functions of complex.h.
const char* const complex_words = R"(
I complex imaginary math_errhandling cabs cacos cacosh carg casin casinh catan catanh ccos ccosh
cexp cimag clog conj cpow cproj creal csin csinh csqrt ctan ctanh cabsf cacosf cacoshf cargf casinf
casinhf catanf catanhf ccosf ccoshf cexpf cimagf clogf conjf cpowf cprojf crealf csinf csinhf csqrtf
ctanf ctanhf cabsl cacosl cacoshl cargl casinl casinhl catanl catanhl ccosl ccoshl cexpl cimagl
clogl conjl cpowl cprojl creall csinl csinhl csqrtl ctanl ctanhl clog10 clog10f clog10l
)";

std::string whole_double(const std::string& digits) {
  if (digits.size() >= too_many_digits)
    throw ModelError(fmt::format("v* has a number of {} digits, which no double is", digits.size()),
                     "`format sympy` and others have exact numbers");
  return digits + ".0";
}

std::string number_in_c(const std::string& digits) {
  const std::size_t bar = digits.find('/');
  if (bar == std::string::npos) return whole_double(digits);
  return whole_double(digits.substr(0, bar)) + "/" + whole_double(digits.substr(bar + 1));
}

bool has_meaning_in_c(const std::string& name) { return is_taken_in_c(name); }

const Syntax c_syntax{.number = number_in_c,
                      .root = {"sqrt("},
                      .absolute = {"fabs("},
                      .absolute_complex = {"cabs("},
                      .imaginary = "I",
                      .power_of_complex = false};

}  // namespace

extern const AlgebraSystem c_language{.name = "c",
                                      .result = "v_star",
                                      .reserved = complex_words,
                                      .has_meaning = has_meaning_in_c,
                                      .spelled = with_index,
                                      .another = with_underscore,
                                      .syntax = &c_syntax,
                                      .escape = in_comment};

}  // namespace vcrit::symbolic
