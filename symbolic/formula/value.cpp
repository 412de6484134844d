#include "formula/value.hpp"

#include "base/errors.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

GiNaC::numeric value_at(const GiNaC::ex& formula, const std::vector<Line>& definitions,
                        const std::map<Symbol, GiNaC::numeric>& values) {
  const AlgebraLock lock;
  GiNaC::exmap known;
  for (const auto& [name, value] : values) {
    known[symbol(name)] = value;
    known[poisson_ratio(name)] = value;
  }
  const auto omega_value = known.find(omega());
  if (omega_value != known.end()) known[laplace()] = GiNaC::I * omega_value->second;
  const auto evaluate = [&known](const GiNaC::ex& expression) {
    const GiNaC::ex number = expression.subs(known, GiNaC::subs_options::no_pattern).evalf();
    ensure(GiNaC::is_a<GiNaC::numeric>(number), "a formula whose symbols all have values");
    return GiNaC::ex_to<GiNaC::numeric>(number);
  };
  for (const Line& line : definitions) known[line.left] = evaluate(line.right);
  return evaluate(formula);
}

}  // namespace vcrit::symbolic
