// The fixed parts of generated CUDA, by sections. The generator fills in what begins with THE_. What is under "alone" is
// not generated: with it this file compiles as it is.
//: includes
#include <cmath>
#include <cstddef>
#include <type_traits>
#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__
#error "-ffast-math destroys the arithmetic of this header, as -fassociative-math alone does"
#endif
#if defined __FLT_EVAL_METHOD__ && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error "doubles have to be rounded as doubles: -msse2 -mfpmath=sse"
#endif
#ifdef __CUDACC__
#define THE_CALL __host__ __device__ inline
#else  // the functions of the host alone
#define THE_CALL inline
#endif
#ifdef __CUDA_ARCH__  // rare
#define THE_COLD __host__ __device__ __noinline__ inline
#else
#define THE_COLD THE_CALL
#endif
//: alone
namespace alone {
constexpr int THE_MOST_EDGES = 52;
struct Parameters { double mu0, THE_OMEGA, du_z; };
//: structs
struct Certified { double value, relative_error_bound; };  ///< infinite: nothing is known
struct Gradient { double value; Parameters partial; };     ///< d value/d parameter
//: alone
namespace detail {
//: numbers
struct Twofold {  // hi + lo; operations err by less than 16 u^2 of their terms' absolute values, u = 2^-53
  double hi, lo;
  THE_CALL Twofold(double h, double l = 0) : hi(h), lo(l) {}
  THE_CALL explicit operator double() const { return hi; }
};
THE_CALL Twofold quick(double a, double b) { return {a + b, b - ((a + b) - a)}; }
THE_CALL Twofold sum(double a, double b) { return {a + b, (a - ((a + b) - ((a + b) - a))) + (b - ((a + b) - a))}; }
THE_CALL Twofold product(double a, double b) {
#ifdef __CUDA_ARCH__  // a product that is not contracted with what it is added to
  const double p = __dmul_rn(a, b);
#else
  const double p = a * b;
#endif
  return {p, ::fma(a, b, -p)};
}
THE_CALL Twofold with(Twofold s, double rest) { return quick(s.hi, s.lo + rest); }
THE_CALL Twofold operator-(Twofold a) { return {-a.hi, -a.lo}; }
THE_CALL Twofold operator+(Twofold a, Twofold b) { return with(sum(a.hi, b.hi), a.lo + b.lo); }
THE_CALL Twofold operator*(Twofold a, Twofold b) { return with(product(a.hi, b.hi), ::fma(a.lo, b.hi, a.hi * b.lo)); }
THE_CALL Twofold operator/(Twofold a, Twofold b) { return with(a.hi / b.hi, (a + -(b * (a.hi / b.hi))).hi / b.hi); }
THE_CALL Twofold sqrt(Twofold a) {
  const double r = ::sqrt(a.hi);
  return with(r, (a + -product(r, r)).hi / (2 * r));
}
struct Wide {  // times 2^e, for numbers out of range
  Twofold t;
  long e;
  THE_CALL Wide(double x) : Wide(Twofold(x)) {}
  THE_COLD Wide(Twofold a, long s = 0) : t(a), e(a.hi == 0 || a.hi - a.hi != 0 ? -100000 : s + ::ilogb(a.hi)) {
    if (e != -100000) t = Twofold(::scalbln(a.hi, s - e), ::scalbln(a.lo, s - e));
  }
  THE_COLD Twofold over(long s) const { return {::scalbln(t.hi, e - s), ::scalbln(t.lo, e - s)}; }
  THE_CALL explicit operator double() const { return ::scalbln(t.hi, e); }
};
THE_COLD Wide operator-(Wide a) { return {-a.t, a.e}; }
THE_COLD Wide operator+(Wide a, Wide b) {
  const long e = a.e > b.e ? a.e : b.e;
  return {a.over(e) + b.over(e), e};
}
THE_COLD Wide operator*(Wide a, Wide b) { return {a.t * b.t, a.e + b.e}; }
THE_COLD Wide operator/(Wide a, Wide b) { return {a.t / b.t, a.e - b.e}; }
THE_COLD Wide sqrt(Wide a) { return a.t.hi == 0 ? a : Wide{sqrt(a.over(a.e & ~1L)), (a.e & ~1L) / 2}; }
THE_CALL double sqrt(double x) { return ::sqrt(x); }
THE_CALL double head(double x) { return x; }
THE_CALL double head(Twofold x) { return x.hi; }
THE_CALL double head(Wide x) { return x.t.hi; }
THE_CALL double size(double x) { return ::fabs(x); }
THE_CALL double size(Twofold x) { return ::fabs(x.hi); }
THE_CALL Wide size(Wide x) { return x.t.hi < 0 ? -x : x; }
THE_CALL bool within(double limit, double x) { return (x <= limit) & (x * limit >= 1.0); }
//: operations
template <class T> THE_CALL T times(double a, double b) {
  if constexpr (std::is_same_v<T, Twofold>) return product(a, b); else return T(a) * T(b);
}
template <class T, class A, class B, class C> THE_CALL T mad(A a, B b, C c) {  // a b + c
  if constexpr (std::is_same_v<decltype(a * b), double>) return times<T>(a, b) + T(c); else return a * b + T(c);
}
//: less_inertia
template <class T> THE_CALL T less_inertia(double k, double m, double w) {  // k - m w^2, exact but for the last rounding
  const Twofold t = product(m, w), p = product(t.hi, w), q = product(t.lo, w);
  if constexpr (std::is_same_v<T, double>) return ::fma(-t.lo, w, ::fma(-t.hi, w, k));
  else if constexpr (std::is_same_v<T, Twofold>) return sum(k, -p.hi) + -sum(p.lo, q.hi) + -q.lo;
  else {
    const Wide a(k), b(m), c(w), bcc = b * c * c;
    const long e = b.e + 2 * c.e, apart = a.e - bcc.e;
    if (apart > 300 || apart < -300) return a + -bcc;
    return Wide(less_inertia<Twofold>(a.over(e).hi, b.t.hi, c.t.hi), e);
  }
}
//: power_unit
THE_CALL double unit(double x) {  // a power of two near 1/x
  int e = 0;
  (void)::frexp(x, &e);
  return ::ldexp(1.0, 1 - e);
}
THE_CALL double unit(Twofold x) { return unit(x.hi); }
THE_CALL double unit(Wide) { return 1.0; }
//: nonzero
template <class T, class B> THE_CALL T nonzero(T a, B b) {  // zeros only occur out of range: T/Q = 0/1
  if constexpr (std::is_same_v<T, Wide>) return head(a) == 0 && head(b) == 0 ? Wide(1.0) : a; else return a;
}
//: ties
template <class T, class R, class I> THE_CALL double gap(double gaps, R re, I im) {  // edges that are 0, as bits
  if constexpr (std::is_same_v<T, Wide>) return 2 * gaps + (head(re) == 0 && head(im) == 0); else return gaps;
}
THE_CALL unsigned ends(const char* wiring, int i) { return 1U << (wiring[2 * i] - 'a') | 1U << (wiring[2 * i + 1] - 'a'); }
// Gaps may leave parts that nothing holds. They carry no load: one gap that leads to each becomes an edge of stiffness 1
// (1), its other gaps are none for good (0), and all other edges stay as they are (-1). `wiring`: two nodes an edge.
template <class T> THE_CALL double tie(const char* wiring, double gaps, int edge) {
  double kind = -1;
  if constexpr (std::is_same_v<T, Wide>) {
    int n = 0, next = -1;
    while (wiring[2 * n] != 0) ++n;
    bool is_gap[THE_MOST_EDGES] = {};
    for (int i = 0; i < n; ++i) is_gap[i] = ::fmod(::floor(::ldexp(gaps, i + 1 - n)), 2.0) == 1;
    unsigned held = 3;  // the terminals, and what edges and ties connect with them
    while (gaps > 0 && next < n) {
      for (int i = 0; i < n * n; ++i)
        if (!is_gap[i % n] && (ends(wiring, i % n) & held)) held |= ends(wiring, i % n);
      if (next == edge) return 1;
      if (next < 0 && is_gap[edge] && (ends(wiring, edge) & ~held)) kind = 0;
      for (next = 0; next < n; ++next)
        if (is_gap[next] && (ends(wiring, next) & held) && (ends(wiring, next) & ~held)) break;
      if (next < n) held |= ends(wiring, next);
    }
  }
  return kind;
}
template <class T, class A> THE_CALL A tied(A a, double kind, double otherwise) {
  if constexpr (std::is_same_v<T, Wide>) return kind < 0 ? a : A(kind * otherwise); else return a;
}
//: magnitude
template <class T> THE_CALL T magnitude(T x) { return head(x) < 0 ? -x : x; }
//: unless_moderate
THE_CALL double unless_moderate(double x) { return within(0x1p200, x) ? 0.0 : HUGE_VAL; }
THE_CALL Wide unless_moderate(Wide) { return 0.0; }
//: alone
constexpr double THE_ROWS = 1.0;
//: table
// The drive's receptance as it was measured: angular frequency, real and imaginary part. Linear between two rows. Number
// `i` of all; the number of rows for -1.
THE_CALL double row_number(int i) {
  const double rows[] = {THE_ROWS};
  return i < 0 ? static_cast<double>(sizeof rows / sizeof rows[0] / 3) : rows[i];
}
THE_CALL double place(double omega) {  // of the row at or below omega, but for the last one; -1 outside of the table
  int low = 0, high = static_cast<int>(row_number(-1)) - 1;
  if (!(omega >= row_number(0) && omega <= row_number(3 * high))) return -1.0;
  while (low + 1 < high) {
    const int middle = (low + high) / 2;
    if (row_number(3 * middle) <= omega) low = middle; else high = middle;
  }
  return low;
}
THE_CALL double entry(double at, int number) { return at < 0 ? NAN : row_number(3 * static_cast<int>(at) + number); }
//: alone
THE_CALL bool in_range(const Parameters& p) { return p.mu0 > 0; }
THE_CALL bool allowed(const Parameters& p) { return p.mu0 > 0; }
THE_CALL double THE_SQUARE_ROOT(double x) { return ::sqrt(x); }
template <class T> THE_CALL T THE_ROOT(T x) { return sqrt(x); }
//: finished
struct Result : Certified { Parameters partial; bool safe; };
// v* = factor root(above/below). Factors (1 + e_j)^(+-1) with sum |e_j| = e < 2^-10 change it by less than 1.01 e, the
// last rounding by u, and another one by 2^-1075 where numbers are subnormal. safe: none has left the range of doubles.
template <class T, class E> THE_CALL Result finished(const Parameters& p, T above, T below, T factor, E roundings) {
  constexpr bool plain = std::is_same_v<T, double>, wide = std::is_same_v<T, Wide>;
  const double h = std::fabs(head(above) / head(below)), e = double(roundings) * (plain ? 0x1p-53 : 0x1p-102);
  const double whole = double(THE_ROOT(above / below) * factor), u = plain ? 0.0 : 0x1p-53;
  const double v = wide && !(h > 0 && h < HUGE_VAL) ? THE_SQUARE_ROOT(h) * head(factor) : whole;
  const double last = !wide || v >= 0x1p-1022 ? u : v > 0 ? u + 0x1p-1074 / (2.0 * v - 0x1p-1074) : 1.0;
  const bool inside = wide ? allowed(p) : in_range(p), known = (e < 0x1p-10) & (v < 0x1.fffffffffffffp1023) & inside;
  const bool safe = (h > 0x1p-900) & (h < 0x1p900) & (v >= 0x1p-1022) & inside;
  return {{v, known ? (1.01 * e + last) * (1.0 + 0x1p-50) : HUGE_VAL}, {}, wide || safe};
}
//: alone
template <class T, bool G> THE_CALL Result evaluate(const Parameters& p) {
  Result r = finished<T>(p, T(p.mu0), T(p.mu0), T(p.mu0), T(50.0));
  if constexpr (G) r.partial = p;
  return r;
}
//: result
// Whether the host's sums and products keep what they round off, of numbers that compilers do not know. Not every compiler
// says that it is told to regroup sums, as by -fassociative-math; and there are libraries whose fma is a product and a sum.
inline bool is_left(double lo, double rest, double unit) {  // where the processor rounds up, hi is a unit larger
  return lo == rest || lo == rest - unit;
}
inline bool is_exact() {
  const volatile double one = 1.0, small = 0x1p-60, odd = 0x1.fffffffffffffp0;
  const double a = one, b = small, c = odd;
  const Twofold whole = Twofold(a) + Twofold(b), square = Twofold(c) * Twofold(c);
  return is_left(quick(a, b).lo, b, 0x1p-52) && is_left(sum(b, a).lo, b, 0x1p-52) && (whole + Twofold(-a)).hi == b &&
         is_left(::fma(c, c, -(c * c)), 0x1p-104, 0x1p-51) && is_left(square.lo, 0x1p-104, 0x1p-51);
}
template <class T, bool G = false> THE_CALL Result result(const Parameters& p) {
  const Result r = evaluate<T, G>(p);
  return r.safe ? r : evaluate<Wide, G>(p);
}
THE_CALL Certified certified(Certified c) {
#ifndef __CUDA_ARCH__
  static const bool exact = is_exact();
  if (!exact) c.relative_error_bound = HUGE_VAL;
#endif
  return c;
}
//: alone
}  // namespace detail
using THE_NUMBER = detail::Twofold;
//: calls
THE_CALL double critical_velocity(const Parameters& p) { return detail::result<THE_NUMBER>(p).value; }
THE_CALL Certified critical_velocity_certified(const Parameters& p) {
  return detail::certified(detail::result<THE_NUMBER>(p));
}
THE_CALL Gradient critical_velocity_gradient(const Parameters& p) {
  const detail::Result r = detail::result<THE_NUMBER, true>(p);
  return {r.value, r.partial};
}
inline void critical_velocity(Parameters p, std::size_t n, const double* omega, double* out) {
  for (std::size_t i = 0; i < n; ++i) p.THE_OMEGA = omega[i], out[i] = detail::result<THE_NUMBER>(p).value;
}
#ifdef __CUDACC__
/// Any grid; `bound`, unless it is null, takes the relative error bounds.
template <int = 0>
__global__ void critical_velocity_kernel(Parameters p, std::size_t n, const double* omega, double* out, double* bound) {
  const std::size_t stride = static_cast<std::size_t>(gridDim.x) * blockDim.x;
  for (std::size_t i = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x; i < n; i += stride) {
    p.THE_OMEGA = omega[i];
    const detail::Result r = detail::result<THE_NUMBER>(p);
    out[i] = r.value;
    if (bound) bound[i] = r.relative_error_bound;
  }
}
#endif
//: alone
}  // namespace alone
