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
enum class MethodFamily { peer, own, machine };

/// How one method evaluates one problem.
struct TimedMethod {
  std::string method;
  CallMode mode = CallMode::sweep;
  MethodFamily family = MethodFamily::peer;
  std::function<void(const Samples&, double* out, double* extra)> run;
  /// What a caller would have at hand before: not timed.
  std::function<void(const Samples&)> prepare = [](const Samples&) {};
};

/// Methods that could not be built, with the reason.
struct MissingMethod {
  std::string subject, method, reason;
};

/// Rows of the table.
std::vector<std::string> all_methods();

std::vector<TimedMethod> loops_by_hand(const Subject& subject,
                                       const std::filesystem::path& compiler);
std::vector<TimedMethod> machine_limits(const std::filesystem::path& compiler);
std::vector<TimedMethod> sympy(const Subject& subject, const std::filesystem::path& compiler);
std::vector<TimedMethod> ginac(const Subject& subject);
/// The calls of the generated library that its header has.
std::vector<TimedMethod> generated(const Subject& subject, const std::filesystem::path& compiler);

/// All of them.
std::vector<TimedMethod> evaluators(const Subject& subject, const std::filesystem::path& compiler,
                                    std::vector<MissingMethod>& missing);

/// A function of a library, kept with it.
TimedMethod evaluator(const std::string& method, CallMode mode,
                      std::shared_ptr<const Library> library, const std::string& function);

}  // namespace vcrit::speed
