#include "emit/names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/errors.hpp"
#include "base/identifiers.hpp"

namespace vcrit::symbolic {

namespace {

// Namespaces that are taken, what the generated code declares, and what the C library puts into the
// global namespace through the headers that the code includes. Those of the functions exist with
// the endings f and l, too.
constexpr auto cpp_names = std::to_array<std::string_view>({"Certified",
                                                            "Parameters",
                                                            "abort",
                                                            "abs",
                                                            "acos",
                                                            "acosh",
                                                            "alloca",
                                                            "arc4random",
                                                            "asin",
                                                            "asinh",
                                                            "atan",
                                                            "atan2",
                                                            "atanh",
                                                            "atexit",
                                                            "blkcnt_t",
                                                            "blksize_t",
                                                            "bsearch",
                                                            "caddr_t",
                                                            "calloc",
                                                            "canonicalize",
                                                            "cbrt",
                                                            "ceil",
                                                            "clearenv",
                                                            "clock_t",
                                                            "copysign",
                                                            "cos",
                                                            "cosh",
                                                            "critical_velocity",
                                                            "critical_velocity_certified",
                                                            "detail",
                                                            "dev_t",
                                                            "div",
                                                            "div_t",
                                                            "double_t",
                                                            "drem",
                                                            "ecvt",
                                                            "erf",
                                                            "erfc",
                                                            "exit",
                                                            "exp",
                                                            "exp10",
                                                            "exp2",
                                                            "expm1",
                                                            "fabs",
                                                            "fadd",
                                                            "fast",
                                                            "fcvt",
                                                            "fd_set",
                                                            "fdim",
                                                            "fdiv",
                                                            "ffma",
                                                            "finite",
                                                            "float_t",
                                                            "floor",
                                                            "fma",
                                                            "fmax",
                                                            "fmin",
                                                            "fmod",
                                                            "fmul",
                                                            "fpclassify",
                                                            "free",
                                                            "frexp",
                                                            "fromfp",
                                                            "fsqrt",
                                                            "fsub",
                                                            "gamma",
                                                            "gcvt",
                                                            "getenv",
                                                            "getpayload",
                                                            "getsubopt",
                                                            "gid_t",
                                                            "grantpt",
                                                            "hypot",
                                                            "id_t",
                                                            "ilogb",
                                                            "initstate",
                                                            "ino_t",
                                                            "isfinite",
                                                            "isgreater",
                                                            "isinf",
                                                            "isless",
                                                            "isnan",
                                                            "isnormal",
                                                            "issignaling",
                                                            "issubnormal",
                                                            "iszero",
                                                            "j0",
                                                            "j1",
                                                            "jn",
                                                            "key_t",
                                                            "labs",
                                                            "ldexp",
                                                            "ldiv",
                                                            "ldiv_t",
                                                            "lgamma",
                                                            "llabs",
                                                            "lldiv",
                                                            "llogb",
                                                            "llrint",
                                                            "llround",
                                                            "loff_t",
                                                            "log",
                                                            "log10",
                                                            "log1p",
                                                            "log2",
                                                            "logb",
                                                            "lrint",
                                                            "lround",
                                                            "main",
                                                            "malloc",
                                                            "max_align_t",
                                                            "mblen",
                                                            "mbtowc",
                                                            "mkstemp",
                                                            "mktemp",
                                                            "mode_t",
                                                            "modf",
                                                            "nan",
                                                            "nearbyint",
                                                            "nextafter",
                                                            "nextdown",
                                                            "nexttoward",
                                                            "nextup",
                                                            "nlink_t",
                                                            "nullptr_t",
                                                            "off_t",
                                                            "pid_t",
                                                            "posix",
                                                            "pow",
                                                            "ptrdiff_t",
                                                            "ptsname",
                                                            "putenv",
                                                            "qsort",
                                                            "quad_t",
                                                            "rand",
                                                            "random",
                                                            "realloc",
                                                            "realpath",
                                                            "remainder",
                                                            "remquo",
                                                            "rint",
                                                            "round",
                                                            "roundeven",
                                                            "rpmatch",
                                                            "scalb",
                                                            "scalbln",
                                                            "scalbn",
                                                            "select",
                                                            "setenv",
                                                            "setpayload",
                                                            "setstate",
                                                            "signbit",
                                                            "signgam",
                                                            "significand",
                                                            "sin",
                                                            "sincos",
                                                            "sinh",
                                                            "size_t",
                                                            "sqrt",
                                                            "srand",
                                                            "srandom",
                                                            "ssize_t",
                                                            "std",
                                                            "strtod",
                                                            "system",
                                                            "tan",
                                                            "tanh",
                                                            "tgamma",
                                                            "time_t",
                                                            "timer_t",
                                                            "timespec",
                                                            "timeval",
                                                            "totalorder",
                                                            "trunc",
                                                            "u_char",
                                                            "u_int",
                                                            "u_long",
                                                            "u_short",
                                                            "ufromfp",
                                                            "uid_t",
                                                            "uint",
                                                            "ulong",
                                                            "unlockpt",
                                                            "unsetenv",
                                                            "useconds_t",
                                                            "ushort",
                                                            "valloc",
                                                            "wait",
                                                            "wctomb",
                                                            "y0",
                                                            "y1",
                                                            "yn"});

bool is_taken_in_cpp(std::string_view name) {
  return std::find(cpp_names.begin(), cpp_names.end(), name) != cpp_names.end();
}

[[noreturn]] void refuse_name(const Place& place, const std::string& name, const std::string& why) {
  throw InputError(place, fmt::format("\"{}\", which {}", name, why),
                   "another name, of letters, digits and underscores");
}

}  // namespace

void check_library_name(const std::string& name) {
  if (const auto why = unsafe_as_identifier(name)) refuse_name(argument("name"), name, *why);
  const bool variant = name.size() > 1 && (name.back() == 'f' || name.back() == 'l');
  if (is_taken_in_cpp(name) ||
      (variant && is_taken_in_cpp(std::string_view(name).substr(0, name.size() - 1))))
    refuse_name(argument("name"), name, "is taken in C++ or in the generated code");
}

void check_member_names(const Problem& problem, const std::vector<Symbol>& symbols) {
  for (const Symbol& symbol : symbols) {
    const std::string name = as_called(problem, symbol).name;
    if (const auto why = unsafe_as_identifier(name))
      refuse_name({problem->source->file}, name, *why);
    if (name == "Parameters")
      refuse_name({problem->source->file}, name,
                  "is the name of the struct that it would be a member of");
  }
}

}  // namespace vcrit::symbolic
