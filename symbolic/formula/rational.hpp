// Rational functions run on other numbers than GiNaC's.
#pragma once

#include <ginac/ginac.h>

#include <cstdlib>

#include "base/errors.hpp"

namespace vcrit::symbolic {

/// Evaluates a rational function. `Algebra` gives the type Value and
///   Value number(const GiNaC::numeric&) for rational numbers, name(const std::string&) for
///   symbols, add(a, b), multiply(a, b), invert(a).
template <class Algebra>
typename Algebra::Value evaluate_rational(const GiNaC::ex& function, const Algebra& algebra) {
  if (GiNaC::is_a<GiNaC::numeric>(function))
    return algebra.number(GiNaC::ex_to<GiNaC::numeric>(function));
  if (GiNaC::is_a<GiNaC::symbol>(function))
    return algebra.name(GiNaC::ex_to<GiNaC::symbol>(function).get_name());
  if (GiNaC::is_a<GiNaC::power>(function)) {
    const auto exponent = GiNaC::ex_to<GiNaC::numeric>(function.op(1)).to_int();
    const auto base = evaluate_rational(function.op(0), algebra);
    auto power = base;
    for (int i = 1; i < std::abs(exponent); ++i) power = algebra.multiply(power, base);
    return exponent < 0 ? algebra.invert(power) : power;
  }
  const bool is_sum = GiNaC::is_a<GiNaC::add>(function);
  ensure(is_sum || GiNaC::is_a<GiNaC::mul>(function), "rational functions have nothing but + * /");
  auto result = evaluate_rational(function.op(0), algebra);
  for (std::size_t i = 1; i < function.nops(); ++i) {
    const auto next = evaluate_rational(function.op(i), algebra);
    result = is_sum ? algebra.add(result, next) : algebra.multiply(result, next);
  }
  return result;
}

}  // namespace vcrit::symbolic
