#include "program/stiffness.hpp"

#include <cmath>

#include <algorithm>

#include "base/errors.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "program/spanning_trees.hpp"
#include "program/star_mesh.hpp"

namespace vcrit::symbolic {

namespace {

// The error of a sum of products in roundings of its own absolute value, for `roundings` of the
// components' terms: the two components together sqrt(2), and another sqrt(2) where two stiffnesses
// are added, as |K1| + |K2| <= sqrt(2) |K1 + K2|.
int of_product(const ComplexSum& z) { return static_cast<int>(std::ceil(1.4143 * z.roundings)); }
int of_sum(const ComplexSum& z) { return 2 * z.roundings; }

// 1e3 to 1e10 N/m, omega tau from 1e-3 to 1e3: what polynomials are laid out for.
constexpr ExponentRange ordinary_stiffness{10, 33}, ordinary_quotient{-10, 10};

double extent(const Stiffness& k) {
  return std::max({std::abs(k.t_range.low), std::abs(k.t_range.high), std::abs(k.q_range.low),
                   std::abs(k.q_range.high)});
}

}  // namespace

NodeId roundings(Program& program, const Stiffness& k) {
  // Rounded up: sqrt(2) < 1.4143 < 1.5.
  const NodeId known = program.constant(static_cast<int>(std::ceil(1.4143 * k.path)));
  if (!k.roundings) return known;
  return program.add(program.multiply(program.constant(GiNaC::numeric(3, 2)), *k.roundings), known);
}

ExponentRange network_range(ExponentRange elements, int count) {
  const double sums = std::log2(count) + 1;
  return {elements.low - sums, elements.high + sums};
}

void StiffnessWriter::join_elements(Stiffness& whole, const Stiffness& a, const Stiffness& b) {
  whole.elements = {std::min(a.elements.low, b.elements.low),
                    std::max(a.elements.high, b.elements.high)};
  whole.count = a.count + b.count;
  whole.range = both(whole.range, network_range(whole.elements, whole.count));
}

ExponentRange StiffnessWriter::guarded(NodeId size) {
  const Node& node = program_[size];
  if (node.operation == Node::Operation::constant) {
    const double exponent = std::log2(std::abs(node.constant.to_double()));
    return {exponent - 0.01, exponent + 0.01};
  }
  const double limit = exponent_;
  const bool is_new = std::none_of(guards_.begin(), guards_.end(),
                                   [&](const Guard& g) { return g.expression == size; });
  if (is_new) guards_.push_back({size, exponent_});
  return {-limit, limit};
}

Stiffness StiffnessWriter::write(const Network& network) {
  if (const auto* e = std::get_if<Element>(&network.form)) return element(*e);
  if (const auto* s = std::get_if<Series>(&network.form))
    return fold(s->parts, &StiffnessWriter::series);
  if (const auto* p = std::get_if<Parallel>(&network.form))
    return fold(p->parts, &StiffnessWriter::parallel);
  return graph(std::get<Graph>(network.form));
}

// By halves: errors grow, and processors wait, with the depth.
Stiffness StiffnessWriter::fold(std::span<const Network> parts, Combine combine) {
  if (parts.size() == 1) return write(parts.front());
  const std::size_t half = parts.size() / 2;
  const Stiffness first = fold(parts.first(half), combine);
  const Stiffness second = fold(parts.subspan(half), combine);
  if (polynomials_ && (first.roundings || second.roundings)) return no_polynomials();
  const Stiffness whole = (this->*combine)(first, second);
  return polynomials_ && is_too_long(whole) ? no_polynomials() : whole;
}

/// No part of a network has longer polynomials than the whole.
bool StiffnessWriter::is_too_long(const Stiffness& k) const {
  return std::max(k.t.coefficients.size(), k.q.coefficients.size()) > longest_;
}

/// Any roundings at run time say so.
Stiffness StiffnessWriter::no_polynomials() {
  Stiffness none;
  none.roundings = program_.constant(0);
  return none;
}

std::optional<Stiffness> StiffnessWriter::write_polynomials(const Network& network,
                                                            std::size_t longest) {
  polynomials_ = true;
  longest_ = longest;
  const Stiffness k = write(network);
  polynomials_ = false;
  if (k.roundings || is_too_long(k)) return std::nullopt;
  return k;
}

namespace {

using ElementNumber = StiffnessWriter::ElementNumber;

/// An element's law: k s^degree, k tau s/(1 + tau s), or k (1 + i eta).
struct Term {
  ElementNumber k;
  int degree = 0;
  std::optional<ElementNumber> tau = {}, eta = {};

  int roundings() const {
    return k.roundings + (tau ? tau->roundings : 0) + (eta ? eta->roundings : 0);
  }
};

// Of an expression every number on the way is guarded: no product of two may leave the range, or be
// 0, before a third one brings it back.
struct Terms {
  using Value = Term;
  Program& program;
  const std::function<NodeId(const Symbol&)>& value;
  const std::function<void(NodeId)>& guard;

  Term of(const Symbol& symbol) const {
    const NodeId id = value(symbol);
    return {{id, program.size(id)}};
  }
  Term constant(const TypedNumber& number) const {
    const NodeId exact = program.constant(exact_decimal(number.decimal));
    const int roundings = program[exact].kind == NodeKind::exact ? 0 : 1;
    return {{exact, program.constant(exact_binary(number.value)), roundings}};
  }
  Term plus(const Term& a, const Term& b) const {
    return guarded({program.add(a.k.value, b.k.value), program.add(a.k.size, b.k.size),
                    std::max(a.k.roundings, b.k.roundings) + 1},
                   a, b);
  }
  Term times(const Term& a, const Term& b) const {
    return guarded({program.multiply(a.k.value, b.k.value), program.multiply(a.k.size, b.k.size),
                    a.k.roundings + b.k.roundings + 1},
                   a, b);
  }
  Term over(const Term& a, const Term& b) const {
    return guarded({program.divide(a.k.value, b.k.value), program.divide(a.k.size, b.k.size),
                    a.k.roundings + b.k.roundings + 1},
                   a, b);
  }

  static Term times_s(Term k) {
    ++k.degree;
    return k;
  }
  static Term relaxing(const Term& k, const Term& tau) { return {k.k, 1, tau.k, {}}; }
  static Term lossy(const Term& k, const Term& eta) { return {k.k, 0, {}, eta.k}; }

 private:
  Term guarded(const ElementNumber& result, const Term& a, const Term& b) const {
    for (const NodeId id : {a.k.size, b.k.size, result.size}) guard(id);
    return {result};
  }
};

}  // namespace

ElementNumber StiffnessWriter::number(const Element& e) {
  return law(e, Terms{program_, value_, guard_}).k;
}

Stiffness StiffnessWriter::polynomial_element(const Element& e) {
  const NodeId zero = program_.constant(0), one = program_.constant(1);
  const Term term = law(e, Terms{program_, value_, guard_});
  const auto [k, size, before] = term.k;
  Stiffness whole;
  if (term.eta) whole.roundings = zero;  // no polynomial with real coefficients
  guarded(size);
  whole.q = polynomial({one});
  whole.t = polynomial(term.degree == 0 ? std::vector{k} : std::vector{zero, k});
  whole.range = whole.t_range = whole.elements = ordinary_stiffness;
  if (!term.tau) return whole;
  guarded(term.tau->size);
  whole.t = polynomial({zero, program_.multiply(k, term.tau->value)});
  whole.q = polynomial({one, term.tau->value});
  whole.q_range = ordinary_quotient;
  whole.t_range = ordinary_stiffness + ordinary_quotient;
  return whole;
}

Stiffness StiffnessWriter::element(const Element& e) {
  if (polynomials_) return polynomial_element(e);
  const NodeId zero = program_.constant(0), one = program_.constant(1);
  const Term term = law(e, Terms{program_, value_, guard_});
  ensure(term.degree < 2, "masses are not in the first quadrant: drive_pair.hpp");
  const auto [k, size, before] = term.k;
  if (term.tau) return relaxing_element(term.k, *term.tau);
  Stiffness whole;
  whole.t = {k, zero};
  whole.q = {one, zero};
  whole.path = term.roundings();
  whole.exact_re = whole.path == 0;
  if (term.degree == 1) {
    whole.t = {zero, program_.multiply(omega_, k)};
    whole.t_range = guarded(program_.multiply(program_.size(omega_), size));
    whole.exact_re = true;
    ++whole.path;
  } else if (term.eta) {
    // |K| lies between k and k (1 + eta), and eta may be 0.
    whole.t = {k, program_.multiply(k, term.eta->value)};
    const ExponentRange range = guarded(size);
    whole.t_range = range + ExponentRange{0, guarded(program_.add(one, term.eta->size)).high};
    ++whole.path;
  } else {
    whole.t_range = guarded(size);
  }
  whole.range = whole.elements = whole.t_range;
  return whole;
}

// d ln K/d ln x = 1/(1 + i x): roundings of tau move K by no more.
Stiffness StiffnessWriter::relaxing_element(const ElementNumber& k, const ElementNumber& tau) {
  const NodeId zero = program_.constant(0), one = program_.constant(1);
  const ExponentRange stiffness = guarded(k.size);
  const ExponentRange x = guarded(program_.multiply(program_.size(omega_), tau.size));
  const NodeId product = program_.multiply(omega_, tau.value);
  // |K| = k x/|1 + i x|; x is rounded once, k x and 1 + i x once more.
  const ExponentRange quotient{0, std::max(x.high, 0.0) + 0.5};
  const ExponentRange range{stiffness.low + std::min(x.low, 0.0) - 0.5, stiffness.high};
  return {{zero, program_.multiply(product, k.value)},
          {one, product},
          stiffness + x,
          quotient,
          range,
          3 + k.roundings + tau.roundings,
          {},
          false,
          range,
          1};
}

Stiffness StiffnessWriter::normalised(const Stiffness& k) {
  NodeId size = program_.constant(0);
  for (const NodeId part : {k.t.re, k.t.im, k.q.re, k.q.im})
    if (!program_.is_constant(part, 0)) size = program_.add(size, program_.magnitude(part));
  const NodeId unit = program_.unit(size);
  Stiffness result = k;
  result.t = real_multiple(program_, unit, k.t);
  result.q = real_multiple(program_, unit, k.q);
  // The sum of four absolute values, 1 to 4 after scaling, is 1 to 2.8 times |T| + |Q|.
  result.t_range = {std::min(k.range.low, 0.0) - 3, 2};
  result.q_range = {-std::max(k.range.high, 0.0) - 3, 2};
  result.exact_re = false;
  return result;
}

void StiffnessWriter::fit_products(Stiffness& a, Stiffness& b) {
  while (!polynomials_ && extent(a) + extent(b) + 2 > largest_exponent) {
    Stiffness& larger = extent(a) > extent(b) ? a : b;
    const double before = extent(larger);
    const Stiffness smaller = normalised(larger);
    if (extent(smaller) >= before) return;  // no further: the caller sees it in the ranges
    larger = smaller;
  }
}

Stiffness StiffnessWriter::parallel(Stiffness a, Stiffness b) {
  fit_products(a, b);
  const ComplexSum t = sum_of_products(program_, {{a.t, b.q}, {b.t, a.q}});
  const ComplexSum q = sum_of_products(program_, {{a.q, b.q}});
  // Two sums in the first quadrant, component by component, lose nothing.
  const bool simple = is_one(program_, a.q) && is_one(program_, b.q);
  const int local = simple ? t.roundings : of_sum(t) + of_product(q);
  Stiffness whole;
  whole.t = t.value;
  whole.q = q.value;
  whole.q_range = a.q_range + b.q_range;
  whole.range = sum_range(a.range, b.range, zeros_);
  join_elements(whole, a, b);
  whole.t_range = whole.range + whole.q_range;
  whole.path = std::max(a.path, b.path) + local;
  const auto one_component = [this](const Stiffness& x, const Stiffness& y) {
    return polynomials_ || program_.is_constant(x.t.re, 0) || program_.is_constant(y.t.re, 0);
  };
  whole.exact_re = a.exact_re && b.exact_re && one_component(a, b);
  whole.roundings = sum_of_roundings(a, b);
  return whole;
}

Stiffness StiffnessWriter::series(Stiffness a, Stiffness b) {
  fit_products(a, b);
  const ComplexSum t = sum_of_products(program_, {{a.t, b.t}});
  const ComplexSum q = sum_of_products(program_, {{a.t, b.q}, {b.t, a.q}});
  ComplexNode divisor = q.value;
  if (!polynomials_) divisor.re = program_.nonzero(divisor.re, divisor.im);
  Stiffness whole;
  whole.t = t.value;
  whole.q = divisor;
  whole.t_range = a.t_range + b.t_range;
  whole.range = {std::min(a.range.low, b.range.low) - 1, std::min(a.range.high, b.range.high)};
  join_elements(whole, a, b);
  const ExponentRange sum = sum_range(a.t_range + b.q_range, b.t_range + a.q_range, zeros_);
  whole.q_range = quotient_range(whole.t_range, whole.range, with_one(sum, zeros_), zeros_);
  whole.path = std::max(a.path, b.path) + of_product(t) + of_sum(q);
  whole.roundings = sum_of_roundings(a, b);
  return whole;
}

std::optional<NodeId> StiffnessWriter::sum_of_roundings(const Stiffness& a, const Stiffness& b) {
  if (!a.roundings || !b.roundings) return a.roundings ? a.roundings : b.roundings;
  return program_.add(*a.roundings, *b.roundings);
}

Stiffness StiffnessWriter::graph(const Graph& graph) {
  std::vector<Stiffness> parts;
  for (const Network& part : graph.parts) parts.push_back(write(part));
  const bool known = std::none_of(parts.begin(), parts.end(),
                                  [](const Stiffness& part) { return part.roundings.has_value(); });
  if (known)
    if (const auto whole = by_spanning_trees(program_, graph, parts, zeros_)) return *whole;
  return polynomials_ ? no_polynomials() : meshed(graph, parts);
}

Stiffness StiffnessWriter::meshed(const Graph& graph, const std::vector<Stiffness>& parts) {
  const MeshedStiffness mesh = by_star_mesh(program_, Network{graph}, [this](const Element& e) {
    const Stiffness k = element(e);
    return MeshElement{k.t, k.q, k.path};
  });
  Stiffness whole = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) join_elements(whole, whole, parts[i]);
  whole.t = mesh.k;
  whole.q = {program_.constant(1), program_.constant(0)};
  whole.range = whole.t_range = network_range(whole.elements, whole.count);
  whole.q_range = {};
  whole.path = 0;
  whole.roundings = mesh.roundings;
  whole.exact_re = false;
  return whole;
}

}  // namespace vcrit::symbolic
