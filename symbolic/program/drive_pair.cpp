#include "program/drive_pair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.hpp"

namespace vcrit::symbolic {

namespace {

// What less_inertia leaves out of m omega^2, the parts below three doubles' digits, is far less
// than 2^-50 roundings of it.
constexpr int tail_bits = 50;
// m, omega and omega again: two products.
constexpr int inertia_roundings = 2;

// Both components of a complex sum err by `roundings` of the sum of its terms' absolute values.
int both_components(const ComplexSum& sum) {
  return static_cast<int>(std::ceil(1.4143 * sum.roundings));
}

double pair_extent(const DrivePair& pair) {
  return std::max({std::abs(pair.t_range.low), std::abs(pair.t_range.high),
                   std::abs(pair.q_range.low), std::abs(pair.q_range.high)});
}

NodeId size_of_inertia(Program& program, NodeId mass_size, NodeId omega) {
  return program.multiply(program.multiply(mass_size, program.size(omega)), program.size(omega));
}

ExponentRange hull(ExponentRange a, ExponentRange b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace

NodeId pair_errors(Program& program, const DrivePair& pair) {
  const NodeId known = program.constant(pair.errors);
  return pair.more_errors ? program.add(*pair.more_errors, known) : known;
}

// K = T/Q errs by some roundings of |K|: they count as those of T, and Q is what it is.
DrivePair PairWriter::massless(const Network& network) {
  const Stiffness k = stiffness_.write(network);
  DrivePair pair;
  pair.t = k.t;
  pair.q = k.q;
  pair.t_size = size_bound(program_, k.t);
  pair.q_size = size_bound(program_, k.q);
  pair.t_range = k.t_range;
  pair.q_range = k.q_range;
  pair.elements = k.range;
  pair.errors = static_cast<int>(std::ceil(1.4143 * k.path));
  if (k.roundings)
    pair.more_errors = program_.multiply(program_.constant(GiNaC::numeric(3, 2)), *k.roundings);
  pair.exact_re = k.exact_re;
  return pair;
}

DrivePair PairWriter::mass(const Element& element) {
  const StiffnessWriter::ElementNumber m = stiffness_.number(element);
  const NodeId size = size_of_inertia(program_, m.size, omega_);
  DrivePair pair;
  pair.t = real(program_,
                program_.negate(program_.multiply(program_.multiply(m.value, omega_), omega_)));
  pair.q = real(program_, program_.constant(1));
  pair.t_size = size;
  pair.q_size = program_.constant(1);
  pair.t_range = pair.elements = stiffness_.guarded(size);
  pair.errors = inertia_roundings + m.roundings;
  if (m.roundings == 0 && program_[m.value].kind == NodeKind::exact)
    pair.inertia = DrivePair::Inertia{m.value, size};
  return pair;
}

PairWriter::Sum PairWriter::sum(const std::vector<Term>& terms) {
  std::vector<std::pair<ComplexNode, ComplexNode>> products;
  Sum whole{{}, program_.constant(0), terms.front().range, 0};
  for (const Term& term : terms) {
    products.emplace_back(term.a, term.b);
    whole.size = program_.add(whole.size, program_.multiply(term.size_a, term.size_b));
    if (&term != &terms.front()) whole.range = sum_range(whole.range, term.range, zeros_);
  }
  const ComplexSum value = sum_of_products(program_, products);
  whole.value = value.value;
  whole.local = both_components(value);
  return whole;
}

void PairWriter::fit_products(DrivePair& a, DrivePair& b) {
  while (pair_extent(a) + pair_extent(b) + 2 > largest_exponent) {
    DrivePair& larger = pair_extent(a) > pair_extent(b) ? a : b;
    const DrivePair smaller = normalised(larger);
    if (pair_extent(smaller) >= pair_extent(larger))
      return;  // no further: the caller sees it in the ranges
    larger = smaller;
  }
}

DrivePair PairWriter::joined(const DrivePair& a, const DrivePair& b) {
  DrivePair whole;
  whole.elements = hull(a.elements, b.elements);
  whole.count = a.count + b.count;
  whole.errors = a.errors + b.errors;
  whole.fits = a.fits && b.fits;
  whole.more_errors = a.more_errors;
  if (b.more_errors)
    whole.more_errors =
        a.more_errors ? program_.add(*a.more_errors, *b.more_errors) : *b.more_errors;
  return whole;
}

DrivePair PairWriter::with(DrivePair whole, const Sum& t, const Sum& q) {
  whole.t = t.value;
  whole.t_size = t.size;
  whole.t_range = t.range;
  whole.q = q.value;
  whole.q_size = q.size;
  whole.q_range = q.range;
  whole.errors += std::max(t.local, q.local);
  whole.fits = whole.fits && symbolic::fits(t.range) && symbolic::fits(q.range);
  return whole;
}

// The last rounding of the difference, the damper's omega c and the tail.
PairWriter::Sum PairWriter::difference(const DrivePair& spring, const DrivePair& mass) {
  const ComplexNode value{program_.less_inertia(spring.t.re, mass.inertia->mass, omega_),
                          spring.t.im};
  const NodeId tail =
      program_.multiply(program_.constant(GiNaC::numeric(1, 1L << tail_bits)), mass.inertia->size);
  ExponentRange range{mass.t_range.low - tail_bits,
                      std::max(spring.t_range.high, mass.t_range.high) + 1};
  if (zeros_ == Zeros::in_range) range.low = std::min(range.low, spring.t_range.low);
  return {value, program_.add(size_bound(program_, value), tail), range, 3};
}

DrivePair PairWriter::side_by_side(const DrivePair& spring, const DrivePair& mass) {
  const Sum t = difference(spring, mass);
  DrivePair whole = joined(spring, mass);
  whole.errors = spring.errors;
  whole.elements = hull(whole.elements, t.range);
  return with(whole, t, {spring.q, spring.q_size, {}, 0});
}

// K m s^2/(K + m s^2)
DrivePair PairWriter::one_behind_the_other(const DrivePair& spring, const DrivePair& mass) {
  const Sum t =
      sum({{spring.t, mass.t, spring.t_size, mass.t_size, spring.t_range + mass.t_range}});
  const Sum q = difference(spring, mass);
  DrivePair whole = joined(spring, mass);
  whole.elements = hull(whole.elements, t.range - q.range);
  return with(whole, t, q);
}

DrivePair PairWriter::parallel(DrivePair a, DrivePair b) {
  if (a.exact_re && b.inertia) return side_by_side(a, b);
  if (b.exact_re && a.inertia) return side_by_side(b, a);
  fit_products(a, b);
  const Sum t = sum({{a.t, b.q, a.t_size, b.q_size, a.t_range + b.q_range},
                     {b.t, a.q, b.t_size, a.q_size, b.t_range + a.q_range}});
  return with(joined(a, b), t, sum({{a.q, b.q, a.q_size, b.q_size, a.q_range + b.q_range}}));
}

DrivePair PairWriter::series(DrivePair a, DrivePair b) {
  if (a.exact_re && b.inertia) return one_behind_the_other(a, b);
  if (b.exact_re && a.inertia) return one_behind_the_other(b, a);
  fit_products(a, b);
  const Sum t = sum({{a.t, b.t, a.t_size, b.t_size, a.t_range + b.t_range}});
  return with(joined(a, b), t,
              sum({{a.t, b.q, a.t_size, b.q_size, a.t_range + b.q_range},
                   {b.t, a.q, b.t_size, a.q_size, b.t_range + a.q_range}}));
}

DrivePair PairWriter::by_edge(const DrivePair& edge, const DrivePair& without,
                              const DrivePair& contracted) {
  DrivePair whole = joined(edge, joined(without, contracted));
  whole.errors = edge.errors + std::max(without.errors, contracted.errors);
  const Sum t = sum(
      {{edge.q, without.t, edge.q_size, without.t_size, edge.q_range + without.t_range},
       {edge.t, contracted.t, edge.t_size, contracted.t_size, edge.t_range + contracted.t_range}});
  return with(whole, t,
              sum({{edge.q, without.q, edge.q_size, without.q_size, edge.q_range + without.q_range},
                   {edge.t, contracted.q, edge.t_size, contracted.q_size,
                    edge.t_range + contracted.q_range}}));
}

DrivePair PairWriter::times(const DrivePair& pair, const DrivePair& factor) {
  const Sum t =
      sum({{pair.t, factor.t, pair.t_size, factor.t_size, pair.t_range + factor.t_range}});
  return with(joined(pair, factor), t,
              sum({{pair.q, factor.t, pair.q_size, factor.t_size, pair.q_range + factor.t_range}}));
}

// S_T/S_Q is the stiffness of the same network with nothing but springs, of the sizes of its parts.
DrivePair PairWriter::normalised(const DrivePair& pair) {
  NodeId size = program_.constant(0);
  for (const NodeId part : {pair.t.re, pair.t.im, pair.q.re, pair.q.im})
    if (!program_.is_constant(part, 0)) size = program_.add(size, program_.magnitude(part));
  const NodeId unit = program_.unit(size);
  DrivePair result = pair;
  result.t = real_multiple(program_, unit, pair.t);
  result.q = real_multiple(program_, unit, pair.q);
  result.t_size = program_.multiply(unit, pair.t_size);
  result.q_size = program_.multiply(unit, pair.q_size);
  const ExponentRange range = network_range(pair.elements, pair.count);
  result.t_range = {std::min(range.low, 0.0) - 3, 2};
  result.q_range = {-std::max(range.high, 0.0) - 3, 2};
  result.exact_re = false;
  result.inertia.reset();
  return result;
}

namespace {

/// D with S_D, and what is checked on the way.
struct PairBody {
  ComplexNode d;
  NodeId size, errors;
  ExponentRange range;
};

PairBody pair_body(Program& program, StiffnessWriter& stiffness, const DrivePair& drive,
                   std::optional<NodeId> mass, NodeId omega, Zeros zeros) {
  if (!mass) return {drive.t, drive.t_size, pair_errors(program, drive), drive.t_range};
  const NodeId inertia = size_of_inertia(program, program.size(*mass), omega);
  const ExponentRange range = stiffness.guarded(inertia);
  const NodeId product = program.multiply(program.multiply(*mass, omega), omega);
  const ComplexNode less = real(program, program.negate(product));
  const ComplexSum d =
      sum_of_products(program, {{drive.t, real(program, program.constant(1))}, {drive.q, less}});
  const int local = both_components(d) + inertia_roundings;
  return {d.value, program.add(drive.t_size, program.multiply(inertia, drive.q_size)),
          program.add(pair_errors(program, drive), program.constant(local)),
          sum_range(drive.t_range, drive.q_range + range, zeros)};
}

/// n S over what is left, |z| >= size_bound(z)/sqrt(2).
NodeId relative_errors(Program& program, NodeId errors, NodeId size, const ComplexNode& z) {
  const NodeId share = program.divide(program.multiply(errors, size), size_bound(program, z));
  return program.multiply(program.constant(GiNaC::numeric(3, 2)), share);
}

}  // namespace

PairBalance balance_of(Program& program, StiffnessWriter& stiffness, const DrivePair& drive,
                       const Stiffness& t, std::optional<NodeId> mass, NodeId omega, Zeros zeros) {
  const PairBody body = pair_body(program, stiffness, drive, mass, omega, zeros);
  const ComplexSum n = sum_of_products(program, {{t.t, drive.q}, {t.q, body.d}});
  const ExponentRange of_t = t.t_range + drive.q_range, of_d = t.q_range + body.range;
  PairBalance result{body.d,     n.value,
                     body.range, sum_range(of_t, of_d, zeros),
                     0,          drive.fits && fits(of_t) && fits(of_d)};
  // Twice the digits of S: of less nothing is known.
  result.d_range.low -= cancellation;
  result.n_range.low -= cancellation;
  const NodeId size = program.add(program.multiply(size_bound(program, t.t), drive.q_size),
                                  program.multiply(size_bound(program, t.q), body.size));
  const NodeId errors = program.add(program.add(body.errors, roundings(program, t)),
                                    program.constant(both_components(n)));
  result.errors = program.add(relative_errors(program, body.errors, body.size, body.d),
                              relative_errors(program, errors, size, n.value));
  return result;
}

}  // namespace vcrit::symbolic
