#include "simulate_indenter.hpp"

#include <fmt/format.h>

#include "options.hpp"

namespace vcrit::app {

namespace {

constexpr int shown_cells = 16;

}  // namespace

IndenterAnswer simulate_indenter(const Scene& scene, double velocity) {
  const indenter::HalfSpace half_space(scene);
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
          {"mean_normal_force_error", number(answer.friction.normal_force_error)},
          {"contact_radius", answer.radius},
          {"largest_contact_radius", answer.edge},
          {"cells_evaluated", answer.friction.cells},
          {"start_disagreement", answer.friction.disagreement},
          {"cells", cells}};
}

void print_indenter(const IndenterAnswer& answer) {
  fmt::print("normal force    {:.6g} N on average\n", answer.friction.normal_force);
  fmt::print("contact radius  {:.6g} m, at most {:.6g} m\n", answer.radius, answer.edge);
  fmt::print("cells           {}, in which both starts differ by at most {:.1g}\n",
             answer.friction.cells, answer.friction.disagreement);
  for (const indenter::Cell& cell : answer.cells)
    fmt::print("  at x = {:<12.6g} friction ratio {:<20.15g} {}\n", cell.x,
               cell.state.friction_ratio, to_text(cell.state.regime));
}

}  // namespace vcrit::app
