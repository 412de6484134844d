#include "network/masses.hpp"

#include "network/graph.hpp"
#include "network/law.hpp"

namespace vcrit {

namespace {

/// Walks a network knowing which ends of each part are the far end.
struct Walk {
  bool from_is_far, to_is_far;
  std::vector<Symbol>& off;

  void into(const Network& part, bool from, bool to) const {
    std::visit(Walk{from, to, off}, part.form);
  }
  void operator()(const Element& element) const {
    if (is_mass(element) && !from_is_far && !to_is_far) off.push_back(element.coefficient.name());
  }
  void operator()(const Series& series) const {
    const std::size_t last = series.parts.size() - 1;
    for (std::size_t i = 0; i <= last; ++i)
      into(series.parts[i], i == 0 && from_is_far, i == last && to_is_far);
  }
  void operator()(const Parallel& parallel) const {
    for (const Network& part : parallel.parts) into(part, from_is_far, to_is_far);
  }
  void operator()(const Graph& graph) const {
    const auto is_far = [this](int node) {
      return (node == 0 && from_is_far) || (node == 1 && to_is_far);
    };
    for (std::size_t i = 0; i < graph.parts.size(); ++i)
      into(graph.parts[i], is_far(graph.wires[i].from), is_far(graph.wires[i].to));
  }
};

}  // namespace

bool has_masses(const Network& network) {
  bool found = false;
  for_each_element(network, [&](const Element& element) { found = found || is_mass(element); });
  return found;
}

bool of_springs_and_dampers(const Network& network) {
  return !has_masses(network) && is_rational(network);
}

std::vector<Symbol> masses_off_the_far_end(const Network& network) {
  std::vector<Symbol> off;
  std::visit(Walk{false, true, off}, network.form);
  return off;
}

bool hangs_on_masses(const Network& network) {
  return has_masses(network) && !without_masses(network);
}

std::optional<Network> without_masses(const Network& network) { return without(network, is_mass); }

}  // namespace vcrit
