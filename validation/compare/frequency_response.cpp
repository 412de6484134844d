#include "compare/frequency_response.hpp"

#include <map>

#include "analysis/asymptotes.hpp"
#include "compare/formulas.hpp"
#include "compare/frequency_points.hpp"
#include "formula/symbols.hpp"
#include "formula/value.hpp"

namespace vcrit::validation {

namespace {

std::vector<AsymptoteLine> asymptotes_of(const symbolic::Derivation& derivation,
                                         const Values& values) {
  std::map<Symbol, GiNaC::numeric> numbers;
  for (const auto& [symbol, value] : values) numbers[symbol] = GiNaC::numeric(value);
  std::vector<AsymptoteLine> lines;
  for (const symbolic::Asymptote& asymptote : symbolic::asymptotes(derivation)) {
    const double coefficient =
        symbolic::value_at(asymptote.coefficient, asymptote.definitions, numbers).to_double();
    lines.push_back(
        {!asymptote.high, asymptote.power, coefficient,
         formula_of(asymptote.coefficient * GiNaC::pow(symbolic::omega(), asymptote.power)),
         equations_of(asymptote.definitions)});
  }
  return lines;
}

}  // namespace

FrequencyResponse frequency_response(const symbolic::Derivation& derivation) {
  FrequencyResponse result = frequency_points(derivation.problem);
  if (!result.points.empty())
    result.asymptotes = asymptotes_of(derivation, derivation.problem.values());
  return result;
}

}  // namespace vcrit::validation
