#include "simulate_indenter.hpp"

#include <fmt/core.h>

#include "options.hpp"

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

nlohmann::ordered_json to_json(const IndenterAnswer& answer) {
  nlohmann::ordered_json cells = nlohmann::ordered_json::array();
  for (const indenter::Cell& cell : answer.cells)
    cells.push_back({{"x", cell.x},
                     {"mean_normal_force", cell.mean_normal_force},
                     {"friction_ratio", cell.state.friction_ratio},
                     {"regime", to_text(cell.state.regime)}});
  return {{"mean_normal_force", answer.friction.normal_force},
          {"mean_normal_force_error", json_number(answer.friction.normal_force_error)},
          {"contact_radius", answer.radius},
          {"largest_contact_radius", answer.edge},
          {"cells_evaluated", answer.friction.cells},
          {"start_disagreement", answer.friction.disagreement},
          {"cells", cells}};
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
