// The error bound of a graph's stiffness against the most that roundings can do: its program is run
// with random values, and what one rounding of each operation does to K is added up by size, found
// by differentiating backwards. A bound holds for any signs of the roundings, so it is no smaller.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "program/star_mesh.hpp"

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

using Operation = Node::Operation;

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
    graph.parts.push_back(graph.wires.size() % 2 == 0 ? spring({"k" + name}) : damper({"c" + name}));
    graph.wires.push_back({from, to});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (j + 1 < n) wire(node(i, j), node(i, j + 1));
      if (i + 1 < n) wire(node(i, j), node(i + 1, j));
    }
  return graph;
}

class Run {
 public:
  Run(const Program& program, std::mt19937_64& engine, double decades) : program_(program) {
    std::uniform_real_distribution<double> exponent(-decades, decades);
    for (const Node& node : program.nodes())
      values_.push_back(node.operation == Operation::parameter ? std::pow(10, exponent(engine))
                                                               : value(node));
  }

  double operator[](NodeId id) const { return values_[id]; }

  /// Derivatives of a value by all.
  std::vector<double> derivatives(NodeId of) const {
    std::vector<double> result(values_.size());
    result[of] = 1;
    for (NodeId id = of + 1; id-- > 0;) {
      const Node& node = program_[id];
      for (std::size_t i = 0; i < arity(node.operation); ++i)
        result[node.arguments[i]] += result[id] * partial(node, i);
    }
    return result;
  }

  /// Whether an operation rounds.
  bool rounds(NodeId id) const {
    const Node& node = program_[id];
    return node.kind == NodeKind::value && arity(node.operation) > 0 &&
           node.operation != Operation::negate && node.operation != Operation::nonzero;
  }

 private:
  double at(const Node& node, std::size_t i) const { return values_[node.arguments[i]]; }

  double value(const Node& node) const {
    const auto x = [&](std::size_t i) { return at(node, i); };
    switch (node.operation) {
      case Operation::constant:
        return node.constant.to_double();
      case Operation::negate:
        return -x(0);
      case Operation::add:
        return x(0) + x(1);
      case Operation::subtract:
        return x(0) - x(1);
      case Operation::multiply:
        return x(0) * x(1);
      case Operation::divide:
        return x(0) / x(1);
      case Operation::multiply_add:
        return x(0) * x(1) + x(2);
      case Operation::root:
        return std::sqrt(x(0));
      case Operation::nonzero:
        return x(0);
      case Operation::size:
        return std::abs(x(0));
      case Operation::unless_moderate:
        return 0;
      default:
        throw std::logic_error("no operation of a graph");
    }
  }

  double partial(const Node& node, std::size_t i) const {
    switch (node.operation) {
      case Operation::negate:
        return -1;
      case Operation::add:
        return 1;
      case Operation::subtract:
        return i == 0 ? 1 : -1;
      case Operation::multiply:
        return at(node, 1 - i);
      case Operation::divide:
        return i == 0 ? 1 / at(node, 1) : -at(node, 0) / at(node, 1) / at(node, 1);
      case Operation::multiply_add:
        return i == 2 ? 1 : at(node, 1 - i);
      case Operation::nonzero:
        return i == 0 ? 1 : 0;
      default:
        return 0;  // of bounds, which K does not depend on
    }
  }

  const Program& program_;
  std::vector<double> values_;
};

// In any direction of the complex plane, in units of |K| and of one rounding.
double most(const Program& program, const Complex& k, const Run& run) {
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
    return std::pair(is_spring ? Complex{coefficient, zero} : Complex{zero, coefficient},
                     Complex{one, zero});
  });
  std::mt19937_64 engine(11);
  double tightest = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Run run(program, engine, trial % 4);
    const double share = most(program, mesh.k, run) / run[mesh.roundings];
    BOOST_TEST(share <= 1);
    tightest = std::max(tightest, share);
  }
  BOOST_TEST_MESSAGE("up to " << tightest << " of the bound");
}
