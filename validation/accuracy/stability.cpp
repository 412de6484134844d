#include "accuracy/stability.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy/cells.hpp"
#include "accuracy/resonance.hpp"
#include "accuracy/simulated_cell.hpp"
#include "compare/system_size.hpp"
#include "critical/critical_velocity.hpp"
#include "network/law.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::validation::accuracy {

namespace {

void add_once(std::vector<Symbol>& symbols, const Symbol& symbol) {
  if (std::find(symbols.begin(), symbols.end(), symbol) == symbols.end()) symbols.push_back(symbol);
}

void add_springs(std::vector<Symbol>& symbols, const Network& network) {
  for_each_element(network, [&](const Element& element) {
    for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
      if (role == NumberRole::stiffness) add_once(symbols, symbol);
    });
  });
}

void add_relaxation(std::vector<Symbol>& symbols, const Network& network) {
  for_each_element(network, [&](const Element& element) {
    for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
      if (role == NumberRole::damping || role == NumberRole::time) add_once(symbols, symbol);
    });
  });
}

std::vector<const Network*> contact_networks(const Problem& problem) {
  if (const auto* tangential = std::get_if<ReducedNetwork>(&problem->tangential))
    return {&tangential->network(), &problem->normal.network()};
  return {&problem->normal.network()};
}

/// Fills in one layer from what was found in the cells.
Layer layer_of(const Cells& cells, std::string key, std::string name,
               const std::vector<double>& found) {
  Layer layer{std::move(key), std::move(name), {}, {}};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double right = cells.right[i];
    const bool comparable = std::isnormal(right);
    layer.lost.push_back(comparable ? digits_lost(found[i], right)
                                    : std::numeric_limits<double>::quiet_NaN());
    if (comparable && !std::isfinite(found[i]))
      layer.marks.push_back({cells.omega_of(i), cells.factor_of(i), "not finite"});
  }
  return layer;
}

void add_driver_layers(StabilityMap& map, const Cells& cells, const Driver& driver) {
  std::vector<std::string> keys{driver.has("pasted") ? "pasted" : "complex"};
  if (driver.has("fast")) keys.emplace_back("fast");
  std::vector<std::vector<double>> sets;
  for (const Values& values : cells.values) {
    std::vector<double>& set = sets.emplace_back();
    for (const Symbol& symbol : driver.symbols()) set.push_back(values.at(symbol));
  }
  for (const WayAnswers& answers : driver.run(sets, keys))
    map.layers.push_back(layer_of(cells, answers.way.key, answers.way.name, answers.values));
}

// A stuck body swings freely, and each swing costs the simulator a piece of motion.
constexpr double most_swings = 1e4;

/// The layer of the simulator, and a mark for each answer that is wrong or missing.
Layer simulated(const Problem& problem, const Cells& cells) {
  const Resonances resonances(problem);
  std::vector<double> thresholds;
  std::vector<Mark> marks;
  cells.for_each(problem, [&](const Problem& each, std::size_t i) {
    const auto swing = resonances.find(ResonanceKind::antiresonance, cells.values[i]);
    const double omega = cells.values[i].at(problem->angular_frequency.symbol);
    const bool too_long = swing && *swing > most_swings * omega;
    const SimulatedCell cell = too_long ? not_asked(each) : simulated_cell(each, cells.right[i]);
    thresholds.push_back(cell.threshold);
    if (!cell.wrong.empty()) marks.push_back({cells.omega_of(i), cells.factor_of(i), cell.wrong});
  });
  Layer layer = layer_of(cells, "simulator", "stick-slip simulation", thresholds);
  layer.marks = std::move(marks);
  return layer;
}

std::vector<MapLine> balance_lines(const Problem& problem, const Cells& cells) {
  const Resonances resonances(problem);
  if (!resonances.exist()) return {};
  std::vector<MapLine> lines{{"resonance", {}}, {"antiresonance", {}}};
  for (std::size_t row = 0; row < cells.factor.size(); ++row) {
    const Values& values = cells.values[row * cells.omega.size()];
    const auto add = [&](MapLine& line, ResonanceKind balance) {
      const auto omega = resonances.find(balance, values);
      if (omega && *omega >= cells.omega.front() && *omega <= cells.omega.back())
        line.points.push_back({*omega, cells.factor[row]});
    };
    add(lines[0], ResonanceKind::resonance);
    add(lines[1], ResonanceKind::antiresonance);
  }
  std::erase_if(lines, [](const MapLine& line) { return line.points.empty(); });
  return lines;
}

/// "k0, c1, k[1], ..., k[10]": of an array the first entry and the last.
std::string names(const std::vector<Symbol>& symbols) {
  std::string text;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const auto same = [&](std::size_t j) {
      return j < symbols.size() && symbols[j].name == symbols[i].name;
    };
    if (i > 0 && same(i - 1) && same(i + 1)) continue;
    const bool after_gap = i > 1 && same(i - 1) && same(i - 2);
    text += (text.empty() ? "" : after_gap ? " … " : ", ") + to_text(symbols[i]);
  }
  return text;
}

bool can_be_simulated(const Problem& problem) {
  return bool{rules::answer(rules::Question::report_stability, problem)};
}

// A motion beyond the range of doubles is not large: its cell says that it has none.
bool is_too_large(const Problem& problem) try {
  return can_be_simulated(problem) && is_large(simulation::system_of(problem));
} catch (const ModelError&) {
  return false;
}

}  // namespace

double digits_lost(double found, double right) {
  if (!std::isfinite(found)) return std::numeric_limits<double>::quiet_NaN();
  const double relative = std::abs(found - right) / std::abs(right);
  return relative == 0 ? 0 : std::clamp(std::log10(relative / 0x1p-53), 0.0, 16.0);
}

std::vector<Symbol> stiffness_symbols(const Problem& problem) {
  std::vector<Symbol> contact, drive;
  for (const Network* network : contact_networks(problem)) add_springs(contact, *network);
  if (const ReducedNetwork* network = problem->drive_network()) {
    add_springs(drive, network->network());
    std::erase_if(contact, [&](const Symbol& symbol) {
      return std::find(drive.begin(), drive.end(), symbol) != drive.end();
    });
    return drive.empty() ? std::vector<Symbol>{} : contact;
  }
  if (contact.size() < 2) return {};
  contact.resize(1);
  return contact;
}

std::vector<Symbol> relaxation_symbols(const Problem& problem) {
  std::vector<Symbol> symbols;
  for (const Network* network : contact_networks(problem)) add_relaxation(symbols, *network);
  if (const auto* drive = problem->drive_network()) add_relaxation(symbols, drive->network());
  return symbols;
}

StabilityMap stability_map(const Problem& problem, const Driver* driver, const std::string& key,
                           const std::vector<Symbol>& scaled, const MapGrid& grid) {
  StabilityMap map;
  map.key = key;
  for (const Symbol& symbol : scaled) map.scaled.push_back(as_called(problem, symbol));
  map.name = names(map.scaled);
  const Cells cells = cells_of(problem, scaled, grid);
  map.omega = cells.omega;
  map.factor = cells.factor;
  std::vector<double> found;
  cells.for_each(
      problem, [&](const Problem& each, std::size_t) { found.push_back(critical_velocity(each)); });
  map.layers.push_back(layer_of(cells, "formula", "Eq. 24 in doubles", found));
  if (driver != nullptr) add_driver_layers(map, cells, *driver);
  if (can_be_simulated(problem) && !is_too_large(problem))
    map.layers.push_back(simulated(problem, cells));
  map.lines = balance_lines(problem, cells);
  return map;
}

std::vector<StabilityMap> stability_maps(const Problem& problem, const Driver* driver,
                                         std::vector<std::string>& left_out) {
  std::vector<StabilityMap> maps;
  if (problem->receptance() != nullptr) {
    left_out.emplace_back(
        "No stability maps: nothing is known of the measured drive outside its table.");
    return maps;
  }
  const auto add = [&](const char* key, const std::vector<Symbol>& scaled, const char* why_not) {
    if (scaled.empty())
      left_out.emplace_back(why_not);
    else
      maps.push_back(stability_map(problem, driver, key, scaled, {}));
  };
  add("stiffness", stiffness_symbols(problem),
      "No map over stiffness ratios: there are no two springs to compare.");
  add("relaxation", relaxation_symbols(problem), "No map over relaxation times: nothing relaxes.");
  if (is_too_large(problem))
    left_out.emplace_back(
        "The simulator is not asked over the maps, nor are methods with dense matrices: with so "
        "many "
        "relaxation times that would take minutes.");
  return maps;
}

}  // namespace vcrit::validation::accuracy
