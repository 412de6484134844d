// The rows of tests/data/two_mass_chains.csv as scenes (two_mass_chains.md).
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "simulation/system/steady_state.hpp"
#include "support/scene_text.hpp"
#include "support/table.hpp"

namespace vcrit::reference {

struct Chain {
  std::string id, group, drive;
  Scene scene;
  double critical_velocity = 0, velocity = 0, friction_ratio = 0;
  std::vector<simulation::Event> events;
};

inline simulation::Event event_of(const std::string& text) {
  using simulation::Motion;
  const auto at = test::split(text, '@');
  for (const Motion to : {Motion::slip, Motion::stick, Motion::backslip})
    if (at.at(0) == simulation::to_text(to)) return {std::stod(at.at(1)), to};
  throw std::runtime_error("an event of a chain is unknown: " + text);
}

inline std::vector<Chain> chains() {
  const std::string table = "two_mass_chains.csv";
  enum {
    id,
    group,
    contact,
    k0,
    c0,
    k1,
    tau1,
    m0,
    m1,
    m2,
    kd1,
    cd3 = 15,
    drive,
    mu0,
    amplitude,
    ratio,
    critical,
    velocity,
    friction,
    agreement,
    count,
    order
  };
  const std::vector<std::string> names{"k0",  "c0",  "k1",  "tau1", "m0",  "m1", "m2",
                                       "kd1", "cd1", "kd2", "cd2",  "kd3", "cd3"};
  std::vector<Chain> result;
  for (const auto& row : test::rows_of(table, 82)) {
    test::SceneText text{.normal = "kn",
                         .tangential = "k0 | c0",
                         .network = row.at(drive),
                         .mass = std::stod(row.at(m0)),
                         .angular_frequency = 1,
                         .amplitude = std::stod(row.at(amplitude)),
                         .indentation = 1,
                         .coefficient = std::stod(row.at(mu0)),
                         .elements = {{"kn", 1}}};
    if (!row.at(k1).empty()) {
      text.tangential = "k0 | c0 | (k1 - c1)";
      text.elements.emplace_back("c1", std::stod(row.at(k1)) * std::stod(row.at(tau1)));
    }
    for (int i = k0; i <= cd3; ++i)
      if (i != m0 && i != tau1 && !row.at(static_cast<std::size_t>(i)).empty())
        text.elements.emplace_back(names.at(static_cast<std::size_t>(i - k0)),
                                   std::stod(row.at(static_cast<std::size_t>(i))));
    Chain chain{row.at(id),
                row.at(group),
                row.at(drive),
                test::scene_of(text),
                std::stod(row.at(critical)),
                std::stod(row.at(velocity)),
                std::stod(row.at(friction)),
                {}};
    for (const std::string& event : test::split(row.at(order), ';'))
      chain.events.push_back(event_of(event));
    result.push_back(std::move(chain));
  }
  return result;
}

}  // namespace vcrit::reference
