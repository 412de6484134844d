// What each kind of element is: its law, and the numbers that it has. Said here alone; a kind that
// the switches do not know does not compile.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "network/network.hpp"

namespace vcrit {

/// Why a lossy spring has no law in time, and what to do.
inline constexpr const char* no_law =
    "lossy(k, eta) is not causal: K = k (1 + i eta) at one frequency is no law in time, nor a "
    "rational function of s";
inline constexpr const char* no_law_advice =
    "eval, derive and generate need that frequency alone; a Zener body or a Prony series fitted "
    "around it has a motion";

/// The same of a measured stiffness.
inline constexpr const char* measured_law =
    "the contact's stiffness is measured, and a table at some frequencies is no law in time, nor a "
    "rational function of s";
inline constexpr const char* measured_law_advice =
    "vcrit fit makes a network of the same table, which has a motion";

template <class Algebra>
typename Algebra::Value in_algebra(const AmountTree& e, Algebra& algebra) {
  switch (e.kind) {
    case AmountTree::Kind::symbol:
      return algebra.of(e.symbol);
    case AmountTree::Kind::number:
      return algebra.constant(e.number);
    case AmountTree::Kind::sum:
      return algebra.plus(in_algebra(*e.first, algebra), in_algebra(*e.second, algebra));
    case AmountTree::Kind::product:
      return algebra.times(in_algebra(*e.first, algebra), in_algebra(*e.second, algebra));
    case AmountTree::Kind::quotient:
      return algebra.over(in_algebra(*e.first, algebra), in_algebra(*e.second, algebra));
  }
  throw Bug("an expression of no kind");
}

/// An amount in the algebra of law().
template <class Algebra>
typename Algebra::Value in_algebra(const Amount& amount, Algebra& algebra) {
  return amount.is_symbol() ? algebra.of(amount.symbol())
                            : in_algebra(*amount.expression(), algebra);
}

/// K(s) of an element in an algebra, which gives the type Value and
///   Value of(const Symbol&)                 a number as a stiffness
///   Value constant(const TypedNumber&)      likewise, above 0
///   Value plus(a, b), times(a, b), over(a, b)   of numbers a and b: a + b, a b and a/b
///   Value times_s(const Value& k)           k s
///   Value relaxing(const Value& k, const Value& tau)   k tau s/(1 + tau s), for numbers k and tau
///   Value lossy(const Value& k, const Value& eta)      k (1 + i eta), likewise; where it knows i
///   omega alone, also for what is measured
/// Each algebra has its own best way to these. Throws ModelError for what it has no law of.
template <class Algebra>
typename std::remove_reference_t<Algebra>::Value law(const Element& e, Algebra&& algebra) {
  auto coefficient = in_algebra(e.coefficient, algebra);
  switch (e.kind) {
    case ElementKind::spring:
      return coefficient;
    case ElementKind::damper:
      return algebra.times_s(coefficient);
    case ElementKind::mass:
      return algebra.times_s(algebra.times_s(coefficient));
    case ElementKind::maxwell:
      return algebra.relaxing(coefficient, in_algebra(e.second, algebra));
    case ElementKind::lossy:
      if constexpr (requires { algebra.lossy(coefficient, coefficient); })
        return algebra.lossy(coefficient, in_algebra(e.second, algebra));
      throw ModelError(no_law, no_law_advice);
    case ElementKind::measured:
      if constexpr (requires { algebra.lossy(coefficient, coefficient); })
        return algebra.lossy(coefficient, in_algebra(e.second, algebra));
      throw ModelError(measured_law, measured_law_advice);
  }
  throw Bug("an element of no kind");
}

/// A number of that role, for all who read, document or try one.
struct NumberRow {
  const char* words;    ///< of a parameter of generated code
  const char* one;      ///< as a message names what has it, alone
  const char* several;  ///< and as an array
  Dimension dimension;  ///< of an element; of a half-space's, `in_half_space`
  Dimension in_half_space;
  double example;  ///< of the size of real devices, in SI units
};

inline const NumberRow& number_row(NumberRole role) {
  static const std::array<NumberRow, 6> rows{{
      {"spring", "a spring", "an array of stiffnesses", Dimension::stiffness, Dimension::modulus,
       4e6},
      {"damper", "a damper", "an array of dampers", Dimension::damping, Dimension::viscosity, 20},
      {"relaxation time", "a relaxation time", "relaxation times", Dimension::time, Dimension::time,
       8e-6},
      {"mass", "a mass", "a mass", Dimension::mass, Dimension::mass, 0.00025},
      {"loss factor", "a loss factor", "loss factors", Dimension::none, Dimension::none, 0.125},
      {"factor", "a plain number", "plain numbers", Dimension::none, Dimension::none, 0.5},
  }};
  return rows.at(static_cast<std::size_t>(role));
}

/// visit(amount, role) for each number of an element, in the order of writing.
template <class Visit>
void for_each_amount(const Element& e, const Visit& visit) {
  switch (e.kind) {
    case ElementKind::spring:
      return visit(e.coefficient, NumberRole::stiffness);
    case ElementKind::damper:
      return visit(e.coefficient, NumberRole::damping);
    case ElementKind::mass:
      return visit(e.coefficient, NumberRole::mass);
    case ElementKind::maxwell:
      visit(e.coefficient, NumberRole::stiffness);
      return visit(e.second, NumberRole::time);
    case ElementKind::lossy:
      visit(e.coefficient, NumberRole::stiffness);
      return visit(e.second, NumberRole::loss_factor);
    case ElementKind::measured:
      visit(e.coefficient, NumberRole::stiffness);
      visit(e.second, NumberRole::loss_factor);
      if (e.rest.exists()) visit(e.rest, NumberRole::stiffness);
      return;
  }
}

/// visit(symbol, role) for each symbol in them.
template <class Visit>
void for_each_number(const Element& e, const Visit& visit) {
  for_each_amount(e, [&](const Amount& amount, NumberRole role) {
    if (amount.is_symbol())
      visit(amount.symbol(), role);
    else
      for_each_symbol(amount, role, visit);
  });
}

/// Whether each of its numbers is that of one symbol.
inline bool is_plain(const Element& e) {
  return e.coefficient.is_symbol() && e.second.is_symbol() && e.rest.is_symbol();
}

inline bool is_plain(const Network& network) {
  bool all = true;
  for_each_element(network, [&all](const Element& e) { all = all && is_plain(e); });
  return all;
}

/// Whether K is a rational function of s, at all frequencies and for a motion in time.
inline bool is_rational(const Element& e) {
  switch (e.kind) {
    case ElementKind::spring:
    case ElementKind::damper:
    case ElementKind::mass:
    case ElementKind::maxwell:
      return true;
    case ElementKind::lossy:
    case ElementKind::measured:
      return false;
  }
  throw Bug("an element of no kind");
}

inline bool is_rational(const Network& network) {
  bool all = true;
  for_each_element(network, [&all](const Element& e) { all = all && is_rational(e); });
  return all;
}

/// Whether it stores energy and loses none, at rest as at any speed: a spring.
inline bool is_elastic(const Element& e) { return e.kind == ElementKind::spring; }
/// Whether its numbers are those of a table.
inline bool follows_table(const Element& e) { return e.kind == ElementKind::measured; }
/// What of it carries a load at rest.
inline std::optional<Element> at_rest(const Element& e) {
  if (follows_table(e) && e.rest.exists()) return Element{ElementKind::spring, e.rest, {}};
  if (!is_rational(e)) return Element{ElementKind::spring, e.coefficient, {}};
  return is_elastic(e) ? std::optional(e) : std::nullopt;
}
inline bool is_mass(const Element& e) { return e.kind == ElementKind::mass; }

/// What is left of it where `zero` holds for the numbers that are 0: nothing, but of a spring
/// without losses the spring.
template <class Zero>
std::optional<Element> without_zeros(const Element& e, const Zero& zero) {
  const auto coefficient = without_zeros(e.coefficient, zero);
  if (!coefficient) return std::nullopt;
  Element left = e;
  left.coefficient = *coefficient;
  if (!e.second.exists()) return left;
  const auto second = without_zeros(e.second, zero);
  if (!second) return is_rational(e) ? std::nullopt : at_rest(left);
  left.second = *second;
  return left;
}

}  // namespace vcrit
