#include "simulate_indenter.hpp"

#include <fmt/core.h>

namespace vcrit::record {

void fields(Fields& f, const indenter::Cell& it) {
  f("x", it.x)("mean_normal_force", it.mean_normal_force);
  f("friction_ratio", it.state.friction_ratio)("regime", it.state.regime);
}

void fields(Fields& f, const app::IndenterAnswer& answer) {
  const indenter::Friction& friction = answer.friction;
  f("mean_normal_force", friction.normal_force);
  f("mean_normal_force_error", friction.normal_force_error);
  f("contact_radius", answer.radius)("largest_contact_radius", answer.edge);
  f("cells_evaluated", friction.cells)("start_disagreement", friction.disagreement);
  f("cells", answer.cells);
}

}  // namespace vcrit::record

namespace vcrit::app {

namespace {

// A table that is seen at one glance.
constexpr int shown_cells = 8;

// Each steady value is promised to 1e-9, and both may be off.
constexpr double starts_tolerance = 2e-9;

}  // namespace

IndenterAnswer simulate_indenter(const Problem& problem, double velocity) {
  const indenter::HalfSpace half_space(problem);
  return {indenter::friction(half_space, velocity),
          indenter::cells(half_space, velocity, half_space.uniform() ? 1 : shown_cells, 0),
          half_space.radius(), half_space.edge()};
}

// As many digits as the default tolerance leaves.
void print_indenter(const IndenterAnswer& answer) {
  const indenter::Friction& friction = answer.friction;
  fmt::print("friction ratio  {:.10f} (error about {:.1g})\n", friction.ratio, friction.error);
  fmt::print("regime          {}\n", to_text(friction.regime));
  fmt::print("normal force    {:.6g} N on average\n", friction.normal_force);
  fmt::print("contact radius  {:.6g} m, at most {:.6g} m\n", answer.radius, answer.edge);
  if (friction.disagreement <= starts_tolerance)
    fmt::print("starts          agree in all cells, in sliding and at rest\n");
  else
    fmt::print("starts          DISAGREE, by up to {:.2g} in a cell\n", friction.disagreement);
  for (const indenter::Cell& cell : answer.cells)
    fmt::print("  at x = {:<12.6g} friction ratio {:.10f}  {}\n", cell.x, cell.state.friction_ratio,
               to_text(cell.state.regime));
}

}  // namespace vcrit::app
