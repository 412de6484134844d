// How no event is missed: a march with steps during which f provably stays below zero. From a point
// t on, f(t + x) is bounded from above, for 0 <= x <= h, by a cubic in x:
//   * slow terms (rate h <= 1): Taylor's cubic with the largest third derivative on the interval;
//     for a decaying exponential it is taken at the end where it is largest, for a pair of modes or
//     the sinusoid its amplitude;
//   * fast decays (rate h > 1): as intervals. Their integral from t is monotone, so it lies between
//     0 and its limit; a negative one is convex, so it lies below its chord;
//   * fast pairs: by their amplitude.
// The step goes to the cubic's first zero. As the bound is exact to third order, steps converge
// cubically on a simple zero of f, always from below; at a maximum below zero they pass over it.
#include "simulation/motion/event_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

// Largest |sigma part of x e^{(-p + sigma) t}| over t >= 0.
double largest(PairNumber x, PairNumber exponent) {
  if (x.q < 0) return std::sqrt(x.b * x.b - x.a * x.a / x.q);
  const double slow = -exponent.a - std::sqrt(x.q);  // > 0: both rates are real and positive
  return std::abs(x.b) + std::abs(x.a) * std::exp(-1.0) / slow;
}

}  // namespace

// The bound c0 + c1 x + c2 x^2/2 + c3 x^3/6.
struct EventFunction::Cubic {
  double c0 = 0, c1 = 0, c2 = 0, c3 = 0;

  double operator()(double x) const { return c0 + x * (c1 + x * (c2 / 2 + x * c3 / 6)); }
  double slope(double x) const { return c1 + x * (c2 + x * c3 / 2); }

  // How long it stays negative after 0, at most h.
  double negative_until(double h) const {
    if (c0 > 0 || (c0 == 0 && (c1 > 0 || (c1 == 0 && (c2 > 0 || (c2 == 0 && c3 > 0)))))) return 0;
    double from = 0;
    for (const double turn : turns(h)) {
      if (turn > from && (*this)(turn) >= 0) return crossing(from, turn);
      from = std::max(from, turn);
    }
    return h;
  }

 private:
  std::array<double, 3> turns(double h) const {
    std::array<double, 3> result{0, 0, h};
    const double discriminant = c2 * c2 - 2 * c3 * c1;
    if (discriminant > 0) {
      const double sum = -(c2 + std::copysign(std::sqrt(discriminant), c2));
      const double one = sum / c3, other = sum == 0 ? 0 : 2 * c1 / sum;
      if (one > 0 && one < h) result[0] = one;
      if (other > 0 && other < h) result[1] = other;
      if (result[0] > result[1]) std::swap(result[0], result[1]);
    }
    return result;
  }
  // Between a point below zero and one not below, on one monotone piece; from below.
  double crossing(double low, double high) const {
    for (int i = 0; i < 100 && high - low > 1e-6 * high; ++i) {
      const double middle = 0.5 * (low + high);
      const double newton = middle - (*this)(middle) / slope(middle);
      ((*this)(middle) < 0 ? low : high) = middle;
      if (newton > low && newton < high) ((*this)(newton) < 0 ? low : high) = newton;
    }
    return low;
  }
};

EventFunction::EventFunction(int order, double value, double size)
    : order_(order), value_(value), size_(size) {
  ensure(order == 1 || order == 2, "event functions are integrals of order 1 or 2");
}

void EventFunction::add_modes(const Spectrum& spectrum, const Vector& row, const Vector& z,
                              double factor, int derivative) {
  for (Index i = 0; i < spectrum.singles(); ++i) {
    const double rate = spectrum.rates[static_cast<std::size_t>(i)];
    const double amplitude = factor * row(i) * z(i) * (derivative == 1 ? -rate : 1);
    if (amplitude != 0) decays_.push_back({amplitude, rate, amplitude});
  }
  if (!spectrum.pair) return;
  const PairNumber exponent = spectrum.pair->exponent();
  PairNumber amplitude = spectrum.weight(row) * spectrum.amplitude(z) * factor;
  if (derivative == 1) amplitude = amplitude * exponent;
  pairs_.push_back({amplitude, exponent, inverse(exponent), size(exponent), amplitude});
}

void EventFunction::add_sinusoid(std::complex<double> amplitude) {
  const PairNumber pair{-amplitude.imag(), amplitude.real(), -1};
  pairs_.push_back({pair, {0, 1, -1}, {0, -1, -1}, 1, pair});
}

namespace {

// e^{s t} and its first two integrals from 0.
template <class Number>
struct Integrals {
  Number none, once, twice;
};

Integrals<double> integrals(double rate, double t) {
  const double x = rate * t;
  if (x < 0.5) {
    const double twice = t * t * phi(2, -x), once = t - rate * twice;
    return {1 - rate * once, once, twice};
  }
  const double none = std::exp(-x), once = (1 - none) / rate;
  return {none, once, (t - once) / rate};
}

Integrals<PairNumber> integrals(PairNumber s, PairNumber inverse, double rate, double t) {
  if (rate * t < 0.5) {
    const PairNumber twice = phi(2, s * t) * (t * t), once = s * twice + t;
    return {s * once + 1, once, twice};
  }
  const PairNumber none = exp(s * t), once = (none - 1) * inverse;
  return {none, once, (once - t) * inverse};
}

}  // namespace

EventFunction::Point EventFunction::move_to(double t) {
  Point p{t, value_, 0, 0, size_};
  const auto add = [&](double value, double slope, double curvature) {
    p.value += value;
    p.slope += slope;
    p.curvature += curvature;
    p.noise += std::abs(value);
  };
  for (Decay& d : decays_) {
    const auto [none, once, twice] = integrals(d.rate, t);
    d.now = d.amplitude * none;
    if (order_ == 1)
      add(d.amplitude * once, d.now, -d.rate * d.now);
    else
      add(d.amplitude * twice, d.amplitude * once, d.now);
  }
  for (Pair& pair : pairs_) {
    const auto [none, once, twice] = integrals(pair.exponent, pair.inverse, pair.rate, t);
    pair.now = pair.amplitude * none;
    if (order_ == 1)
      add((pair.amplitude * once).b, pair.now.b, (pair.now * pair.exponent).b);
    else
      add((pair.amplitude * twice).b, (pair.amplitude * once).b, pair.now.b);
  }
  p.noise *= rounding;
  slope_ = p.slope;
  return p;
}

// Slow decays' cubic coefficients are exact but for the last; c1 of order 2 is the point's slope.
bool EventFunction::bound_decays(Cubic& bound, double h) const {
  bool fast = false;
  for (const Decay& d : decays_) {
    const double rate_h = d.rate * h;
    if (rate_h > 1) {
      fast = true;
      if (order_ == 1)
        (d.now > 0 ? bound.c0 : bound.c1) += d.now > 0 ? d.now / d.rate : d.now * 0.63 / rate_h;
      else if (d.now > 0)
        bound.c1 += d.now / d.rate;
      continue;
    }
    const double second = order_ == 1 ? -d.rate * d.now : d.now;
    const double third = -d.rate * second;
    if (order_ == 1) bound.c1 += d.now;
    bound.c2 += second;
    bound.c3 += third > 0 ? third : third * (1 - rate_h);
  }
  return fast;
}

bool EventFunction::bound_pairs(Cubic& bound, double h) const {
  bool fast = false;
  for (const Pair& pair : pairs_) {
    if (pair.rate * h <= 1) {
      const PairNumber once = pair.now * pair.exponent;
      if (order_ == 1) bound.c1 += pair.now.b;
      bound.c2 += order_ == 1 ? once.b : pair.now.b;
      bound.c3 += largest(order_ == 1 ? once * pair.exponent : once, pair.exponent);
      continue;
    }
    fast = true;
    const PairNumber back = pair.now * pair.inverse;
    if (order_ == 1) {
      bound.c0 += largest(back, pair.exponent) - back.b;
    } else {
      const PairNumber twice = back * pair.inverse;
      bound.c0 += largest(twice, pair.exponent) - twice.b;
      bound.c1 -= back.b;
    }
  }
  return fast;
}

EventFunction::Safe EventFunction::safe_duration(double value, double h) const {
  Cubic bound;
  bound.c0 = value;
  if (order_ == 2) bound.c1 = slope_;
  const bool fast_decays = bound_decays(bound, h);
  const bool fast_pairs = bound_pairs(bound, h);
  return {bound.negative_until(h), fast_decays || fast_pairs};
}

namespace {

class March {
 public:
  March(EventFunction& f, double end, bool leaving, double first_step)
      : f_(f), end_(end), leaving_(leaving), h_(first_step) {}

  std::optional<double> run() {
    EventFunction::Point here = f_.move_to(0);
    if (leaving_) here.value = 0;
    for (int i = 0; i < most_steps; ++i) {
      if (here.time >= end_) return std::nullopt;
      const bool at_start = leaving_ && here.time == 0;
      if (!at_start && here.value >= -here.noise) {
        if (here.slope > 0 || here.curvature > 0) return polished(here);
        here = f_.move_to(here.time + past(here));
        continue;
      }
      const double step = safe_step(here);
      if (step <= least_step(here.time)) {
        if (!at_start) return polished(here);
        return 0.0;
      }
      here = f_.move_to(std::min(end_, here.time + step));
    }
    throw ModelError("too many oscillations before the next change of stick and slip");
  }

 private:
  static constexpr int most_steps = 10'000'000;

  static double least_step(double t) {
    return t == 0 ? 1e-300 : std::numeric_limits<double>::epsilon() * t;
  }

  // Intervals are narrowed while they hide fast terms and show little; they grow when all is safe.
  double safe_step(const EventFunction::Point& here) {
    while (true) {
      const EventFunction::Safe safe = f_.safe_duration(here.value, h_);
      if (safe.duration >= h_) {
        const double whole = h_;
        h_ *= 2;
        return whole;
      }
      if (safe.finer && safe.duration < h_ / 4 && h_ > least_step(here.time)) {
        h_ /= 4;
        continue;
      }
      h_ = std::max(4 * safe.duration, 1e-290);
      return safe.duration;
    }
  }

  // f is within rounding of zero and turning down: a touch, left behind by twice the time that it
  // takes f to get out of the rounding.
  static double past(const EventFunction::Point& p) {
    const double by_slope = p.slope < 0 ? 2 * p.noise / -p.slope : 1e-8;
    const double by_curvature = p.curvature < 0 ? 2 * std::sqrt(p.noise / -p.curvature) : 1e-8;
    return std::max(std::min(by_slope, by_curvature), 2 * least_step(p.time));
  }

  // One Newton step over what is left, where the slope carries it.
  double polished(const EventFunction::Point& p) const {
    const double step = -p.value / p.slope;
    const bool small = p.slope > 0 && std::abs(step) < 1e-6 * p.time;
    return std::min(end_, small ? p.time + step : p.time);
  }

  EventFunction& f_;
  double end_;
  bool leaving_;
  double h_;
};

}  // namespace

std::optional<double> first_zero(EventFunction& f, double end, bool leaving, double first_step) {
  return March(f, end, leaving, first_step).run();
}

}  // namespace vcrit::simulation
