// Generated programs are the derived formula: for all scenes, and not where one step is another.
#include "program/proof.hpp"

#include <boost/test/unit_test.hpp>

#include "base/errors.hpp"
#include "program/sweep.hpp"
#include "scene/scene.hpp"

using namespace vcrit;
using namespace vcrit::symbolic;
using Operation = Node::Operation;

BOOST_AUTO_TEST_SUITE(test_proof)

namespace {

NodeId own(Program& program, const Symbol& symbol) { return program.parameter(symbol); }

const char* const bridge = R"toml(
[contact]
normal = "k0 | (k1 - c1)"
tangential = "bridge"
[drive]
network = "kd | (k2 - c2)"
[body]
mass = "m"
[networks.bridge]
terminals = ["a", "b"]
edges = [["k3", "a", "n"], ["k4", "n", "b"], ["c3", "a", "o"], ["c4", "o", "b"], ["k5", "n", "o"]]
)toml";
const char* const prony = R"toml(
[contact]
normal = "prony(k0, k, tau)"
poisson = 0.3
[drive]
network = "kd"
[body]
mass = "m"
[elements]
k = [1, 2, 3, 4, 5, 6, 7]
tau = [1, 2, 3, 4, 5, 6, 7]
)toml";
const char* const rigid = R"toml(
[contact]
normal = "k0 | c0"
tangential = "k1 | (k2 - c2)"
)toml";
const char* const poisson = R"toml(
[contact]
normal = "k0 | maxwell(k1, tau)"
poisson = "nu"
[drive]
network = "k2 | maxwell(k1, tau)"
)toml";
const std::vector<const char*> scenes{bridge, prony, rigid, poisson};

Scene read(const char* text) { return parse_scene(text, "test.toml"); }

/// What v* is made of, where no element is 0: not what looks for zeros and sets scales.
std::set<NodeId> made_of(const VelocityProgram& velocity) {
  std::set<NodeId> nodes{velocity.above, velocity.below, velocity.factor};
  for (NodeId id = velocity.program.nodes().size(); id-- > 0;) {
    if (!nodes.contains(id)) continue;
    const Node& node = velocity.program[id];
    const bool first_alone =
        node.operation == Operation::tied || node.operation == Operation::nonzero;
    const std::size_t used = node.operation == Operation::unit ? 0
                             : first_alone                     ? 1
                                                               : arity(node.operation);
    for (std::size_t i = 0; i < used; ++i) nodes.insert(node.arguments[i]);
  }
  return nodes;
}

/// The program with one step changed; nothing where that would be the same step, or is of no use.
std::optional<VelocityProgram> faulty(const VelocityProgram& velocity, NodeId changed) {
  const std::set<NodeId> needed = made_of(velocity);
  if (!needed.contains(changed)) return std::nullopt;
  VelocityProgram result = velocity;
  Program program;
  std::map<NodeId, NodeId> places;
  for (const NodeId id : needed) {
    const Node& node = velocity.program[id];
    const auto argument = [&](std::size_t i) { return places.at(node.arguments[i]); };
    const bool fault = id == changed;
    switch (node.operation) {
      case Operation::parameter:
        if (fault) return std::nullopt;
        places[id] = program.parameter(node.parameter);
        break;
      case Operation::constant:
        places[id] = program.constant(fault ? node.constant + 1 : node.constant);
        break;
      case Operation::negate:
        places[id] = fault ? argument(0) : program.negate(argument(0));
        break;
      case Operation::add:
        places[id] = fault ? program.subtract(argument(0), argument(1))
                           : program.add(argument(0), argument(1));
        break;
      case Operation::subtract:
        places[id] = fault ? program.add(argument(0), argument(1))
                           : program.subtract(argument(0), argument(1));
        break;
      case Operation::multiply:
        places[id] = fault ? program.divide(argument(0), argument(1))
                           : program.multiply(argument(0), argument(1));
        break;
      case Operation::divide:
        places[id] = fault ? program.multiply(argument(0), argument(1))
                           : program.divide(argument(0), argument(1));
        break;
      case Operation::multiply_add:
        places[id] = fault ? program.multiply_add(argument(0), argument(2), argument(1))
                           : program.multiply_add(argument(0), argument(1), argument(2));
        break;
      case Operation::less_inertia:
        places[id] = fault ? program.less_inertia(argument(0), argument(2), argument(1))
                           : program.less_inertia(argument(0), argument(1), argument(2));
        break;
      case Operation::unit:
        if (fault) return std::nullopt;
        places[id] = program.constant(1);
        break;
      default:
        if (fault) return std::nullopt;
        places[id] = argument(0);
    }
  }
  result.program = program;
  for (NodeId* id : {&result.above, &result.below, &result.factor}) *id = places.at(*id);
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(programs_are_the_derived_formula) {
  for (const char* text : scenes) {
    const Scene scene = read(text);
    const Proof proof(scene, own);
    const VelocityProgram velocity = velocity_program(scene, own);
    BOOST_CHECK_NO_THROW(proof.holds(derive(scene)));
    BOOST_CHECK_NO_THROW(proof.holds(derive(scene, true)));
    BOOST_CHECK_NO_THROW(proof.holds(velocity));
    BOOST_CHECK_NO_THROW(proof.holds(gradient_program(velocity)));
    BOOST_CHECK_NO_THROW(proof.holds(quantity_program(scene, own)));
    if (const auto sweep = sweep_program(scene, own)) BOOST_CHECK_NO_THROW(proof.holds(*sweep));
  }
}

// A node, changed alone: the sign of a term, a product for a quotient, other arguments, a constant.
// What v* does not depend on stays unnoticed: a number in which above and below both have a factor,
// and the sign of the whole.
BOOST_AUTO_TEST_CASE(one_other_step_is_found) {
  for (const char* text : scenes) {
    const Scene scene = read(text);
    const Proof proof(scene, own);
    const VelocityProgram velocity = velocity_program(scene, own);
    int planted = 0;
    for (NodeId id = 0; id < velocity.program.nodes().size(); ++id) {
      const auto fault = faulty(velocity, id);
      if (!fault) continue;
      ++planted;
      BOOST_TEST_CONTEXT("node " << id << " of " << scene.text)
      BOOST_CHECK_THROW(proof.holds(*fault), Bug);
    }
    BOOST_TEST(planted >= 10);
  }
}

BOOST_AUTO_TEST_CASE(other_partial_derivatives_are_found) {
  const Scene scene = read(bridge);
  const Proof proof(scene, own);
  const GradientProgram gradient = gradient_program(velocity_program(scene, own));
  for (const auto& [symbol, partial] : gradient.partials)
    for (const auto& [other, its] : gradient.partials) {
      if (partial == its) continue;
      GradientProgram wrong = gradient;
      wrong.partials[symbol] = its;
      BOOST_CHECK_THROW(proof.holds(wrong), Bug);
    }
}

BOOST_AUTO_TEST_CASE(other_quantities_are_found) {
  const Scene scene = read(bridge);
  const Proof proof(scene, own);
  const QuantityProgram right = quantity_program(scene, own);
  const auto refused = [&](const auto& change) {
    QuantityProgram wrong = right;
    change(wrong);
    BOOST_CHECK_THROW(proof.holds(wrong), Bug);
  };
  refused([](auto& q) { std::swap(q.normal, q.tangential); });
  refused([](auto& q) { std::swap(q.tangential, *q.drive); });
  refused([](auto& q) { std::swap(q.drive->k.re, q.drive->k.im); });
  refused([](auto& q) { q.body->amplitude = q.contact_point.amplitude; });
  refused([](auto& q) { q.body->direction = q.contact_point.direction; });
  refused([](auto& q) { q.contact_point.direction = q.body->direction; });
  refused([](auto& q) { q.contact_point.amplitude = q.body->amplitude; });
  refused([](auto& q) { q.largest_amplitude = q.body->amplitude; });
}

BOOST_AUTO_TEST_CASE(another_formula_is_found) {
  const Scene scene = read(bridge);
  Derivation derivation = derive(read(rigid));
  BOOST_CHECK_THROW(Proof(scene, own).holds(derivation), Bug);
  derivation = derive(scene, true);
  std::swap(derivation.definitions.front().right, derivation.definitions.back().right);
  BOOST_CHECK_THROW(Proof(scene, own).holds(derivation), Bug);
}

BOOST_AUTO_TEST_SUITE_END()
