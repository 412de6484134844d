// All ways to evaluate v* that are compared.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "speed/library.hpp"
#include "speed/samples.hpp"

namespace vcrit::speed {

/// machine: no evaluation, but what a division and a square root a value take.
enum class Family { peer, own, machine };

/// How one method evaluates one problem.
struct Evaluator {
  std::string method;
  Mode mode = Mode::sweep;
  Family family = Family::peer;
  std::function<void(const Samples&, double* out, double* extra)> run;
  /// What a caller would have at hand before: not timed.
  std::function<void(const Samples&)> prepare = [](const Samples&) {};
};

/// Methods that could not be built, with the reason.
struct Missing {
  std::string subject, method, reason;
};

/// Rows of the table.
std::vector<std::string> all_methods();

std::vector<Evaluator> loops_by_hand(const Subject& subject, const std::filesystem::path& compiler);
std::vector<Evaluator> machine_limits(const std::filesystem::path& compiler);
std::vector<Evaluator> sympy(const Subject& subject, const std::filesystem::path& compiler);
std::vector<Evaluator> ginac(const Subject& subject);
/// The calls of the generated library that its header has.
std::vector<Evaluator> generated(const Subject& subject, const std::filesystem::path& compiler);

/// All of them.
std::vector<Evaluator> evaluators(const Subject& subject, const std::filesystem::path& compiler,
                                  std::vector<Missing>& missing);

/// A function of a library, kept with it.
Evaluator evaluator(const std::string& method, Mode mode, std::shared_ptr<const Library> library,
                    const std::string& function);

}  // namespace vcrit::speed
