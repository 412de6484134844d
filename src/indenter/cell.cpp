#include "indenter/cell.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/steady/answers.hpp"

namespace vcrit::indenter {

namespace {

using simulation::Motion;
using simulation::Regime;
using simulation::Start;

// What a touch reaches down to, in amplitudes. Less lasts for 5e-4 of a period at most, weighs
// 1e-15 under an elastic parabola, and is lost in rounding errors where the surface is strongly
// damped.
constexpr double shallow = 1e-6;

// No friction ratio changes by more than so many times what the normal force's amplitude does; by
// the balance of both it is about as much.
constexpr double neglect = 4;

bool empty(const HalfSpace& half_space, double depth) {
  return !(depth + half_space.amplitude() > shallow * half_space.amplitude());
}

}  // namespace

void Motions::add(const Motions& other) {
  separated = separated || other.separated;
  stick = stick || other.stick;
  backslip = backslip || other.backslip;
}

Regime Motions::regime() const {
  if (backslip)
    return separated ? Regime::stick_slip_backslip_separated : Regime::stick_slip_backslip;
  if (stick) return separated ? Regime::stick_slip_separated : Regime::stick_slip;
  return separated ? Regime::sliding_separated : Regime::sliding;
}

Motions motions_of(Regime regime) {
  switch (regime) {
    case Regime::sliding:
      return {};
    case Regime::stick_slip:
    case Regime::stick:
      return {false, true, false};
    case Regime::stick_slip_backslip:
      return {false, true, true};
    case Regime::sliding_separated:
      return {true, false, false};
    case Regime::stick_slip_separated:
      return {true, true, false};
    case Regime::stick_slip_backslip_separated:
      return {true, true, true};
  }
  return {};
}

namespace {

// A contact that sticks carries less than friction allows: a stick that friction falls short of by
// no more than its error is one of rounding, as cells have it that hardly touch.
Motions motions_beyond_error(const simulation::SteadyState& state) {
  Motions motions = motions_of(state.regime);
  motions.stick = motions.stick && 1 - state.friction_ratio > state.friction_ratio_error;
  return motions;
}

}  // namespace

CellFriction cell_friction(const HalfSpace& half_space, double x, double velocity) {
  const double depth = half_space.depth(x);
  if (empty(half_space, depth)) return {};
  simulation::Answers answers(half_space.cell_under(depth));
  const simulation::SteadyState& state = answers.alone(velocity, Start::sliding, 0);
  CellFriction result{answers.normal_force(), state.friction_ratio, state.friction_ratio_error, 0,
                      motions_beyond_error(state)};
  answers.alone(velocity, Start::rest, 0);  // in the memory of the other
  result.disagreement = std::abs(state.friction_ratio - result.ratio);
  result.error =
      std::max(result.error, state.friction_ratio_error) + neglect * half_space.neglected(depth);
  result.motions.add(motions_beyond_error(state));
  return result;
}

double counted_edge(const HalfSpace& half_space) {
  return half_space.gap().half_width(half_space.indentation() +
                                     half_space.amplitude() * (1 - shallow));
}

MotionCounts course(const HalfSpace& half_space, double x, double velocity) {
  MotionCounts result{};
  const double depth = half_space.depth(x);
  if (empty(half_space, depth)) return result;
  simulation::Answers answers(half_space.cell_under(depth));
  for (const simulation::Event& event : answers.alone(velocity, Start::sliding, 0).events)
    ++result[static_cast<std::size_t>(event.to)];
  return result;
}

}  // namespace vcrit::indenter
