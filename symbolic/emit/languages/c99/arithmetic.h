/* The fixed parts of generated C99, by sections. The generator fills in what begins with THE_, last of all THE_ itself,
   the prefix of all names. What is under "alone" is not generated: with it this file compiles as it is. */
//: includes
#include <math.h>
#include <stddef.h>
#include <string.h>
#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__
#error "-ffast-math destroys the arithmetic of this header, as -fassociative-math alone does"
#endif
#if defined __FLT_EVAL_METHOD__ && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error "doubles have to be rounded as doubles: -msse2 -mfpmath=sse"
#endif
//: alone
enum { THE_MOST_EDGES = 52 };
typedef struct { double mu0, THE_OMEGA, du_z; } THE_Parameters;
typedef struct { double value, relative_error_bound; } THE_Certified;
typedef struct { double value; THE_Parameters partial; } THE_Gradient;
static inline int THE_in_range(const THE_Parameters p) { return p.mu0 > 0.0; }
static inline int THE_allowed(const THE_Parameters p) { return p.mu0 > 0.0; }
#define THE_SQUARE_ROOT sqrt
#define THE_DD_ROOT THE_dd_root
#define THE_WIDE_ROOT THE_wide_root
//: numbers
/* hi + lo; operations err by less than 16 u^2 of their terms' absolute values, u = 2^-53 */
typedef struct { double hi, lo; } THE_dd;
static inline THE_dd THE_dd_number(double hi, double lo) { const THE_dd x = {hi, lo}; return x; }
static inline THE_dd THE_dd_of(double x) { return THE_dd_number(x, 0.0); }
static inline THE_dd THE_dd_quick(double a, double b) { const double s = a + b; return THE_dd_number(s, b - (s - a)); }
static inline THE_dd THE_dd_sum(double a, double b) {
  const double s = a + b, t = s - a;
  return THE_dd_number(s, (a - (s - t)) + (b - t));
}
static inline THE_dd THE_dd_product(double a, double b) { const double p = a * b; return THE_dd_number(p, fma(a, b, -p)); }
static inline THE_dd THE_dd_negated(THE_dd a) { return THE_dd_number(-a.hi, -a.lo); }
static inline THE_dd THE_dd_add_d(THE_dd a, double b) { const THE_dd s = THE_dd_sum(a.hi, b); return THE_dd_quick(s.hi, s.lo + a.lo); }
static inline THE_dd THE_dd_add(THE_dd a, THE_dd b) {
  const THE_dd s = THE_dd_sum(a.hi, b.hi);
  return THE_dd_quick(s.hi, s.lo + (a.lo + b.lo));
}
static inline THE_dd THE_dd_mul_d(THE_dd a, double b) {
  const THE_dd p = THE_dd_product(a.hi, b);
  return THE_dd_quick(p.hi, fma(a.lo, b, p.lo));
}
static inline THE_dd THE_dd_mul(THE_dd a, THE_dd b) {
  const THE_dd p = THE_dd_product(a.hi, b.hi);
  return THE_dd_quick(p.hi, p.lo + fma(a.lo, b.hi, a.hi * b.lo));
}
static inline THE_dd THE_dd_div(THE_dd a, THE_dd b) {
  const double q = a.hi / b.hi;
  return THE_dd_quick(q, THE_dd_add(a, THE_dd_negated(THE_dd_mul_d(b, q))).hi / b.hi);
}
static inline THE_dd THE_dd_root(THE_dd a) {
  const double r = sqrt(a.hi);
  return THE_dd_quick(r, THE_dd_add(a, THE_dd_negated(THE_dd_product(r, r))).hi / (2.0 * r));
}
static inline int THE_within(double limit, double x) { return x <= limit && x * limit >= 1.0; }
//: wide
/* times 2^e, for numbers out of range; calls, as that is where hardly anyone goes */
#if defined __GNUC__
#define THE_CALLED static __attribute__((noinline, unused))
#else
#define THE_CALLED static inline
#endif
typedef struct { THE_dd t; long e; } THE_wide;
THE_CALLED THE_wide THE_wide_scaled(THE_dd t, long s) {
  THE_wide x = {t, -100000};
  if (t.hi == 0.0 || !isfinite(t.hi)) return x;
  x.e = s + ilogb(t.hi);
  x.t = THE_dd_number(scalbln(t.hi, s - x.e), scalbln(t.lo, s - x.e));
  return x;
}
static inline THE_wide THE_wide_number(double hi, double lo) { return THE_wide_scaled(THE_dd_number(hi, lo), 0); }
static inline THE_wide THE_wide_of(double x) { return THE_wide_scaled(THE_dd_of(x), 0); }
static inline THE_dd THE_wide_over(THE_wide a, long s) { return THE_dd_number(scalbln(a.t.hi, a.e - s), scalbln(a.t.lo, a.e - s)); }
static inline double THE_wide_rounded(THE_wide a) { return scalbln(a.t.hi, a.e); }
static inline THE_wide THE_wide_negated(THE_wide a) { return THE_wide_scaled(THE_dd_negated(a.t), a.e); }
THE_CALLED THE_wide THE_wide_add(THE_wide a, THE_wide b) {
  const long e = a.e > b.e ? a.e : b.e;
  return THE_wide_scaled(THE_dd_add(THE_wide_over(a, e), THE_wide_over(b, e)), e);
}
THE_CALLED THE_wide THE_wide_mul(THE_wide a, THE_wide b) { return THE_wide_scaled(THE_dd_mul(a.t, b.t), a.e + b.e); }
THE_CALLED THE_wide THE_wide_div(THE_wide a, THE_wide b) { return THE_wide_scaled(THE_dd_div(a.t, b.t), a.e - b.e); }
THE_CALLED THE_wide THE_wide_root(THE_wide a) {
  const long e = a.e & ~1L;
  return a.t.hi == 0.0 ? a : THE_wide_scaled(THE_dd_root(THE_wide_over(a, e)), e / 2);
}
static inline THE_wide THE_wide_magnitude(THE_wide a) { return a.t.hi < 0.0 ? THE_wide_negated(a) : a; }
//: less_inertia
/* k - m w^2, exact but for the last rounding */
static inline double THE_plain_less_inertia(double k, double m, double w) {
  const THE_dd t = THE_dd_product(m, w);
  return fma(-t.lo, w, fma(-t.hi, w, k));
}
static inline THE_dd THE_dd_less_inertia(double k, double m, double w) {
  const THE_dd t = THE_dd_product(m, w), p = THE_dd_product(t.hi, w), q = THE_dd_product(t.lo, w);
  return THE_dd_add_d(THE_dd_add(THE_dd_sum(k, -p.hi), THE_dd_negated(THE_dd_sum(p.lo, q.hi))), -q.lo);
}
static inline THE_wide THE_wide_less_inertia(double k, double m, double w) {
  const THE_wide a = THE_wide_of(k), b = THE_wide_of(m), c = THE_wide_of(w), bcc = THE_wide_mul(THE_wide_mul(b, c), c);
  const long e = b.e + 2 * c.e, apart = a.e - bcc.e;
  if (apart > 300 || apart < -300) return THE_wide_add(a, THE_wide_negated(bcc));
  return THE_wide_scaled(THE_dd_less_inertia(THE_wide_over(a, e).hi, b.t.hi, c.t.hi), e);
}
//: power_unit
/* a power of two near 1/x */
static inline double THE_unit(double x) {
  int e = 0;
  (void)frexp(x, &e);
  return ldexp(1.0, 1 - e);
}
static inline double THE_wide_unit(THE_wide x) { (void)x; return 1.0; }
//: nonzero
/* zeros only occur out of range: T/Q = 0/1 */
static inline THE_wide THE_wide_nonzero(THE_wide a, THE_wide b) { return a.t.hi == 0.0 && b.t.hi == 0.0 ? THE_wide_of(1.0) : a; }
//: ties
/* edges that are 0, as bits */
static inline double THE_wide_gap(double gaps, THE_wide re, THE_wide im) { return 2.0 * gaps + (re.t.hi == 0.0 && im.t.hi == 0.0); }
static inline unsigned long THE_ends(const char *wiring, int i) {
  return 1UL << (wiring[2 * i] - 'a') | 1UL << (wiring[2 * i + 1] - 'a');
}
/* Gaps may leave parts that nothing holds. They carry no load: one gap that leads to each becomes an edge of stiffness
   1 (1), its other gaps are none for good (0), and all other edges stay as they are (-1). wiring: two nodes an edge. */
static inline double THE_tie(const char *wiring, double gaps, int edge) {
  const int n = (int)strlen(wiring) / 2;
  unsigned long held = 3; /* the terminals, and what edges and ties connect with them */
  double kind = -1.0;
  int is_gap[THE_MOST_EDGES], next = -1;
  for (int i = 0; i < n; ++i) is_gap[i] = fmod(floor(ldexp(gaps, i + 1 - n)), 2.0) == 1.0;
  while (gaps > 0.0 && next < n) {
    for (int i = 0; i < n * n; ++i)
      if (!is_gap[i % n] && (THE_ends(wiring, i % n) & held)) held |= THE_ends(wiring, i % n);
    if (next == edge) return 1.0;
    if (next < 0 && is_gap[edge] && (THE_ends(wiring, edge) & ~held)) kind = 0.0;
    for (next = 0; next < n; ++next)
      if (is_gap[next] && (THE_ends(wiring, next) & held) && (THE_ends(wiring, next) & ~held)) break;
    if (next < n) held |= THE_ends(wiring, next);
  }
  return kind;
}
static inline double THE_plain_tied(double a, double kind, double otherwise) { return kind < 0.0 ? a : kind * otherwise; }
static inline THE_wide THE_wide_tied(THE_wide a, double kind, double otherwise) {
  return kind < 0.0 ? a : THE_wide_of(kind * otherwise);
}
//: magnitude
static inline THE_dd THE_dd_magnitude(THE_dd a) { return a.hi < 0.0 ? THE_dd_negated(a) : a; }
//: unless_moderate
static inline double THE_unless_moderate(double x) { return THE_within(0x1p200, x) ? 0.0 : HUGE_VAL; }
static inline THE_wide THE_wide_unless_moderate(THE_wide x) { (void)x; return THE_wide_of(0.0); }
//: alone
#define THE_ROWS 1.0
//: table
/* The drive's receptance as it was measured: angular frequency, real and imaginary part. Linear between two rows. */
static const double THE_rows[] = {THE_ROWS};
/* of the row at or below omega, but for the last one; -1 outside of the table */
static inline double THE_place(double omega) {
  int low = 0, high = (int)(sizeof THE_rows / sizeof THE_rows[0]) / 3 - 1;
  if (!(omega >= THE_rows[0] && omega <= THE_rows[3 * high])) return -1.0;
  while (low + 1 < high) {
    const int middle = (low + high) / 2;
    if (THE_rows[3 * middle] <= omega) low = middle; else high = middle;
  }
  return low;
}
static inline double THE_entry(double at, int number) { return at < 0.0 ? NAN : THE_rows[3 * (int)at + number]; }
//: finished
/* Whether sums and products keep what they round off, of numbers that compilers do not know. Not every compiler says
   that it is told to regroup sums, as by -fassociative-math; and there are libraries whose fma is a product and a sum. */
static inline int THE_is_left(double lo, double rest, double unit) { /* rounding up, hi is a unit larger */
  return lo == rest || lo == rest - unit;
}
static inline int THE_asked_is_exact(void) {
  const volatile double one = 1.0, small = 0x1p-60, odd = 0x1.fffffffffffffp0;
  const double a = one, b = small, c = odd;
  const THE_dd sum = THE_dd_add(THE_dd_of(a), THE_dd_of(b)), product = THE_dd_mul(THE_dd_of(c), THE_dd_of(c));
  return THE_is_left(THE_dd_quick(a, b).lo, b, 0x1p-52) && THE_is_left(THE_dd_sum(b, a).lo, b, 0x1p-52) &&
         THE_dd_add_d(sum, -a).hi == b && THE_is_left(fma(c, c, -(c * c)), 0x1p-104, 0x1p-51) &&
         THE_is_left(product.lo, 0x1p-104, 0x1p-51);
}
static inline int THE_is_exact(void) {
  static volatile int known = 0; /* 1 or -1, for each thread the same; C99 itself has no atomic numbers */
#ifdef __GNUC__
  int answer = __atomic_load_n(&known, __ATOMIC_RELAXED);
  if (answer == 0) __atomic_store_n(&known, answer = THE_asked_is_exact() ? 1 : -1, __ATOMIC_RELAXED);
#else
  int answer = known;
  if (answer == 0) known = answer = THE_asked_is_exact() ? 1 : -1;
#endif
  return answer > 0;
}
typedef struct { THE_Certified certified; int safe; } THE_Result;
/* v* = factor root(above/below). Factors (1 + e_j)^(+-1) with sum |e_j| = e < 2^-10 change it by less than 1.01 e, the
   last rounding by u, and another one by 2^-1075 where numbers are subnormal. safe: none has left the range of doubles. */
static inline THE_Result THE_finished(double v, double e, double u, int safe) {
  const int known = e < 0x1p-10 && v < 0x1.fffffffffffffp1023;
  const THE_Result r = {{v, known ? (1.01 * e + u) * (1.0 + 0x1p-50) : HUGE_VAL}, safe};
  return r;
}
static inline int THE_safe(double h, double v, int inside) {
  return inside && h > 0x1p-900 && h < 0x1p900 && v >= 0x1p-1022;
}
static inline THE_Result THE_plain_finished(double above, double below, double factor, double roundings, int inside) {
  const double h = above / below, v = THE_SQUARE_ROOT(h) * factor;
  return THE_finished(v, roundings * 0x1p-53, 0.0, THE_safe(h, v, inside));
}
static inline THE_Result THE_dd_finished(THE_dd above, THE_dd below, THE_dd factor, double roundings, int inside) {
  const double v = THE_dd_mul(THE_DD_ROOT(THE_dd_div(above, below)), factor).hi;
  return THE_finished(v, roundings * 0x1p-102, 0x1p-53, THE_safe(above.hi / below.hi, v, inside));
}
static inline THE_Result THE_wide_finished(THE_wide above, THE_wide below, THE_wide factor, THE_wide roundings, int inside) {
  const double h = fabs(above.t.hi / below.t.hi);
  const double v = h > 0.0 && h < HUGE_VAL ? THE_wide_rounded(THE_wide_mul(THE_WIDE_ROOT(THE_wide_div(above, below)), factor))
                                           : THE_SQUARE_ROOT(h) * factor.t.hi;
  const double tiny = v > 0.0 ? 0x1p-53 + 0x1p-1074 / (2.0 * v - 0x1p-1074) : 1.0;
  const double e = inside ? THE_wide_rounded(roundings) * 0x1p-102 : HUGE_VAL;
  return THE_finished(v, e, v >= 0x1p-1022 ? 0x1p-53 : tiny, 1);
}
//: alone
static inline THE_Result THE_wide_evaluate(const THE_Parameters p, THE_Parameters *partial) {
  const THE_wide x = THE_wide_of(p.mu0);
  if (partial) *partial = p;
  return THE_wide_finished(x, x, x, x, THE_allowed(p));
}
static inline THE_Result THE_GRADE_evaluate(const THE_Parameters p, THE_Parameters *partial) {
  const THE_dd x = THE_dd_of(p.mu0);
  if (partial) *partial = p;
  return THE_dd_finished(x, x, x, 50.0, THE_in_range(p));
}
//: result
static inline THE_Result THE_GRADE_result(const THE_Parameters *p, THE_Parameters *partial) {
  const THE_Result r = THE_GRADE_evaluate(*p, partial);
  return r.safe ? r : THE_wide_evaluate(*p, partial);
}
//: calls
static inline double THE_FAST_critical_velocity(const THE_Parameters *p) {
  return THE_GRADE_result(p, NULL).certified.value;
}
static inline THE_Certified THE_FAST_critical_velocity_certified(const THE_Parameters *p) {
  THE_Certified c = THE_GRADE_result(p, NULL).certified;
  if (!THE_is_exact()) c.relative_error_bound = HUGE_VAL;
  return c;
}
static inline THE_Gradient THE_FAST_critical_velocity_gradient(const THE_Parameters *p) {
  THE_Gradient g;
  g.value = THE_GRADE_result(p, &g.partial).certified.value;
  return g;
}
static inline void THE_FAST_critical_velocity_batch(const THE_Parameters *p, size_t n, const double *omega, double *out) {
  THE_Parameters at = *p;
  for (size_t i = 0; i < n; ++i) {
    at.THE_OMEGA = omega[i];
    out[i] = THE_FAST_critical_velocity(&at);
  }
}
