#include "program/quantities.hpp"

#include <cmath>

#include "critical/eq24.hpp"
#include "formula/symbols.hpp"
#include "network/graph.hpp"
#include "program/drive_tree.hpp"
#include "program/measured_drive.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::symbolic {

namespace {

constexpr int element_exponent = 64;
// Squares of T and Q stay far within the doubles.
constexpr double largest_part = 400;

ComplexNode times(Program& program, const ComplexNode& a, const ComplexNode& b) {
  return sum_of_products(program, {{a, b}}).value;
}

ComplexNode conjugate(Program& program, const ComplexNode& z) {
  return {z.re, program.negate(z.im)};
}

ComplexNode complex_sum(Program& program, const ComplexNode& a, const ComplexNode& b) {
  return {program.add(a.re, b.re), program.add(a.im, b.im)};
}

/// |z|; without a root where one part is 0.
NodeId modulus(Program& program, const ComplexNode& z) {
  if (program.is_constant(z.im, 0)) return program.magnitude(z.re);
  if (program.is_constant(z.re, 0)) return program.magnitude(z.im);
  return program.root(square(program, z));
}

/// An oscillation over another one: |z|, and a number with the argument of z.
struct PointResponse {
  NodeId amplitude;
  ComplexNode direction;
};

/// The contact point's oscillation over du_z is Eq. (24) without moduli: its algebra in eq24.hpp.
class QuantityWriter {
 public:
  QuantityWriter(const Problem& problem, const SymbolValue& value)
      : problem_(problem),
        value_(value),
        omega_(symbol({"omega"})),
        stiffness_(program_, omega_, element_exponent,
                   [this](const Symbol& s) { return symbol(s); }) {}

  QuantityProgram write() {
    result_.normal = network(problem_->normal.network());
    write_tangential();
    std::visit([this](const auto& drive) { this->write_drive(drive); }, problem_->drive);
    friction_ = program_.multiply(symbol({"mu0"}), symbol({"du_z"}));
    if (result_.drive) dynamic_ = dynamic_stiffness();
    if (problem_->mount) write_mount();
    if (problem_->mass) result_.body = body();
    result_.contact_point = contact_point();
    result_.largest_amplitude = largest_amplitude();
    result_.program = std::move(program_);
    return std::move(result_);
  }

  PointResponse outer() { return {program_.constant(1), real(program_, program_.constant(1))}; }
  void times_mount(PointResponse& z, const ComplexNode&, const ReducedNetwork&) {
    times_quotient(z, result_.mount->k, *mounted_);
  }
  NodeId ratio(const Isotropic&) const { return *ratio_; }
  const ComplexNode& normal() const { return result_.normal.k; }
  const ComplexNode& tangential(const ReducedNetwork&) const { return result_.tangential.k; }
  const ComplexNode& scaled(NodeId, const ComplexNode&) const { return result_.tangential.k; }
  /// By a number above 0.
  void divide(PointResponse& z, NodeId ratio) {
    z.amplitude = program_.divide(z.amplitude, program_.magnitude(ratio));
  }
  void times_quotient(PointResponse& z, const ComplexNode& above, const ComplexNode& below) {
    z.amplitude = program_.multiply(
        z.amplitude, program_.divide(modulus(program_, above), modulus(program_, below)));
    z.direction = times(program_, z.direction, times(program_, above, conjugate(program_, below)));
  }
  /// (K_t + D)/D, and with D/Q in the place of D where that may be infinite.
  void times_drive(PointResponse& z, const ComplexNode& tangential, const auto& /*drive*/) {
    const ComplexNode contact = pair_ ? times(program_, tangential, pair_->q) : tangential;
    times_quotient(z, complex_sum(program_, contact, *dynamic_), *dynamic_);
  }

 private:
  NodeId symbol(const Symbol& s) { return value_(program_, s); }

  StiffnessResult network(const Network& network) {
    Stiffness k = stiffness_.write(network);
    const auto fits = [](const ExponentRange& range) {
      return range.low > -largest_part && range.high < largest_part;
    };
    if (!fits(k.t_range) || !fits(k.q_range)) k = stiffness_.normalised(k);
    StiffnessResult result{quotient(k.t, k.q), std::nullopt, k.exact_re};
    // Besides T and Q: the two products of T conj(Q), 2 sqrt(2), their sum |Q|^2, 2, the quotient.
    const double known = 1.4143 * k.path + (is_one(program_, k.q) ? 0 : 6);
    if (!k.roundings) result.roundings = static_cast<int>(std::ceil(1.01 * known));
    return result;
  }

  ComplexNode quotient(const ComplexNode& t, const ComplexNode& q) {
    if (is_one(program_, q)) return t;
    const ComplexNode above = times(program_, t, conjugate(program_, q));
    const NodeId below = square(program_, q);
    return {program_.divide(above.re, below), program_.divide(above.im, below)};
  }

  void write_tangential() {
    const auto* isotropic = std::get_if<Isotropic>(&problem_->tangential);
    if (isotropic == nullptr) {
      result_.tangential = network(std::get<ReducedNetwork>(problem_->tangential).network());
      return;
    }
    ratio_ = number_of(*isotropic);
    result_.tangential = {real_multiple(program_, *ratio_, result_.normal.k),
                          result_.normal.roundings, false};
    // 1 - nu, 2 - nu, their quotient, and its product with K_n.
    if (result_.tangential.roundings) *result_.tangential.roundings += 4;
  }

  NodeId number_of(const Isotropic& isotropic) {
    const auto& given = isotropic.quantity;
    const NodeId number =
        given.value ? program_.constant(exact_binary(*given.value)) : symbol(given.symbol);
    if (isotropic.by == Isotropic::By::ratio) return number;
    const NodeId two = program_.constant(2);
    const NodeId one_less = program_.subtract(program_.constant(1), number);
    return program_.divide(program_.multiply(two, one_less), program_.subtract(two, number));
  }

  static void write_drive(const Rigid&) {}
  void write_drive(const ReducedNetwork& drive) {
    if (!rules::drive_resonates(problem_)) {
      result_.drive = network(drive.network());
      return;
    }
    PairWriter writer(program_, omega_, stiffness_, Zeros::out_of_range);
    const DrivePair pair = drive_pair(program_, writer, drive.network());
    const auto fits = [](const ExponentRange& range) {
      return range.low > -largest_part && range.high < largest_part;
    };
    write_pair(fits(pair.t_range) && fits(pair.q_range) ? pair : writer.normalised(pair));
  }
  void write_drive(const Receptance& drive) { write_pair(measured_pair(program_, omega_, drive)); }
  /// How much of K_d cancels is not known before the code runs.
  void write_pair(const DrivePair& pair) {
    pair_ = pair;
    result_.drive = {quotient(pair.t, pair.q), std::nullopt, false, true};
  }

  /// K_d - m omega^2, times Q of a drive that is a pair.
  ComplexNode dynamic_stiffness() {
    if (pair_) return dynamic_pair();
    return less_inertia(result_.drive->k, problem_->mass, result_.drive->exact_re);
  }

  ComplexNode less_inertia(const ComplexNode& k, const std::optional<Quantity>& mass,
                           bool exact_re) {
    if (!mass) return k;
    const NodeId m = symbol(mass->symbol);
    if (exact_re) return {program_.less_inertia(k.re, m, omega_), k.im};
    const NodeId inertia = program_.multiply(program_.multiply(m, omega_), omega_);
    return {program_.subtract(k.re, inertia), k.im};
  }

  ComplexNode dynamic_pair() {
    if (!problem_->mass) return pair_->t;
    const NodeId m = symbol(problem_->mass->symbol);
    const NodeId inertia = program_.multiply(program_.multiply(m, omega_), omega_);
    const ComplexNode less = real(program_, program_.negate(inertia));
    const ComplexNode one = real(program_, program_.constant(1));
    return sum_of_products(program_, {{pair_->t, one}, {pair_->q, less}}).value;
  }

  /// K_m, K_m + K_n - m_n omega^2, and the contact's height over the vibrator's.
  void write_mount() {
    result_.mount = network(problem_->mount->network());
    const ComplexNode sum = complex_sum(program_, result_.mount->k, result_.normal.k);
    mounted_ = less_inertia(sum, problem_->mount_mass, false);
    PointResponse z = outer();
    times_quotient(z, result_.mount->k, *mounted_);
    result_.height = {program_.multiply(symbol({"du_z"}), z.amplitude), z.direction};
  }

  OscillationResult body() {
    const ComplexNode k = pair_ ? times(program_, result_.normal.k, pair_->q) : result_.normal.k;
    const NodeId ratio = program_.divide(modulus(program_, k), modulus(program_, *dynamic_));
    PointResponse z{ratio, times(program_, k, conjugate(program_, *dynamic_))};
    if (problem_->mount) times_quotient(z, result_.mount->k, *mounted_);
    return {program_.multiply(friction_, z.amplitude), against(z.direction)};
  }

  OscillationResult contact_point() {
    const PointResponse z = eq24(problem_, *this);
    return {program_.multiply(friction_, z.amplitude), against(z.direction)};
  }

  /// Friction acts against the sliding.
  ComplexNode against(const ComplexNode& z) {
    return {program_.negate(z.re), program_.negate(z.im)};
  }

  /// (3) and (4): u_z0 K_n(0)/|K_n(i omega)|, at most u_z0; K_n(0) <= |K_n| as no part of a
  /// network of springs and dampers grows softer with the frequency.
  /// Under a load W/|K_n|; below an indenter no formula says what u_z0 that leads to.
  std::optional<NodeId> largest_amplitude() {
    if (problem_->load && problem_->indenter) return std::nullopt;
    if (problem_->load)
      return of_vibrator(
          program_.divide(symbol(problem_->load->symbol), modulus(program_, result_.normal.k)));
    const std::optional<Network> at_rest = springs_alone(problem_->normal.network());
    if (!at_rest) return std::nullopt;
    const ComplexNode k = network(*at_rest).k;
    const NodeId share = program_.divide(k.re, modulus(program_, result_.normal.k));
    return of_vibrator(program_.multiply(symbol({"u_z0"}), share));
  }

  /// The amplitude of the vibrator that is so large at the contact.
  NodeId of_vibrator(NodeId amplitude) {
    if (!problem_->mount) return amplitude;
    return program_.multiply(amplitude, program_.divide(modulus(program_, *mounted_),
                                                        modulus(program_, result_.mount->k)));
  }

  Problem problem_;
  const SymbolValue& value_;
  Program program_;
  NodeId omega_;
  StiffnessWriter stiffness_;
  NodeId friction_ = 0;
  std::optional<NodeId> ratio_;
  std::optional<ComplexNode> dynamic_, mounted_;
  std::optional<DrivePair> pair_;  ///< of a drive with masses, or measured
  QuantityProgram result_;
};

}  // namespace

QuantityProgram quantity_program(const Problem& problem, const SymbolValue& value) {
  rules::require(rules::Question::evaluator, problem);
  return QuantityWriter(problem, value).write();
}

}  // namespace vcrit::symbolic
