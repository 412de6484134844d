#include "program/gradient.hpp"

#include "base/errors.hpp"

namespace vcrit::symbolic {

namespace {

class Backward {
 public:
  Backward(Program& program, NodeId result) : program_(program), last_(result) {
    adjoints_[result] = program.constant(1);
  }

  /// Passes what `id` gets on to its arguments, from `id` down to 0.
  void run() {
    for (NodeId id = last_ + 1; id-- > 0;)
      if (const auto known = adjoints_.find(id); known != adjoints_.end()) pass(id, known->second);
  }

  NodeId of(NodeId id) const {
    const auto known = adjoints_.find(id);
    return known == adjoints_.end() ? program_.constant(0) : known->second;
  }

 private:
  using Operation = Node::Operation;

  /// adjoint of `id` += a b
  void add(NodeId id, NodeId a, NodeId b) {
    if (program_[id].operation == Operation::constant) return;
    const auto [known, is_new] = adjoints_.try_emplace(id, program_.constant(0));
    known->second = program_.multiply_add(a, b, known->second);
  }
  void add(NodeId id, NodeId a) { add(id, a, program_.constant(1)); }
  /// What a product a b passes on; squares are frequent.
  void add_product(NodeId g, NodeId a, NodeId b) {
    if (a == b) return add(a, program_.multiply(program_.constant(2), g), a);
    add(a, g, b);
    add(b, g, a);
  }

  void pass(NodeId id, NodeId g) {
    const Node node = program_[id];
    const auto [a, b, c] = node.arguments;
    switch (node.operation) {
      case Operation::parameter:
      case Operation::constant:
      case Operation::unit:   // T and Q together: v* does not depend on it
      case Operation::place:  // a table's numbers stay from one row to the next
      case Operation::entry:
        return;
      case Operation::negate:
        return add(a, program_.negate(g));
      case Operation::nonzero:
        return add(a, g);
      case Operation::gap:
      case Operation::tie:
        return;
      case Operation::tied:
        return add(a, program_.tied(g, b, 0));
      case Operation::add:
        add(a, g);
        return add(b, g);
      case Operation::subtract:
        add(a, g);
        return add(b, program_.negate(g));
      case Operation::multiply:
        return add_product(g, a, b);
      case Operation::multiply_add:
        add_product(g, a, b);
        return add(c, g);
      case Operation::divide: {
        const NodeId share = program_.divide(g, b);
        add(a, share);
        return add(b, program_.negate(share), id);
      }
      case Operation::less_inertia: {  // a - b c^2
        const NodeId change = program_.negate(program_.multiply(g, c));
        add(a, g);
        add(b, change, c);
        return add(c, program_.multiply(program_.constant(2), change), b);
      }
      case Operation::root:
        return add(a, program_.divide(g, program_.multiply(program_.constant(2), id)));
      case Operation::magnitude:
        return add(a, g, program_.divide(id, a));
      case Operation::size:
      case Operation::unless_moderate:
        throw Bug("a bound has no derivative");
    }
  }

  Program& program_;
  NodeId last_;
  std::map<NodeId, NodeId> adjoints_;
};

}  // namespace

GradientProgram gradient_program(VelocityProgram velocity) {
  GradientProgram result;
  Program& program = velocity.program;
  result.ratio = program.divide(velocity.above, velocity.below);
  const NodeId root = velocity.rooted ? program.root(result.ratio) : result.ratio;
  result.value = program.multiply(root, velocity.factor);
  Backward backward(program, result.value);
  backward.run();
  for (NodeId id = 0; id <= result.value; ++id)
    if (program[id].operation == Node::Operation::parameter)
      result.partials[program[id].parameter] = backward.of(id);
  result.program = std::move(program);
  return result;
}

}  // namespace vcrit::symbolic
