#include "accuracy/accuracy.hpp"

#include <fmt/core.h>

#include <exception>

#include "accuracy/evaluator_errors.hpp"
#include "accuracy/simulator_errors.hpp"
#include "accuracy/stability.hpp"
#include "critical/admissibility.hpp"
#include "run/driver.hpp"

namespace vcrit::validation::accuracy {

namespace {

constexpr std::uint64_t draw_seed = 20261121;  // any: the same inputs in every report
constexpr std::size_t drawn_sets = 4096;       // errors as rare as one in a thousand show

/// Null where it cannot be compiled.
const Driver* compiled(Driver& driver, Accuracy& result) {
  const auto compiler = find_compiler();
  if (!compiler) {
    result.left_out.emplace_back("No compiled evaluators: no C++ compiler was found.");
    return nullptr;
  }
  try {
    driver.compile(*compiler);
    return &driver;
  } catch (const std::runtime_error& error) {
    result.left_out.push_back(fmt::format("No compiled evaluators: {}.", error.what()));
    return nullptr;
  }
}

std::string compiler_version() {
  const PrivateFolder folder;
  return describe_compiler(*find_compiler(), folder.path());
}

void add_simulators(const Problem& problem, Accuracy& result) {
  if (const auto reasons = inadmissible_reasons(problem); !reasons.empty()) {
    result.left_out.push_back(fmt::format("No simulations: {}.", reasons.front()));
    return;
  }
  try {
    result.simulators = simulator_errors(problem, {0.1, 0.5, 0.99});
  } catch (const ModelError& error) {
    result.left_out.push_back(fmt::format("No simulations: {}.", error.what()));
  }
}

}  // namespace

Accuracy measure(Driver& own, const Progress& progress) {
  const Problem& problem = own.derivation().problem;
  Accuracy result;
  result.command = fmt::format("vcrit validate {} --out DIR", problem->source->file);
  progress("compiling all evaluators");
  const Driver* const driver = compiled(own, result);
  progress("evaluators: error against run time");
  result.evaluators =
      evaluator_errors(problem, driver, draw_inputs(problem, own.symbols(), drawn_sets, draw_seed));
  if (driver != nullptr) result.evaluators.compiler = compiler_version();
  progress("simulators: error against run time");
  add_simulators(problem, result);
  progress("stability maps");
  result.maps = stability_maps(problem, driver, result.left_out);
  return result;
}

}  // namespace vcrit::validation::accuracy
