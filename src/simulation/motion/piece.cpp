#include "simulation/motion/piece.hpp"

#include <cmath>

#include "base/complex.hpp"
#include "base/errors.hpp"
#include "modes/first_zero.hpp"

namespace vcrit::simulation {

Index states(const Model& model, Motion motion) {
  return motion == Motion::stick ? model.stick_states() : model.slip_states();
}

namespace {

// Re(a b)
double real_product(const ComplexDouble& a, const ComplexDouble& b) {
  return a.real() * b.real() - a.imag() * b.imag();
}

// The integral of e^{it} from a time on: e^{i start} times the factor.
ComplexDouble turned(const Instant& start, PairNumber factor) {
  return {real_product(start.turn, {factor.a, factor.b}),
          start.turn.real() * factor.b + start.turn.imag() * factor.a};
}

}  // namespace

// The modes are those of what is left of y without its sinusoidal part in slip.
Piece::Piece(const Model& model, double velocity, State start)
    : model_(&model), velocity_(velocity), start_(std::move(start)) {
  ensure(start_.x.size() == states(model, start_.motion), "a state has the size of its motion");
  const Matrix& to_modes = (stuck() ? model.stick : model.slip).modes.to_modes;
  Vector y(to_modes.columns());
  model.rates(start_.x, stuck(), y);
  if (const int side = direction(start_.motion))
    for (Index i = 0; i < y.size(); ++i)
      y[i] -= side * real_product(model.sliding_rates[i], start_.at.turn);
  if (const auto& opening = model.opening) {
    const int side = stuck() ? 1 : direction(start_.motion);
    const Index first = y.size() - opening->rates.size();
    for (Index i = 0; i < opening->rates.size(); ++i)
      y[first + i] = side * opening->part(i, start_.touch, start_.at.time);
  }
  modes_.resize(to_modes.rows());
  add_product(to_modes, y, modes_);
}

State Piece::after(const Flow& flow, View integrals) const {
  const int side = direction(start_.motion);
  State state{start_.motion, start_.at.time + flow.duration(), start_.x, 0, start_.touch};
  double impulse = integrals[0];
  flow.move(modes_, state.x, integrals);
  if (side == 0) return state;
  for (Index i = 0; model_->opening && i < model_->opening->rates.size(); ++i)
    impulse += side * model_->opening->part(i, start_.touch, start_.at.time) *
               simulation::integrals(model_->opening->rates[i], flow.duration())[1];
  const Index body = model_->body_states(), levels = model_->level_states();
  const Index held = model_->integrated_levels();
  const ComplexDouble once = turned(start_.at, flow.factors().turn()[1]);
  const ComplexDouble twice = turned(start_.at, flow.factors().turn()[2]);
  state.x[0] = model_->slip_force(side, state.at, state.touch);
  integrals[0] = impulse + (side * model_->mean - model_->load) * flow.duration() +
                 side * model_->amplitude * once.real();
  for (Index i = 0; i < body; ++i) {
    state.x[1 + i] += side * real_product(model_->sliding_rates[i], once);
    if (1 + i < held) integrals[1 + i] += side * real_product(model_->sliding_rates[i], twice);
  }
  for (Index i = 0; i < model_->units(); ++i) {
    const ComplexDouble& rate = model_->sliding_rates[body + i];
    state.x[levels + i] += side * real_product(rate, state.at.turn);
    if (i < model_->slow_units) integrals[held + i] += side * real_product(rate, once);
  }
  return state;
}

State Piece::after(double duration) const {
  Vector integrals(model_->integrals());
  return after(flow(duration), integrals);
}

std::optional<Piece::NextEvent> Piece::next_event(double horizon) const {
  const auto before = [&](Motion to, double end) -> std::optional<NextEvent> {
    EventFunction f = event_function(to);
    const auto zero = first_zero(f, end, leaving(to));
    if (!zero || *zero >= end) return std::nullopt;
    return NextEvent{*zero, to};
  };
  if (start_.motion == Motion::separated) return std::nullopt;
  if (!stuck()) return before(Motion::stick, horizon);
  const auto forward = before(Motion::slip, horizon);
  const auto backward = before(Motion::backslip, forward ? forward->duration : horizon);
  return backward ? backward : forward;
}

EventFunction Piece::event_function(Motion to) const {
  return stuck() ? stick_end(direction(to)) : slip_end();
}

bool Piece::leaving(Motion to) const {
  if (stuck()) return start_.entered == direction(to) || start_.entered == both_sides;
  const double velocity = simulation::contact_velocity(*model_, velocity_, start_);
  return start_.entered != 0 &&
         (model_->contact.damper > 0 || direction(start_.motion) * velocity <= 0);
}

// f = -w towards the side of the slip.
EventFunction Piece::slip_end() const {
  const int side = direction(start_.motion);
  const bool from_zero = leaving(Motion::stick);
  const double velocity = simulation::contact_velocity(*model_, velocity_, start_);
  const double size =
      velocity_ + sum_of_sizes(start_.x) + model_->contact.glassy * model_->force_size();
  EventFunction f(model_->slip.modes.spectrum, 1, from_zero ? 0 : -side * velocity,
                  from_zero ? 0 : size, &model_->effort);
  f.add_modes(model_->slip.event, modes_, -side);
  const ComplexDouble velocity_now = model_->sliding_velocity * start_.at.turn;
  f.add_sinusoid({velocity_now.imag(), -velocity_now.real()});
  return f;
}

// f = side F - b. Where stick began from slip on that side without a direct damper, F and F' were
// those of the bound, and f = f' = 0 there.
EventFunction Piece::stick_end(int side) const {
  const bool entered = leaving(side > 0 ? Motion::slip : Motion::backslip);
  const ComplexDouble bound = model_->amplitude * start_.at.turn;
  const int order = start_.entered == side && model_->contact.damper == 0 ? 2 : 1;
  const double gap = side * (start_.x[0] - model_->slip_force(side, start_.at, start_.touch));
  EventFunction f(model_->stick.modes.spectrum, order, entered ? 0 : std::min(gap, 0.0),
                  entered ? 0 : std::abs(start_.x[0]), &model_->effort);
  f.add_modes(model_->stick.event, modes_, side, order - 1);
  if (model_->opening) f.add_modes(model_->stick.bound, modes_, -1, order - 1);
  f.add_sinusoid(order == 2 ? bound : ComplexDouble{bound.imag(), -bound.real()});
  return f;
}

double contact_velocity(const Model& model, double velocity, const State& state) {
  if (state.motion == Motion::stick) return 0;
  const int side = direction(state.motion);
  double w = velocity - model.contact.fluidity * state.x[0] -
             side * model.contact.glassy * model.bound_rate(state.at, state.touch);
  if (model.body) w += state.x[1];
  for (Index j = model.level_states(); j < state.x.size(); ++j) w -= state.x[j];
  return w;
}

}  // namespace vcrit::simulation
