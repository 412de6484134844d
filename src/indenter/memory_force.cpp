#include "indenter/memory_force.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "normal/normal_force.hpp"
#include "normal/quadrature_rules.hpp"

namespace vcrit::indenter {

namespace {

using simulation::NormalCycle;

// Cells that dip by less than this share of the amplitude touch as if the surface had no memory:
// they do for a thousandth of the period, and weigh 1e-9 of all under a parabola.
constexpr double hardly_dips = 1e-6;

// A relaxation that falls by more than this over a span has it halved towards the front.
constexpr double most_decades = 4;
constexpr int most_spans = 60;

// Places at which cells are compared with the next.
constexpr int compared = 64;

// Of phases, from cells that are found to about 1e-13 and have roots at the ends.
constexpr double phase_error = 1e-6;

constexpr int bisections = 60;

}  // namespace

CellPanels::CellPanels(const HalfSpace& half_space) {
  const double edge = half_space.edge(), inside = half_space.closed_radius();
  std::vector<double> ends = half_space.gap().edges();
  ends.push_back(inside);
  std::erase_if(ends, [&](double x) { return !(x > 0 && x < edge); });
  ends.insert(ends.end(), {0, edge});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    (ends[i + 1] <= inside ? closed : opening).push_back({ends[i], ends[i + 1]});
}

MemoryCells::MemoryCells(const HalfSpace& half_space)
    : half_space_(half_space),
      modes_(simulation::modes_of({half_space.normal(), 0, half_space.amplitude()},
                                  half_space.omega())),
      swing_(half_space.amplitude() * dynamic_stiffness(half_space.normal(), half_space.omega())) {}

double MemoryCells::swing_force(double t) const { return (swing_ * std::polar(1.0, t)).real(); }

double MemoryCells::force(const CellTouch& touch, double t, double swing) const {
  double sum = swing;
  for (simulation::Index i = 0; i < touch.decays.size(); ++i)
    sum += touch.decays[i] * std::exp(-modes_.branch_rates[i] * (t - touch.begin));
  return sum;
}

// Its branches carry nothing where it touches.
CellTouch MemoryCells::of_rim(double depth) const {
  const double reach = std::max(0.0, depth / half_space_.amplitude() + 1);
  CellTouch result{-std::sqrt(2 * reach), std::sqrt(2 * reach), {}};
  const std::complex<double> turn = std::polar(1.0, result.begin), i(0, 1);
  for (simulation::Index j = 0; j < modes_.branch_rates.size(); ++j) {
    const double stiffness = modes_.branch_stiffness[j], rate = modes_.branch_rates[j];
    result.decays.push_back(rate == 0 ? stiffness * depth
                                      : -stiffness * half_space_.amplitude() *
                                            (i / (rate + i) * turn).real());
  }
  return result;
}

CellTouch MemoryCells::touch(double x) const {
  const double depth = half_space_.depth(x);
  if (depth + half_space_.amplitude() < hardly_dips * half_space_.amplitude()) return of_rim(depth);
  const NormalCycle cycle =
      simulation::normal_cycle(modes_, {depth, half_space_.amplitude()}, half_space_.effort());
  if (cycle.touches.size() != 1)
    throw ModelError(
        "below the indenter a cell touches more than once in a period: no motion is known");
  const NormalCycle::Touch& found = cycle.touches[0];
  if (found.duration >= two_pi) return {least_phase() - two_pi, least_phase(), found.decays};
  // A cell lifts off while the indentation falls.
  const double end = simulation::wrapped(found.begin + found.duration);
  return {end - found.duration, end, found.decays};
}

MemoryForce::MemoryForce(const HalfSpace& half_space, double tolerance) : cells_(half_space) {
  const CellPanels panels(half_space);
  if (!panels.closed.empty()) {
    closed_edge_ = panels.closed.back().high;
    closed_mean_ = 2 * half_space.static_modulus() *
                   (half_space.indentation() * closed_edge_ - half_space.gap().area(closed_edge_));
  }
  // As x^n with n > 1: of x it is less and less.
  const double small = 1e-8 * half_space.edge();
  rate_unbounded_ = cells_.modes().damper > 0 && panels.closed.empty() &&
                    half_space.gap().at(small) / small <
                        0.5 * half_space.gap().at(half_space.edge()) / half_space.edge();
  find_touches(panels.opening, tolerance);
  interpolate(tolerance);
}

void MemoryForce::find_touches(const std::vector<Panel>& panels, double tolerance) {
  const auto branches = static_cast<Eigen::Index>(cells_.modes().branch_rates.size());
  for (const Panel& panel : panels) {
    Pieces touch(
        [&](double s, Eigen::VectorXd& values) {
          const CellTouch found = cells_.touch(panel.at(s));
          values(0) = found.begin;
          values(1) = found.end;
          for (Eigen::Index i = 0; i < branches; ++i)
            values(2 + i) = found.decays[static_cast<simulation::Index>(i)];
        },
        2 + branches, tolerance);
    require_nested(touch);
    openings_.push_back({panel, std::move(touch), {}});
    Opening& part = openings_.back();
    const std::vector<double>& ends = part.touch.ends();
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      part.whole.push_back(spans(part, ends[i], ends[i + 1]));
  }
}

void MemoryForce::require_nested(const Pieces& touch) const {
  for (int i = 0; i < compared; ++i) {
    const double s = static_cast<double>(i) / compared, next = s + 1.0 / compared;
    if (touch.at(next, 0) < touch.at(s, 0) - phase_error ||
        touch.at(next, 1) > touch.at(s, 1) + phase_error)
      throw ModelError(
          "below the indenter an outer cell touches before an inner one: no motion is known");
  }
}

// The variable up to which cells of a panel touch, and whether it grows.
double MemoryForce::front(const Opening& part, double t, bool& grows) const {
  grows = true;
  double best = 1;
  for (const Eigen::Index which : {0, 1}) {
    const double side = which == 0 ? 1 : -1;
    const auto touched = [&](double s) { return side * (t - part.touch.at(s, which)) >= 0; };
    if (touched(best)) continue;
    double low = 0, high = best;
    if (!touched(0)) {
      grows = false;
      return 0;
    }
    // Of three halvings all places that may be asked.
    for (int i = 0; i < bisections && high - low > epsilon * high; i += 3) {
      const double middle = 0.5 * (low + high), below = 0.5 * (low + middle),
                   above = 0.5 * (middle + high);
      const std::array<double, 7> places{
          0.5 * (low + below),    below, 0.5 * (below + middle), middle,
          0.5 * (middle + above), above, 0.5 * (above + high)};
      const std::array<double, 7> phases = part.touch.at_places(places, which);
      for (std::size_t at = 3, step = 2;; step /= 2) {
        const bool touches = side * (t - phases[at]) >= 0;
        (touches ? low : high) = places[at];
        if (step == 0 || !(high - low > epsilon * high)) break;
        at = touches ? at + step : at - step;
      }
    }
    best = low;
    grows = which == 0;
  }
  return best;
}

// Halved towards the front, where what touched just now has not relaxed yet.
std::vector<MemoryForce::Span> MemoryForce::spans(const Opening& part, double low,
                                                  double high) const {
  double fastest = 0;
  for (const double rate : cells_.modes().branch_rates) fastest = std::max(fastest, rate);
  std::vector<Span> result;
  for (int j = 0; j < most_spans; ++j) {
    if (fastest * std::abs(part.touch.at(high, 0) - part.touch.at(low, 0)) < most_decades) break;
    const double middle = 0.5 * (low + high);
    result.push_back({low, middle, {}});
    low = middle;
  }
  result.push_back({low, high, {}});
  const auto numbers = 2 + static_cast<Eigen::Index>(cells_.modes().branch_rates.size());
  Eigen::VectorXd touch;
  for (Span& span : result) {
    const SymmetricRule rule = gauss_20();
    span.touches.resize(1 + numbers, 2 * static_cast<Eigen::Index>(rule.nodes.size()));
    Eigen::Index column = 0;
    integral(rule, span.low, span.high, [&](double s) {
      part.touch.at(s, touch);
      span.touches.col(column++) << part.panel.rate(s), touch;
      return 0.0;
    });
  }
  return result;
}

void MemoryForce::add_span(const Span& span, double t, Sum& sum) const {
  const simulation::ContactModes& modes = cells_.modes();
  Eigen::Index column = 0;
  const auto next = [&](double) -> std::complex<double> {
    const auto touch = span.touches.col(column++);
    double force = 0, rate = 0;
    for (simulation::Index i = 0; i < modes.branch_rates.size(); ++i) {
      const double r = modes.branch_rates[i],
                   each = touch(3 + static_cast<Eigen::Index>(i)) * std::exp(-r * (t - touch(1)));
      force += each;
      rate -= r * each;
    }
    return touch(0) * std::complex<double>(force, rate);
  };
  const std::complex<double> found = integral(gauss_20(), span.low, span.high, next);
  sum.force += 2 * found.real();
  sum.rate += 2 * found.imag();
}

void MemoryForce::add(const Opening& part, double t, Sum& sum) const {
  bool grows = false;
  const double to = front(part, t, grows);
  if (!(to > 0)) return;
  const std::complex<double> swing = cells_.swing() * std::polar(1.0, t);
  const double width = part.panel.at(to) - part.panel.low;
  sum.force += 2 * width * swing.real();
  sum.rate -= 2 * width * swing.imag();
  const std::vector<double>& ends = part.touch.ends();
  for (std::size_t i = 0; i + 1 < ends.size() && ends[i] < to; ++i) {
    if (ends[i + 1] <= to)
      for (const Span& span : part.whole[i]) add_span(span, t, sum);
    else
      for (const Span& span : spans(part, ends[i], to)) add_span(span, t, sum);
  }
  if (!grows || !(cells_.modes().damper > 0) || to >= 1) return;
  // A direct damper carries a force at once, of each cell that touches.
  double force = swing.real();
  for (Eigen::Index i = 2; i < 2 + static_cast<Eigen::Index>(cells_.modes().branch_rates.size());
       ++i)
    force += part.touch.at(to, i);
  sum.rate += 2 * force * part.panel.rate(to) / part.touch.slope(to, 0);
}

MemoryForce::Sum MemoryForce::summed(double t) const {
  const std::complex<double> swing = cells_.swing() * std::polar(1.0, t);
  Sum sum{closed_mean_ + 2 * closed_edge_ * swing.real(), -2 * closed_edge_ * swing.imag()};
  for (const Opening& part : openings_) add(part, t, sum);
  return sum;
}

// Spans of time end where the front is at the end of a panel; in each, time is a cubic polynomial
// of the variable, with its extrema there, in which roots are smooth.
void MemoryForce::interpolate(double tolerance) {
  std::vector<double> ends;
  for (const Opening& part : openings_)
    for (const double s : {0.0, 1.0})
      ends.insert(ends.end(), {part.touch.at(s, 0), part.touch.at(s, 1)});
  last_ = closed_edge_ > 0 ? cells_.least_phase() : openings_.front().touch.at(0, 1);
  for (double& end : ends)
    end = std::abs(end) < phase_error ? 0 : std::clamp(end, last_ - two_pi, last_);
  ends.insert(ends.end(), {last_ - two_pi, 0, last_});
  std::sort(ends.begin(), ends.end());
  const auto together = [](double a, double b) { return b - a < phase_error; };
  ends.erase(std::unique(ends.begin(), ends.end(), together), ends.end());
  ends.back() = last_;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Panel span{ends[i], ends[i + 1]};
    phases_.push_back({span.low, span.high,
                       Pieces(
                           [&](double s, Eigen::VectorXd& values) {
                             const Sum found = summed(span.at(s));
                             values(0) = found.force;
                             values(1) = rate_unbounded_ ? 0 : found.rate;
                           },
                           2, tolerance)});
  }
  for (const double end : ends) kinks_.push_back(simulation::wrapped(end));
  kinks_.insert(kinks_.end(), {0, two_pi});
  std::sort(kinks_.begin(), kinks_.end());
}

double MemoryForce::wrapped(double t) const {
  const double begin = last_ - two_pi;
  return begin + simulation::wrapped(t - begin);
}

bool MemoryForce::touches(double t) const {
  return closed_edge_ > 0 || wrapped(t) >= openings_.front().touch.at(0, 0);
}

MemoryForce::Sum MemoryForce::at(double given) const {
  const double t = wrapped(given);
  const auto after =
      std::upper_bound(phases_.begin(), phases_.end() - 1, t,
                       [](double value, const Phases& each) { return value < each.end; });
  const double share = std::clamp((t - after->begin) / (after->end - after->begin), 0.0, 1.0);
  // The root of s^2 (3 - 2 s) = share.
  const double s = 0.5 - std::sin(std::asin(1 - 2 * share) / 3);
  const Eigen::Array2d found = after->values.several_at<2>(s, 0);
  return {found(0), found(1)};
}

}  // namespace vcrit::indenter
