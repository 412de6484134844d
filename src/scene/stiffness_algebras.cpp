#include "scene/stiffness_algebras.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/joined.hpp"
#include "network/law.hpp"

namespace vcrit {

namespace {

// Of the coefficients of a polynomial, together: 100 factors whose numbers have 20 digits take half
// of it.
constexpr long most_bits = 1L << 21;

// Of the polynomials of names: those of ten branches with names of their own have 2^10 terms, and
// what is made of them takes seconds beyond that.
constexpr std::size_t most_terms = 2000;

std::vector<std::string> variables_of(const std::vector<Symbol>& leaves) {
  std::vector<std::string> all{NamedAlgebra::variable()};
  for (const Symbol& leaf : leaves) all.push_back(to_text(leaf));
  return all;
}

}  // namespace

void refuse_large_stiffness(const Place& place) {
  throw InputError(place, "a stiffness of very many terms or digits",
                   fmt::format("polynomials of degree {} at most", largest_degree_of_stiffness),
                   "the network itself, as in prony(k0, k, tau)");
}

TypedNumberAlgebra::Value TypedNumberAlgebra::plus(const Value& a, const Value& b) const {
  if (a.below == b.below) return {a.above + b.above, a.below};
  return {product(a.above, b.below) + product(b.above, a.below), product(a.below, b.below)};
}

TypedNumberAlgebra::Value TypedNumberAlgebra::times(const Value& a, const Value& b) const {
  return {product(a.above, b.above), product(a.below, b.below)};
}

// Common factors are left in it until the end, hence twice the degree.
ExactPolynomial TypedNumberAlgebra::product(const ExactPolynomial& a,
                                            const ExactPolynomial& b) const {
  const long degree = a.degree() + b.degree();
  if (degree > 2 * largest_degree_of_stiffness || (degree + 1) * (a.bits() + b.bits()) > most_bits)
    refuse_large_stiffness(place_);
  return a * b;
}

NameCollector::Value NameCollector::named(const Symbol& name, const Place& place) {
  place_ = place;
  keys_.insert(name.name);
  const Symbol element = names_.called(name);
  keys_.insert(element.name);
  const bool circle = std::find(way_.begin(), way_.end(), element) != way_.end();
  if (circle) {
    std::vector<std::string> way;
    for (const Symbol& each : way_) way.push_back(to_text(each));
    way.push_back(to_text(element));
    throw InputError(place, fmt::format("expressions in a circle: {}", joined(way, " -> ")),
                     "a value for one of them");
  }
  if (!known_.insert(element).second) return {};
  const AmountTreePointer expression = names_.expression(element);
  if (expression == nullptr) {
    leaves_.push_back(element);
    return {};
  }
  known_.erase(element);  // which it is once it has been read
  way_.push_back(element);
  in_algebra(*expression, *this);
  way_.pop_back();
  known_.insert(element);
  return {};
}

NamedAlgebra::NamedAlgebra(const StiffnessNames& names, const std::vector<Symbol>& leaves,
                           const Place& place)
    : names_(names), ring_(variables_of(leaves)), place_(place) {}

NamedAlgebra::Value NamedAlgebra::number(const std::string& decimal) const {
  const auto [above, below] = ExactPolynomial(decimal).fraction();
  const std::vector<unsigned long> none(ring_.size());
  Value value{Polynomial(ring_, 0), Polynomial(ring_, 0)};
  value.over.add_term(above, none);
  value.under.add_term(below, none);
  return value;
}

NamedAlgebra::Value NamedAlgebra::of(const Symbol& name) {
  const Symbol element = names_.called(name);
  const auto known = known_.find(element);
  if (known != known_.end()) return known->second;
  const AmountTreePointer expression = names_.expression(element);
  const Value value = expression != nullptr ? in_algebra(*expression, *this)
                                            : Value{Polynomial::variable(ring_, to_text(element)),
                                                    Polynomial(ring_, 1)};
  known_.emplace(element, value);
  return value;
}

NamedAlgebra::Value NamedAlgebra::plus(const Value& a, const Value& b) const {
  if (a.under == b.under) return checked({a.over + b.over, a.under});
  for (const auto& [x, y] :
       {std::pair(&a.over, &b.under), {&b.over, &a.under}, {&a.under, &b.under}})
    refuse_large_product(*x, *y);
  return checked(a + b);
}

NamedAlgebra::Value NamedAlgebra::times(const Value& a, const Value& b) const {
  refuse_large_product(a.over, b.over);
  refuse_large_product(a.under, b.under);
  return checked(a * b);
}

NamedAlgebra::Value NamedAlgebra::checked(const Value& a) const {
  if (a.under.is_zero() || a.over.is_zero()) return {a.over, Polynomial(ring_, 1)};
  Value whole = cancelled(a);
  if (whole.over.terms() > most_terms || whole.under.terms() > most_terms)
    refuse_large_stiffness(place_);
  return whole;
}

void NamedAlgebra::refuse_large_product(const Polynomial& a, const Polynomial& b) const {
  const auto bits = [](const Polynomial& p) { return fmpz_mpoly_max_bits(p.raw()); };
  const auto terms = static_cast<long>(a.terms() * b.terms());
  const unsigned long degree = a.degree(variable()) + b.degree(variable());
  if (degree > 2UL * largest_degree_of_stiffness || terms > 10 * static_cast<long>(most_terms) ||
      terms * (std::labs(bits(a)) + std::labs(bits(b))) > most_bits)
    refuse_large_stiffness(place_);
}

}  // namespace vcrit
