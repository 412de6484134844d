// The fixed parts of generated C++, by sections. The generator fills in what begins with THE_. What is under "alone" is not
// generated: with it this file compiles as it is.
//: alone
// clang-format off
#include <bit>
#include <cstdint>
//: includes
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <span>
#include <type_traits>
#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__
#error "-ffast-math destroys the arithmetic of this header, as -fassociative-math alone does"
#endif
#if defined __FLT_EVAL_METHOD__ && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error "doubles have to be rounded as doubles: -msse2 -mfpmath=sse"
#endif
//: alone
namespace alone {
struct Parameters { double mu0, THE_OMEGA, du_z; };
//: structs
struct Certified { double value, relative_error_bound; };  ///< infinite: nothing is known
struct Gradient { double value; Parameters partial; };     ///< d value/d parameter
//: alone
template <class T> struct Each { T mu0{}, THE_OMEGA{}, du_z{}; };
//: each
using Columns = Each<const double*>;   ///< the values of each parameter that varies; null: as in Parameters
using PartialColumns = Each<double*>;  ///< null: not wanted
using Varying = Each<bool>;            ///< known when compiled: what depends on the others only is computed once
//: alone
namespace detail {
//: inline_all
#ifdef __clang__
#pragma clang attribute push(__attribute__((always_inline)), apply_to = function)
#endif
//: numbers
struct Twofold {  // hi + lo; operations err by less than 16 u^2 of their terms' absolute values, u = 2^-53
  double hi, lo;
  constexpr Twofold(double h, double l = 0) : hi(h), lo(l) {}
  static Twofold quick(double a, double b) { return {a + b, b - ((a + b) - a)}; }
  static Twofold sum(double a, double b) { return {a + b, (a - ((a + b) - ((a + b) - a))) + (b - ((a + b) - a))}; }
  static Twofold product(double a, double b) { return {a * b, std::fma(a, b, -(a * b))}; }
  static Twofold with(Twofold s, double rest) { return quick(s.hi, s.lo + rest); }
  static Twofold root(Twofold a, double q) { return with(q, (a + -product(q, q)).hi / (2.0 * q)); }  // q^2 near a
  friend Twofold operator-(Twofold a) { return {-a.hi, -a.lo}; }
  friend Twofold operator+(Twofold a, Twofold b) { return with(sum(a.hi, b.hi), a.lo + b.lo); }
  friend Twofold operator*(Twofold a, Twofold b) { return with(product(a.hi, b.hi), std::fma(a.lo, b.hi, a.hi * b.lo)); }
  friend Twofold operator/(Twofold a, Twofold b) { return with(a.hi / b.hi, (a + -(b * (a.hi / b.hi))).hi / b.hi); }
  friend Twofold sqrt(Twofold a) { return root(a, std::sqrt(a.hi)); }
  explicit operator double() const { return hi; }
};
struct Wide : Twofold {  // times 2^e, for numbers out of range; calls, as that is where hardly anyone goes
  long e;
  Wide(double x) : Wide(Twofold(x)) {}
  [[gnu::noinline]] Wide(Twofold a, long s = 0)
      : Twofold(a), e(a.hi == 0 || !std::isfinite(a.hi) ? -100000 : s + std::ilogb(a.hi)) {
    if (e != -100000) hi = std::scalbln(a.hi, s - e), lo = std::scalbln(a.lo, s - e);
  }
  Twofold times(long s) const { return {std::scalbln(hi, e + s), std::scalbln(lo, e + s)}; }
  friend Wide operator-(Wide a) { return {-Twofold(a), a.e}; }
  [[gnu::noinline]] friend Wide operator+(Wide a, Wide b) { return a.e < b.e ? b + a : Wide(a.times(-a.e) + b.times(-a.e), a.e); }
  [[gnu::noinline]] friend Wide operator*(Wide a, Wide b) { return {Twofold(a) * Twofold(b), a.e + b.e}; }
  [[gnu::noinline]] friend Wide operator/(Wide a, Wide b) { return {Twofold(a) / Twofold(b), a.e - b.e}; }
  [[gnu::noinline]] friend Wide sqrt(Wide a) { return a.hi == 0 ? a : Wide{sqrt(a.times(-(a.e & ~1L))), (a.e & ~1L) / 2}; }
  explicit operator double() const { return std::scalbln(hi, e); }
};
inline double head(Twofold x) { return x.hi; }
inline double size(auto x) { return std::fabs(head(x)); }
inline Wide size(Wide x) { return x.hi < 0 ? -x : x; }
inline bool within(double limit, auto... x) { return (((x <= limit) & (x * limit >= 1.0)) & ...); }
inline bool every(auto... x) { return (x & ...); }
//: operations
template <class T> T times(double a, double b) {
  if constexpr (std::is_same_v<T, Twofold>) return T::product(a, b); else return T(a) * T(b);
}
template <class T> T mad(auto a, auto b, auto c) {  // a b + c
#ifdef __FMA__
  if constexpr (std::is_same_v<T, double>) return std::fma(a, b, c);
#endif
  if constexpr (std::is_same_v<decltype(a * b), double>) return times<T>(a, b) + T(c); else return a * b + T(c);
}
//: less_inertia
template <class T> T less_inertia(double k, double m, double w) {  // k - m w^2, exact but for the last rounding
  const Twofold t = Twofold::product(m, w), p = Twofold::product(t.hi, w), q = Twofold::product(t.lo, w);
  if constexpr (std::is_same_v<T, double>) return std::fma(-m, std::fma(w, w, -(w * w)), std::fma(-m, w * w, k));
  else if constexpr (std::is_same_v<T, Twofold>) return T::sum(k, -p.hi) + -T::sum(p.lo, q.hi) + -q.lo;
  const Wide a(k), b(m), c(w), bcc = b * c * c;
  if (std::labs(a.e - bcc.e) > 300) return T(a + -bcc);
  return T(Wide(less_inertia<Twofold>(a.times(-(b.e + 2 * c.e)).hi, b.hi, c.hi), b.e + 2 * c.e));
}
//: power_unit
inline double unit(double x) {  // a power of two near 1/x
  return std::bit_cast<double>(0x7fe0000000000000 - (std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000));
}
inline double unit(Twofold x) { return unit(x.hi); }
inline double unit(Wide) { return 1.0; }
//: nonzero
template <class T> T nonzero(T a, [[maybe_unused]] std::type_identity_t<T> b) {  // zeros only occur out of range: T/Q = 0/1
  if constexpr (std::is_same_v<T, Wide>) return a.hi == 0 && b.hi == 0 ? Wide(1.0) : a; else return a;
}
//: ties
template <class T> double gap(double gaps, [[maybe_unused]] auto re, [[maybe_unused]] auto im) {  // edges that are 0, as bits
  if constexpr (std::is_same_v<T, Wide>) return 2 * gaps + (head(re) == 0 && head(im) == 0); else return gaps;
}
// Gaps may leave parts that nothing holds. They carry no load: one gap that leads to each becomes an edge of stiffness 1
// (1), its other gaps are none for good (0), and all other edges stay as they are (-1). `wiring`: two nodes an edge.
template <class T> double tie([[maybe_unused]] const char* wiring, [[maybe_unused]] double gaps, [[maybe_unused]] int edge) {
  double kind = -1;
  if constexpr (std::is_same_v<T, Wide>) {
    int n = 0, next = -1;
    while (wiring[2 * n] != 0) ++n;
    const auto ends = [&](int i) { return 1U << (wiring[2 * i] - 'a') | 1U << (wiring[2 * i + 1] - 'a'); };
    const auto is_gap = [&](int i) { return std::fmod(std::floor(std::ldexp(gaps, i + 1 - n)), 2.0) == 1; };
    unsigned held = 3;  // the terminals, and what edges and ties connect with them
    while (gaps > 0 && next < n) {
      for (int i = 0; i < n * n; ++i)
        if (!is_gap(i % n) && (ends(i % n) & held)) held |= ends(i % n);
      if (next == edge) return 1;
      if (next < 0 && is_gap(edge) && (ends(edge) & ~held)) kind = 0;
      for (next = 0; next < n; ++next)
        if (is_gap(next) && (ends(next) & held) && (ends(next) & ~held)) break;
      if (next < n) held |= ends(next);
    }
  }
  return kind;
}
template <class T, class A> A tied(A a, [[maybe_unused]] double kind, [[maybe_unused]] double otherwise) {
  if constexpr (std::is_same_v<T, Wide>) return kind < 0 ? a : A(kind * otherwise); else return a;
}
//: magnitude
template <class T> T magnitude(T x) {
  if constexpr (std::is_same_v<T, double>) return std::fabs(x); else return head(x) < 0 ? -x : x;
}
//: unless_moderate
inline double unless_moderate(double x) { return within(0x1p200, x) ? 0.0 : HUGE_VAL; }
inline Wide unless_moderate(Wide) { return 0.0; }
using std::sqrt;
//: alone
constexpr double THE_ROWS = 1.0;
//: table
// The drive's receptance as it was measured: angular frequency, real and imaginary part. Linear between two rows.
inline constexpr double rows[] = {THE_ROWS};
inline double place(double omega) {  // of the row at or below omega, but for the last one; -1 outside of the table
  int low = 0, high = static_cast<int>(std::size(rows)) / 3 - 1;
  if (!(omega >= rows[0] && omega <= rows[3 * high])) return -1.0;
  while (low + 1 < high) (rows[3 * ((low + high) / 2)] <= omega ? low : high) = (low + high) / 2;
  return low;
}
inline double entry(double at, int number) { return at < 0 ? NAN : rows[3 * static_cast<int>(at) + number]; }
//: steps
inline unsigned long long steps(double x, double least) {  // 2^(52 + n) or more: beyond 2^(2^n) least, or no number
  return std::bit_cast<unsigned long long>(x) - std::bit_cast<unsigned long long>(least);
}
//: alone
inline bool in_range(const Parameters& p) { return p.mu0 > 0; }
inline bool allowed(const Parameters& p) { return p.mu0 > 0; }
inline bool has_polynomials(const Parameters& p) { return p.mu0 > 0; }
auto THE_ROOT(auto x) { return sqrt(x); }
#define THE_SIMPLE_ROOT std::sqrt(h)
//: result
struct Result : Certified { unsigned long long unsafe; };
// v* = factor THE_ROOT(above/below). Factors (1 + e_j)^(+-1) with sum |e_j| = e < 2^-10 change it by less than 1.01 e, the
// last rounding by u, and another one by 2^-1075 where numbers are subnormal. unsafe is 0 if none left the range of doubles.
template <class T> [[gnu::always_inline]] inline Result finished(const Parameters& p, T above, T below, T factor, auto n) {
  constexpr bool plain = std::is_same_v<T, double>, wide = std::is_same_v<T, Wide>;
  const double h = std::fabs(head(above) / head(below)), e = double(n) * (plain ? 0x1p-53 : 0x1p-102);
  const double whole = double(THE_ROOT(above / below) * factor), u = plain ? 0.0 : 0x1p-53;
  const double v = wide && !(h > 0 && h < HUGE_VAL) ? THE_SIMPLE_ROOT * head(factor) : whole;
  const double last = !wide || v >= 0x1p-1022 ? u : v > 0 ? u + 0x1p-1074 / (2.0 * v - 0x1p-1074) : 1.0;
  const bool inside = wide ? allowed(p) : in_range(p), known = (e < 0x1p-10) & (v < 0x1.fffffffffffffp1023) & inside;
  const bool safe = wide | ((h > 0x1p-900) & (h < 0x1p900) & (v >= 0x1p-1022) & inside);
  const auto far = (std::bit_cast<unsigned long long>(h) - 0x1ff0000000000000) >> 62;  // 0 within 2^512, 2^-512
  return {{v, known ? (1.01 * e + last) * (1.0 + 0x1p-50) : HUGE_VAL}, plain ? far : safe ? 0ULL : 1ULL};
}
//: alone
template <class T> Result evaluate(const Parameters& p, auto&... partial) {
  ((partial = p), ...);
  return finished<T>(p, T(p.mu0), T(p.mu0), T(p.mu0), T(50.0));
}
//: inline_no_more
#ifdef __clang__
#pragma clang attribute pop
#endif
//: polynomials
// For sweeps: T and Q as polynomials in i THE_OMEGA, whose coefficients are computed once. Their terms add up to at most 2^5
// times their sums, but for (anti)resonance; beyond what is checked the other way is taken.
//: alone
constexpr double THE_LEAST_OMEGA = 0x1p-24, THE_LEAST_SQUARE = 0x1p-512;
inline Result evaluate_polynomials(const Parameters& p) {
  const double above = p.mu0, below = p.mu0, v = p.mu0;
//: polynomials_end
  const auto squares = steps(above, THE_LEAST_SQUARE) | steps(below, THE_LEAST_SQUARE);
  return {{v, HUGE_VAL}, squares >> 62 | steps(p.THE_OMEGA, THE_LEAST_OMEGA) >> 58};
}
//: sweep
// Whether sums and products keep what they round off, of numbers that compilers do not know. Not every compiler says that
// it is told to regroup sums, as by -fassociative-math; and there are libraries whose fma is a product and a sum.
[[gnu::always_inline]] inline bool is_exact() {
  const volatile double one = 1.0, small = 0x1p-60, odd = 0x1.fffffffffffffp0;
  const double a = one, b = small, c = odd;
  // Where the processor rounds up, hi is a unit larger.
  const auto left = [](double lo, double rest, double unit) { return lo == rest || lo == rest - unit; };
  const Twofold sum = Twofold(a) + Twofold(b), product = Twofold(c) * Twofold(c);
  return left(Twofold::quick(a, b).lo, b, 0x1p-52) && left(Twofold::sum(b, a).lo, b, 0x1p-52) &&
         (sum + Twofold(-a)).hi == b && left(std::fma(c, c, -(c * c)), 0x1p-104, 0x1p-51) &&
         left(product.lo, 0x1p-104, 0x1p-51);
}
[[gnu::cold, gnu::noinline]] Result wide_result(const Parameters& p, auto&... partial) { return evaluate<Wide>(p, partial...); }
template <class T> [[gnu::noinline]] Result result(const Parameters& p, auto&... partial) {
  static const bool exact = is_exact();
  Result r = evaluate<T>(p, partial...);
  if (r.unsafe != 0) r = wide_result(p, partial...);
  if (!exact) r.relative_error_bound = HUGE_VAL;
  return r;
}
template <class T> Gradient gradient(const Parameters& p) { Gradient g{}; g.value = result<T>(p, g.partial).value; return g; }
// The first loop is vectorised, straight from `omega` to `out` if they are apart; what is not safe again, one by one.
template <class T, Result function(const Parameters&) = evaluate<T>>
[[gnu::flatten]] void sweep(const Parameters p, std::span<const double> omega, std::span<double> out) {
  std::array<double, 1024> copy;
  const std::size_t size = omega.size() < out.size() ? omega.size() : out.size();
  const bool apart = omega.data() + size <= out.data() || out.data() + size <= omega.data();
  for (std::size_t i = 0, n = 0; i < size; i += n) {
    n = size - i < copy.size() ? size - i : copy.size();
    if (!apart) std::memcpy(copy.data(), omega.data() + i, n * sizeof(double));
    const double* const from = apart ? omega.data() + i : copy.data();
    unsigned long long unsafe = 0;
    const auto at = [&](std::size_t l) { Parameters q = p; q.THE_OMEGA = from[l]; return q; };
    const auto store = [&](std::size_t l, const Result& r) { out[i + l] = r.value, unsafe |= r.unsafe; };
    for (std::size_t l = 0; l < n; ++l) store(l, function(at(l)));
    for (std::size_t l = 0; unsafe != 0 && l < n; ++l) store(l, result<T>(at(l)));
  }
}
//: alone
constexpr void each(auto f, auto&&... a) { f(a.mu0...); f(a.THE_OMEGA...); f(a.du_z...); }
constexpr Varying all{true, true, true}, reused{false, true, false};
//: batch
#ifdef __clang__  // not vectorised without optimisation, or with a square root that sets errno
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wpass-failed"
#endif
// Values alone in plain double, straight from the columns to `out`. A number that compilers cannot know to be 0 keeps
// them from reading a column, mostly across the lines of the cache, anew for each of its uses.
template <Varying S> [[gnu::flatten]] void straight(const Parameters p, const Columns c, std::span<double> out) {
  using Bits = unsigned long long;
  const volatile Bits unknown = 0;
  const Bits zero = unknown;
  double* const to = out.data();
  const auto at = [&](std::size_t l) {
    Parameters q;
    each([l, zero](double& x, bool varies, bool again, const double* y, double z) {
      x = !varies ? z : again ? std::bit_cast<double>(std::bit_cast<Bits>(y[l]) ^ zero) : y[l];
    }, q, S, reused, c, p);
    return q;
  };
  for (std::size_t i = 0, end = 0; i < out.size(); i = end) {
    end = out.size() - i < 1024 ? out.size() : i + 1024;
    Bits unsafe = 0;
    const auto store = [&](std::size_t l, const Result& r) { to[l] = r.value, unsafe |= r.unsafe; };
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
    for (std::size_t l = i; l < end; ++l) store(l, evaluate<double>(at(l)));
    for (std::size_t l = i; unsafe != 0 && l < end; ++l) store(l, result<double>(at(l)));
  }
}
// What varies has columns, and none of them is overwritten.
template <Varying S> bool is_straight(const Columns& c, std::span<double> out) {
  bool apart = true;
  each([&](bool varies, const double* x) {
    apart &= !varies || (x && (x + out.size() <= out.data() || out.data() + out.size() <= x));
  }, S, c);
  return apart;
}
// In blocks, whose loop is vectorised; what is not safe again, one by one.
template <class T, Varying S>
[[gnu::flatten]] void batch(const Parameters p, const Columns& c, std::span<double> out, auto&&... more) {
  constexpr bool G = (std::is_same_v<std::decay_t<decltype(more)>, PartialColumns> || ...);
  constexpr bool B = sizeof...(more) != 0 && !G;
  if constexpr (std::is_same_v<T, double> && sizeof...(more) == 0)
    if (is_straight<S>(c, out)) return straight<S>(p, c, out);
  using Lanes = std::array<double, 64>;
  Each<Lanes> in, partial;
  Columns from;
  Lanes value, bound;
  for (std::size_t i = 0; i < out.size(); i += value.size()) {
    const std::size_t n = out.size() - i < value.size() ? out.size() - i : value.size();
    each([=](const double*& y, Lanes& own, const double* x, double fixed) {
      const bool whole = x && n == own.size();
      if (x ? !whole : i == 0) own.fill(fixed);
      if (x && !whole) std::memcpy(own.data(), x + i, n * sizeof(double));
      y = whole ? x + i : own.data();
    }, from, in, c, p);
    unsigned long long unsafe = 0;
    const auto at = [&](std::size_t l) {
      Parameters q;
      each([l](double& x, bool varies, const double* y, double z) { x = varies ? y[l] : z; }, q, S, from, p);
      return q;
    };
    const auto store = [&](std::size_t l, const Result& r, auto&... d) {
      value[l] = r.value, bound[l] = r.relative_error_bound, unsafe |= r.unsafe;
      if constexpr (G) each([l](Lanes& y, double x) { y[l] = x; }, partial, d...);
    };
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#endif
    for (std::size_t l = 0; l < value.size(); ++l)
      if constexpr (G) { Parameters d; const Result r = evaluate<T>(at(l), d); store(l, r, d); }
      else store(l, evaluate<T>(at(l)));
    for (std::size_t l = 0; unsafe != 0 && l < n; ++l)
      if constexpr (G) { Parameters d; const Result r = result<T>(at(l), d); store(l, r, d); }
      else store(l, result<T>(at(l)));
    std::memcpy(out.data() + i, value.data(), n * sizeof(double));
    if constexpr (B) {
      static const bool exact = is_exact();
      if (!exact) bound.fill(HUGE_VAL);
      std::memcpy(std::span<double>(more...).data() + i, bound.data(), n * sizeof(double));
    }
    if constexpr (G)
      each([=](double* to, const Lanes& x) { if (to) std::memcpy(to + i, x.data(), n * sizeof(double)); }, more..., partial);
  }
}
#ifdef __clang__
#pragma clang diagnostic pop
#endif
//: alone
}  // namespace detail
//: calls_comment
// Infinite at resonance and above the largest double, 0 at antiresonance, NaN for 0/0 alone; `out` may be `omega` itself.
//: alone
using THE_NUMBER = detail::Twofold;
//: calls
inline double critical_velocity(const Parameters& p) noexcept { return detail::result<THE_NUMBER>(p).value; }
inline Certified critical_velocity_certified(const Parameters& p) noexcept { return detail::result<THE_NUMBER>(p); }
inline Gradient critical_velocity_gradient(const Parameters& p) noexcept { return detail::gradient<THE_NUMBER>(p); }
inline void critical_velocity(const Parameters& p, std::span<const double> omega, std::span<double> out) noexcept {
  detail::sweep<THE_NUMBER>(p, omega, out);
}
//: alone
inline void sweep_of_doubles(const Parameters& p, std::span<const double> omega, std::span<double> out) {
//: polynomial_sweep
  if (detail::has_polynomials(p)) detail::sweep<double, detail::evaluate_polynomials>(p, omega, out);
  else detail::sweep<double>(p, omega, out);
//: alone
}
//: batch_comment
//   critical_velocity(p, columns, out)            one value for each element of `out`, which may be a column
//   critical_velocity(p, columns, out, bounds)    and a std::span<double> of their relative error bounds
//   critical_velocity(p, columns, out, partials)  and the partial derivatives, PartialColumns
//   critical_velocity<Varying{.THE_OMEGA = true}>(p, columns, out)  for these columns only, and faster
// Vectorised by -O3 -march=native -fno-math-errno.
//: batch_calls
template <Varying S = detail::all>
void critical_velocity(const Parameters& p, const Columns& c, std::span<double> out, auto&&... more) noexcept {
  detail::batch<THE_NUMBER, S>(p, c, out, more...);
}
//: alone
}  // namespace alone
