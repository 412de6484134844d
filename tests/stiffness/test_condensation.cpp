// What series and parallel leave of a graph.
#include "stiffness/condensation.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_condensation)

namespace {

using namespace vcrit;

Relaxation spring_of(double k) { return {k, 0, {}}; }

}  // namespace

// Between the terminals 1 N/m; 6 and 3 in a row: 2 N/m; two of 4 side by side, in a row with 8:
// 4 N/m. Numbers and their quotients are exact.
BOOST_AUTO_TEST_CASE(rows_and_side_by_side_become_one_edge) {
  const RelaxationGraph left = condensed(
      {4,
       {{0, 1}, {0, 2}, {2, 1}, {0, 3}, {3, 0}, {1, 3}},
       {spring_of(1), spring_of(6), spring_of(3), spring_of(4), spring_of(4), spring_of(8)}});
  BOOST_TEST(left.nodes == 2U);
  BOOST_REQUIRE_EQUAL(left.edges.size(), 1U);
  BOOST_TEST(left.edges[0].equilibrium == 7.0);
}

// A spring behind a damper, each in an edge of its own: a branch.
BOOST_AUTO_TEST_CASE(unlike_edges_in_a_row) {
  const RelaxationGraph left = condensed({3, {{0, 2}, {2, 1}}, {spring_of(4), {0, 32, {}}}});
  BOOST_REQUIRE_EQUAL(left.edges.size(), 1U);
  BOOST_TEST(left.edges[0].equilibrium == 0.0);
  BOOST_TEST(left.edges[0].branches.at(0).stiffness == 4.0);
  BOOST_TEST(left.edges[0].branches.at(0).time == 8.0);
}

// A bridge, one arm of it as a row of two, its middle twice: five edges between four nodes.
BOOST_AUTO_TEST_CASE(a_bridge_stays) {
  const RelaxationGraph left = condensed({5,
                                          {{0, 4}, {4, 2}, {0, 3}, {2, 1}, {3, 1}, {2, 3}, {3, 2}},
                                          {spring_of(6), spring_of(3), spring_of(10), spring_of(11),
                                           spring_of(12), spring_of(5), spring_of(8)}});
  BOOST_TEST(left.nodes == 4U);
  BOOST_REQUIRE_EQUAL(left.edges.size(), 5U);
  double sum = 0;
  for (const Relaxation& edge : left.edges) sum += edge.equilibrium;
  BOOST_TEST(sum == 2.0 + 10 + 11 + 12 + 13);
}

BOOST_AUTO_TEST_SUITE_END()
