// Networks of springs, dampers and, in a drive, masses between two terminals, as trees of elements,
// series and parallel combinations, and graphs for what is neither (a bridge).
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "network/amount.hpp"

namespace vcrit {

/// spring: K = k.  damper: K = c s.  maxwell: K = k tau s/(1 + tau s), a spring k in series with a
/// damper k tau, given by its relaxation time.  mass: K = m s^2 between a point and inertial
/// ground; to an oscillation the uniformly moving far end of a drive is that ground, see
/// masses.hpp.  lossy: K = k (1 + i eta), a spring with the same loss factor at all frequencies,
/// which no causal element has: it stands for a material at the frequency of the oscillation.
/// measured: the same at the frequency of the oscillation alone, k and eta being those of a table;
/// what it carries at rest is a number of its own.
enum class ElementKind { spring, damper, maxwell, mass, lossy, measured };

struct Element {
  ElementKind kind = ElementKind::spring;
  Amount coefficient;  ///< k (N/m) of a spring or Maxwell branch, c (N s/m), m (kg) of a mass
  Amount second;       ///< tau (s) of a Maxwell branch, eta of a lossy spring; others have none
  Amount rest = {};    ///< k (N/m) at rest of what is measured; others have none
  friend bool operator==(const Element&, const Element&) = default;
};

struct Network;

struct Series {
  std::vector<Network> parts;
};

struct Parallel {
  std::vector<Network> parts;
};

/// Ends of one edge of a graph, as indices into Graph::nodes.
struct Wire {
  int from = 0;
  int to = 0;
  friend bool operator==(const Wire&, const Wire&) = default;
};

/// Any wiring: edge i is parts[i] between wires[i].from and wires[i].to. Nodes 0 and 1 are the
/// terminals; the others are massless inner nodes. Holds no edge without load (see graph.hpp).
struct Graph {
  std::vector<std::string> nodes;
  std::vector<Network> parts;
  std::vector<Wire> wires;
};

struct Network {
  std::variant<Element, Series, Parallel, Graph> form;
};

bool operator==(const Series&, const Series&);
bool operator==(const Parallel&, const Parallel&);
bool operator==(const Graph&, const Graph&);
bool operator==(const Network&, const Network&);

Network spring(Amount k);
Network damper(Amount c);
Network maxwell(Amount k, Amount tau);
Network mass(Amount m);
/// One part stands for itself; nested combinations of the same kind are flattened.
Network series(std::vector<Network> parts);
Network parallel(std::vector<Network> parts);

/// Levels of combinations in one another; 0 for an element.
int depth(const Network& network);

/// How many elements it has.
std::size_t size(const Network& network);

/// Calls `visit` for every element, in the order of writing.
void for_each_element(const Network& network, const std::function<void(const Element&)>& visit);

/// Puts other amounts in the place of its symbols.
void rename(Network& network, const std::function<Amount(const Symbol&)>& name);

/// The symbols of all elements, each once, in the order of writing.
std::vector<Symbol> symbols_of(const Network& network);

}  // namespace vcrit
