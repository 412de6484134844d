// Relaxation forms of graphs, compared with tests/data/graph_forms.csv to the last bit.
#include "stiffness/graph_relaxation.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/errors.hpp"
#include "simulation/reference_tables.hpp"
#include "support/table.hpp"

BOOST_AUTO_TEST_SUITE(test_graph_relaxation)

namespace {

using namespace vcrit;

// "from-to form; from-to form; ..."
RelaxationGraph graph_of(const std::string& text) {
  RelaxationGraph graph;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ';');) {
    Wire wire{};
    char dash = 0;
    std::istringstream edge(part);
    edge >> wire.from >> dash >> wire.to;
    std::string form;
    std::getline(edge, form);
    graph.wires.push_back(wire);
    graph.edges.push_back(reference::network(form));
    graph.nodes = std::max({graph.nodes, static_cast<std::size_t>(wire.from) + 1,
                            static_cast<std::size_t>(wire.to) + 1});
  }
  return graph;
}

void check_same(const Relaxation& form, const Relaxation& expected) {
  BOOST_TEST(form.equilibrium == expected.equilibrium);
  BOOST_TEST(form.damper == expected.damper);
  BOOST_REQUIRE_EQUAL(form.branches.size(), expected.branches.size());
  for (std::size_t j = 0; j < form.branches.size(); ++j) {
    BOOST_TEST(form.branches[j].stiffness == expected.branches[j].stiffness);
    BOOST_TEST(form.branches[j].time == expected.branches[j].time);
  }
}

template <class Check>
void for_each_reference(const Check& check) {
  const auto rows = test::rows_of("graph_forms.csv", 25);
  for (const auto& row : rows) BOOST_TEST_CONTEXT(row.at(0)) {
      check(graph_of(row.at(1)), reference::network(row.at(2)));
    }
}

// A bridge whose middle has this form.
RelaxationGraph bridge(const Relaxation& middle) {
  return {4,
          {{0, 2}, {0, 3}, {2, 1}, {3, 1}, {2, 3}},
          {{1, 0, {}}, {0, 1, {}}, {0, 1, {}}, {1, 0, {}}, middle}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_are_the_nearest_doubles) {
  for_each_reference([](const RelaxationGraph& graph, const Relaxation& expected) {
    check_same(graph_relaxation(graph), expected);
  });
}

// Swapping the terminals changes the eigenproblem, but not K.
BOOST_AUTO_TEST_CASE(terminals_may_be_swapped) {
  for_each_reference([](RelaxationGraph graph, const Relaxation& expected) {
    const auto other = [](int node) { return node < 2 ? 1 - node : node; };
    for (Wire& wire : graph.wires) wire = {other(wire.from), other(wire.to)};
    check_same(graph_relaxation(graph), expected);
  });
}

// Units that differ by powers of 2 change no digit.
BOOST_AUTO_TEST_CASE(units_do_not_matter) {
  constexpr double stiffness_unit = 0x1p600, time_unit = 0x1p-400;
  for_each_reference([](RelaxationGraph graph, Relaxation expected) {
    const auto change_units = [](Relaxation& form) {
      form = scaled(form, stiffness_unit);
      form.damper *= time_unit;
      for (MaxwellBranch& branch : form.branches) branch.time *= time_unit;
    };
    std::ranges::for_each(graph.edges, change_units);
    change_units(expected);
    check_same(graph_relaxation(graph), expected);
  });
}

// Seven nodes, each joined to each other by a damper of 1 + 2^-51. Between any two nodes they act
// as one of 3.5 times as much, which is halfway between two doubles.
BOOST_AUTO_TEST_CASE(ties_go_to_the_even_double) {
  RelaxationGraph graph;
  graph.nodes = 7;
  for (int i = 0; i < 7; ++i)
    for (int j = i + 1; j < 7; ++j) {
      graph.wires.push_back({i, j});
      graph.edges.push_back({0, 1 + 0x1p-51, {}});
    }
  BOOST_TEST(graph_relaxation(graph).damper == 3.5 + 0x1p-49);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_are_a_bug) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  BOOST_CHECK_THROW(graph_relaxation(bridge({infinity, 0, {}})), Bug);
  BOOST_CHECK_THROW(graph_relaxation(bridge({0, 0, {{1, infinity}}})), Bug);
  BOOST_CHECK_THROW(graph_relaxation(bridge({0, std::nan(""), {}})), Bug);
}

BOOST_AUTO_TEST_SUITE_END()
