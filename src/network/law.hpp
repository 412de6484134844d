// What each kind of element is: its law, and the numbers that it has. Said here alone; a kind that
// the switches do not know does not compile.
#pragma once

#include <utility>

#include "base/errors.hpp"
#include "network/network.hpp"

namespace vcrit {

/// K(s) of an element in an algebra, which gives the type Value and
///   Value of(const Symbol&)                 a number as a stiffness
///   Value times_s(const Value& k)           k s
///   Value relaxing(const Value& k, const Value& tau)   k tau s/(1 + tau s), for numbers k and tau
/// Each algebra has its own best way to these.
template <class Algebra>
typename std::remove_reference_t<Algebra>::Value law(const Element& e, Algebra&& algebra) {
  auto coefficient = algebra.of(e.coefficient);
  switch (e.kind) {
    case ElementKind::spring:
      return coefficient;
    case ElementKind::damper:
      return algebra.times_s(coefficient);
    case ElementKind::mass:
      return algebra.times_s(algebra.times_s(coefficient));
    case ElementKind::maxwell:
      return algebra.relaxing(coefficient, algebra.of(e.time));
  }
  throw Bug("an element of no kind");
}

/// What a number of an element measures.
enum class NumberRole { stiffness, damping, time, mass };

/// visit(symbol, role) for each number of an element, in the order of writing.
template <class Visit>
void for_each_number(const Element& e, const Visit& visit) {
  switch (e.kind) {
    case ElementKind::spring:
      return visit(e.coefficient, NumberRole::stiffness);
    case ElementKind::damper:
      return visit(e.coefficient, NumberRole::damping);
    case ElementKind::mass:
      return visit(e.coefficient, NumberRole::mass);
    case ElementKind::maxwell:
      visit(e.coefficient, NumberRole::stiffness);
      return visit(e.time, NumberRole::time);
  }
}

/// Whether it stores energy and loses none, at rest as at any speed: a spring.
inline bool is_elastic(const Element& e) { return e.kind == ElementKind::spring; }
inline bool is_mass(const Element& e) { return e.kind == ElementKind::mass; }

}  // namespace vcrit
