#include "network/real_roots.hpp"

#include <arb.h>

#include <algorithm>
#include <utility>

#include "base/errors.hpp"

namespace vcrit {

namespace {

// Halvings of one binade. Poles that agree in more than 120 digits are no input of a person.
constexpr int deepest_halving = 400;

/// An integer polynomial that frees itself.
class Integers {
 public:
  Integers() { fmpz_poly_init(p_); }
  Integers(const Integers&) = delete;
  Integers& operator=(const Integers&) = delete;
  ~Integers() { fmpz_poly_clear(p_); }
  fmpz_poly_struct* get() { return p_; }

 private:
  fmpz_poly_t p_;
};

/// An integer that frees itself.
class Integer {
 public:
  Integer() { fmpz_init(n_); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(n_); }
  fmpz* get() { return n_; }

 private:
  fmpz_t n_;
};

/// x = m 2^exponent.
slong mantissa_and_exponent(const Dyadic& x, Integer& m) {
  Integer exponent;
  arf_get_fmpz_2exp(m.get(), exponent.get(), x.get());
  return fmpz_get_si(exponent.get());
}

/// p(2^exponent x) times a power of two that leaves integers.
void scale(fmpz_poly_struct* p, slong exponent) {
  const slong last = fmpz_poly_degree(p);
  for (slong i = 0; i <= last; ++i) {
    const slong by = exponent >= 0 ? exponent * i : -exponent * (last - i);
    fmpz_mul_2exp(p->coeffs + i, p->coeffs + i, static_cast<ulong>(by));
  }
}

int sign_changes(const fmpz_poly_struct* p) {
  int changes = 0, last = 0;
  for (slong i = 0; i < p->length; ++i) {
    const int sign = fmpz_sgn(p->coeffs + i);
    if (sign == 0) continue;
    changes += last != 0 && sign != last;
    last = sign;
  }
  return changes;
}

slong bits_of(const fmpz_poly_struct* p, slong i) {
  return static_cast<slong>(fmpz_bits(p->coeffs + i));
}

/// How many bits of the root are known; very many of one that is known exactly.
slong bits_of_width(const RootInterval& interval) {
  Dyadic width;
  arf_sub(width.get(), interval.high.get(), interval.low.get(), ARF_PREC_EXACT, ARF_RND_DOWN);
  if (arf_is_zero(width.get()) != 0) return ARF_PREC_EXACT;
  return arf_abs_bound_lt_2exp_si(interval.low.get()) - arf_abs_bound_lt_2exp_si(width.get());
}

/// A polynomial around a point: p(z) of x = middle + 2^unit z.
struct Around {
  const Dyadic& middle;
  slong unit;
  Integers p;
};

/// The slope of p where |z| <= h.
void slope_within(arb_t slope, const fmpz_poly_struct* p, const arb_t h, slong precision) {
  arb_t term, sum;
  arb_init(term);
  arb_init(sum);
  for (slong i = fmpz_poly_degree(p); i >= 2; --i) {
    arb_mul(sum, sum, h, precision);
    arb_set_fmpz(term, p->coeffs + i);
    arb_mul_si(term, term, i, precision);
    arb_abs(term, term);
    arb_add(sum, sum, term, precision);
  }
  arb_mul(sum, sum, h, precision);
  mag_t radius;
  mag_init(radius);
  arb_get_mag(radius, sum);
  arb_set_fmpz(slope, p->coeffs + 1);
  arb_add_error_mag(slope, radius);
  mag_clear(radius);
  arb_clear(sum);
  arb_clear(term);
}

/// Newton's step with intervals, where it makes the interval much narrower.
bool take_newton_step(Around& around, slong sure, RootInterval& interval) {
  const slong precision = 2 * std::max<slong>(sure, 0) + 64;
  arb_t h, step, slope;
  arb_init(h);
  arb_init(step);
  arb_init(slope);
  arf_sub(arb_midref(h), interval.high.get(), around.middle.get(), ARF_PREC_EXACT, ARF_RND_DOWN);
  arb_mul_2exp_si(h, h, -around.unit);
  slope_within(slope, around.p.get(), h, precision);
  RootInterval next;
  const bool is_there = arb_contains_zero(slope) == 0;
  if (is_there) {
    arb_set_fmpz(step, around.p.get()->coeffs);
    arb_div(step, step, slope, precision);
    arb_mul_2exp_si(step, step, around.unit);
    arb_neg(step, step);
    arb_add_arf(step, step, around.middle.get(), precision);
    arb_get_interval_arf(next.low.get(), next.high.get(), step, precision);
    if (arf_cmp(next.low.get(), interval.low.get()) < 0) next.low = interval.low;
    if (arf_cmp(next.high.get(), interval.high.get()) > 0) next.high = interval.high;
  }
  arb_clear(slope);
  arb_clear(step);
  arb_clear(h);
  if (!is_there || bits_of_width(next) < sure + 4) return false;
  interval = std::move(next);
  return true;
}

/// An interval to look at, between powers of two as long as there are some inside.
struct Isolating {
  Dyadic low, high;
  slong low_power, high_power;
  int halvings;
};

}  // namespace

Dyadic Dyadic::power_of_two(slong exponent) {
  Dyadic x;
  arf_one(x.x_);
  arf_mul_2exp_si(x.x_, x.x_, exponent);
  return x;
}

Dyadic Dyadic::between(const Dyadic& a, const Dyadic& b) {
  Dyadic x;
  arf_add(x.x_, a.x_, b.x_, ARF_PREC_EXACT, ARF_RND_DOWN);
  arf_mul_2exp_si(x.x_, x.x_, -1);
  return x;
}

PositiveRoots::PositiveRoots(const fmpz_poly_struct* polynomial) {
  fmpz_poly_init(polynomial_);
  fmpz_poly_set(polynomial_, polynomial);
}

PositiveRoots::~PositiveRoots() { fmpz_poly_clear(polynomial_); }

// Coefficients of (1 + y)^n p(low + (high - low)/(1 + y)), whose positive roots are those between.
int PositiveRoots::most_roots(const Dyadic& low, const Dyadic& high) const {
  Dyadic width;
  arf_sub(width.get(), high.get(), low.get(), ARF_PREC_EXACT, ARF_RND_DOWN);
  Integer begin, wide;
  const slong unit = mantissa_and_exponent(width, wide);
  Dyadic steps;
  arf_mul_2exp_si(steps.get(), low.get(), -unit);
  const slong more = mantissa_and_exponent(steps, begin);
  ensure(more >= 0, "intervals begin at multiples of their unit");
  fmpz_mul_2exp(begin.get(), begin.get(), static_cast<ulong>(more));
  Integers p;
  fmpz_poly_set(p.get(), polynomial_);
  scale(p.get(), unit);
  fmpz_poly_taylor_shift(p.get(), p.get(), begin.get());
  Integer factor;
  fmpz_one(factor.get());
  for (slong i = 0; i < p.get()->length; ++i) {
    fmpz_mul(p.get()->coeffs + i, p.get()->coeffs + i, factor.get());
    fmpz_mul(factor.get(), factor.get(), wide.get());
  }
  fmpz_poly_reverse(p.get(), p.get(), fmpz_poly_length(polynomial_));
  fmpz_one(factor.get());
  fmpz_poly_taylor_shift(p.get(), p.get(), factor.get());
  return sign_changes(p.get());
}

std::optional<std::vector<RootInterval>> PositiveRoots::isolated() const {
  std::vector<RootInterval> found;
  slong largest = 0;
  const slong last = fmpz_poly_degree(polynomial_);
  for (slong i = 0; i <= last; ++i) largest = std::max(largest, bits_of(polynomial_, i));
  // Cauchy's bounds.
  const slong lowest = bits_of(polynomial_, 0) - largest - 2;
  const slong highest = largest - bits_of(polynomial_, last) + 2;
  std::vector<Isolating> left{
      {Dyadic::power_of_two(lowest), Dyadic::power_of_two(highest), lowest, highest, 0}};
  while (!left.empty()) {
    const Isolating all = std::move(left.back());
    left.pop_back();
    const int roots = most_roots(all.low, all.high);
    if (roots == 1) found.push_back({all.low, all.high});
    if (roots <= 1) continue;
    const bool by_powers = all.high_power - all.low_power > 1;
    if (!by_powers && all.halvings == deepest_halving) return std::nullopt;
    const slong power = (all.low_power + all.high_power) / 2;
    const Dyadic middle =
        by_powers ? Dyadic::power_of_two(power) : Dyadic::between(all.low, all.high);
    if (exact_sign(polynomial_, middle) == 0) found.push_back({middle, middle});
    const int halvings = all.halvings + (by_powers ? 0 : 1);
    left.push_back({all.low, middle, all.low_power, by_powers ? power : all.high_power, halvings});
    left.push_back({middle, all.high, by_powers ? power : all.low_power, all.high_power, halvings});
  }
  return found;
}

int PositiveRoots::exact_sign(const fmpz_poly_struct* polynomial, const Dyadic& x) const {
  Integer m, value;
  const slong exponent = mantissa_and_exponent(x, m);
  Integers p;
  fmpz_poly_set(p.get(), polynomial);
  scale(p.get(), exponent);
  fmpz_poly_evaluate_fmpz(value.get(), p.get(), m.get());
  return fmpz_sgn(value.get());
}

// At a root that of the slope, as roots are simple.
int PositiveRoots::sign_right_of(const Dyadic& x) const {
  if (const int sign = exact_sign(polynomial_, x); sign != 0) return sign;
  Integers slope;
  fmpz_poly_derivative(slope.get(), polynomial_);
  return exact_sign(slope.get(), x);
}

void PositiveRoots::refine(RootInterval& interval, slong bits) const {
  const int before = sign_right_of(interval.low);
  for (slong sure = bits_of_width(interval); sure < bits; sure = bits_of_width(interval)) {
    const Dyadic middle = Dyadic::between(interval.low, interval.high);
    Integer m;
    Around around{middle, mantissa_and_exponent(middle, m), {}};
    fmpz_poly_set(around.p.get(), polynomial_);
    scale(around.p.get(), around.unit);
    fmpz_poly_taylor_shift(around.p.get(), around.p.get(), m.get());
    const int sign = fmpz_sgn(around.p.get()->coeffs);
    if (sign == 0)
      interval = {middle, middle};
    else if (!take_newton_step(around, sure, interval))
      (sign == before ? interval.low : interval.high) = middle;
  }
}

}  // namespace vcrit
