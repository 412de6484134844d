#include "emit/languages/c99_arithmetic.hpp"

namespace vcrit::symbolic::c99 {

const char* const includes =
    R"(#include <math.h>
#include <stddef.h>
#include <string.h>
#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__
#error "-ffast-math destroys the arithmetic of this header, as -fassociative-math alone does"
#endif
#if defined __FLT_EVAL_METHOD__ && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error "doubles have to be rounded as doubles: -msse2 -mfpmath=sse"
#endif
)";

const char* const numbers =
    R"(/* hi + lo; operations err by less than 16 u^2 of their terms' absolute values, u = 2^-53 */
typedef struct { double hi, lo; } @dd;
static inline @dd @dd_number(double hi, double lo) { const @dd x = {hi, lo}; return x; }
static inline @dd @dd_of(double x) { return @dd_number(x, 0.0); }
static inline @dd @dd_quick(double a, double b) { const double s = a + b; return @dd_number(s, b - (s - a)); }
static inline @dd @dd_sum(double a, double b) {
  const double s = a + b, t = s - a;
  return @dd_number(s, (a - (s - t)) + (b - t));
}
static inline @dd @dd_product(double a, double b) { const double p = a * b; return @dd_number(p, fma(a, b, -p)); }
static inline @dd @dd_negated(@dd a) { return @dd_number(-a.hi, -a.lo); }
static inline @dd @dd_add_d(@dd a, double b) { const @dd s = @dd_sum(a.hi, b); return @dd_quick(s.hi, s.lo + a.lo); }
static inline @dd @dd_add(@dd a, @dd b) {
  const @dd s = @dd_sum(a.hi, b.hi);
  return @dd_quick(s.hi, s.lo + (a.lo + b.lo));
}
static inline @dd @dd_mul_d(@dd a, double b) {
  const @dd p = @dd_product(a.hi, b);
  return @dd_quick(p.hi, fma(a.lo, b, p.lo));
}
static inline @dd @dd_mul(@dd a, @dd b) {
  const @dd p = @dd_product(a.hi, b.hi);
  return @dd_quick(p.hi, p.lo + fma(a.lo, b.hi, a.hi * b.lo));
}
static inline @dd @dd_div(@dd a, @dd b) {
  const double q = a.hi / b.hi;
  return @dd_quick(q, @dd_add(a, @dd_negated(@dd_mul_d(b, q))).hi / b.hi);
}
static inline @dd @dd_root(@dd a) {
  const double r = sqrt(a.hi);
  return @dd_quick(r, @dd_add(a, @dd_negated(@dd_product(r, r))).hi / (2.0 * r));
}
static inline int @within(double limit, double x) { return x <= limit && x * limit >= 1.0; }
)";

const char* const wide =
    R"(/* times 2^e, for numbers out of range */
typedef struct { @dd t; long e; } @wide;
static inline @wide @wide_scaled(@dd t, long s) {
  @wide x = {t, -100000};
  if (t.hi == 0.0 || !isfinite(t.hi)) return x;
  x.e = s + ilogb(t.hi);
  x.t = @dd_number(scalbln(t.hi, s - x.e), scalbln(t.lo, s - x.e));
  return x;
}
static inline @wide @wide_number(double hi, double lo) { return @wide_scaled(@dd_number(hi, lo), 0); }
static inline @wide @wide_of(double x) { return @wide_scaled(@dd_of(x), 0); }
static inline @dd @wide_over(@wide a, long s) { return @dd_number(scalbln(a.t.hi, a.e - s), scalbln(a.t.lo, a.e - s)); }
static inline double @wide_rounded(@wide a) { return scalbln(a.t.hi, a.e); }
static inline @wide @wide_negated(@wide a) { return @wide_scaled(@dd_negated(a.t), a.e); }
static inline @wide @wide_add(@wide a, @wide b) {
  const long e = a.e > b.e ? a.e : b.e;
  return @wide_scaled(@dd_add(@wide_over(a, e), @wide_over(b, e)), e);
}
static inline @wide @wide_mul(@wide a, @wide b) { return @wide_scaled(@dd_mul(a.t, b.t), a.e + b.e); }
static inline @wide @wide_div(@wide a, @wide b) { return @wide_scaled(@dd_div(a.t, b.t), a.e - b.e); }
static inline @wide @wide_root(@wide a) {
  const long e = a.e & ~1L;
  return a.t.hi == 0.0 ? a : @wide_scaled(@dd_root(@wide_over(a, e)), e / 2);
}
static inline @wide @wide_magnitude(@wide a) { return a.t.hi < 0.0 ? @wide_negated(a) : a; }
)";

const char* const less_inertia =
    R"(/* k - m w^2, exact but for the last rounding */
static inline double @plain_less_inertia(double k, double m, double w) {
  const @dd t = @dd_product(m, w);
  return fma(-t.lo, w, fma(-t.hi, w, k));
}
static inline @dd @dd_less_inertia(double k, double m, double w) {
  const @dd t = @dd_product(m, w), p = @dd_product(t.hi, w), q = @dd_product(t.lo, w);
  return @dd_add_d(@dd_add(@dd_sum(k, -p.hi), @dd_negated(@dd_sum(p.lo, q.hi))), -q.lo);
}
static inline @wide @wide_less_inertia(double k, double m, double w) {
  const @wide a = @wide_of(k), b = @wide_of(m), c = @wide_of(w), bcc = @wide_mul(@wide_mul(b, c), c);
  const long e = b.e + 2 * c.e, apart = a.e - bcc.e;
  if (apart > 300 || apart < -300) return @wide_add(a, @wide_negated(bcc));
  return @wide_scaled(@dd_less_inertia(@wide_over(a, e).hi, b.t.hi, c.t.hi), e);
}
)";

const char* const power_unit =
    R"(/* a power of two near 1/x */
static inline double @unit(double x) {
  int e = 0;
  (void)frexp(x, &e);
  return ldexp(1.0, 1 - e);
}
static inline double @wide_unit(@wide x) { (void)x; return 1.0; }
)";

const char* const nonzero =
    R"(/* zeros only occur out of range: T/Q = 0/1 */
static inline @wide @wide_nonzero(@wide a, @wide b) { return a.t.hi == 0.0 && b.t.hi == 0.0 ? @wide_of(1.0) : a; }
)";

// Zeros only occur out of range.
const char* const ties =
    R"(/* edges that are 0, as bits */
static inline double @wide_gap(double gaps, @wide re, @wide im) { return 2.0 * gaps + (re.t.hi == 0.0 && im.t.hi == 0.0); }
static inline unsigned long @ends(const char *wiring, int i) {
  return 1UL << (wiring[2 * i] - 'a') | 1UL << (wiring[2 * i + 1] - 'a');
}
/* Gaps may leave parts that nothing holds. They carry no load: one gap that leads to each becomes an edge of stiffness
   1 (1), its other gaps are none for good (0), and all other edges stay as they are (-1). wiring: two nodes an edge. */
static inline double @tie(const char *wiring, double gaps, int edge) {
  const int n = (int)strlen(wiring) / 2;
  unsigned long held = 3; /* the terminals, and what edges and ties connect with them */
  double kind = -1.0;
  int is_gap[@MOST], next = -1;
  for (int i = 0; i < n; ++i) is_gap[i] = fmod(floor(ldexp(gaps, i + 1 - n)), 2.0) == 1.0;
  while (gaps > 0.0 && next < n) {
    for (int i = 0; i < n * n; ++i)
      if (!is_gap[i % n] && (@ends(wiring, i % n) & held)) held |= @ends(wiring, i % n);
    if (next == edge) return 1.0;
    if (next < 0 && is_gap[edge] && (@ends(wiring, edge) & ~held)) kind = 0.0;
    for (next = 0; next < n; ++next)
      if (is_gap[next] && (@ends(wiring, next) & held) && (@ends(wiring, next) & ~held)) break;
    if (next < n) held |= @ends(wiring, next);
  }
  return kind;
}
static inline double @plain_tied(double a, double kind, double otherwise) { return kind < 0.0 ? a : kind * otherwise; }
static inline @wide @wide_tied(@wide a, double kind, double otherwise) {
  return kind < 0.0 ? a : @wide_of(kind * otherwise);
}
)";

const char* const magnitude =
    R"(static inline @dd @dd_magnitude(@dd a) { return a.hi < 0.0 ? @dd_negated(a) : a; }
)";

const char* const unless_moderate =
    R"(static inline double @unless_moderate(double x) { return @within(0x1p200, x) ? 0.0 : HUGE_VAL; }
static inline @wide @wide_unless_moderate(@wide x) { (void)x; return @wide_of(0.0); }
)";

const char* const finished =
    R"(/* Whether sums and products keep what they round off, of numbers that compilers do not know. Not every compiler says
   that it is told to regroup sums, as by -fassociative-math; and there are libraries whose fma is a product and a sum. */
static inline int @is_left(double lo, double rest, double unit) { /* rounding up, hi is a unit larger */
  return lo == rest || lo == rest - unit;
}
static inline int @is_exact(void) {
  static volatile int known = 0; /* 1 or -1, for each thread the same */
  const volatile double one = 1.0, small = 0x1p-60, odd = 0x1.fffffffffffffp0;
  if (known == 0) {
    const double a = one, b = small, c = odd;
    const @dd sum = @dd_add(@dd_of(a), @dd_of(b)), product = @dd_mul(@dd_of(c), @dd_of(c));
    known = @is_left(@dd_quick(a, b).lo, b, 0x1p-52) && @is_left(@dd_sum(b, a).lo, b, 0x1p-52) &&
            @dd_add_d(sum, -a).hi == b && @is_left(fma(c, c, -(c * c)), 0x1p-104, 0x1p-51) &&
            @is_left(product.lo, 0x1p-104, 0x1p-51) ? 1 : -1;
  }
  return known > 0;
}
typedef struct { @Certified certified; int safe; } @Result;
/* v* = factor root(above/below). Factors (1 + e_j)^(+-1) with sum |e_j| = e < 2^-10 change it by less than 1.01 e, the
   last rounding by u, and another one by 2^-1075 where numbers are subnormal. safe: none has left the range of doubles. */
static inline @Result @finished(double v, double e, double u, int safe) {
  const int known = e < 0x1p-10 && v < 0x1.fffffffffffffp1023;
  const @Result r = {{v, known ? (1.01 * e + u) * (1.0 + 0x1p-50) : HUGE_VAL}, safe};
  return r;
}
static inline int @safe(double h, double v, int inside) {
  return inside && h > 0x1p-900 && h < 0x1p900 && v >= 0x1p-1022;
}
static inline @Result @plain_finished(double above, double below, double factor, double roundings, int inside) {
  const double h = above / below, v = @SQRT(h) * factor;
  return @finished(v, roundings * 0x1p-53, 0.0, @safe(h, v, inside));
}
static inline @Result @dd_finished(@dd above, @dd below, @dd factor, double roundings, int inside) {
  const double v = @dd_mul(@ROOT_DD(@dd_div(above, below)), factor).hi;
  return @finished(v, roundings * 0x1p-102, 0x1p-53, @safe(above.hi / below.hi, v, inside));
}
static inline @Result @wide_finished(@wide above, @wide below, @wide factor, @wide roundings, int inside) {
  const double h = fabs(above.t.hi / below.t.hi);
  const double v = h > 0.0 && h < HUGE_VAL ? @wide_rounded(@wide_mul(@ROOT_WIDE(@wide_div(above, below)), factor))
                                           : @SQRT(h) * factor.t.hi;
  const double tiny = v > 0.0 ? 0x1p-53 + 0x1p-1074 / (2.0 * v - 0x1p-1074) : 1.0;
  const double e = inside ? @wide_rounded(roundings) * 0x1p-102 : HUGE_VAL;
  return @finished(v, e, v >= 0x1p-1022 ? 0x1p-53 : tiny, 1);
}
)";

const char* const result =
    R"(static inline @Result @GRADE_result(const @Parameters *p, @Parameters *partial) {
  const @Result r = @GRADE_evaluate(*p, partial);
  return r.safe ? r : @wide_evaluate(*p, partial);
}
)";

const char* const calls =
    R"(static inline double @FASTcritical_velocity(const @Parameters *p) {
  return @GRADE_result(p, NULL).certified.value;
}
static inline @Certified @FASTcritical_velocity_certified(const @Parameters *p) {
  @Certified c = @GRADE_result(p, NULL).certified;
  if (!@is_exact()) c.relative_error_bound = HUGE_VAL;
  return c;
}
static inline @Gradient @FASTcritical_velocity_gradient(const @Parameters *p) {
  @Gradient g;
  g.value = @GRADE_result(p, &g.partial).certified.value;
  return g;
}
static inline void @FASTcritical_velocity_batch(const @Parameters *p, size_t n, const double *omega, double *out) {
  @Parameters at = *p;
  for (size_t i = 0; i < n; ++i) {
    at.@omega@ = omega[i];
    out[i] = @FASTcritical_velocity(&at);
  }
}
)";

}  // namespace vcrit::symbolic::c99
