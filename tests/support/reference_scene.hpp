// The rows of data/vstar_extreme.csv as scenes: v* by exact rational arithmetic, for networks and
// values of every size that doubles have.
#pragma once

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "network/graph.hpp"
#include "scene/scene.hpp"
#include "support/table.hpp"

namespace vcrit::test {

struct ReferenceRow {
  std::string id, network_class, kind, status;
  double velocity;             ///< nearest double; infinite or NaN where the status says so
  std::optional<Scene> scene;  ///< nothing where a network has only elements of value 0: no scene
};

/// A network of the row's kind, its elements named after `prefix`, without those of value 0.
class ReferenceNetwork {
 public:
  ReferenceNetwork(const std::string& kind, const std::string& numbers, const std::string& prefix) {
    for (const std::string& text : split(numbers, ';'))
      values_.push_back(std::strtod(text.c_str(), nullptr));
    for (std::size_t i = 0; i < values_.size(); ++i) names_.push_back({prefix + std::to_string(i)});
    whole_ = build(kind);
  }

  std::optional<Network> add_to(Scene& scene) const {
    Values by_name;
    for (std::size_t i = 0; i < values_.size(); ++i) by_name[names_[i]] = values_[i];
    const auto left = without(whole_, [&](const Element& e) {
      return by_name.at(e.coefficient) == 0 ||
             (e.kind == ElementKind::maxwell && by_name.at(e.second) == 0);
    });
    if (!left) return std::nullopt;
    for (const Symbol& symbol : symbols_of(*left))
      scene.elements.emplace_back(symbol, by_name.at(symbol));
    return *left;
  }

 private:
  Network k(std::size_t i) const { return spring(names_.at(i)); }
  Network c(std::size_t i) const { return damper(names_.at(i)); }

  Network build(const std::string& kind) const {
    if (kind == "kelvin") return parallel({k(0), c(1)});
    if (kind == "maxwell") return series({k(0), c(1)});
    if (kind == "zener") return parallel({k(0), series({k(1), c(2)})});
    if (kind == "burgers") return series({k(0), c(1), parallel({k(2), c(3)})});
    if (kind == "prony10") return prony();
    if (kind == "ladder10") return ladder();
    if (kind == "bridge") return bridge();
    throw std::runtime_error("unknown kind " + kind);
  }

  Network prony() const {
    std::vector<Network> parts{k(0)};
    for (std::size_t j = 1; j <= 10; ++j) parts.push_back(maxwell(names_.at(j), names_.at(10 + j)));
    return parallel(std::move(parts));
  }

  Network ladder() const {
    Network inner = parallel({k(9), c(19)});
    for (std::size_t j = 9; j-- > 0;) inner = parallel({c(10 + j), series({k(j), inner})});
    return inner;
  }

  Network bridge() const {
    const auto z = [this](std::size_t j) { return parallel({k(j), c(5 + j)}); };
    return {Graph{{"A", "B", "C", "D"},
                  {z(0), z(1), z(2), z(3), z(4)},
                  {{0, 2}, {0, 3}, {2, 1}, {3, 1}, {2, 3}}}};
  }

  std::vector<double> values_;
  std::vector<Symbol> names_;
  Network whole_;
};

inline std::optional<Scene> extreme_scene(const std::vector<std::string>& f) {
  const auto number = [&](std::size_t i) { return std::strtod(f.at(i).c_str(), nullptr); };
  Scene scene;
  scene.file = "row " + f.at(0);
  scene.coefficient = {{"mu0"}, number(3)};
  scene.angular_frequency = {{"omega"}, number(4)};
  scene.amplitude = {{"du_z"}, number(5)};
  scene.indentation = {{"u_z0"}, 1.0};
  if (number(6) != 0) scene.mass = Quantity{{"m"}, number(6)};
  const auto tangential = ReferenceNetwork(f.at(2), f.at(7), "t").add_to(scene);
  const auto normal = ReferenceNetwork(f.at(2), f.at(8), "n").add_to(scene);
  scene.drive = ReferenceNetwork(f.at(2), f.at(9), "d").add_to(scene);
  if (!tangential || !normal || !scene.drive) return std::nullopt;
  scene.tangential = *tangential;
  scene.normal = *normal;
  return scene;
}

inline std::vector<ReferenceRow> extreme_rows() {
  std::vector<ReferenceRow> rows;
  for (const auto& f : rows_of("vstar_extreme.csv", 247))
    rows.push_back({f.at(0), f.at(1), f.at(2), f.at(10), std::strtod(f.at(11).c_str(), nullptr),
                    extreme_scene(f)});
  return rows;
}

}  // namespace vcrit::test
