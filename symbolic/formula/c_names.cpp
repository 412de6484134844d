#include "formula/c_names.hpp"

#include <set>
#include <sstream>
#include <string>

namespace vcrit::symbolic {

namespace {

const char* const c_words = R"(
abort abs acos acosh alloca arc4random asin asinh atan atan2 atanh atexit blkcnt_t blksize_t
bsearch caddr_t calloc canonicalize cbrt ceil clearenv clock_t copysign cos cosh dev_t div div_t
double_t drem ecvt erf erfc exit exp exp10 exp2 expm1 fabs fadd fcvt fd_set fdim fdiv ffma finite
float_t floor fma fmax fmin fmod fmul fpclassify free frexp fromfp fsqrt fsub gamma gcvt getenv
getpayload getsubopt gid_t grantpt hypot id_t ilogb initstate ino_t isfinite isgreater isinf
isless isnan isnormal issignaling issubnormal iszero j0 j1 jn key_t labs ldexp ldiv ldiv_t lgamma
llabs lldiv llogb llrint llround loff_t log log10 log1p log2 logb lrint lround main malloc
max_align_t mblen mbtowc mkstemp mktemp mode_t modf nan nearbyint nextafter nextdown nexttoward
nextup nlink_t nullptr_t off_t pid_t pow ptrdiff_t ptsname putenv qsort quad_t rand random realloc
realpath remainder remquo rint round roundeven rpmatch scalb scalbln scalbn select setenv
setpayload setstate signbit signgam significand sin sincos sinh size_t sqrt srand srandom ssize_t
strtod system tan tanh tgamma time_t timer_t timespec timeval totalorder trunc u_char u_int u_long
u_short ufromfp uid_t uint ulong unlockpt unsetenv useconds_t ushort valloc wait wctomb y0 y1 yn
)";

bool is_word_of_c(std::string_view name) {
  static const std::set<std::string, std::less<>> all = [] {
    std::set<std::string, std::less<>> words;
    std::istringstream text{c_words};
    for (std::string word; text >> word;) words.insert(word);
    return words;
  }();
  return all.contains(name);
}

}  // namespace

// The functions exist with the endings f and l, too.
bool is_taken_in_c(std::string_view name) {
  const bool variant = name.size() > 1 && (name.back() == 'f' || name.back() == 'l');
  return is_word_of_c(name) || (variant && is_word_of_c(name.substr(0, name.size() - 1)));
}

}  // namespace vcrit::symbolic
