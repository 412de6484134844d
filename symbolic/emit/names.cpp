#include "emit/names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>

#include "base/errors.hpp"
#include "base/identifiers.hpp"
#include "formula/c_names.hpp"

namespace vcrit::symbolic {

namespace {

// Namespaces that are taken, and what the generated code declares.
constexpr auto cpp_names = std::to_array<std::string_view>(
    {"Certified", "Parameters", "critical_velocity", "critical_velocity_certified", "detail",
     "fast", "posix", "std"});

// What the headers that generated code includes declare for everyone, beside the words of C: no
// namespace can have these names. With the endings f, l and _l there are more of them.
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

bool is_header_word(const std::string& name) {
  static const std::set<std::string> all = [] {
    std::istringstream text{header_words};
    return std::set<std::string>{std::istream_iterator<std::string>(text), {}};
  }();
  return all.contains(name);
}

/// As C names its functions of the types _Float32, _Float64x and the like: sinf32, f64addf128.
bool ends_like_a_type(std::string_view name) {
  for (const std::string_view rest : {"_l", "_r", "x"})
    if (name.ends_with(rest)) name.remove_suffix(rest.size());
  return name.ends_with("f16") || name.ends_with("f32") || name.ends_with("f64") ||
         name.ends_with("f128");
}

bool is_taken_by_headers(const std::string& name) {
  const bool variant = name.size() > 1 && (name.back() == 'f' || name.back() == 'l');
  return is_taken_in_c(name) || is_header_word(name) || ends_like_a_type(name) ||
         (variant && is_header_word(name.substr(0, name.size() - 1)));
}

bool is_taken_in_cpp(const std::string& name) {
  return std::find(cpp_names.begin(), cpp_names.end(), name) != cpp_names.end() ||
         is_taken_by_headers(name);
}

/// The library `pad` has a file pad_batch.hpp; one called `pad_batch` would replace it.
bool ends_like_a_file(std::string_view name) {
  return name.ends_with("_batch") || name.ends_with("_quantities");
}

[[noreturn]] void refuse_name(const Place& place, const std::string& name, const std::string& why) {
  throw InputError(place, fmt::format("\"{}\", which {}", name, why),
                   "another name, of letters, digits and underscores");
}

}  // namespace

void check_library_name(const std::string& name) {
  if (const auto why = unsafe_as_identifier(name)) refuse_name(argument("name"), name, *why);
  if (is_taken_in_cpp(name))
    refuse_name(argument("name"), name, "is taken in C++ or in the generated code");
  if (ends_like_a_file(name))
    refuse_name(argument("name"), name, "ends like a file of another evaluator");
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
