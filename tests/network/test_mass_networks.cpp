// Masses in networks: where they may stand, and what is left of a network without them.
#include <boost/test/unit_test.hpp>

#include "network/masses.hpp"

BOOST_AUTO_TEST_SUITE(test_mass_networks)

using namespace vcrit;

namespace {

Network k(const char* name) { return spring({name}); }
Network m(const char* name) { return mass({name}); }

bool is_allowed(const Network& network) { return masses_off_the_far_end(network).empty(); }

/// Nodes 0 and 1 are the terminals.
Network graph(int nodes, const std::vector<std::pair<Network, Wire>>& edges) {
  Graph g;
  for (int n = 0; n < nodes; ++n) g.nodes.push_back(std::to_string(n));
  for (const auto& [part, wire] : edges) {
    g.parts.push_back(part);
    g.wires.push_back(wire);
  }
  return {g};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_mass_has_an_end_at_the_far_end) {
  BOOST_TEST(is_allowed(m("m1")));
  BOOST_TEST(is_allowed(series({k("k1"), parallel({m("m1"), k("k2")})})));
  BOOST_TEST(is_allowed(parallel({k("k1"), series({k("k2"), m("m1")})})));
  BOOST_TEST(!is_allowed(series({m("m1"), k("k1")})));
  BOOST_TEST(!is_allowed(series({k("k0"), parallel({m("m1"), k("k2")}), k("k1")})));
  BOOST_TEST(!is_allowed(parallel({k("k0"), series({k("k1"), series({m("m1"), k("k2")})})})));
  const std::vector<Symbol> off =
      masses_off_the_far_end(series({parallel({m("m1"), k("k1")}), parallel({m("m2"), k("k2")})}));
  BOOST_TEST((off == std::vector<Symbol>{{"m1"}}));
}

BOOST_AUTO_TEST_CASE(in_a_graph_the_far_end_is_the_second_terminal_whichever_way_an_edge_runs) {
  const auto with = [](const Network& part, Wire wire) {
    return graph(3, {{k("k1"), {0, 2}}, {k("k2"), {2, 1}}, {part, wire}});
  };
  BOOST_TEST(is_allowed(with(m("m1"), {2, 1})));
  BOOST_TEST(is_allowed(with(m("m1"), {1, 2})));
  BOOST_TEST(is_allowed(with(m("m1"), {0, 1})));
  BOOST_TEST(!is_allowed(with(m("m1"), {0, 2})));
  const Network absorber = series({k("k3"), m("m1")});
  BOOST_TEST(is_allowed(with(absorber, {2, 1})));
  BOOST_TEST(!is_allowed(with(absorber, {1, 2})));
  // The graph in the middle of a chain ends at a moving point.
  BOOST_TEST(!is_allowed(series({with(m("m1"), {2, 1}), k("k4")})));
  BOOST_TEST(is_allowed(series({k("k4"), with(m("m1"), {2, 1})})));
}

BOOST_AUTO_TEST_CASE(at_rest_masses_carry_nothing) {
  const Network chain = series({k("k1"), parallel({m("m1"), k("k2")})});
  BOOST_TEST(has_masses(chain));
  BOOST_CHECK(without_masses(chain).value() == series({k("k1"), k("k2")}));
  BOOST_CHECK(without_masses(parallel({k("k1"), series({k("k2"), m("m1")})})).value() == k("k1"));
  BOOST_TEST(!without_masses(m("m1")).has_value());
  BOOST_TEST(!without_masses(series({k("k1"), m("m1")})).has_value());
  BOOST_TEST(!without_masses(graph(3, {{k("k1"), {0, 2}}, {m("m1"), {2, 1}}})).has_value());
  BOOST_TEST(!has_masses(series({k("k1"), k("k2")})));
}

BOOST_AUTO_TEST_SUITE_END()
