// What every language prints: the parameters and programs of a scene, made and proved once, and one
// evaluation of them as statements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/languages/call_dialect.hpp"
#include "emit/parameters.hpp"
#include "program/gradient.hpp"
#include "program/sweep.hpp"
#include "program/velocity.hpp"

namespace vcrit::symbolic {

struct Evaluator {
  /// Throws ModelError for a scene of which no code is generated (rules/rulebook.hpp).
  Evaluator(const Derivation& derivation, const GenerateOptions& options, Zeros zeros,
            Spelled spelled = nullptr);

  const Derivation& derivation;
  const GenerateOptions& options;
  FixedValues fixed;
  ParameterList parameters;
  VelocityProgram velocity;
  GradientProgram gradient;
  std::optional<SweepProgram> sweep;  ///< in C++
  int operations;                     ///< of the value

  bool has(Node::Operation operation) const { return gradient.program.has(operation); }
};

/// Declarations that lead to v*, then those that lead from there to its derivatives.
struct FunctionBody {
  std::vector<StraightLine::Declarations> value, gradient;
  std::string above, below, factor;   ///< of the grade's number type
  std::string roundings;              ///< of its type of bounds
  std::vector<std::string> partials;  ///< doubles, in the order of the parameters' entries
};

FunctionBody body(const Evaluator& evaluator, const CallDialect& dialect);

/// "within(L, a) && within(L, b)" with `never` where no values are in range.
std::string in_range(const Evaluator& evaluator, const Spelling& spelling,
                     const std::string& conjunction, const std::string& never);

/// All numbers of the parameters: "k0", or "k[2]" for the third entry of an array.
std::vector<std::string> entries(const ParameterList& parameters);

/// "  double mu0, omega;\n  double k[10];\n": members of a struct in C and C++.
std::string c_members(const ParameterList& parameters);

/// Declarations as statements of C, C++ or JavaScript.
std::string statements(const std::vector<StraightLine::Declarations>& declarations,
                       const CodeDialect& dialect);

}  // namespace vcrit::symbolic
