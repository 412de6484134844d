#include "program/velocity.hpp"

#include <cmath>
#include <utility>

#include "critical/eq24.hpp"
#include "program/drive_tree.hpp"
#include "program/measured_drive.hpp"
#include "program/quotient.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::symbolic {

namespace {

// less_inertia subtracts exactly: 53 digits of each of three factors.
constexpr double exact_cancellation = 160;

/// |z| of it, and where |z| lies.
struct Factor {
  ComplexNode value;
  ExponentRange range;
};

/// v*/(mu0 omega du_z) as |above|/|below|, and what its relative error is made of.
struct Velocity {
  std::vector<Factor> above, below;
  int ratio_path = 0;
  std::vector<Stiffness> quotient;  ///< K_n and K_t
  std::optional<NodeId> drive_errors, mount_errors;
};

/// K_t = T/Q. Where v is divided by |K_t|, Q stands above; but of r K_n only the ratio's part.
struct Tangential {
  Stiffness k;
  std::optional<Factor> more_of_q;
};

/// Writes Eq. (24) down: an algebra of eq24.hpp.
class VelocityWriter {
 public:
  /// scaled: normalised, and so are the factors of v* whose product would leave the range.
  enum class Form { plain, normalised, scaled };

  VelocityWriter(const Problem& problem, const SymbolValue& value, int exponent, Form form,
                 Zeros zeros)
      : problem_(problem),
        value_(value),
        form_(form),
        zeros_(zeros),
        omega_(symbol({"omega"})),
        stiffness_(
            program_, omega_, exponent, [this](const Symbol& s) { return symbol(s); }, zeros) {
    result_.exponent = exponent;
  }

  VelocityProgram write() {
    finish(eq24(problem_, *this));
    result_.program = std::move(program_);
    return std::move(result_);
  }

  static Velocity outer() { return {}; }

  Ratio ratio(const Isotropic& isotropic) {
    const Symbol& given = isotropic.quantity.symbol;
    const Ratio ratio = contact_ratio(program_, stiffness_, isotropic, value_);
    if (isotropic.by == Isotropic::By::poisson && !isotropic.quantity.value &&
        program_[symbol(given)].operation == Node::Operation::parameter)
      result_.poisson = given;
    return ratio;
  }

  Stiffness normal() { return contact(problem_->normal.network()); }
  Tangential tangential(const ReducedNetwork& own) { return {contact(own.network()), {}}; }

  /// T and Q each times a number.
  Tangential scaled(const Ratio& ratio, const Stiffness& normal) {
    Stiffness k = normal;
    k.t = real_multiple(program_, ratio.t, normal.t);
    k.q = real_multiple(program_, ratio.q, normal.q);
    k.t_range = normal.t_range + ratio.t_range;
    k.range = normal.range + ratio.range;
    k.q_range = normal.q_range + ratio.q_range;
    k.path += ratio.path + 2;
    k.exact_re = false;
    return {k, Factor{normal.q, normal.q_range}};
  }

  /// |K_m|/|K_m + K_n - m_n omega^2| = |T_m| |Q_n|/|N|, with D and N as of a drive K_m under a
  /// mass.
  void times_mount(Velocity& v, const Stiffness& normal, const ReducedNetwork& mount) {
    const Stiffness m = contact(mount.network());
    const std::optional<Quantity>& mass = problem_->mount_mass;
    Difference body{m.t, m.t_range, 0};
    if (mass) body = difference(m, mass->symbol);
    const ComplexSum whole = sum_of_products(program_, {{normal.t, m.q}, {normal.q, body.value}});
    ExponentRange range =
        sum_range(normal.t_range + m.q_range, normal.q_range + body.range, Zeros::out_of_range);
    range.low -= mass ? cancellation : 1;
    check(normal.t_range + m.q_range);
    check(normal.q_range + body.range);
    v.above.insert(v.above.end(), {{m.t, m.t_range}, {normal.q, normal.q_range}});
    v.below.push_back({whole.value, range});
    const int local = static_cast<int>(std::ceil(1.4143 * whole.roundings));
    const NodeId sum =
        mass ? one_and_a_half(error_of_sum(normal, m, body.error, size_bound(program_, body.value),
                                           whole, local))
             : error_of_passive_sum(normal, m, local);
    v.mount_errors = program_.add(sum, roundings(program_, m));
  }

  void divide(Velocity& v, const Ratio& ratio) {
    v.above.push_back({real(program_, ratio.q), ratio.q_range});
    v.below.push_back({real(program_, ratio.t), ratio.t_range});
    v.ratio_path = ratio.path;
  }

  static void times_quotient(Velocity& v, const Stiffness& n, const Tangential& t) {
    divide_by(v.above, v.below, {n.q, n.q_range});
    v.above.insert(v.above.end(), {{n.t, n.t_range}, {t.k.q, t.k.q_range}});
    v.below.push_back({t.k.t, t.k.t_range});
    v.quotient = {n, t.k};
  }

  /// |K_t + D|/|D| = |N|/(|Q_t| |D|), D and N as in velocity.hpp.
  void times_drive(Velocity& v, const Tangential& tangential, const ReducedNetwork& drive) {
    if (rules::drive_resonates(problem_))
      return times_pair(v, tangential, with_masses(drive.network()));
    const Stiffness& t = tangential.k;
    const Stiffness d = network(drive.network());
    Difference body{d.t, d.t_range, 0};
    if (problem_->mass) body = difference(d, problem_->mass->symbol);
    const ComplexSum whole = sum_of_products(program_, {{t.t, d.q}, {t.q, body.value}});
    // K_t = 0 is a pole, which no range has to hold.
    ExponentRange range =
        sum_range(t.t_range + d.q_range, t.q_range + body.range, Zeros::out_of_range);
    range.low -= problem_->mass ? cancellation : 1;
    check(t.t_range + d.q_range);
    check(t.q_range + body.range);
    v.above.back() = {whole.value, range};  // in the place of Q_t
    if (tangential.more_of_q) divide_by(v.above, v.below, *tangential.more_of_q);
    v.below.push_back({body.value, body.range});
    v.drive_errors = with_drive_errors(t, d, body, whole);
  }
  void times_drive(Velocity& v, const Tangential& tangential, const Receptance& drive) {
    times_pair(v, tangential, measured_pair(program_, omega_, drive));
  }

 private:
  NodeId symbol(const Symbol& s) { return value_(program_, s); }

  DrivePair with_masses(const Network& drive) {
    PairWriter writer(program_, omega_, stiffness_, zeros_);
    const DrivePair pair = drive_pair(program_, writer, drive);
    return form_ != Form::plain ? writer.normalised(pair) : pair;
  }

  void times_pair(Velocity& v, const Tangential& tangential, const DrivePair& drive) {
    std::optional<NodeId> mass;
    if (problem_->mass) mass = symbol(problem_->mass->symbol);
    const PairBalance balance =
        balance_of(program_, stiffness_, drive, tangential.k, mass, omega_, zeros_);
    result_.fits = result_.fits && balance.fits;
    v.above.back() = {balance.n, balance.n_range};  // in the place of Q_t
    if (tangential.more_of_q) divide_by(v.above, v.below, *tangential.more_of_q);
    v.below.push_back({balance.d, balance.d_range});
    v.drive_errors = balance.errors;
  }

  Stiffness network(const Network& network) {
    const Stiffness k = stiffness_.write(network);
    return form_ != Form::plain && !is_one(program_, k.q) ? stiffness_.normalised(k) : k;
  }

  /// K_n and K_t: where they are 0, v* is none.
  Stiffness contact(const Network& of) {
    Stiffness k = network(of);
    k.q_range = quotient_range(k.t_range, k.range, k.q_range, Zeros::out_of_range);
    return k;
  }

  NodeId number(int value) { return program_.constant(value); }
  NodeId number_of_exponent(double exponent) {
    return program_.constant(
        GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(static_cast<int>(exponent))));
  }
  NodeId times(int count, NodeId bound) { return program_.multiply(number(count), bound); }
  NodeId one_and_a_half(NodeId bound) {
    return program_.multiply(program_.constant(GiNaC::numeric(3, 2)), bound);
  }

  /// D with a bound of |error| in roundings, absolute.
  struct Difference {
    ComplexNode value;
    ExponentRange range;
    NodeId error = 0;
  };

  Difference difference(const Stiffness& d, const Symbol& mass) {
    const NodeId m = symbol(mass);
    const NodeId inertia_size = program_.multiply(
        program_.multiply(program_.size(m), program_.size(omega_)), program_.size(omega_));
    const ExponentRange inertia = stiffness_.guarded(inertia_size);
    Difference result;
    const ExponentRange sum_of_both = sum_range(d.t_range, d.q_range + inertia, zeros_);
    if (d.exact_re) {
      result.value = {program_.less_inertia(d.t.re, m, omega_), d.t.im};
      // Both components nearly exact, but for what the parts of m omega^2 below three doubles'
      // digits can do: far less than 2^-50 of it.
      const NodeId tail =
          program_.multiply(program_.constant(GiNaC::numeric(1, 1L << 50)), inertia_size);
      result.error =
          program_.add(times(std::max(3, d.path), size_bound(program_, result.value)), tail);
      result.range = {sum_of_both.low - exact_cancellation, sum_of_both.high};
      return result;
    }
    const NodeId inertia_value = program_.multiply(program_.multiply(m, omega_), omega_);
    const ComplexNode less = real(program_, program_.negate(inertia_value));
    const ComplexNode unity = real(program_, number(1));
    const ComplexSum sum = sum_of_products(program_, {{d.t, unity}, {d.q, less}});
    result.value = sum.value;
    const int local = static_cast<int>(std::ceil(1.4143 * sum.roundings));
    // m omega^2 itself errs by two roundings.
    result.error =
        program_.add(program_.multiply(program_.add(roundings(program_, d), number(local)),
                                       size_bound(program_, d.t)),
                     times(local + 2, program_.multiply(inertia_size, size_bound(program_, d.q))));
    result.range = {sum_of_both.low - cancellation, sum_of_both.high};
    return result;
  }

  // Relative errors of D and N, where |z| >= size_bound(z)/sqrt(2).
  NodeId with_drive_errors(const Stiffness& t, const Stiffness& d, const Difference& body,
                           const ComplexSum& whole) {
    const int local = static_cast<int>(std::ceil(1.4143 * whole.roundings));
    if (!problem_->mass) {
      const NodeId sum = error_of_passive_sum(t, d, local);
      return program_.add(sum, roundings(program_, d));
    }
    const NodeId d_size = size_bound(program_, body.value);
    const NodeId d_error = program_.divide(body.error, d_size);
    return one_and_a_half(
        program_.add(d_error, error_of_sum(t, d, body.error, d_size, whole, local)));
  }

  // K_t + K_d, both in the first quadrant.
  NodeId error_of_passive_sum(const Stiffness& t, const Stiffness& d, int local) {
    return program_.add(
        one_and_a_half(program_.add(roundings(program_, t), roundings(program_, d))),
        number(2 * local));
  }

  // Relative, of N, by sizes.
  NodeId error_of_sum(const Stiffness& t, const Stiffness& d, NodeId body_error, NodeId d_size,
                      const ComplexSum& whole, int local) {
    const NodeId t_part =
        program_.multiply(program_.add(roundings(program_, t), number(local)),
                          program_.multiply(size_bound(program_, t.t), size_bound(program_, d.q)));
    const NodeId d_part = program_.multiply(program_.add(body_error, times(local, d_size)),
                                            size_bound(program_, t.q));
    return program_.divide(program_.add(t_part, d_part), size_bound(program_, whole.value));
  }

  NodeId errors_of(const Velocity& v) {
    const NodeId contact = v.quotient.empty()
                               ? number(v.ratio_path)
                               : program_.add(roundings(program_, v.quotient.front()),
                                              roundings(program_, v.quotient.back()));
    const NodeId joined = v.drive_errors ? program_.add(*v.drive_errors, contact) : contact;
    return v.mount_errors ? program_.add(*v.mount_errors, joined) : joined;
  }

  void check(ExponentRange range) { result_.fits = result_.fits && fits(range); }

  /// A product of absolute values, or of their squares.
  struct Product {
    NodeId value;
    ExponentRange range = {};
  };

  ExponentRange range_of(const Factor& factor) const {
    return result_.rooted ? twice(factor.range) : factor.range;
  }

  void multiply(Product& whole, const Factor& factor) {
    const ComplexNode& z = factor.value;
    const bool is_real = program_.is_constant(z.im, 0);
    const NodeId one =
        result_.rooted ? square(program_, z) : program_.magnitude(is_real ? z.re : z.im);
    whole = {program_.multiply(whole.value, one), whole.range + range_of(factor)};
    check(range_of(factor));
    check(whole.range);
  }

  /// Brings the factor near 1 by a power of two, which it returns.
  Factor scaled_by_unit(Factor& factor) {
    // At a resonance the factor is 0: without the first term its unit would leave the range.
    const double least = std::floor(factor.range.low) - 2;
    NodeId size = number_of_exponent(least);
    for (const NodeId part : {factor.value.re, factor.value.im})
      if (!program_.is_constant(part, 0)) size = program_.add(size, program_.magnitude(part));
    const NodeId unit = program_.unit(size);
    const ExponentRange range{-factor.range.high - 2, -least};
    factor = {real_multiple(program_, unit, factor.value), {-1, 1}};
    return {real(program_, unit), range};
  }

  /// Multiplies `whole`; of a factor with which that would leave the range, the power of two goes
  /// to the other side of the line.
  void multiply(Product& whole, Factor factor, Product& other) {
    if (form_ == Form::scaled && !fits(whole.range + range_of(factor)))
      multiply(other, scaled_by_unit(factor));
    multiply(whole, factor);
  }

  void write_quotient(const Velocity& v) {
    Product above{number(1)}, below{number(1)};
    for (const Factor& factor : v.above) multiply(above, factor, below);
    for (const Factor& factor : v.below) multiply(below, factor, above);
    result_.above = above.value;
    result_.below = below.value;
  }

  void finish(const Velocity& v) {
    const NodeId errors = errors_of(v);
    const auto has_both = [this](const Factor& factor) {
      const ComplexNode& z = factor.value;
      return !program_.is_constant(z.re, 0) && !program_.is_constant(z.im, 0);
    };
    result_.rooted = std::any_of(v.above.begin(), v.above.end(), has_both) ||
                     std::any_of(v.below.begin(), v.below.end(), has_both);
    write_quotient(v);
    for (const char* name : {"mu0", "du_z", "omega"}) guard_factor({name});
    result_.factor =
        program_.multiply(program_.multiply(symbol({"mu0"}), omega_), symbol({"du_z"}));
    result_.guards.insert(result_.guards.end(), stiffness_.guards().begin(),
                          stiffness_.guards().end());
    // Each square 2 and its product 1, the quotient 1, all halved by the root, itself 1; mu0 omega
    // du_z and its product 3.
    const int count = static_cast<int>(v.above.size() + v.below.size());
    const int last = result_.rooted ? (3 * count + 2) / 2 + 1 + 3 : count + 1 + 3;
    result_.roundings = program_.add(errors, number(last));
  }

  void guard_factor(const Symbol& s) {
    const NodeId size = program_.size(symbol(s));
    if (program_[size].operation == Node::Operation::constant) {
      const double exponent = std::log2(program_[size].constant.to_double());
      result_.fits = result_.fits && std::abs(exponent) < result_.exponent;
      return;
    }
    result_.guards.push_back({size, result_.exponent});
  }

  Problem problem_;
  const SymbolValue& value_;
  Form form_;
  Zeros zeros_;
  Program program_;
  NodeId omega_;
  StiffnessWriter stiffness_;
  VelocityProgram result_;
};

}  // namespace

// The widest range for which all numbers stay among the doubles, and scaling only where there is
// none otherwise: it costs a tenth of the time.
VelocityProgram velocity_program(const Problem& problem, const SymbolValue& value, Zeros zeros) {
  rules::require(rules::Question::evaluator, problem);
  using Writer = VelocityWriter;
  const std::vector<std::pair<Writer::Form, std::vector<int>>> forms{
      {Writer::Form::plain, {200, 150, 100, 64, 40}},
      {Writer::Form::normalised, {100, 64, 48, 40, 32}},
      {Writer::Form::scaled, {100, 64, 48, 40, 32}}};
  VelocityProgram program;
  for (const auto& [form, exponents] : forms)
    for (const int exponent : exponents) {
      program = Writer(problem, value, exponent, form, zeros).write();
      if (program.fits) return program;
    }
  return program;  // numbers folded in are too large
}

}  // namespace vcrit::symbolic
