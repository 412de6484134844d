// The error bound of a graph's stiffness against the most that roundings can do: its program is run
// with random values, and what one rounding of each operation does to K is added up by size, found
// by differentiating backwards. A bound holds for any signs of the roundings, so it is no smaller.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "interpreter.hpp"
#include "network/graph.hpp"
#include "program/star_mesh.hpp"
#include "program/stiffness.hpp"
#include "support/nodal.hpp"

BOOST_AUTO_TEST_SUITE(test_graphs)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

using vcrit::test::Run;

// Springs and dampers in turn along the lines between 3 x 3 nodes, the terminals in two corners.
Graph grid() {
  constexpr int n = 3;
  const auto node = [](int row, int column) {
    const int place = n * row + column;
    return place == 0 ? 0 : (place == n * n - 1 ? 1 : place + 1);
  };
  Graph graph;
  for (int i = 0; i < n * n; ++i) graph.nodes.push_back("n" + std::to_string(i));
  const auto wire = [&](int from, int to) {
    const std::string name = std::to_string(graph.wires.size());
    graph.parts.push_back(graph.wires.size() % 2 == 0 ? spring({"k" + name})
                                                      : damper({"c" + name}));
    graph.wires.push_back({from, to});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (j + 1 < n) wire(node(i, j), node(i, j + 1));
      if (i + 1 < n) wire(node(i, j), node(i + 1, j));
    }
  return graph;
}

// In any direction of the complex plane, in units of |K| and of one rounding.
double most(const Program& program, const ComplexNode& k, const Run& run) {
  const std::vector<double> re = run.derivatives(k.re), im = run.derivatives(k.im);
  double largest = 0;
  for (double angle = 0; angle < std::numbers::pi; angle += 0.1) {
    double sum = 0;
    for (NodeId id = 0; id < program.nodes().size(); ++id)
      if (run.rounds(id))
        sum += std::abs((std::cos(angle) * re[id] + std::sin(angle) * im[id]) * run[id]);
    largest = std::max(largest, sum);
  }
  return largest / std::hypot(run[k.re], run[k.im]);
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_roundings_exceed_the_bound_of_a_graph) {
  Program program;
  const NodeId zero = program.constant(0), one = program.constant(1);
  const MeshedStiffness mesh = by_star_mesh(program, Network{grid()}, [&](const Element& element) {
    const NodeId coefficient = program.parameter(element.coefficient);
    const bool is_spring = element.kind == ElementKind::spring;
    return MeshElement{is_spring ? ComplexNode{coefficient, zero} : ComplexNode{zero, coefficient},
                       ComplexNode{one, zero}};
  });
  std::mt19937_64 engine(11);
  double tightest = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::uniform_real_distribution<double> exponent(-(trial % 4), trial % 4);
    const Run run(program, [&](const Symbol&) { return std::pow(10, exponent(engine)); });
    const double share = most(program, mesh.k, run) / run[mesh.roundings];
    BOOST_TEST(share <= 1);
    tightest = std::max(tightest, share);
  }
  BOOST_TEST_MESSAGE("up to " << tightest << " of the bound");
}

// Whatever a graph is reduced by, spanning trees or meshes: its stiffness is that of nodal
// analysis.
BOOST_AUTO_TEST_CASE(any_graph_is_as_stiff_as_nodal_analysis_says) {
  std::mt19937_64 engine(12);
  std::uniform_real_distribution<double> exponent(-1, 1);
  int tried = 0;
  while (tried < 60) {
    Graph graph;
    const int inner = 2 + tried % 4;
    for (int i = 0; i < inner + 2; ++i) graph.nodes.push_back("n" + std::to_string(i));
    for (int from = 0; from < inner + 2; ++from)
      for (int to = from + 1; to < inner + 2; ++to) {
        if (engine() % 8 >= 5) continue;
        const std::string name = std::to_string(graph.parts.size());
        graph.parts.push_back(engine() % 2 == 0 ? spring({"k" + name}) : damper({"c" + name}));
        graph.wires.push_back({from, to});
      }
    const auto loaded = load_carrying(graph);
    if (!loaded) continue;
    ++tried;
    Program program;
    const NodeId omega = program.parameter({"omega"});
    StiffnessWriter writer(program, omega, 50,
                           [&](const Symbol& symbol) { return program.parameter(symbol); });
    const Network network{loaded->graph};
    const Stiffness k = writer.write(network);
    const NodeId bound = roundings(program, k);
    Values values;
    const Run run(program, [&](const Symbol& symbol) {
      return values[symbol] = std::pow(10, exponent(engine));
    });
    const std::complex<double> found =
        std::complex(run[k.t.re], run[k.t.im]) / std::complex(run[k.q.re], run[k.q.im]);
    const test::Complex exact =
        test::Nodal(values, test::Real(values.at({"omega"}))).stiffness(network);
    const std::complex<double> expected(static_cast<double>(exact.real()),
                                        static_cast<double>(exact.imag()));
    // What the program says of itself, and the quotient and the exact value's own roundings.
    BOOST_TEST(std::abs(found - expected) <= (run[bound] + 10) * 1.2e-16 * std::abs(expected));
    BOOST_TEST(run[bound] < 1e5);  // leaves eleven digits
  }
}

BOOST_AUTO_TEST_SUITE_END()
