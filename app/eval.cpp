// vcrit eval: v* of a scene, correctly rounded, and whether Eq. 24 applies.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "options.hpp"

namespace vcrit::app {

namespace {

struct Result {
  CertifiedVelocity critical;
  std::vector<std::string> reasons;  // why not admissible
  double drive_velocity;
};

Result evaluate(const Scene& scene) {
  const CertifiedVelocity critical = certified_critical_velocity(scene);
  return {critical, inadmissible_reasons(scene), critical.value + creep_velocity(scene)};
}

void print_json(const Result& result) {
  std::vector<std::string> reasons = result.reasons;
  if (!result.critical.reason.empty()) reasons.push_back(result.critical.reason);
  print({{"critical_velocity", number(result.critical.value)},
         {"relative_error_bound", number(result.critical.relative_error_bound)},
         {"admissible", result.reasons.empty()},
         {"reasons", reasons},
         {"drive_velocity", number(result.drive_velocity)}});
}

void print_text(const Scene& scene, const Result& result) {
  if (!scene.title.empty()) fmt::print("{}\n", scene.title);
  fmt::print("critical velocity v*  {} m/s\n", result.critical.value);
  if (!result.critical.reason.empty())
    fmt::print("                      {}\n", result.critical.reason);
  fmt::print("relative error        at most {:.2g}\n", result.critical.relative_error_bound);
  if (result.drive_velocity != result.critical.value)
    fmt::print("drive velocity        {} m/s (the path creeps)\n", result.drive_velocity);
  fmt::print("admissible            {}\n", result.reasons.empty() ? "yes" : "no");
  for (const std::string& reason : result.reasons) fmt::print("                      {}\n", reason);
}

}  // namespace

void add_eval(CLI::App& program) {
  struct Options {
    SceneOptions scene;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("eval", "Critical velocity of a scene as a number");
  options->scene.add_to(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] {
    const Scene scene = options->scene.read();
    const Result result = evaluate(scene);
    if (options->json)
      print_json(result);
    else
      print_text(scene, result);
  });
}

}  // namespace vcrit::app
