// The real part as a function that stays as written; GiNaC's own multiplies it out.
#pragma once

#include <ginac/ginac.h>

namespace vcrit::symbolic {

/// Re(expression), a number where the expression is one.
GiNaC::ex real_part_of(const GiNaC::ex& expression);

}  // namespace vcrit::symbolic
