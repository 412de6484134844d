// v* of the independent nodal evaluation as an exact number, beside a scene's exact values.
#pragma once

#include "derivation/values.hpp"
#include "support/nodal.hpp"
#include "support/random_scene.hpp"

namespace vcrit::test {

inline GiNaC::numeric number(const Real& value) { return GiNaC::numeric(value.str(120).c_str()); }

/// Digits in which two numbers agree.
inline double agreement(const GiNaC::numeric& a, const GiNaC::numeric& b) {
  if (a.is_equal(b)) return 1000;
  return -(GiNaC::log(GiNaC::abs((a - b) / b)) / GiNaC::log(GiNaC::numeric(10))).to_double();
}

}  // namespace vcrit::test
