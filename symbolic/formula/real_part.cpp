#include "formula/real_part.hpp"

namespace vcrit::symbolic {

DECLARE_FUNCTION_1P(Re)

namespace {

GiNaC::ex re_eval(const GiNaC::ex& argument) {
  if (GiNaC::is_a<GiNaC::numeric>(argument)) return GiNaC::real_part(argument);
  return Re(argument).hold();
}

GiNaC::ex re_evalf(const GiNaC::ex& argument) { return re_eval(argument.evalf()); }

}  // namespace

REGISTER_FUNCTION(Re, eval_func(re_eval).evalf_func(re_evalf))

GiNaC::ex real_part_of(const GiNaC::ex& expression) { return Re(expression); }

}  // namespace vcrit::symbolic
