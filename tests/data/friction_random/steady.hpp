// Motion from event to event, and the steady state as the fixed point of the period map.
#pragma once

#include <algorithm>
#include <stdexcept>

#include "system.hpp"

namespace reference {

/// side: +1 slip, -1 backslip, 0 stick.
template <class Real>
struct State {
  int side = 0;
  Real time = 0;
  Vector<Real> states;
};

template <class To, class From>
State<To> converted(const State<From>& state) {
  return {state.side, To(state.time), state.states.template cast<To>()};
}

template <class Real>
struct Steady {
  Real ratio = 0, impulse = 0, friction_heat = 0, damper_heat = 0;
  int events = 0;
  State<Real> start;
};

template <class Real>
class Motion {
 public:
  explicit Motion(const Scene<Real>& scene)
      : laws_(scene),
        slip_(laws_.slip()),
        stick_(laws_.stick()),
        slip_steps_(steps(slip_)),
        stick_steps_(steps(stick_)),
        scale_(laws_.scale()) {
    // At least 24 even steps to a turn of the fastest swing that mass and stiffness allow.
    Real stiffest = 1;
    if (scene.mass > 0) {
      Real sum = scene.contact.spring + scene.drive->spring;
      for (const auto& [k, tau] : scene.contact.maxwell) sum += k;
      for (const auto& [k, tau] : scene.drive->maxwell) sum += k;
      stiffest = std::max(stiffest, Real(sqrt(sum / scene.mass)));
    }
    while (ldexp(Real(1), even_) < 24 * stiffest) ++even_;
  }

  /// From any start; nothing given: at rest.
  Steady<Real> steady(State<Real> start = {}) {
    if (start.states.size() == 0) {
      start.states = Vector<Real>::Zero(laws_.states());
      for (int i = 0; i < 3; ++i) start = settled(start);
    }
    return result(newton(start));
  }

 private:
  using State = reference::State<Real>;
  static constexpr int form_friction = 0, form_damping = 1;

  struct Piece {
    int side;
    Vector<Real> begin, end;
    Real duration;
    bool event;
  };
  using Path = std::vector<Piece>;

  const Law<Real>& law(int side) const { return side == 0 ? stick_ : slip_; }
  const Steps<Real>& steps(int side) const { return side == 0 ? stick_steps_ : slip_steps_; }

  Steps<Real> steps(const Law<Real>& law) const { return {law.matrix, {}}; }

  Steps<Real> steps_with_energy(const Law<Real>& law) const {
    const Matrix<Real> product = law.force.transpose() * law.velocity;
    return {law.matrix, {(product + product.transpose()) / 2, laws_.damping(law)}};
  }

  // Functions that are negative as long as the motion lasts, and the side that follows.
  std::vector<std::pair<Row<Real>, int>> ends(int side) const {
    if (side != 0) return {{-side * slip_.velocity, 0}};
    return {{stick_.force - laws_.bound(), 1}, {-stick_.force - laws_.bound(), -1}};
  }

  Vector<Real> extended(const State& state) const {
    Vector<Real> z = Vector<Real>::Zero(laws_.size());
    const Real side = state.side == 0 ? 1 : state.side;
    z.head(laws_.states()) = state.states;
    z(laws_.one()) = 1;
    z(laws_.side()) = side;
    z(laws_.side() + 1) = side * cos(state.time);
    z(laws_.side() + 2) = side * sin(state.time);
    return z;
  }

  struct Found {
    Real time;
    int to;
  };

  // The first sign change within the step 2^-level from z to next, `from` later than the start.
  std::optional<Found> search(const Steps<Real>& steps, const std::pair<Row<Real>, int>& end,
                              const Vector<Real>& z, const Vector<Real>& next, int level,
                              const Real& from) const {
    const auto& [row, to] = end;
    const bool crossed = row.dot(next) >= 0;
    if (!crossed) {
      const Row<Real> slope = row * steps.matrix();
      if (!(slope.dot(z) > 0 && slope.dot(next) < 0)) return std::nullopt;
    }
    if (level == steps.deepest()) {
      if (!crossed) return std::nullopt;
      return Found{from + root(steps.series(row, z), Steps<Real>::length(level)), to};
    }
    const Vector<Real> middle = steps.move(level + 1) * z;
    if (auto found = search(steps, end, z, middle, level + 1, from)) return found;
    return search(steps, end, middle, next, level + 1, from + Steps<Real>::length(level + 1));
  }

  // Of a polynomial that goes from below to above zero; bisection, then Newton.
  static Real root(const std::vector<Real>& series, const Real& length) {
    const auto value = [&](const Real& t, Real& slope) {
      Real sum = 0;
      slope = 0;
      for (std::size_t k = series.size(); k-- > 0;)
        slope = slope * t + sum, sum = sum * t + series[k];
      return sum;
    };
    Real low = 0, high = length, t, slope;
    for (int i = 0; i < 40; ++i) {
      t = (low + high) / 2;
      (value(t, slope) < 0 ? low : high) = t;
    }
    for (int i = 0; i < 8; ++i) {
      const Real error = value(t, slope);
      if (slope > 0) t = std::clamp(Real(t - error / slope), Real(0), length);
    }
    return t;
  }

  std::optional<Found> next_event(const State& state, const Real& horizon) const {
    const Steps<Real>& own = steps(state.side);
    const auto functions = ends(state.side);
    Vector<Real> z = extended(state);
    Real time = 0;
    int level = own.deepest();
    while (time < horizon) {
      while (level > even_ && time >= 8 * Steps<Real>::length(level - 1)) --level;
      const Vector<Real> next = own.move(level) * z;
      std::optional<Found> first;
      for (const auto& end : functions) {
        const auto found = search(own, end, z, next, level, time);
        if (found && (!first || found->time < first->time)) first = found;
      }
      if (first) return first->time < horizon ? first : std::nullopt;
      time += Steps<Real>::length(level);
      z = next;
    }
    return std::nullopt;
  }

  Path path(State state, const Real& duration) const {
    Path pieces;
    const Real end = state.time + duration;
    while (state.time < end) {
      if (pieces.size() > 2000) throw std::runtime_error("too many events");
      const auto event = next_event(state, end - state.time);
      Piece piece{state.side,
                  extended(state),
                  {},
                  event ? event->time : end - state.time,
                  event.has_value()};
      if (event && event->time == 0 && !pieces.empty())
        throw std::runtime_error("two events at once");
      piece.end = moved(piece);
      state.time = event ? Real(state.time + event->time) : end;
      state.side = event ? event->to : state.side;
      state.states = piece.end.head(laws_.states());
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  Vector<Real> moved(const Piece& piece) const {
    return steps(piece.side).over(piece.duration).move * piece.begin;
  }

  // One period later, in the middle of the longest piece.
  State settled(State start) const {
    const Path pieces = path(start, 2 * pi<Real>());
    const auto longest =
        std::max_element(pieces.begin(), pieces.end(),
                         [](const Piece& a, const Piece& b) { return a.duration < b.duration; });
    const Real half = longest->duration / 2;
    const Vector<Real> z = steps(longest->side).over(half).move * longest->begin;
    Real time = start.time + half;
    for (auto piece = pieces.begin(); piece != longest; ++piece) time += piece->duration;
    time -= 2 * pi<Real>() * floor(time / (2 * pi<Real>()));
    return {longest->side, time, z.head(laws_.states())};
  }

  // dz at the end for dz at the start, events moving as they must.
  Matrix<Real> derivative(const Path& pieces) const {
    const Eigen::Index n = laws_.states();
    Matrix<Real> result = Matrix<Real>::Identity(n, n);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& piece = pieces[i];
      result =
          Matrix<Real>(steps(piece.side).over(piece.duration).move.topLeftCorner(n, n) * result);
      if (!piece.event || i + 1 == pieces.size()) continue;
      const Piece& next = pieces[i + 1];
      for (const auto& [row, to] : ends(piece.side)) {
        if (to != next.side) continue;
        const Matrix<Real>& before = law(piece.side).matrix;
        const Row<Real> time = -row.head(n) * result / Real((row * before).dot(piece.end));
        const Vector<Real> jump = before * piece.end - law(next.side).matrix * next.begin;
        result += jump.head(n) * time;
      }
    }
    return result;
  }

  bool possible(const State& state) const {
    const Vector<Real> z = extended(state);
    for (const auto& [row, to] : ends(state.side))
      if (row.dot(z) >= 0) return false;
    return true;
  }

  struct Mapped {
    State start;
    Path path;
    Vector<Real> residual;
    Real size = 0;
    bool usable = false;
  };

  Mapped mapped(const State& state) const {
    Mapped result{state, {}, {}, 0, false};
    if (!possible(state)) return result;
    result.path = path(state, 2 * pi<Real>());
    result.residual = result.path.back().end.head(laws_.states()) - state.states;
    result.usable = result.path.back().side == state.side;
    result.size = size(result.residual);
    return result;
  }

  // (I - P + weight) dz = residual, keeping to the constraints.
  Vector<Real> step(const Matrix<Real>& p, const Vector<Real>& residual, const State& state,
                    const Real& weight) const {
    const Eigen::Index n = laws_.states();
    const Matrix<Real> rows = laws_.constraints(state.side == 0);
    const auto left = scale_.asDiagonal();
    const auto right = scale_.cwiseInverse().asDiagonal();
    Matrix<Real> a(n + rows.rows(), n);
    Vector<Real> b(a.rows());
    a.topRows(n) = left * Matrix<Real>((1 + weight) * Matrix<Real>::Identity(n, n) - p) * right;
    b.head(n) = scale_.cwiseProduct(residual);
    a.bottomRows(rows.rows()) = rows.leftCols(n) * right;
    b.tail(rows.rows()) = -rows * extended(state);
    return Eigen::ColPivHouseholderQR<Matrix<Real>>(a).solve(b).cwiseQuotient(scale_);
  }

  Real size(const Vector<Real>& states) const { return states.cwiseProduct(scale_).norm(); }

  // No cycle moves two motions apart, so that with a weight on the identity, which turns a step
  // into many plain cycles at once, it goes on from anywhere.
  State newton(const State& start) const {
    const Real done = sqrt(std::numeric_limits<Real>::epsilon()) * Real("1e-15");
    Mapped now = mapped(settled(start));
    if (laws_.states() == 0) return now.start;
    Real weight = 0;
    int closed = 0;
    for (int i = 0; i < 300; ++i) {
      while (!now.usable) now = mapped(settled(now.start));
      const Matrix<Real> p = derivative(now.path);
      const Vector<Real> dz = step(p, now.residual, now.start, weight);
      const Real small = done * (1 + now.start.states.cwiseProduct(scale_).norm());
      const bool at_end = weight == 0 && now.size < small && size(dz) < small;
      if (at_end && ++closed == 2) return now.start;
      // Without an event a motion may go on for ever and no dz solves the equation.
      const bool solved = size((1 + weight) * dz - p * dz - now.residual) <= now.size / 10;
      Mapped trial = mapped({now.start.side, now.start.time, now.start.states + dz});
      const bool good =
          trial.usable && solved && size(trial.residual - weight * dz) <= now.size / 2;
      if (good || at_end) {
        now = std::move(trial);
        weight = weight < Real("1e-12") ? Real(0) : Real(weight / 30);
      } else {
        now = mapped(settled(now.start));
        weight = weight == 0 ? Real("1e-10") : std::min(Real(1), Real(weight * 10));
      }
    }
    throw std::runtime_error("no steady state found");
  }

  Steady<Real> result(const State& start) const {
    const Path pieces = path(start, 2 * pi<Real>());
    const Steps<Real> slip = steps_with_energy(slip_), stick = steps_with_energy(stick_);
    Steady<Real> steady;
    steady.start = start;
    for (const Piece& piece : pieces) {
      const Step<Real> step = (piece.side == 0 ? stick : slip).over(piece.duration);
      steady.impulse += Vector<Real>(step.move * piece.begin)(laws_.impulse());
      steady.friction_heat += piece.begin.dot(step.forms[form_friction] * piece.begin);
      steady.damper_heat += piece.begin.dot(step.forms[form_damping] * piece.begin);
      steady.events += piece.event ? 1 : 0;
    }
    steady.ratio = steady.impulse / (2 * pi<Real>());
    return steady;
  }

  Laws<Real> laws_;
  Law<Real> slip_, stick_;
  Steps<Real> slip_steps_, stick_steps_;
  Vector<Real> scale_;
  int even_ = 8;
};

}  // namespace reference
