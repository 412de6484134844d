#include "simulate_indenter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "base/rounded.hpp"
#include "options.hpp"

namespace vcrit::record {

void fields(Fields& f, const indenter::CellMotion& it) {
  f("x", it.x)("mean_normal_force", it.mean_normal_force);
  f("friction_ratio", it.state.friction_ratio)("regime", it.state.regime);
}

void fields(Fields& f, const app::IndenterAnswer& answer) {
  const indenter::Friction& friction = answer.friction;
  f("mean_normal_force", friction.normal_force);
  f("mean_normal_force_error", friction.normal_force_error);
  f("contact_radius", answer.radius)("largest_contact_radius", answer.edge);
  if (answer.on_drive) return;
  f("cells_evaluated", friction.cells)("start_disagreement", friction.disagreement);
  f("cells", answer.cells);
}

}  // namespace vcrit::record

namespace vcrit::app {

namespace {

// Few enough that the table fits on a screen.
constexpr int shown_cells = 8;

// The steady value from each start may be off by 1e-9.
constexpr double starts_tolerance = 2e-9;

// With the default tolerance further digits are not known.
constexpr int cell_digits = 9;

// Short, for the end of a cell's line.
const char* words_of(simulation::Regime regime) {
  using simulation::Regime;
  switch (regime) {
    case Regime::sliding:
      return "continuous sliding";
    case Regime::stick_slip:
      return "stick-slip";
    case Regime::stick_slip_backslip:
      return "stick-slip with reverse slip";
    case Regime::stick:
      return "sticking";
    case Regime::sliding_separated:
      return "sliding, opens in every cycle";
    case Regime::stick_slip_separated:
      return "stick-slip, opens in every cycle";
    case Regime::stick_slip_backslip_separated:
      return "stick-slip with reverse slip, opens in every cycle";
  }
  throw Bug("a regime without words");
}

}  // namespace

IndenterAnswer simulate_indenter(const Problem& problem, double velocity) {
  const indenter::HalfSpace half_space(problem);
  if (half_space.holder())
    return {
        indenter::friction(half_space, velocity), {}, half_space.radius(), half_space.edge(), true};
  return {indenter::friction(half_space, velocity),
          indenter::cells(half_space, velocity, half_space.uniform() ? 1 : shown_cells, 0),
          half_space.radius(), half_space.edge()};
}

void print_indenter(const IndenterAnswer& answer, int digits) {
  const indenter::Friction& friction = answer.friction;
  const auto length = [&](double x) { return rounded(x, "m", digits); };
  print_row("contact radius",
            fmt::format("{}, at most {}", length(answer.radius), length(answer.edge)));
  if (answer.on_drive) {
    if (friction.cells == 0) print_row("cells", "infinitely many, which move one another");
    return;
  }
  print_row("starts",
            friction.disagreement <= starts_tolerance
                ? "from rest and from sliding, all cells become the same"
                : fmt::format("DISAGREE, by up to {:.2g} in a cell", friction.disagreement));
  const char* heading = "cells";
  for (const indenter::CellMotion& cell : answer.cells)
    print_row(std::exchange(heading, ""),
              fmt::format("at x = {:<9}  friction ratio {:<7}  {}", length(cell.x),
                          rounded(cell.state.friction_ratio, "", std::min(digits, cell_digits)),
                          words_of(cell.state.regime)));
}

}  // namespace vcrit::app
