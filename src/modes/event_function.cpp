#include "modes/event_function.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

// Of a term: an exponential or a cosine, its argument, a product and the sum.
constexpr double term_rounding = 4 * epsilon;

// A decay or pair whose rate times the interval is below this enters by its Taylor series.
constexpr double taylor_limit = 2;

const ModePair oscillation{0, -1};

// What a step costs whatever the number of modes, in modes carried over one (some 200 ns): the
// sinusoid, the polynomial that bounds the function, and its first zero.
constexpr Index fixed_work = 12;

// Largest |sigma part of x e^{(-p + sigma) t}| over t >= 0.
double largest(PairNumber x, PairNumber exponent) {
  if (x.q < 0) return std::sqrt(x.b * x.b - x.a * x.a / x.q);
  const double slowest = -exponent.a - std::sqrt(x.q);  // > 0: both rates are real and positive
  return std::abs(x.b) + std::abs(x.a) * std::exp(-1.0) / slowest;
}

}  // namespace

EventFunction::EventFunction(const Spectrum& spectrum, int order, double value, double size,
                             Effort* effort)
    : spectrum_(&spectrum),
      order_(static_cast<std::size_t>(order)),
      value_(value),
      size_(size),
      effort_(effort),
      singles_(spectrum.singles()) {
  ensure(order == 1 || order == 2, "event functions are integrals of order 1 or 2");
  for (const ModePair& pair : spectrum.pairs) pairs_.push_back({0, 0, pair.q});
}

void EventFunction::add_modes(ConstView row, ConstView z, double factor, int derivative) {
  for (Index i = 0; i < spectrum_->singles(); ++i)
    singles_[i] += factor * row[i] * z[i] * (derivative == 1 ? -spectrum_->rates[i] : 1);
  for (Index p = 0; p < pairs_.size(); ++p) {
    PairNumber amplitude = spectrum_->weight(row, p) * spectrum_->amplitude(z, p) * factor;
    if (derivative == 1) amplitude = amplitude * spectrum_->pairs[p].exponent;
    pairs_[p] = pairs_[p] + amplitude;
  }
}

void EventFunction::add_sinusoid(std::complex<double> amplitude) {
  sinusoid_ = sinusoid_ + PairNumber{-amplitude.imag(), amplitude.real(), -1};
}

void EventFunction::count() const {
  if (effort_ != nullptr) effort_->spend(fixed_work + spectrum_->size());
}

EventFunction::Point EventFunction::at(const ModalFactors& factors) const {
  count();
  Point p{factors.duration(), value_, 0, 0, size_};
  const auto add = [&](double value, double slope, double curvature) {
    p.value += value;
    p.slope += slope;
    p.curvature += curvature;
    p.noise += std::abs(value);
  };
  const auto add_pair = [&](PairNumber amplitude, const Integrals<PairNumber>& factor,
                            PairNumber exponent) {
    const double curvature =
        order_ == 1 ? (amplitude * factor[0] * exponent).b : (amplitude * factor[0]).b;
    add((amplitude * factor[order_]).b, (amplitude * factor[order_ - 1]).b, curvature);
  };
  for (Index i = 0; i < singles_.size(); ++i) {
    const double amplitude = singles_[i];
    const Integrals<double>& factor = factors.single(i);
    add(amplitude * factor[order_], amplitude * factor[order_ - 1],
        amplitude * factor[0] * (order_ == 1 ? -spectrum_->rates[i] : 1));
  }
  for (Index i = 0; i < pairs_.size(); ++i)
    add_pair(pairs_[i], factors.pair(i), spectrum_->pairs[i].exponent);
  add_pair(sinusoid_, factors.turn(), oscillation.exponent);
  p.noise *= term_rounding;
  return p;
}

EventFunction::Point EventFunction::move_to(double t) {
  here_ = ModalFactors(*spectrum_, t);
  const Point p = at(here_);
  slope_ = p.slope;
  return p;
}

double EventFunction::ceiling(double t) const {
  if (order_ == 2) return infinity;
  double sum = value_, size = size_;
  const auto add = [&](double highest) {
    sum += highest;
    size += std::abs(highest);
  };
  for (Index i = 0; i < singles_.size(); ++i)
    if (singles_[i] > 0) add(singles_[i] * std::min(t, 1 / spectrum_->rates[i]));
  const auto add_pair = [&](PairNumber amplitude, const ModePair& pair) {
    const PairNumber once = amplitude * pair.receptance;
    add(largest(once, pair.exponent) - once.b);
  };
  for (Index p = 0; p < pairs_.size(); ++p) add_pair(pairs_[p], spectrum_->pairs[p]);
  add_pair(sinusoid_, oscillation);
  return sum + term_rounding * size;
}

// Slow decays' coefficients are exact but for the last; c1 of order 2 is the point's slope.
bool EventFunction::bound_decays(Derivatives& bound, double h) const {
  bool fast = false;
  for (Index i = 0; i < singles_.size(); ++i) {
    const double now = singles_[i] * here_.single(i)[0], rate = spectrum_->rates[i],
                 rate_h = rate * h;
    if (now == 0) continue;
    if (rate_h > taylor_limit) {
      fast = true;
      if (order_ == 1)
        (now > 0 ? bound[0] : bound[1]) += now > 0 ? now / rate : now * 0.63 / rate_h;
      else if (now > 0)
        bound[1] += now / rate;
      continue;
    }
    double derivative = now;
    for (std::size_t k = order_; k < degree; ++k, derivative *= -rate) bound[k] += derivative;
    bound[degree] += derivative > 0 ? derivative : derivative * std::max(0.0, 1 - rate_h);
  }
  return fast;
}

bool EventFunction::bound_pair(Derivatives& bound, double h, PairNumber now,
                               const ModePair& pair) const {
  if (pair.rate * h <= taylor_limit) {
    PairNumber derivative = now;
    for (std::size_t k = order_; k < degree; ++k, derivative = derivative * pair.exponent)
      bound[k] += derivative.b;
    const double change = h * largest(derivative * pair.exponent, pair.exponent);
    bound[degree] += std::min(largest(derivative, pair.exponent), derivative.b + change);
    return false;
  }
  const PairNumber once = now * pair.receptance;
  if (order_ == 1) {
    bound[0] += largest(once, pair.exponent) - once.b;
  } else {
    const PairNumber twice = once * pair.receptance;
    bound[0] += largest(twice, pair.exponent) - twice.b;
    bound[1] -= once.b;
  }
  return true;
}

// The same of the sinusoid, whose derivatives are turned by a quarter and all of one size.
bool EventFunction::bound_sinusoid(Derivatives& bound, double h) const {
  PairNumber derivative = sinusoid_ * here_.turn()[0];
  const double size = std::sqrt(derivative.b * derivative.b + derivative.a * derivative.a);
  if (h <= taylor_limit) {
    for (std::size_t k = order_; k < degree; ++k, derivative = {-derivative.b, derivative.a})
      bound[k] += derivative.b;
    bound[degree] += std::min(size, derivative.b + h * size);
    return false;
  }
  bound[0] += size + (order_ == 1 ? derivative.a : derivative.b);
  if (order_ == 2) bound[1] += derivative.a;
  return true;
}

EventFunction::Safe EventFunction::safe_duration(double value, double h) const {
  count();
  Derivatives bound{value};
  if (order_ == 2) bound[1] = slope_;
  bool fast = bound_decays(bound, h);
  for (Index p = 0; p < pairs_.size(); ++p)
    fast = bound_pair(bound, h, pairs_[p] * here_.pair(p)[0], spectrum_->pairs[p]) || fast;
  fast = bound_sinusoid(bound, h) || fast;
  return {negative_duration(bound, h), fast};
}

double EventFunction::safe_step(double value, double& h) const {
  const double time = here_.duration(), least = time == 0 ? 1e-300 : epsilon * time;
  while (true) {
    const Safe safe = safe_duration(value, h);
    if (safe.duration >= h) {
      const double whole = h;
      h *= 2;
      return whole;
    }
    if (safe.finer && safe.duration < h / 4 && h > least) {
      h /= 4;
      continue;
    }
    h = std::max(4 * safe.duration, 1e-290);
    return safe.duration;
  }
}

}  // namespace vcrit::simulation
