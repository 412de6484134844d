#include "stiffness/secular.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/interruption.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit {

namespace {

// Of a pole, as a share of it.
constexpr double very_near = 0x1p-10;

// f and its derivatives at reference + d. The pole at the reference is left out of the sums and
// kept apart, since w/d alone is large there.
struct Near {
  const SecularFunction& f;
  double reference;

  double own_weight() const {
    for (std::size_t j = 0; j < f.poles.size(); ++j)
      if (f.poles[j] == reference) return f.weights[j];
    return 0;
  }
  double rest(double d) const {
    if (std::abs(d) <= very_near * reference) return rest_beside(d);
    double sum = f.slope * (reference + d) - f.constant;
    for (std::size_t j = 0; j < f.poles.size(); ++j)
      if (f.poles[j] != reference) sum += f.weights[j] / ((reference - f.poles[j]) + d);
    return sum;
  }
  // What is left at the reference, which nearly cancels, and the change from there, which does not:
  // the roots to both sides of a pole of little weight, of two networks with nearly equal rates,
  // then have one rounding error. With one each, their weights would lose its share of the gap.
  double rest_beside(double d) const {
    double sum = f.slope * reference - f.constant, change = f.slope * d;
    for (std::size_t j = 0; j < f.poles.size(); ++j) {
      if (f.poles[j] == reference) continue;
      const double distance = reference - f.poles[j];
      if (std::abs(d) <= 0.5 * std::abs(distance)) {
        sum += f.weights[j] / distance;
        change -= f.weights[j] / distance * (d / (distance + d));
      } else {
        change += f.weights[j] / (distance + d);
      }
    }
    return sum + change;
  }
  double rest_slope(double d) const {
    double sum = f.slope;
    for (std::size_t j = 0; j < f.poles.size(); ++j) {
      const double distance = (reference - f.poles[j]) + d;
      if (f.poles[j] != reference) sum -= f.weights[j] / distance / distance;
    }
    return sum;
  }
  double value(double d) const {
    const double weight = own_weight();
    return (weight > 0 ? weight / d : 0) + rest(d);
  }
  double first(double d) const {
    const double weight = own_weight();
    return rest_slope(d) - (weight > 0 ? weight / d / d : 0);
  }
  double second(double d) const {
    double sum = 0;
    for (std::size_t j = 0; j < f.poles.size(); ++j) {
      const double distance = (reference - f.poles[j]) + d;
      sum += 2 * f.weights[j] / distance / distance / distance;
    }
    return sum;
  }
};

double between(double low, double high) {
  if (low > 0) return std::sqrt(low) * std::sqrt(high);
  if (high < 0) return -std::sqrt(-low) * std::sqrt(-high);
  return low == 0 ? high / 1024 : low / 1024;
}

// The sign change of `sign` between two offsets of one sign, to the last bits.
template <class Sign>
double bisect(const Sign& sign, double low, double high) {
  const bool rising = !(sign(low == 0 ? high * 1e-300 : low) > 0);
  for (int i = 0; i < 200 && high - low > 4e-16 * std::max(std::abs(low), std::abs(high)); ++i) {
    const double middle = between(low, high);
    ((sign(middle) > 0) == rising ? high : low) = middle;
  }
  return low == 0 ? high : low;
}

// The root of the monotone f between the offsets low and high (one sign, one of them may be 0):
// Newton on d f(d), smooth through the pole, kept inside a bracket that halves its exponent.
double solve(const Near& near, double low, double high, bool rising) {
  hear_interruption();
  const double weight = near.own_weight();
  double d = between(low, high);
  for (int i = 0; i < 300; ++i) {
    const double rest = near.rest(d);
    const double value = (weight > 0 ? weight / d : 0) + rest;
    if (value == 0) return d;
    ((value > 0) == rising ? high : low) = d;
    const double slope = near.rest_slope(d);
    double next = weight > 0 ? d - (weight + d * rest) / (rest + d * slope) : d - rest / slope;
    if (!(next > low && next < high)) next = between(low, high);
    if (std::abs(next - d) <= 3e-16 * std::abs(d) || next == low || next == high) return next;
    d = next;
  }
  return d;
}

// The interval between neighbouring poles; `left` 0 may have no pole, `right` is infinite beyond
// the last. Places in it are offsets, since the whole of what matters may lie within rounding of a
// pole.
class PoleInterval {
 public:
  PoleInterval(const SecularFunction& f, double left, double right)
      : f_(f), left_(left), right_(right) {}

  // The root in the monotone piece [from, to] of the interval, where f changes its sign.
  OffsetRate root(const OffsetRate& from, const OffsetRate& to, bool rising) const {
    const double reference = nearest(from, to, rising);
    double low = from.minus(reference), high = to.minus(reference);
    if (std::isfinite(right_)) {
      if (reference == left_) high = std::min(high, half());
      if (reference == right_) low = std::max(low, -half());
    } else {
      high = upper_end();
    }
    return {reference, solve(Near{f_, reference}, low, high, rising)};
  }
  double half() const { return 0.5 * (right_ - left_); }

 private:
  double nearest(const OffsetRate& from, const OffsetRate& to, bool rising) const {
    if (!std::isfinite(right_)) return left_;
    if (from.minus(left_) >= half()) return right_;
    if (to.minus(left_) <= half()) return left_;
    return (Near{f_, left_}.value(half()) > 0) == rising ? left_ : right_;
  }
  // Beyond the last pole: there f > slope x - constant, and without a slope
  // f < (sum of weights)/offset - constant. The margin covers rounding.
  double upper_end() const {
    const double margin = 1 + 1e-12;
    if (f_.slope > 0) return (f_.constant / f_.slope) * margin - left_ * (1 - 1e-12);
    double total = 0;
    for (const double w : f_.weights) total += w;
    return total / f_.constant * margin;
  }

  const SecularFunction& f_;
  double left_, right_;
};

class Roots {
 public:
  explicit Roots(const SecularFunction& f) : f_(f) {}

  std::vector<OffsetRate> all() {
    const auto& poles = f_.poles;
    if (poles.empty()) {
      if (f_.slope > 0 && f_.constant > 0) roots_.push_back({0, f_.constant / f_.slope});
      return roots_;
    }
    if (poles.front() > 0 && f_.slope > 0) below();
    for (std::size_t j = 0; j + 1 < poles.size(); ++j) gap(poles[j], poles[j + 1]);
    beyond(poles.back());
    return roots_;
  }

 private:
  // (0, first pole): f is concave from below 0 to -infinity; none or two roots.
  void below() {
    const double right = f_.poles.front();
    const Near at_zero{f_, 0}, at_right{f_, right};
    if (at_zero.first(0) <= 0) return;
    const auto falls = [&](double d) { return -at_right.first(d); };
    const OffsetRate top{right, bisect(falls, -right, 0)};
    if (at_right.value(top.offset) <= 0) return;
    const PoleInterval interval(f_, 0, right);
    roots_.push_back(interval.root({0, 0}, top, true));
    roots_.push_back(interval.root(top, {right, 0}, false));
  }

  // f falls from +infinity to -infinity. Its slope is concave, so it rises at most once on the way.
  void gap(double left, double right) {
    const PoleInterval interval(f_, left, right);
    if (may_rise(left, right)) {
      const double half = interval.half();
      // Where the slope is steepest just halfway, bisection from the left pole ends there; the one
      // to the right one would begin without a sign.
      const bool in_left_half = !(Near{f_, right}.second(-half) > 0);
      const Near near{f_, in_left_half ? left : right};
      const double end = in_left_half ? half : -half;
      const double steepest =
          bisect([&](double d) { return near.second(d); }, std::min(end, 0.0), std::max(end, 0.0));
      if (near.first(steepest) > 0 && three(interval, left, right, {near.reference, steepest}))
        return;
    }
    roots_.push_back(interval.root({left, 0}, {right, 0}, false));
  }

  // Seen from one pole, a steepest place near the other may be within rounding of that.
  bool three(const PoleInterval& interval, double left, double right, const OffsetRate& steepest) {
    const Near from_left{f_, left}, from_right{f_, right};
    const double inside = std::nextafter(right - left, 0);
    const OffsetRate bottom{left, bisect([&](double d) { return from_left.first(d); }, 0,
                                         std::min(steepest.minus(left), inside))};
    const OffsetRate top{right, bisect([&](double d) { return from_right.first(d); },
                                       std::max(steepest.minus(right), -inside), 0)};
    if (!(bottom.offset > 0 && bottom.minus(top) < 0 && top.offset < 0)) return false;
    if (!(from_left.value(bottom.offset) < 0 && from_right.value(top.offset) > 0)) return false;
    roots_.push_back(interval.root({left, 0}, bottom, false));
    roots_.push_back(interval.root(bottom, top, true));
    roots_.push_back(interval.root(top, {right, 0}, false));
    return true;
  }

  // The least value that the gap's own two poles leave for sum_j w_j/(x - a_j)^2 decides cheaply.
  bool may_rise(double left, double right) const {
    if (f_.slope == 0) return false;
    double sum = 0;
    for (std::size_t j = 0; j < f_.poles.size(); ++j)
      if (f_.poles[j] == left || f_.poles[j] == right) sum += std::cbrt(f_.weights[j]);
    return f_.slope > sum * sum * sum / (right - left) / (right - left);
  }

  // Beyond the last pole f is convex with a slope (none or two roots), else it falls to -constant.
  void beyond(double left) {
    const PoleInterval interval(f_, left, infinity);
    if (f_.slope == 0) {
      if (f_.constant > 0) roots_.push_back(interval.root({left, 0}, {infinity, 0}, false));
      return;
    }
    const Near near{f_, left};
    double total = 0;
    for (const double w : f_.weights) total += w;
    const double far = 2 * std::sqrt(total / f_.slope);
    const double bottom = bisect([&](double d) { return near.first(d); }, 0, far);
    if (near.value(bottom) > 0) return;
    roots_.push_back({left, solve(near, 0, bottom, false)});
    roots_.push_back(interval.root({left, bottom}, {infinity, 0}, true));
  }

  const SecularFunction& f_;
  std::vector<OffsetRate> roots_;
};

}  // namespace

std::vector<OffsetRate> positive_roots(const SecularFunction& f) {
  check_weights(f.poles.size(), f.weights.size());
  return Roots(f).all();
}

}  // namespace vcrit
