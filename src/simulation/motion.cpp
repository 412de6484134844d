#include "simulation/motion.hpp"

#include <cmath>

#include "base/errors.hpp"
#include "simulation/event_function.hpp"

namespace vcrit::simulation {

using namespace std::complex_literals;

int direction(Motion motion) {
  return motion == Motion::slip ? 1 : (motion == Motion::backslip ? -1 : 0);
}

Index states(const Model& model, Motion motion) {
  return direction(motion) == 0 ? model.stick_states() : model.slip_states();
}

Index contact_states(const Model& model, const State& state) {
  return state.x.size() - model.level_states();
}

namespace {

double body_velocity(const Model& model, const Vector& x) { return model.body ? x(1) : 0; }

Eigen::VectorXd forced(const Model& model, int side, double t) {
  return side * (model.sliding_rates * std::exp(1i * t)).real();
}

}  // namespace

Piece::Piece(const Model& model, double velocity, State start)
    : model_(&model), velocity_(velocity), start_(std::move(start)) {
  ensure(start_.x.size() == states(model, start_.motion), "a state has the size of its motion");
  Vector y = model.rates(start_.x);
  const int side = direction(start_.motion);
  if (side != 0) y -= forced(model, side, start_.time);
  modes_ = phase().modes.to_modes * y;
}

const Phase& Piece::phase() const {
  return start_.motion == Motion::stick ? model_->stick : model_->slip;
}

State Piece::after(double duration) const {
  const Index levels = model_->level_states();
  const Spectrum& spectrum = phase().modes.spectrum;
  State state = start_;
  state.time += duration;
  state.entered = 0;
  state.x.head(levels) += phase().levels * spectrum.integrated(1, duration, modes_);
  const Index contact = contact_states(*model_, state);
  state.x.tail(contact) =
      phase().modes.from_modes.bottomRows(contact) * spectrum.integrated(0, duration, modes_);
  const int side = direction(start_.motion);
  if (side == 0) return state;
  state.x(0) = side * model_->bound(state.time);
  const std::complex<double> turned = std::exp(1i * state.time) - std::exp(1i * start_.time);
  const Index body = model_->body_states();
  state.x.segment(1, body) += side * (model_->sliding_rates.head(body) * (turned / 1i)).real();
  state.x.tail(contact) += forced(*model_, side, state.time).tail(contact);
  return state;
}

double Piece::impulse(double duration) const {
  const int side = direction(start_.motion);
  if (side != 0)
    return side * (duration +
                   model_->amplitude * (std::sin(start_.time + duration) - std::sin(start_.time)));
  return start_.x(0) * duration +
         phase().event.dot(phase().modes.spectrum.integrated(2, duration, modes_));
}

double Piece::force(double duration) const { return after(duration).x(0); }

double Piece::contact_velocity(double duration) const {
  return simulation::contact_velocity(*model_, velocity_, after(duration));
}

std::optional<Piece::Event> Piece::next_event(double horizon) const {
  if (start_.motion != Motion::stick) return slip_end(horizon);
  const int first = start_.entered == 0 ? 1 : start_.entered;
  std::optional<Event> event;
  for (const int side : {first, -first}) {
    const auto end = stick_end(side, event ? event->duration : horizon);
    if (end) event = Event{*end, side > 0 ? Motion::slip : Motion::backslip};
  }
  return event;
}

// f = -w towards the side of the slip.
std::optional<Piece::Event> Piece::slip_end(double horizon) const {
  const int side = direction(start_.motion);
  const double velocity = simulation::contact_velocity(*model_, velocity_, start_);
  const bool leaving = start_.entered != 0 && (model_->contact.damper > 0 || side * velocity <= 0);
  EventFunction f(1, leaving ? 0 : -side * velocity);
  f.add_modes(phase().modes.spectrum, phase().event, modes_, -side);
  f.add_sinusoid(-(1i * model_->sliding_velocity) * std::exp(1i * start_.time));
  const auto zero = first_zero(f, horizon, leaving);
  if (!zero || *zero >= horizon) return std::nullopt;
  return Event{*zero, Motion::stick};
}

// f = side F - b. Where stick began from slip on that side without a direct damper, F and F' were
// those of the bound, and f = f' = 0 there.
std::optional<double> Piece::stick_end(int side, double horizon) const {
  const bool entered = start_.entered == side;
  const std::complex<double> bound = model_->amplitude * std::exp(1i * start_.time);
  const int order = entered && model_->contact.damper == 0 ? 2 : 1;
  const double gap = side * start_.x(0) - model_->bound(start_.time);
  EventFunction f(order, entered ? 0 : std::min(gap, 0.0));
  f.add_modes(phase().modes.spectrum, phase().event, modes_, side, order - 1);
  f.add_sinusoid(order == 2 ? bound : -1i * bound);
  const auto zero = first_zero(f, horizon, entered);
  return zero && *zero < horizon ? zero : std::nullopt;
}

Matrix Piece::carried(const Matrix& dx, double duration, Eigen::RowVectorXd& impulse) const {
  const Index levels = model_->level_states();
  const Spectrum& spectrum = phase().modes.spectrum;
  const Matrix z = phase().modes.to_modes * model_->rates(dx);
  Matrix result = dx;
  result.topRows(levels) += phase().levels * spectrum.integrated(1, duration, z);
  const Index contact = dx.rows() - levels;
  result.bottomRows(contact) =
      phase().modes.from_modes.bottomRows(contact) * spectrum.integrated(0, duration, z);
  if (start_.motion == Motion::stick)
    impulse +=
        dx.row(0) * duration + phase().event.transpose() * spectrum.integrated(2, duration, z);
  return result;
}

double contact_velocity(const Model& model, double velocity, const State& state) {
  const int side = direction(state.motion);
  if (side == 0) return 0;
  return velocity + body_velocity(model, state.x) - model.contact.fluidity * state.x(0) -
         side * model.contact.glassy * model.bound_rate(state.time) -
         state.x.tail(contact_states(model, state)).sum();
}

}  // namespace vcrit::simulation
