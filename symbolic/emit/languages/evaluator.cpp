#include "emit/languages/evaluator.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/joined.hpp"
#include "emit/languages/cpp/dialect.hpp"
#include "emit/pieces.hpp"
#include "program/proof.hpp"

namespace vcrit::symbolic {

Evaluator::Evaluator(const Derivation& derivation_, const GenerateOptions& options_, Zeros zeros,
                     Spelled spelled)
    : derivation(derivation_),
      options(options_),
      fixed(fixed_values(derivation.problem, options.fixed)),
      parameters(derivation.problem, derivation, fixed, spelled),
      velocity(velocity_program(derivation.problem, parameters.values(), zeros)),
      gradient(gradient_program(velocity)) {
  const Proof proof(derivation, parameters.values());
  proof.holds(derivation);
  proof.holds(velocity);
  proof.holds(gradient);
  if (options.language == "c++")
    sweep = sweep_program(derivation.problem, parameters.values(), velocity);
  if (sweep) proof.holds(*sweep);
  const Program& program = gradient.program;
  // The product with the factor and its conversion stand outside of these.
  operations = program.operations(program.needed_for({gradient.ratio, velocity.factor})) + 2;
}

FunctionBody body(const Evaluator& evaluator, const CallDialect& dialect) {
  const VelocityProgram& velocity = evaluator.velocity;
  const GradientProgram& gradient = evaluator.gradient;
  StraightLine code(gradient.program, dialect);
  FunctionBody result;
  result.value =
      code.declare({velocity.above, velocity.below, velocity.factor, velocity.roundings});
  result.above = dialect.number(code.expression(velocity.above));
  result.below = dialect.number(code.expression(velocity.below));
  result.factor = dialect.number(code.expression(velocity.factor));
  result.roundings = dialect.bound(code.expression(velocity.roundings));
  std::vector<NodeId> partials;
  for (const auto& [symbol, partial] : gradient.partials) partials.push_back(partial);
  result.gradient = code.declare(partials);
  for (const Member& member : evaluator.parameters.members())
    for (int entry = member.length == 0 ? 0 : 1; entry <= member.length; ++entry) {
      const auto partial = gradient.partials.find({member.symbol, entry});
      result.partials.push_back(partial == gradient.partials.end()
                                    ? "0.0"
                                    : dialect.rounded(code.expression(partial->second)));
    }
  return result;
}

std::string in_range(const Evaluator& evaluator, const Spelling& spelling,
                     const std::string& conjunction, const std::string& never) {
  if (!evaluator.velocity.fits) return never;
  const GuardCalls dialect(evaluator.parameters, spelling);
  const StraightLine code(evaluator.velocity.program, dialect);
  std::vector<std::string> checks;
  for (const Guard& guard : evaluator.velocity.guards)
    checks.push_back(fmt::format("{}within({}, {})", spelling.prefix,
                                 literal(std::ldexp(1.0, guard.exponent)),
                                 code.expression(guard.expression).text));
  if (evaluator.velocity.poisson)
    checks.push_back(poisson_check(evaluator.parameters, evaluator.velocity));
  return joined(checks, conjunction);
}

std::vector<std::string> entries(const ParameterList& parameters) {
  std::vector<std::string> result;
  for (const Member& member : parameters.members()) {
    if (member.length == 0) result.push_back(member.name);
    for (int i = 0; i < member.length; ++i) result.push_back(fmt::format("{}[{}]", member.name, i));
  }
  return result;
}

std::string c_members(const ParameterList& parameters) {
  std::vector<std::string> names;
  for (const Member& member : parameters.members())
    names.push_back(member.length == 0 ? member.name
                                       : fmt::format("{}[{}]", member.name, member.length));
  return statement(fmt::format("double {};", joined(names, ", ")));
}

std::string statements(const std::vector<StraightLine::Declarations>& declarations,
                       const CodeDialect& dialect) {
  std::string out;
  for (const auto& [kind, items] : declarations)
    out += statement(fmt::format("{} {};", dialect.type(kind), joined(items, ", ")));
  return out;
}

}  // namespace vcrit::symbolic
