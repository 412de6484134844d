#include "problem/findings.hpp"

#include <utility>

#include "scene/findings.hpp"

namespace vcrit {

ProblemFindings examine_problem(const std::string& text, const std::string& file) {
  SceneFindings scene = examine_scene(text, file);
  ProblemFindings found{std::move(scene.errors), std::move(scene.warnings), {}};
  if (!scene.scene) return found;
  Complaints complaints(Complaints::Mode::all);
  complaints.attempt([&] { found.problem = resolve(*scene.scene); });
  found.errors = complaints.sorted();
  return found;
}

}  // namespace vcrit
