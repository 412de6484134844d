#include "indenter/rim_motion.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/interruption.hpp"

namespace vcrit::indenter {

namespace {

// At most of a period in one step; the first one after an event.
constexpr double longest_step = 0.4, first_step = 0.05;

// A step is asked so often for an event. What comes and goes between two of these is a dip of
// the margin by some 1e-3 of its changes at most; a longer one is seen.
constexpr int asked_of_step = 16;

// Rounding error of a phase.
constexpr double no_time = 1e-12;

// More events at one instant than any motion has.
constexpr int most_at_once = 50;

}  // namespace

RimMotion::RimMotion(const ScaledContact& contact, const ScaledHolder& holder, double velocity,
                     double tolerance, SharedEffort* whole, bool always_slides)
    : contact_(contact),
      holder_(holder),
      velocity_(velocity),
      always_slides_(always_slides),
      steps_([this](double t, const StateVector& x, StateVector& out) { rates(t, x, out); },
             tolerance, whole) {
  spring_ = holder.mass > 0 ? 1 : 0;
  branches_ = spring_ + (holder.spring > 0 ? 1 : 0);
  body_ = branches_ + static_cast<Eigen::Index>(holder.branches.size());
  place_ = body_;
  lack_ = body_ + 1;
  impulse_ = body_ + 2;
  moments_.fill({-infinity, 0, 0, 0, 0, 0});
}

Eigen::VectorXd RimMotion::energy_weights() const {
  Eigen::VectorXd result(body_);
  if (holder_.mass > 0) result(0) = std::sqrt(holder_.mass);
  if (holder_.spring > 0) result(spring_) = 1 / std::sqrt(holder_.spring);
  for (std::size_t j = 0; j < holder_.branches.size(); ++j)
    result(branches_ + static_cast<Eigen::Index>(j)) = 1 / std::sqrt(holder_.branches[j].stiffness);
  return result;
}

int RimMotion::direction() const {
  if (mode_ == RimMode::forward) return 1;
  return mode_ == RimMode::backward ? -1 : 0;
}

/// Of the body, while cells touched and stuck.
TimeStep::WithRate RimMotion::place_at(double t) const {
  const auto step = std::partition_point(history_.begin(), history_.end() - 1,
                                         [t](const TimeStep& each) { return each.end() < t; });
  return step->with_rate(t, place_);
}

/// l_d of what the innermost cells of a layer remember: l_- = l_+ + 2 g.
double RimMotion::inner_level(const Layer& layer, int d) const {
  if (layer.frozen == 0) return layer.first.level(d);
  return layer.level + (layer.frozen - d) * layer.from;
}

// Where the level of touched cells is `wanted`: outwards, d l_d falls. By Newton's method from the
// last answer, which is near while a step is found, between ends that close in.
double RimMotion::touched_when(const Layer& layer, double wanted, int d) const {
  double low = layer.first.t, high = layer.last.t, before = high - low;
  if (d * (layer.first.level(d) - wanted) <= 0) return low;
  if (d * (layer.last.level(d) - wanted) >= 0) return high;
  double t = touched_.when > low && touched_.when < high ? touched_.when : 0.5 * (low + high);
  for (int i = 0; i < 100 && high - low > 4 * epsilon * high; ++i) {
    const auto [place, speed] = place_at(t);
    const double value = place - d * contact_.depth(t), slope = speed - d * contact_.depth_rate(t);
    const double found = d * (value - wanted);
    if (std::abs(found) <= 2 * epsilon * std::max(1.0, std::abs(wanted))) return t;
    (found > 0 ? low : high) = t;
    const double next = t - (value - wanted) / slope, change = std::abs(next - t);
    const bool closes_in = next > low && next < high && change < 0.5 * before;
    before = closes_in ? change : high - low;
    t = closes_in ? next : 0.5 * (low + high);
  }
  return t;
}

/// The depth up to which cells stick; below 0 if none does.
double RimMotion::stuck_to(const Moment& now, double place) const {
  if (mode_ == RimMode::stick) return now.depth;
  if (layers_.empty()) return -1;
  const int d = direction();
  const Layer& top = layers_.back();
  const double here = level(now, place, d);
  if (top.frozen == 0) {
    if (touched_.t != now.t || touched_.place != place) {
      const double when = touched_when(top, here, d);
      touched_ = {now.t, place, contact_.depth(when), when};
    }
    return touched_.depth;
  }
  if (top.frozen == d) return top.to;
  return std::clamp((here - top.level) / (top.frozen - d), top.from, top.to);
}

/// The stiffness of the cells that stick.
double RimMotion::sticking(const Moment& now, const StateVector& state) const {
  if (mode_ == RimMode::apart) return 0;
  const double depth = stuck_to(now, state(place_));
  return depth < now.depth ? contact_.stiffness(depth) : now.stiffness;
}

/// Of the springs.
double RimMotion::holding_force(const StateVector& state) const {
  return state.segment(spring_, body_ - spring_).sum();
}

/// By how much the body is slower than the drive: small, where the drive is stiff.
double RimMotion::behind(const Moment& now, const StateVector& state, double stuck) const {
  if (holder_.mass > 0) return state(0);
  const double friction = now.force - state(lack_);
  if (holder_.damper > 0) return (friction - holding_force(state)) / holder_.damper;
  // Of the first spring, which relaxes where all do: the drive then creeps.
  const double given = friction - (holding_force(state) - state(spring_));
  double relaxing = 0;
  for (std::size_t j = 0; j < holder_.branches.size(); ++j) {
    const Eigen::Index i = branches_ + static_cast<Eigen::Index>(j);
    relaxing += (i == spring_ ? given : state(i)) / holder_.branches[j].time;
  }
  const double slides =
      always_slides_ ? now.force_rate : direction() * (now.stiffness - stuck) * now.depth_rate;
  return (stuck * velocity_ + slides + relaxing) / (holder_.glassy() + stuck);
}

const RimMotion::Moment& RimMotion::moment(double t) {
  for (const Moment& each : moments_)
    if (each.t == t) return each;
  Moment& found = moments_[oldest_];
  oldest_ = (oldest_ + 1) % moments_.size();
  return found = contact_.at(t);
}

void RimMotion::rates(double t, const StateVector& state, StateVector& out) {
  out.resize(state.size());
  const Moment& now = moment(t);
  const double stuck = sticking(now, state), pulled = behind(now, state, stuck);
  const double v = velocity_ - pulled, friction = now.force - state(lack_);
  if (holder_.mass > 0)
    out(0) = (friction - holding_force(state) - holder_.damper * pulled) / holder_.mass;
  if (holder_.spring > 0) out(spring_) = holder_.spring * pulled;
  for (std::size_t j = 0; j < holder_.branches.size(); ++j) {
    const Eigen::Index i = branches_ + static_cast<Eigen::Index>(j);
    const auto& [stiffness, time] = holder_.branches[j];
    out(i) = stiffness * pulled - state(i) / time;
  }
  if (first_given()) out(spring_) = 0;
  const double all = now.stiffness, rate = now.depth_rate;
  out(place_) = v;
  // Of F_n and F; 0 where all slide forward, but for rounding.
  out(lack_) = mode_ == RimMode::forward
                   ? stuck * (rate - v)
                   : all * rate - (stuck * v + direction() * (all - stuck) * rate);
  out(impulse_) = friction;
}

void RimMotion::start(double t, const StateVector& body) {
  t_ = clear_since_ = t;
  state_ = StateVector::Zero(body_ + 3);
  state_.head(body_) = body;
  mode_ = always_slides_ || contact_.depth(t) > 0 ? RimMode::forward : RimMode::apart;
  layers_.clear();
  history_.clear();
  kept_.clear();
  shown_ = {};
}

/// What is above 0 as long as a mode goes on: the velocity at which a rim slides; how far the
/// level is from where the layer that slides next is used up; and while the indentation falls, the
/// rim that is left.
RimMotion::Margins RimMotion::margins(double t, const StateVector& state) const {
  if (mode_ == RimMode::apart || always_slides_) return {};
  const Moment now = holder_.mass > 0 ? contact_.depths_at(t) : contact_.at(t);
  const double v = speed(now, state), rate = now.depth_rate;
  if (mode_ == RimMode::stick) return {rate - v, rate + v};
  const int d = direction();
  const double slides = d * v - rate;
  if (layers_.empty()) return {slides};
  const double left = d * (inner_level(layers_.back(), d) - level(now, state(place_), d));
  // Asked whether it is needed or not: the next answer is looked for from the last one.
  const double stuck = stuck_to(now, state(place_));
  if (rate >= 0) return {slides, left};
  return {slides, left, now.depth - stuck};
}

double RimMotion::least_margin(double t, const StateVector& state) const {
  const Margins all = margins(t, state);
  return all.empty() ? 1 : *std::min_element(all.begin(), all.end());
}

/// The first event within a step, if there is one.
bool RimMotion::ends_in(const TimeStep& step, double& at) const {
  if (mode_ == RimMode::apart || always_slides_) return false;
  double before = step.begin();
  for (int i = 1; i <= asked_of_step; ++i) {
    double t = step.begin() + (step.end() - step.begin()) * i / asked_of_step;
    if (least_margin(t, step.at(t)) >= 0) {
      before = t;
      continue;
    }
    for (double middle = 0.5 * (before + t); middle > before && middle < t;
         middle = 0.5 * (before + t))
      (least_margin(middle, step.at(middle)) < 0 ? t : before) = middle;
    at = t;
    return true;
  }
  return false;
}

void RimMotion::now_clear() {
  clear_since_ = t_;
  history_.clear();
  state_(lack_) = 0;
}

void RimMotion::clear_no_longer() {
  const double length = t_ - clear_since_;
  if (length <= shown_.clear) return;
  shown_.clear = length;
  shown_.clear_at = clear_since_ + 0.5 * length;
}

/// What has slid in a direction remembers nothing of before.
void RimMotion::cut_layer(int d) {
  if (layers_.empty()) return;
  Layer& top = layers_.back();
  const Moment now = contact_.at(t_);
  top.to = stuck_to(now, state_(place_));
  if (top.frozen == 0) top.last = touched_at(touched_when(top, level(now, state_(place_), d), d));
}

void RimMotion::go_on(RimMode mode) {
  mode_ = mode;
  if (mode == RimMode::backward) shown_.backslip = true;
  if (mode != RimMode::stick) return;
  shown_.stick = true;
  const double rim = contact_.depth(t_);
  layers_.push_back({0, 0, rim, rim, {t_}, {}});
}

/// After an event: while the indentation grows, the rim sticks between both directions of sliding;
/// while it falls the rim slides in one or the other.
void RimMotion::change() {
  const Margins margin = margins(t_, state_);
  const Moment now = contact_.at(t_);
  const double v = speed(now, state_), rate = now.depth_rate;
  if (mode_ == RimMode::stick) {
    Layer& top = layers_.back();
    top.to = now.depth;
    top.first = touched_at(top.first.t);
    top.last = touched_at(t_);
    return go_on(margin[0] < margin[1] ? RimMode::forward : RimMode::backward);
  }
  const int d = direction();
  const RimMode other = d > 0 ? RimMode::backward : RimMode::forward;
  auto least = std::min_element(margin.begin(), margin.end()) - margin.begin();
  // Cells that slid together before do so again all at once: then the layer is used up and no rim
  // is left, and rounding would decide which of the two is seen first.
  if (least == 2 && margin[1] <= no_time * std::max(1.0, std::abs(level(now, state_(place_), d))))
    least = 1;
  if (least == 1) {
    layers_.pop_back();
    if (clear()) now_clear();
    return;
  }
  if (clear()) clear_no_longer();
  cut_layer(d);
  if (least == 2) return go_on(other);
  const double from = layers_.empty() ? 0 : layers_.back().to;
  layers_.push_back({d, level(now, state_(place_), d), from, now.depth});
  go_on(rate > 0 && d * v > -rate ? RimMode::stick : other);
}

/// Where the indenter leaves the surface, or touches it again.
void RimMotion::pass_kink() {
  constexpr double after = 1e-7;
  const bool touches = contact_.depth(t_ + after) > 0;
  if (always_slides_ || touches == (mode_ != RimMode::apart)) return;
  if (!touches) {
    const bool was_clear = clear();
    layers_.clear();
    mode_ = RimMode::apart;
    if (was_clear) return;
    return now_clear();
  }
  const double v = speed(contact_.at(t_), state_), rate = contact_.depth_rate(t_);
  if (v >= rate) return go_on(RimMode::forward);
  clear_no_longer();
  go_on(v > -rate ? RimMode::stick : RimMode::backward);
}

double RimMotion::next_kink() const {
  const double turns = std::floor(t_ / two_pi) * two_pi;
  for (const double kink : contact_.kinks())
    if (turns + kink > t_ * (1 + epsilon)) return turns + kink;
  return turns + two_pi + contact_.kinks()[1];
}

void RimMotion::take(TimeStep step, bool ends) {
  at_once_ = step.end() > step.begin() + no_time ? 0 : at_once_ + 1;
  if (at_once_ > most_at_once)
    throw ModelError("below the indenter, stick and slip alternate without end at one instant");
  t_ = step.end();
  state_ = step.at(t_);
  if (mode_ == RimMode::stick) history_.push_back(step);
  if (always_slides_) kept_.push_back(std::move(step));
  if (ends) change();
}

void RimMotion::run(double until) {
  double length = first_step;
  while (t_ < until) {
    hear_interruption();
    touched_ = {};  // the step before may have changed the layers
    const double kink = next_kink(), to = std::min(kink, until), whole = to - t_;
    if (whole <= no_time * std::max(1.0, to)) {
      t_ = to;
      if (to == kink) pass_kink();
      continue;
    }
    const double wanted = std::min({length, longest_step, whole});
    TimeStep step = steps_.step(t_, state_, wanted);
    double event = 0;
    const bool ends = ends_in(step, event), arrives = step.end() >= to - 1e-14 * to;
    if (ends)
      step.end_at(event);
    else if (arrives)
      step.end_at(to);
    take(std::move(step), ends);
    length = ends ? first_step : steps_.next_length();
    if (!ends && arrives && to == kink) {
      pass_kink();
      length = first_step;
    }
  }
  if (clear()) clear_no_longer();
}

}  // namespace vcrit::indenter
