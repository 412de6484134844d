#include "simulation/motion/piece.hpp"

#include <cmath>

#include "base/errors.hpp"
#include "simulation/motion/event_function.hpp"

namespace vcrit::simulation {

using namespace std::complex_literals;

int direction(Motion motion) {
  return motion == Motion::slip ? 1 : (motion == Motion::backslip ? -1 : 0);
}

Index states(const Model& model, Motion motion) {
  return direction(motion) == 0 ? model.stick_states() : model.slip_states();
}

namespace {

double body_velocity(const Model& model, const Vector& x) { return model.body ? x(1) : 0; }

// The sinusoidal part of y in slip.
Vector forced(const Model& model, int side, double t) {
  return side * (model.sliding_rates * std::exp(1i * t)).real();
}

}  // namespace

Piece::Piece(const Model& model, double velocity, State start)
    : model_(&model), velocity_(velocity), start_(std::move(start)) {
  ensure(start_.x.size() == states(model, start_.motion), "a state has the size of its motion");
  Vector y = model.rates(start_.x, stuck());
  const int side = direction(start_.motion);
  if (side != 0) y -= forced(model, side, start_.time);
  modes_ = phase().modes.to_modes * y;
}

// x after the free motion of the given modes: levels by their integrals, own contact states from
// the modes, and in stick the units driven by F'.
Matrix Piece::moved(const Matrix& x, const Matrix& modes, double duration) const {
  const Index levels = model_->level_states();
  const Index own = stuck() ? model_->branches() : model_->units();
  const Spectrum& spectrum = phase().modes.spectrum;
  Matrix result = x;
  result.topRows(levels) += phase().levels * spectrum.integrated(1, duration, modes);
  result.middleRows(levels, own) =
      phase().modes.from_modes.bottomRows(own) * spectrum.integrated(0, duration, modes);
  if (!stuck()) return result;
  for (Index j = 0; j < model_->units(); ++j) {
    const double rate = model_->contact.unit_rates[static_cast<std::size_t>(j)];
    auto unit = result.row(levels + own + j);
    unit =
        unit * std::exp(-rate * duration) +
        model_->contact.unit_fluidity(j) * spectrum.filtered(phase().event, modes, rate, duration);
  }
  return result;
}

State Piece::after(double duration) const {
  State state{start_.motion, start_.time + duration, moved(start_.x, modes_, duration), 0};
  const int side = direction(start_.motion);
  if (side == 0) return state;
  const std::complex<double> turned = std::exp(1i * state.time) - std::exp(1i * start_.time);
  const Index body = model_->body_states(), units = model_->units();
  state.x(0) = side * model_->bound(state.time);
  state.x.segment(1, body) += side * (model_->sliding_rates.head(body) * (turned / 1i)).real();
  state.x.tail(units) += forced(*model_, side, state.time).tail(units);
  return state;
}

Vector Piece::integrals(double duration) const {
  const Index levels = model_->level_states(), body = model_->body_states();
  Vector result = start_.x.head(levels) * duration +
                  phase().levels * phase().modes.spectrum.integrated(2, duration, modes_);
  const int side = direction(start_.motion);
  if (side == 0) return result;
  const double end = start_.time + duration;
  result(0) = side * (duration + model_->amplitude * (std::sin(end) - std::sin(start_.time)));
  const std::complex<double> begin = std::exp(1i * start_.time);
  const std::complex<double> twice = begin + 1i * duration * begin - std::exp(1i * end);
  result.tail(body) += side * (model_->sliding_rates.head(body) * twice).real();
  return result;
}

double Piece::force(double duration) const { return after(duration).x(0); }

double Piece::contact_velocity(double duration) const {
  return simulation::contact_velocity(*model_, velocity_, after(duration));
}

std::optional<Piece::Event> Piece::next_event(double horizon) const {
  if (!stuck()) return slip_end(horizon);
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
  const double size = velocity_ + start_.x.cwiseAbs().sum() + model_->contact.glassy;
  EventFunction f(1, leaving ? 0 : -side * velocity, leaving ? 0 : size);
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
  EventFunction f(order, entered ? 0 : std::min(gap, 0.0), entered ? 0 : std::abs(start_.x(0)));
  f.add_modes(phase().modes.spectrum, phase().event, modes_, side, order - 1);
  f.add_sinusoid(order == 2 ? bound : -1i * bound);
  const bool expected = entered || start_.entered == 0;
  const auto zero = first_zero(f, horizon, entered, expected ? 1 : horizon);
  return zero && *zero < horizon ? zero : std::nullopt;
}

Matrix Piece::carried(const Matrix& dx, double duration, Matrix& integrals) const {
  const Index levels = model_->level_states();
  const Matrix modes = phase().modes.to_modes * model_->rates(dx, stuck());
  integrals += dx.topRows(levels) * duration +
               phase().levels * phase().modes.spectrum.integrated(2, duration, modes);
  return moved(dx, modes, duration);
}

double contact_velocity(const Model& model, double velocity, const State& state) {
  const int side = direction(state.motion);
  if (side == 0) return 0;
  return velocity + body_velocity(model, state.x) - model.contact.fluidity * state.x(0) -
         side * model.contact.glassy * model.bound_rate(state.time) -
         state.x.tail(model.units()).sum();
}

}  // namespace vcrit::simulation
