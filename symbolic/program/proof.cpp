#include "program/proof.hpp"

#include <fmt/core.h>

#include <utility>

#include "analysis/residues.hpp"
#include "base/errors.hpp"
#include "formula/names.hpp"
#include "formula/rational.hpp"
#include "formula/symbols.hpp"
#include "network/graph.hpp"
#include "problem/variants.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;
using FixedNumbers = std::map<std::string, GiNaC::numeric>;

const GaussianResidue imaginary_unit{{}, Residue(1)};

// One is enough; at the second nothing is the same but the functions.
constexpr int compared_points = 2;
// Nobody divides by 0 at so many.
constexpr std::uint64_t points_looked_at = 100;

/// The scene at a point, and how it changes along a line through it.
class SceneAt {
 public:
  SceneAt(const SymbolicModel& model, const FixedNumbers& fixed, std::uint64_t number)
      : fixed_(fixed), point_(named_point(2 * number)), direction_(named_point(2 * number + 1)) {
    algebra_.point = [this](const std::string& name) { return at(name); };
    algebra_.s = DualResidue(imaginary_unit) * at("omega");
    algebra_.known[own_name("R_d")] = receptance();
    for (const NamedNetwork& part : model.networks())
      algebra_.known[own_name(part.name)] = evaluate(part.network.reduction(), algebra_);
    for (const Line& identity : model.identities())
      algebra_.known[GiNaC::ex_to<GiNaC::symbol>(identity.left).get_name()] =
          evaluate_rational(identity.right, algebra_);
    height = evaluate_rational(model.balance().normal_amplitude, algebra_);
    body = evaluate_rational(model.balance().body_amplitude, algebra_);
    contact = evaluate_rational(model.balance().contact_amplitude, algebra_);
  }

  SceneAt(const SceneAt&) = delete;

  DualResidue at(const std::string& name) const {
    if (const auto known = fixed_.find(name); known != fixed_.end())
      return DualResidue(known->second);
    return {point_(name), direction_(name)};
  }
  DualResidue stiffness(const char* name) const { return algebra_.known.at(own_name(name)); }
  /// A positive factor of a program's, such as a power of two; it cancels.
  GaussianResidue factor(NodeId id) const { return point_(fmt::format("factor {}", id)); }
  /// Of the table of a measured drive, at the omega of this point.
  GaussianResidue entry(int number) const { return point_(fmt::format("entry {}", number)); }
  Residue direction(const Symbol& symbol) const { return at(to_text(symbol)).change.re; }
  const NumberAlgebra<DualResidue>& algebra() const { return algebra_; }

  DualResidue height, body, contact;  ///< amplitudes

 private:
  /// Linear in omega between two rows of the table.
  DualResidue receptance() const {
    const DualResidue omega = at("omega"), below = entry(0), above = entry(3);
    const auto row = [this](int first) {
      return DualResidue(entry(first + 1) + imaginary_unit * entry(first + 2));
    };
    return (row(0) * (above + -omega) + row(3) * (omega + -below)) * inverse(above + -below);
  }

  const FixedNumbers& fixed_;
  ResiduePoint point_, direction_;
  NumberAlgebra<DualResidue> algebra_;
};

DualResidue times_conjugate(DualResidue z) { return z * conjugate(z); }
GaussianResidue times_conjugate(GaussianResidue z) { return z * conjugate(z); }

/// v*^2
DualResidue square_of_velocity(const SceneAt& scene) {
  const DualResidue omega = scene.at("omega");
  return omega * omega * times_conjugate(scene.contact);
}

/// The square of a formula of products, quotients, roots and absolute values: a number where the
/// formula itself need not be one.
DualResidue square_of(const ex& formula, const NumberAlgebra<DualResidue>& algebra) {
  if (GiNaC::is_a<GiNaC::mul>(formula)) {
    DualResidue product = square_of(formula.op(0), algebra);
    for (std::size_t i = 1; i < formula.nops(); ++i)
      product = product * square_of(formula.op(i), algebra);
    return product;
  }
  if (GiNaC::is_a<GiNaC::power>(formula) && !formula.op(1).info(GiNaC::info_flags::integer))
    return evaluate_rational(GiNaC::pow(formula.op(0), 2 * formula.op(1)), algebra);
  if (GiNaC::is_a<GiNaC::power>(formula)) {
    const ex half = GiNaC::pow(ex(quantity("square")), formula.op(1));
    NumberAlgebra<DualResidue> inner = algebra;
    inner.known[own_name("square")] = square_of(formula.op(0), algebra);
    return evaluate_rational(half, inner);
  }
  if (GiNaC::is_a<GiNaC::function>(formula) &&
      GiNaC::ex_to<GiNaC::function>(formula).get_name() == "abs")
    return times_conjugate(evaluate_rational(formula.op(0), algebra));
  const DualResidue value = evaluate_rational(formula, algebra);
  return value * value;
}

/// Every value of a program that `results` need; bounds, which are estimates, are left out.
class ProgramAt {
 public:
  ProgramAt(const Program& program, const std::vector<NodeId>& results, const SceneAt& scene)
      : program_(program), scene_(scene) {
    for (const NodeId id : program.needed_for(results))
      if (program[id].kind != NodeKind::bound) values_[id] = value(id);
  }
  GaussianResidue operator[](NodeId id) const { return values_.at(id); }
  GaussianResidue operator[](const ComplexNode& z) const {
    return values_.at(z.re) + imaginary_unit * values_.at(z.im);
  }

 private:
  GaussianResidue value(NodeId id) const {
    using Operation = Node::Operation;
    const Node& node = program_[id];
    const auto argument = [&](std::size_t i) { return values_.at(node.arguments[i]); };
    switch (node.operation) {
      case Operation::parameter:
        return scene_.at(to_text(node.parameter)).value;
      case Operation::constant:
        return GaussianResidue(node.constant);
      case Operation::negate:
        return -argument(0);
      case Operation::add:
        return argument(0) + argument(1);
      case Operation::subtract:
        return argument(0) + -argument(1);
      case Operation::multiply:
        return argument(0) * argument(1);
      case Operation::divide:
        return argument(0) * inverse(argument(1));
      case Operation::multiply_add:
        return argument(0) * argument(1) + argument(2);
      case Operation::less_inertia:
        return argument(0) + -(argument(1) * argument(2) * argument(2));
      case Operation::root:
        ensure(argument(0).im == Residue(), "roots are of real numbers");
        return square_root(argument(0).re);
      case Operation::unit:
        return scene_.factor(id);
      case Operation::nonzero:
      case Operation::tied:
      case Operation::magnitude:  // where signs do not count: in squares
        return argument(0);
      case Operation::gap:
      case Operation::tie:  // no element is 0 here
      case Operation::place:
        return {};
      case Operation::entry:
        return scene_.entry(program_[node.arguments[1]].constant.to_int());
      case Operation::size:
      case Operation::unless_moderate:
        break;
    }
    throw Bug("a bound has no residue");
  }

  const Program& program_;
  const SceneAt& scene_;
  std::map<NodeId, GaussianResidue> values_;
};

/// compare: throws Bug for a difference, and NoInverse where it divides by 0.
template <class Compare>
void at_points(const SymbolicModel& model, const FixedNumbers& fixed, const Compare& compare) {
  int compared = 0;
  for (std::uint64_t number = 0; number < points_looked_at && compared < compared_points;
       ++number) {
    try {
      compare(SceneAt(model, fixed, number));
      ++compared;
    } catch (const NoInverse&) {
      continue;
    }
  }
  ensure(compared == compared_points, "a formula is finite at nearly all points");
}

void check(GaussianResidue found, GaussianResidue derived, const char* what) {
  if (found == derived) return;
  throw Bug(fmt::format("{} is not the derived formula: other residues modulo 2^61 - 1", what));
}

/// What is real and positive where residues stand for real numbers, up to the sign.
void check_direction(GaussianResidue found, GaussianResidue derived, const char* what) {
  check((found * conjugate(derived)).im, {}, what);
}

/// Of a network that carries a load at rest.
GaussianResidue stiffness_of_springs(const Network& network, const SceneAt& scene) {
  NumberAlgebra<DualResidue> algebra = scene.algebra();
  return evaluate(reduce(network), algebra).value;
}

}  // namespace

Proof::Proof(const Derivation& derivation, const SymbolValue& value)
    : problem_(derivation.problem), model_(derivation.model) {
  Program program;
  const auto fix = [&](const Symbol& symbol) {
    const Node& node = program[value(program, symbol)];
    if (node.operation == Node::Operation::constant) fixed_[to_text(symbol)] = node.constant;
  };
  for (const Symbol& symbol : *problem_->elements) fix(symbol);
  for (const Quantity& quantity : quantities(problem_)) fix(quantity.symbol);
  const auto* isotropic = std::get_if<Isotropic>(&problem_->tangential);
  if (isotropic == nullptr || !isotropic->quantity.value) return;
  ratio_ = isotropic->quantity.value;
  ratio_name_ = to_text(isotropic->quantity.symbol);
  fixed_[ratio_name_] = exact_binary(*ratio_);
  model_ = std::make_shared<const SymbolicModel>(
      with_isotropic(problem_, {isotropic->by, {isotropic->quantity.symbol, {}}}));
}

// A ratio that is a number is a decimal there.
void Proof::holds(const Derivation& derivation) const {
  FixedNumbers values;
  if (ratio_) values[ratio_name_] = exact_decimal(*ratio_);
  at_points(*model_, values, [&](const SceneAt& scene) {
    NumberAlgebra<DualResidue> algebra = scene.algebra();
    for (const Line& line : derivation.definitions)
      algebra.known[GiNaC::ex_to<GiNaC::symbol>(line.left).get_name()] =
          evaluate_rational(line.right, algebra);
    check(square_of(derivation.critical_velocity, algebra).value, square_of_velocity(scene).value,
          "the printed v*");
  });
}

void Proof::holds(const VelocityProgram& velocity) const {
  at_points(*model_, fixed_, [&](const SceneAt& scene) {
    const ProgramAt at(velocity.program, {velocity.above, velocity.below, velocity.factor}, scene);
    const GaussianResidue ratio = at[velocity.above] * inverse(at[velocity.below]);
    check(at[velocity.factor] * at[velocity.factor] * (velocity.rooted ? ratio : ratio * ratio),
          square_of_velocity(scene).value, "the program of v*");
  });
}

void Proof::holds(const GradientProgram& gradient) const {
  std::vector<NodeId> results{gradient.value};
  for (const auto& [symbol, partial] : gradient.partials) results.push_back(partial);
  at_points(*model_, fixed_, [&](const SceneAt& scene) {
    const ProgramAt at(gradient.program, results, scene);
    const DualResidue square = square_of_velocity(scene);
    const GaussianResidue value = at[gradient.value];
    check(value * value, square.value, "the program of v* and its gradient");
    GaussianResidue change;
    for (const auto& [symbol, partial] : gradient.partials)
      change = change + at[partial] * scene.direction(symbol);
    check(Residue(2) * value * change, square.change, "the gradient's program");
  });
}

void Proof::holds(const QuantityProgram& quantities) const {
  std::vector<NodeId> results;
  const auto add = [&results](const ComplexNode& z) {
    results.push_back(z.re);
    results.push_back(z.im);
  };
  const auto add_oscillation = [&](const OscillationResult& of) {
    results.push_back(of.amplitude);
    add(of.direction);
  };
  add(quantities.normal.k);
  add(quantities.tangential.k);
  if (quantities.drive) add(quantities.drive->k);
  if (quantities.mount) add(quantities.mount->k);
  if (quantities.height) add_oscillation(*quantities.height);
  if (quantities.body) add_oscillation(*quantities.body);
  add_oscillation(quantities.contact_point);
  if (quantities.largest_amplitude) results.push_back(*quantities.largest_amplitude);

  at_points(*model_, fixed_, [&](const SceneAt& scene) {
    const ProgramAt at(quantities.program, results, scene);
    const GaussianResidue normal = scene.stiffness("K_n").value;
    check(at[quantities.normal.k], normal, "K_n");
    check(at[quantities.tangential.k], scene.stiffness("K_t").value, "K_t");
    if (quantities.drive) check(at[quantities.drive->k], scene.stiffness("K_d").value, "K_d");
    const auto compare = [&](const OscillationResult& of, const DualResidue& amplitude,
                             const char* what) {
      check(at[of.amplitude] * at[of.amplitude], times_conjugate(amplitude.value), what);
      check_direction(at[of.direction], amplitude.value, what);
    };
    if (quantities.mount) check(at[quantities.mount->k], scene.stiffness("K_m").value, "K_m");
    if (quantities.height) compare(*quantities.height, scene.height, "the contact's height");
    if (quantities.body) compare(*quantities.body, scene.body, "the body's motion");
    compare(quantities.contact_point, scene.contact, "the contact point's motion");
    if (!quantities.largest_amplitude) return;
    // Of a vibrator, times what is left of it at the contact.
    const GaussianResidue unit = scene.at("du_z").value;
    const GaussianResidue left = scene.height.value * inverse(unit);
    const GaussianResidue largest = at[*quantities.largest_amplitude];
    const auto squared = [&](GaussianResidue amplitude) {
      return amplitude * amplitude * times_conjugate(normal) * times_conjugate(left);
    };
    if (problem_->load) {  // W/|K_n|
      const GaussianResidue given = scene.at(to_text(problem_->load->symbol)).value;
      return check(squared(largest), given * given, "the largest amplitude");
    }
    // u_z0 K_n(0)/|K_n|
    const auto springs = springs_alone(problem_->normal.network());
    ensure(springs.has_value(), "what has a largest amplitude carries a load");
    const GaussianResidue load = scene.at("u_z0").value * stiffness_of_springs(*springs, scene);
    check(squared(largest), load * load, "the largest amplitude");
  });
}

}  // namespace vcrit::symbolic
