// Scene files. What is accepted reads the same again, and v* is a number of at least 0, infinity
// with its reason, or an error; where the contact may open, the simulated one as well.
#include <cmath>

#include "answers/critical_onset.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "fuzz.hpp"
#include "problem/problem.hpp"
#include "scene/scene.hpp"

using namespace vcrit;

namespace {

void check_velocity(const Scene& scene) {
  resolve(scene).values();
  const CertifiedVelocity critical = certified_critical_velocity(scene);
  fuzz::check(critical.value >= 0, "v* is no NaN and not negative");
  fuzz::check(std::isfinite(critical.value) || !critical.reason.empty(), "infinity has a reason");
  inadmissible_reasons(scene);
  fuzz::check(!std::isnan(creep_velocity(scene)), "creep is no NaN");
  if (!scene.separation) return;
  const CriticalOnset onset = critical_onset(scene);
  fuzz::check(onset.contact_velocity >= 0 && onset.drive_velocity >= onset.contact_velocity,
              "v* of a contact that opens is no NaN and not negative, and the drive no slower");
}

}  // namespace

void fuzz::read_scene(const std::string& text) {
  if (fuzz::many_branches(text)) return;
  fuzz::answered([&] {
    const Scene scene = parse_scene(text, "scene.toml");
    const Scene again = parse_scene(text, "scene.toml");
    fuzz::check(scene.normal == again.normal && scene.elements == again.elements,
                "one text is one scene");
    check_velocity(scene);
  });
}
