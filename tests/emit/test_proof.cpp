// Generated programs are the derived formula: for all scenes, and not where one step is another.
#include "program/proof.hpp"

#include <boost/test/unit_test.hpp>

#include "base/errors.hpp"
#include "program/sweep.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"

using namespace vcrit;
using namespace vcrit::symbolic;
using Operation = Node::Operation;

BOOST_AUTO_TEST_SUITE(test_proof)

namespace {

NodeId own(Program& program, const Symbol& symbol) { return program.parameter(symbol); }

const std::string bridge = test::to_toml(test::symbolic({.normal = "k0 | (k1 - c1)",
                                                         .tangential = "bridge",
                                                         .network = "kd | (k2 - c2)",
                                                         .mass = "m",
                                                         .more = R"toml([networks.bridge]
terminals = ["a", "b"]
edges = [["k3", "a", "n"], ["k4", "n", "b"], ["c3", "a", "o"], ["c4", "o", "b"], ["k5", "n", "o"]]
)toml"}));
const std::vector<double> seven{1, 2, 3, 4, 5, 6, 7};
const std::string prony =
    test::to_toml(test::symbolic({.normal = "prony(k0, k, tau)",
                                  .network = "kd",
                                  .mass = "m",
                                  .elements = {{"k", seven}, {"tau", seven}}}));
const std::string rigid =
    test::to_toml(test::symbolic({.normal = "k0 | c0", .tangential = "k1 | (k2 - c2)"}));
const std::string poisson = test::to_toml(test::symbolic(
    {.normal = "k0 | maxwell(k1, tau)", .poisson = "nu", .network = "k2 | maxwell(k1, tau)"}));
const std::string chain = test::to_toml(test::symbolic(
    {.normal = "k0 | (k1 - c1)",
     .poisson = "nu",
     .network = "ka - (mass(ma) | kb | cb | (kc - (mass(mc) | maxwell(k1, tau)))) | kd - mass(md)",
     .mass = "m"}));
const std::string frame = test::to_toml(test::symbolic({.normal = "k0 | c0",
                                                        .tangential = "k1 | c1",
                                                        .network = "frame",
                                                        .more = R"toml([networks.frame]
terminals = ["a", "b"]
edges = [["ka", "a", "1"], ["kb | cb", "a", "2"], ["kc", "1", "2"], ["mass(ma)", "1", "b"], ["kd", "1", "b"],
         ["mass(mb)", "2", "b"], ["ke | ce", "2", "b"]]
)toml"}));
const std::vector<std::string> scenes{bridge, prony, rigid, poisson, chain, frame};

Scene read(const std::string& text) { return parse_scene(text, "test.toml"); }

std::vector<Scene> scenes_and_a_table() {
  std::vector<Scene> all;
  for (const std::string& text : scenes) all.push_back(read(text));
  all.push_back(read_scene(VCRIT_SCENES "/measured_drive.toml"));
  return all;
}

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

/// What is written in the place of a step: a term's sign, a quotient for a product and so on; where
/// the operation stays, other arguments. Nothing for steps that decide no value.
std::optional<Node> other_step(Node node) {
  static const std::map<Operation, Operation> others{
      {Operation::add, Operation::subtract},
      {Operation::subtract, Operation::add},
      {Operation::multiply, Operation::divide},
      {Operation::divide, Operation::multiply},
      {Operation::multiply_add, Operation::multiply_add},
      {Operation::less_inertia, Operation::less_inertia},
      {Operation::constant, Operation::constant},
      {Operation::negate, Operation::magnitude}};
  const auto other = others.find(node.operation);
  if (other == others.end()) return std::nullopt;
  node.constant += 1;
  if (node.operation == other->second) std::swap(node.arguments[1], node.arguments[2]);
  node.operation = other->second;
  return node;
}

NodeId written(Program& program, const Node& node, const std::map<NodeId, NodeId>& places) {
  const auto argument = [&](std::size_t i) { return places.at(node.arguments[i]); };
  switch (node.operation) {
    case Operation::parameter:
      return program.parameter(node.parameter);
    case Operation::constant:
      return program.constant(node.constant);
    case Operation::negate:
      return program.negate(argument(0));
    case Operation::add:
      return program.add(argument(0), argument(1));
    case Operation::subtract:
      return program.subtract(argument(0), argument(1));
    case Operation::multiply:
      return program.multiply(argument(0), argument(1));
    case Operation::divide:
      return program.divide(argument(0), argument(1));
    case Operation::multiply_add:
      return program.multiply_add(argument(0), argument(1), argument(2));
    case Operation::less_inertia:
      return program.less_inertia(argument(0), argument(1), argument(2));
    case Operation::unit:
      return program.constant(1);
    case Operation::place:
      return program.place(argument(0), {1, 2, 3, 4, 5, 6});
    case Operation::entry:
      return program.entry(argument(0), program[argument(1)].constant.to_int());
    default:  // where no element is 0, the first one
      return argument(0);
  }
}

/// The program with one step changed; nothing where none can be.
std::optional<VelocityProgram> faulty(const VelocityProgram& velocity, NodeId changed) {
  VelocityProgram result = velocity;
  Program program;
  std::map<NodeId, NodeId> places;
  bool planted = false;
  for (const NodeId id : made_of(velocity)) {
    Node node = velocity.program[id];
    if (id == changed) {
      const std::optional<Node> other = other_step(node);
      if (!other) return std::nullopt;
      node = *other;
      planted = true;
    }
    places[id] = written(program, node, places);
  }
  if (!planted) return std::nullopt;
  result.program = program;
  for (NodeId* id : {&result.above, &result.below, &result.factor}) *id = places.at(*id);
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(programs_are_the_derived_formula) {
  for (const Scene& scene : scenes_and_a_table()) {
    const Derivation derivation = derive(scene);
    const Proof proof(derivation, own);
    const VelocityProgram velocity = velocity_program(scene, own);
    BOOST_CHECK_NO_THROW(proof.holds(derivation));
    BOOST_CHECK_NO_THROW(proof.holds(nested_form(derivation)));
    BOOST_CHECK_NO_THROW(proof.holds(velocity));
    BOOST_CHECK_NO_THROW(proof.holds(gradient_program(velocity)));
    BOOST_CHECK_NO_THROW(proof.holds(quantity_program(scene, own)));
    if (const auto sweep = sweep_program(scene, own, velocity))
      BOOST_CHECK_NO_THROW(proof.holds(*sweep));
  }
}

// A node, changed alone: the sign of a term, a product for a quotient, other arguments, a constant.
// What v* does not depend on stays unnoticed: a number in which above and below both have a factor,
// and the sign of the whole.
BOOST_AUTO_TEST_CASE(one_other_step_is_found) {
  for (const Scene& scene : scenes_and_a_table()) {
    const Proof proof(derive(scene), own);
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
  const Proof proof(derive(scene), own);
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
  const Proof proof(derive(scene), own);
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
  BOOST_CHECK_THROW(Proof(derive(scene), own).holds(derivation), Bug);
  derivation = nested_form(derive(scene));
  std::swap(derivation.definitions.front().right, derivation.definitions.back().right);
  BOOST_CHECK_THROW(Proof(derive(scene), own).holds(derivation), Bug);
}

BOOST_AUTO_TEST_SUITE_END()
