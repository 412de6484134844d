#include "program/sweep.hpp"

#include <cmath>
#include <set>
#include <vector>

#include "critical/eq24.hpp"
#include "program/quotient.hpp"
#include "rules/kinds.hpp"

namespace vcrit::symbolic {

namespace {

// Degree 10 and degree 5.
constexpr std::size_t longest_polynomial = 11, longest_square = 6;
constexpr int guard_exponent = 40;
// Coefficients are scaled for 20 kHz, and good for 2^8 times less or more.
constexpr int usual_omega = 17, octaves = 8;

/// Writes Eq. (24) down: an algebra of eq24.hpp.
class SweepWriter {
  /// A factor of v*: a polynomial, or its value at omega where it is not multiplied out.
  struct Factor {
    ComplexNode polynomial, value;
    ExponentRange range;
    bool is_passive = true;  ///< roots real and negative
  };

  /// v*/(mu0 omega du_z) as |above|/|below|, and Q_t, which is above where no N takes its place.
  struct Velocity {
    std::vector<Factor> above, below;
    std::optional<Stiffness> of_q_t = {};
  };

  /// K_t = T/Q. Of r K_n the Q_n alone stands below where there is an N: the ratio's is in it.
  struct Tangential {
    Stiffness k;
    std::optional<Stiffness> normal = {};
  };

 public:
  SweepWriter(const Problem& problem, const SymbolValue& value, bool normalised)
      : problem_(problem),
        value_(value),
        normalised_(normalised),
        omega_(symbol({"omega"})),
        square_(program_.multiply(omega_, omega_)),
        stiffness_(program_, omega_, guard_exponent,
                   [this](const Symbol& s) { return symbol(s); }) {
    result_.exponent = guard_exponent;
    result_.least_omega = normalised ? usual_omega - octaves : -24;
    // Stiffnesses in N/m and their products are large numbers.
    result_.least_square = normalised ? -512 : -124;
  }

  SweepProgram write() {
    normal_ = network(problem_->normal.network());  // first: the order of the code's lines
    return finished(eq24(problem_, *this));
  }

  static Velocity outer() { return {}; }
  Ratio ratio(const Isotropic& isotropic) {
    return contact_ratio(program_, stiffness_, isotropic, value_);
  }
  const Stiffness& normal() const { return normal_; }
  Tangential tangential(const ReducedNetwork& own) { return {network(own.network())}; }

  Tangential scaled(const Ratio& ratio, const Stiffness& n) {
    Stiffness t = n;
    t.t = times(ratio.t, n.t);
    t.q = times(ratio.q, n.q);
    t.t_range = n.t_range + ratio.t_range;
    t.q_range = n.q_range + ratio.q_range;
    return {t, n};
  }

  void times_mount(Velocity& v, const Stiffness& n, const ReducedNetwork& mount) {
    const Stiffness m = network(mount.network());
    const Factor body = loaded(m, problem_->mount_mass);
    v.above.push_back(passive(m.t, m.t_range));
    v.above.push_back(passive(n.q, n.q_range));
    v.below.push_back(sum(n, m, body, problem_->mount_mass));
  }

  /// The ratio's Q cancels with a drive. Without one nothing but mu0 omega du_z depends on omega,
  /// and the mount.
  void divide(Velocity& v, const Ratio& ratio) {
    v.below.push_back(passive(polynomial({ratio.t}), ratio.t_range));
    if (problem_->drive_network() != nullptr) return;
    result_.fits = result_.fits && problem_->mount.has_value();
    v.above.push_back(passive(polynomial({ratio.q}), ratio.q_range));
  }

  void times_quotient(Velocity& v, const Stiffness& n, const Tangential& t) {
    v.above.push_back(passive(n.t, n.t_range));
    divide_by(v.above, v.below, passive(n.q, n.q_range));
    v.below.push_back(passive(t.k.t, t.k.t_range));
    v.of_q_t = t.k;
  }

  /// Polynomials whose terms add up to little more than they do are of springs and dampers alone.
  void times_drive(Velocity& v, const Tangential& t, const ReducedNetwork& drive) {
    if (rules::drive_resonates(problem_)) return leave_out();
    const Stiffness d = network(drive.network());
    const Factor body = loaded(d, problem_->mass);
    v.above.push_back(sum(t.k, d, body, problem_->mass));
    if (t.normal) divide_by(v.above, v.below, passive(t.normal->q, t.normal->q_range));
    v.below.push_back(body);
    v.of_q_t.reset();
  }
  void times_drive(Velocity&, const Tangential&, const Receptance&) { leave_out(); }

 private:
  NodeId symbol(const Symbol& s) { return value_(program_, s); }
  void leave_out() { result_.fits = false; }

  Stiffness network(const Network& network) {
    const auto k = stiffness_.write_polynomials(network, longest_polynomial);
    if (!k) {
      result_.fits = false;
      return {};
    }
    // Where it does not fit, powers of the usual omega need not be doubles either.
    const bool scaled = result_.fits && normalised_ && !is_one(program_, k->q);
    return scaled ? scaled_at_usual_omega(*k) : *k;
  }

  static bool is_short(const ComplexNode& z) { return z.coefficients.size() <= longest_polynomial; }

  Stiffness scaled_at_usual_omega(Stiffness k) {
    NodeId size = program_.constant(0);
    for (const ComplexNode* z : {&k.t, &k.q})
      for (std::size_t j = 0; j < z->coefficients.size(); ++j)
        size = program_.multiply_add(
            z->coefficients[j],
            program_.constant(GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(usual_omega * j))),
            size);
    const NodeId unit = program_.unit(size);
    const auto range = [](const ComplexNode& z, double low) {
      const double extent = octaves * static_cast<double>(z.coefficients.size() - 1);
      return ExponentRange{low - 3 - extent, 2 + extent};
    };
    k.t_range = range(k.t, std::min(k.range.low, 0.0));
    k.q_range = range(k.q, -std::max(k.range.high, 0.0));
    k.t = times(unit, k.t);
    k.q = times(unit, k.q);
    return k;
  }

  ComplexNode times(NodeId factor, ComplexNode z) {
    for (NodeId& each : z.coefficients) each = program_.multiply(factor, each);
    return z;
  }

  Factor passive(const ComplexNode& z, ExponentRange range) {
    return {z, at(program_, z, omega_), range, true};
  }

  /// D
  Factor loaded(const Stiffness& d, const std::optional<Quantity>& mass) {
    if (!mass) return passive(d.t, d.t_range);
    const NodeId m = symbol(mass->symbol);
    const ExponentRange inertia = stiffness_.guarded(program_.size(m));
    Factor result;
    result.is_passive = false;
    result.range = {std::max(d.t_range.low, d.q_range.low + inertia.low) - cancellation,
                    std::max(d.t_range.high, d.q_range.high + inertia.high) + 1};
    const ComplexNode t = at(program_, d.t, omega_);
    if (is_one(program_, d.q) && program_[t.re].kind == NodeKind::exact) {
      result.value = {program_.less_inertia(t.re, m, omega_), t.im};
      return result;
    }
    const NodeId zero = program_.constant(0), one = program_.constant(1);
    const ComplexNode whole =
        sum_of_products(program_, {{d.t, polynomial({one})}, {d.q, polynomial({zero, zero, m})}})
            .value;
    if (is_short(whole)) return as_polynomial(result, whole);
    const ComplexNode less{program_.negate(program_.multiply(m, square_)), zero};
    result.value =
        sum_of_products(program_, {{t, {one, zero}}, {at(program_, d.q, omega_), less}}).value;
    return result;
  }

  Factor as_polynomial(Factor factor, const ComplexNode& z) {
    factor.polynomial = z;
    factor.value = at(program_, z, omega_);
    return factor;
  }

  /// N
  Factor sum(const Stiffness& t, const Stiffness& d, const Factor& body,
             const std::optional<Quantity>& mass) {
    const ExponentRange first = t.t_range + d.q_range, second = t.q_range + body.range;
    check(first);
    check(second);
    Factor result;
    result.is_passive = !mass;
    result.range = {std::max(first.low, second.low) - (mass ? cancellation : 1),
                    std::max(first.high, second.high) + 1};
    if (!body.polynomial.coefficients.empty()) {
      const ComplexNode whole =
          sum_of_products(program_, {{t.t, d.q}, {t.q, body.polynomial}}).value;
      if (is_short(whole)) return as_polynomial(result, whole);
    }
    result.value =
        sum_of_products(program_, {{at(program_, t.t, omega_), at(program_, d.q, omega_)},
                                   {at(program_, t.q, omega_), body.value}})
            .value;
    return result;
  }

  void check(ExponentRange range) { result_.fits = result_.fits && fits(range); }

  /// |T|^2
  NodeId squared(const Factor& factor) {
    const std::vector<NodeId>& a = factor.polynomial.coefficients;
    if (!factor.is_passive || a.empty() || a.size() > longest_square)
      return square(program_, factor.value);
    NodeId whole = program_.constant(0);
    for (std::size_t k = a.size(); k-- > 0;)
      whole = program_.multiply_add(square_, whole, square_coefficient(a, k));
    return whole;
  }

  NodeId square_coefficient(const std::vector<NodeId>& a, std::size_t k) {
    NodeId sum = program_.multiply(a[k], a[k]);
    for (std::size_t i = 1; i <= k && k + i < a.size(); ++i) {
      const NodeId sign = program_.constant(i % 2 == 0 ? 2 : -2);
      sum = program_.multiply_add(program_.multiply(sign, a[k - i]), a[k + i], sum);
    }
    return sum;
  }

  NodeId product(const std::vector<Factor>& factors) {
    NodeId whole = program_.constant(1);
    ExponentRange range;
    for (const Factor& factor : factors) {
      check(twice(factor.range));
      check(range = range + twice(factor.range));
      whole = program_.multiply(whole, squared(factor));
    }
    return whole;
  }

  SweepProgram finished(Velocity v) {
    if (v.of_q_t) v.above.push_back(passive(v.of_q_t->q, v.of_q_t->q_range));
    result_.rooted = true;
    if (result_.fits) {
      result_.above = product(v.above);
      result_.below = product(v.below);
    }
    const NodeId mu0 = symbol({"mu0"}), du_z = symbol({"du_z"});
    for (const NodeId id : {mu0, du_z}) stiffness_.guarded(program_.size(id));
    result_.factor = program_.multiply(program_.multiply(mu0, du_z), omega_);
    result_.guards = stiffness_.guards();
    result_.program = std::move(program_);
    return std::move(result_);
  }

  Problem problem_;
  const SymbolValue& value_;
  bool normalised_;
  Program program_;
  NodeId omega_, square_;
  StiffnessWriter stiffness_;
  Stiffness normal_;
  SweepProgram result_;
};

// Operations by which omega and the result are found to be of ordinary size.
constexpr int checks = 8;

/// Operations that depend on omega.
int operations_at_each_omega(const VelocityProgram& velocity) {
  const Program& program = velocity.program;
  std::set<NodeId> varying;
  for (const NodeId id : program.needed_for({velocity.above, velocity.below, velocity.factor})) {
    const Node& node = program[id];
    bool varies = node.operation == Node::Operation::parameter && node.parameter.name == "omega";
    for (std::size_t i = 0; i < arity(node.operation); ++i)
      varies = varies || varying.contains(node.arguments[i]);
    if (varies) varying.insert(id);
  }
  return program.operations(varying);
}

}  // namespace

std::optional<SweepProgram> sweep_program(const Problem& problem, const SymbolValue& value,
                                          const VelocityProgram& single) {
  const int others = operations_at_each_omega(single);
  for (const bool normalised : {false, true}) {
    SweepProgram program = SweepWriter(problem, value, normalised).write();
    if (program.fits && operations_at_each_omega(program) + checks < others) return program;
  }
  return std::nullopt;
}

}  // namespace vcrit::symbolic
