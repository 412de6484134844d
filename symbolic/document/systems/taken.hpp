// A derived formula that is taken to another system: what it is made of, apart from the system's
// syntax.
#pragma once

#include <string>
#include <vector>

#include "document/content.hpp"
#include "formula/form.hpp"
#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// A symbol that has its value from outside.
struct TakenParameter {
  enum class Domain {
    positive,
    poisson,  ///< above -1, at most 1/2
    complex   ///< a measured receptance
  };
  std::string symbol;  ///< its name within the program, as Form::text
  Domain range = Domain::positive;
  std::string meaning, unit;  ///< "spring", "N/m"
};

struct TakenDefinition {
  std::string symbol;  ///< likewise
  Form meaning;
  bool complex = false;
};

/// v* (m/s), real, of parameters in SI units and of definitions, each of which needs none but
/// earlier ones. The only name besides theirs is that of the imaginary unit.
struct TakenFormula {
  std::vector<std::string> notes;  ///< what its reader has to know
  std::vector<TakenParameter> parameters;
  std::vector<TakenDefinition> definitions;
  Form velocity;
};

/// In the form that was asked for.
TakenFormula taken_formula(const Problem& problem, const Findings& findings);

/// Whether a value may be complex, where those of `complex` and the imaginary unit are.
bool may_be_complex(const Form& form, const std::vector<std::string>& complex);

}  // namespace vcrit::symbolic
