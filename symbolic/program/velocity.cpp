#include "program/velocity.hpp"

#include <cmath>

#include "network/masses.hpp"
#include "onset/formula_scope.hpp"

namespace vcrit::symbolic {

namespace {

// less_inertia subtracts exactly: 53 digits of each of three factors.
constexpr double exact_cancellation = 160;

class VelocityWriter {
 public:
  enum class Form { plain, normalised };

  VelocityWriter(const Scene& scene, const SymbolValue& value, int exponent, Form form, Zeros zeros)
      : scene_(scene),
        value_(value),
        form_(form),
        zeros_(zeros),
        omega_(symbol({"omega"})),
        stiffness_(
            program_, omega_, exponent, [this](const Symbol& s) { return symbol(s); }, zeros) {
    result_.exponent = exponent;
  }

  VelocityProgram write() {
    const auto* isotropic = std::get_if<Isotropic>(&scene_.tangential);
    if (isotropic != nullptr) {
      ratio_ = contact_ratio(program_, stiffness_, *isotropic, value_);
      const Symbol& given = isotropic->quantity.symbol;
      if (isotropic->by == Isotropic::By::poisson && !isotropic->quantity.value &&
          program_[symbol(given)].operation == Node::Operation::parameter)
        result_.poisson = given;
    }
    if (scene_.drive)
      with_drive(isotropic != nullptr);
    else if (isotropic != nullptr)
      finish({real(program_, ratio_.q)}, {real(program_, ratio_.t)}, {{}}, {{}},
             program_.constant(ratio_.path));
    else
      rigid();
    result_.program = std::move(program_);
    return std::move(result_);
  }

 private:
  NodeId symbol(const Symbol& s) { return value_(program_, s); }

  Stiffness network(const Network& network) {
    const Stiffness k = stiffness_.write(network);
    return form_ == Form::normalised && !is_one(program_, k.q) ? stiffness_.normalised(k) : k;
  }

  /// K_n and K_t: where they are 0, v* is none.
  Stiffness contact(const Network& of) {
    Stiffness k = network(of);
    k.q_range = quotient_range(k.t_range, k.range, k.q_range, Zeros::out_of_range);
    return k;
  }

  /// K_t = ratio K_n: T and Q each times a number.
  Stiffness isotropic_tangential(const Stiffness& normal) {
    Stiffness k = normal;
    k.t = real_multiple(program_, ratio_.t, normal.t);
    k.q = real_multiple(program_, ratio_.q, normal.q);
    k.t_range = normal.t_range + ratio_.t_range;
    k.range = normal.range + ratio_.range;
    k.q_range = normal.q_range + ratio_.q_range;
    k.path += ratio_.path + 2;
    k.exact_re = false;
    return k;
  }

  NodeId number(int value) { return program_.constant(value); }
  NodeId times(int count, NodeId bound) { return program_.multiply(number(count), bound); }
  NodeId one_and_a_half(NodeId bound) {
    return program_.multiply(program_.constant(GiNaC::numeric(3, 2)), bound);
  }

  /// D with a bound of |error| in roundings, absolute.
  struct Difference {
    Complex value;
    ExponentRange range;
    NodeId error = 0;
  };

  Difference difference(const Stiffness& d) {
    const NodeId m = symbol(scene_.mass->symbol);
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
    const Complex less = real(program_, program_.negate(inertia_value));
    const Complex unity = real(program_, number(1));
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

  void with_drive(bool isotropic) {
    const Stiffness n = contact(scene_.normal);
    const Stiffness t =
        isotropic ? isotropic_tangential(n) : contact(std::get<Network>(scene_.tangential));
    const Stiffness d = network(*scene_.drive);
    Difference body{d.t, d.t_range, 0};
    if (scene_.mass) body = difference(d);
    const ComplexSum sum = sum_of_products(program_, {{t.t, d.q}, {t.q, body.value}});
    const Complex whole = sum.value;
    // K_t = 0 is a pole, which no range has to hold.
    ExponentRange range =
        sum_range(t.t_range + d.q_range, t.q_range + body.range, Zeros::out_of_range);
    range.low -= scene_.mass ? cancellation : 1;
    check(t.t_range + d.q_range);
    check(t.q_range + body.range);
    const NodeId errors = with_drive_errors(t, d, body, sum);
    if (isotropic)
      return finish({whole}, {real(program_, ratio_.t), n.q, body.value}, {range},
                    {ratio_.t_range, n.q_range, body.range},
                    program_.add(errors, number(ratio_.path)));
    finish({n.t, whole}, {n.q, t.t, body.value}, {n.t_range, range},
           {n.q_range, t.t_range, body.range},
           program_.add(errors, program_.add(roundings(program_, n), roundings(program_, t))));
  }

  // Relative errors of D and N, where |z| >= size_bound(z)/sqrt(2).
  NodeId with_drive_errors(const Stiffness& t, const Stiffness& d, const Difference& body,
                           const ComplexSum& whole) {
    const int local = static_cast<int>(std::ceil(1.4143 * whole.roundings));
    if (!scene_.mass) {
      // K_t + K_d, both in the first quadrant.
      const NodeId sum =
          program_.add(one_and_a_half(program_.add(roundings(program_, t), roundings(program_, d))),
                       number(2 * local));
      return program_.add(sum, roundings(program_, d));
    }
    const NodeId d_size = size_bound(program_, body.value);
    const NodeId d_error = program_.divide(body.error, d_size);
    const NodeId t_part =
        program_.multiply(program_.add(roundings(program_, t), number(local)),
                          program_.multiply(size_bound(program_, t.t), size_bound(program_, d.q)));
    const NodeId d_part = program_.multiply(program_.add(body.error, times(local, d_size)),
                                            size_bound(program_, t.q));
    const NodeId n_error =
        program_.divide(program_.add(t_part, d_part), size_bound(program_, whole.value));
    return one_and_a_half(program_.add(d_error, n_error));
  }

  void rigid() {
    const Stiffness n = contact(scene_.normal);
    const Stiffness t = contact(std::get<Network>(scene_.tangential));
    finish({n.t, t.q}, {n.q, t.t}, {n.t_range, t.q_range}, {n.q_range, t.t_range},
           program_.add(roundings(program_, n), roundings(program_, t)));
  }

  void check(ExponentRange range) { result_.fits = result_.fits && fits(range); }

  /// The product of absolute values, or of their squares.
  NodeId product(const std::vector<Complex>& factors, const std::vector<ExponentRange>& ranges,
                 bool squared) {
    NodeId whole = number(1);
    ExponentRange range;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const Complex& z = factors[i];
      range = range + (squared ? twice(ranges[i]) : ranges[i]);
      check(range);
      check(squared ? twice(ranges[i]) : ranges[i]);
      if (squared) {
        whole = program_.multiply(whole, square(program_, z));
        continue;
      }
      const bool is_real = program_.is_constant(z.im, 0);
      whole = program_.multiply(whole, program_.magnitude(is_real ? z.re : z.im));
    }
    return whole;
  }

  void finish(const std::vector<Complex>& above, const std::vector<Complex>& below,
              const std::vector<ExponentRange>& above_ranges,
              const std::vector<ExponentRange>& below_ranges, NodeId errors) {
    const auto has_both = [this](const Complex& z) {
      return !program_.is_constant(z.re, 0) && !program_.is_constant(z.im, 0);
    };
    result_.rooted = std::any_of(above.begin(), above.end(), has_both) ||
                     std::any_of(below.begin(), below.end(), has_both);
    result_.above = product(above, above_ranges, result_.rooted);
    result_.below = product(below, below_ranges, result_.rooted);
    for (const char* name : {"mu0", "du_z", "omega"}) guard_factor({name});
    result_.factor =
        program_.multiply(program_.multiply(symbol({"mu0"}), omega_), symbol({"du_z"}));
    result_.guards.insert(result_.guards.end(), stiffness_.guards().begin(),
                          stiffness_.guards().end());
    // Each square 2 and its product 1, the quotient 1, all halved by the root, itself 1; mu0 omega
    // du_z and its product 3.
    const int count = static_cast<int>(above.size() + below.size());
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

  const Scene& scene_;
  const SymbolValue& value_;
  Form form_;
  Zeros zeros_;
  Program program_;
  NodeId omega_;
  StiffnessWriter stiffness_;
  Ratio ratio_;
  VelocityProgram result_;
};

}  // namespace

void refuse_other_scenes(const Scene& scene) {
  if (scene.receptance)
    throw ModelError("the generator needs a network; this drive is a measured receptance");
  if (scene.drive && has_masses(*scene.drive))
    throw ModelError("the generator knows one body; this drive holds masses of its own");
  switch (formula_scope(scene)) {
    case FormulaScope::always:
      return;
    case FormulaScope::while_touching:
      throw ModelError(
          "where these surfaces part (separation = true) v* is Eq. (24) only while they touch "
          "where the indentation grows fastest, which an evaluator cannot tell",
          "vcrit eval can, and of the closed contact there is an evaluator, without separation");
    case FormulaScope::never:
      throw ModelError("no closed form of v* where these surfaces part (separation = true)",
                       "of the closed contact there is one, without it");
  }
}

// The widest range for which all numbers stay among the doubles, and scaling only where there is
// none otherwise: it costs a tenth of the time.
VelocityProgram velocity_program(const Scene& scene, const SymbolValue& value, Zeros zeros) {
  refuse_other_scenes(scene);
  for (const int exponent : {200, 150, 100, 64, 40}) {
    VelocityProgram program =
        VelocityWriter(scene, value, exponent, VelocityWriter::Form::plain, zeros).write();
    if (program.fits) return program;
  }
  for (const int exponent : {100, 64, 48, 40, 32}) {
    VelocityProgram program =
        VelocityWriter(scene, value, exponent, VelocityWriter::Form::normalised, zeros).write();
    if (program.fits || exponent == 32) return program;
  }
  throw Bug("the last range is returned");
}

}  // namespace vcrit::symbolic
