#include "formula/c_names.hpp"

#include <functional>
#include <iterator>
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

// What the other headers declare for everyone.
const char* const header_words = R"(
a64l aligned_alloc arc4random_buf arc4random_uniform asprintf at_quick_exit atof atoi atol
basename bcmp bcopy blkcnt64_t bzero canonicalize_file_name clearerr clearerr_unlocked clockid_t
comparison_fn_t cookie_close_function_t cookie_io_functions_t cookie_read_function_t
cookie_seek_function_t cookie_write_function_t ctermid cuserid daddl daddr_t ddivl dfmal dmull
dprintf drand48 drand48_data drand48_r dsqrtl dsubl ecvt_r erand48 erand48_r explicit_bzero fclose
fcloseall fcvt_r fd_mask fdopen feof feof_unlocked ferror ferror_unlocked fflush fflush_unlocked
ffs ffsl fgetc fgetc_unlocked fgetpos fgetpos64 fgets fgets_unlocked fileno fileno_unlocked flockfile
fmaximum fmaximum_mag fmaximum_mag_num fmaximum_num fmaxmag fmemopen fminimum fminimum_mag
fminimum_mag_num fminimum_num fminmag fopen fopen64 fopencookie fpos64_t fpos_t fprintf fputc
fputc_unlocked fputs fputs_unlocked fread fread_unlocked freopen freopen64 fromfpx fsblkcnt64_t
fsblkcnt_t fscanf fseek fseeko fseeko64 fsetpos fsetpos64 fsfilcnt64_t fsfilcnt_t fsid_t ftell
ftello ftello64 ftrylockfile funlockfile fwrite fwrite_unlocked getc getc_unlocked getchar
getchar_unlocked getdelim getline getloadavg getpt getw index initstate_r ino64_t int16_t int32_t
int64_t int8_t iscanonical iseqsig jrand48 jrand48_r l64a lcong48 lcong48_r lgamma_r lgammaf_r
lgammal_r lldiv_t locale_t lrand48 lrand48_r mbstowcs memccpy memchr memcmp memcpy memfrob memmem
memmove mempcpy memrchr memset mkdtemp mkostemp mkostemp64 mkostemps mkostemps64 mkstemp64
mkstemps mkstemps64 mrand48 mrand48_r nrand48 nrand48_r obstack obstack_printf obstack_vprintf
off64_t on_exit open_memstream pclose perror popen posix_memalign posix_openpt printf pselect
pthread_attr_t pthread_barrier_t pthread_barrierattr_t pthread_cond_t pthread_condattr_t
pthread_key_t pthread_mutex_t pthread_mutexattr_t pthread_once_t pthread_rwlock_t
pthread_rwlockattr_t pthread_spinlock_t pthread_t ptsname_r putc putc_unlocked putchar
putchar_unlocked puts putw qecvt qecvt_r qfcvt qfcvt_r qgcvt qsort_r quick_exit rand_r random_data
random_r rawmemchr reallocarray register_t remove rename renameat renameat2 rewind rindex rsize_t
scanf secure_getenv seed48 seed48_r setbuf setbuffer setlinebuf setpayloadsig setstate_r setvbuf
sigabbrev_np sigdescr_np sigset_t snprintf sprintf srand48 srand48_r srandom_r sscanf stpcpy
stpncpy strcasecmp strcasecmp_l strcasestr strcat strchr strchrnul strcmp strcoll strcoll_l strcpy
strcspn strdup strerror strerror_l strerror_r strerrordesc_np strerrorname_np strfromd strfromf
strfroml strfry strlen strncasecmp strncasecmp_l strncat strncmp strncpy strndup strnlen strpbrk
strrchr strsep strsignal strspn strstr strtod_l strtof strtof_l strtok strtok_r strtol strtol_l
strtold strtold_l strtoll_l strtoq strtoul strtoul_l strtoull_l strtouq strverscmp strxfrm
strxfrm_l suseconds_t tempnam tmpfile tmpfile64 tmpnam tmpnam_r totalordermag u_int16_t u_int32_t
u_int64_t u_int8_t u_quad_t ufromfpx ungetc va_list vasprintf vdprintf vfprintf vfscanf vprintf
vscanf vsnprintf vsprintf vsscanf wcstombs
)";

/// Whether it is one of the words; functions exist with the endings f and l, too.
bool is_word_of(const std::set<std::string, std::less<>>& words, std::string_view name) {
  const bool variant = name.size() > 1 && (name.back() == 'f' || name.back() == 'l');
  return words.contains(name) || (variant && words.contains(name.substr(0, name.size() - 1)));
}

std::set<std::string, std::less<>> words_in(const char* text) {
  std::istringstream stream{text};
  return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

bool is_taken_in_c(std::string_view name) {
  static const std::set<std::string, std::less<>> all = words_in(c_words);
  return is_word_of(all, name);
}

bool is_declared_by_c(std::string_view name) {
  static const std::set<std::string, std::less<>> all = words_in(header_words);
  return is_word_of(all, name);
}

}  // namespace vcrit::symbolic
