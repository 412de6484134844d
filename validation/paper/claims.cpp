// What the paper says, and whether it holds: decided by the comparisons, none of it by words.
#include <fmt/core.h>

#include <algorithm>

#include "paper/paper.hpp"

namespace vcrit::validation::paper {

namespace {

/// All comparisons of these keys were made and passed.
bool shown(const Paper& paper, std::initializer_list<const char*> keys) {
  const std::vector<Comparison> all = all_comparisons(paper);
  return std::all_of(keys.begin(), keys.end(), [&](const char* key) {
    bool found = false;
    for (const Comparison& each : all) {
      if (each.key != key) continue;
      if (outcome(each) != Comparison::Outcome::passed) return false;
      found = true;
    }
    return found;
  });
}

/// The reduced model errs by more than `least` somewhere, as three methods agree.
bool reduced_model_errs(const Paper& paper, double least) {
  if (!shown(paper, {"exact", "moreau", "adaptive"})) return false;
  return std::any_of(paper.evidence.rows.begin(), paper.evidence.rows.end(), [&](const Witness& w) {
    return w.reduced - std::max({w.exact, w.moreau.back(), w.adaptive}) > least;
  });
}

using Verdict = Claim::Verdict;

Verdict held(bool shown) { return shown ? Verdict::holds : Verdict::not_shown; }
Verdict refuted(bool shown) { return shown ? Verdict::does_not_hold : Verdict::not_shown; }

Claim critical_velocity_holds(const Paper& paper) {
  return {
      "The critical velocity v* is (24), and (29), (30), (31) in its special cases.",
      "Derived from scenes by computer algebra and proved equal to the printed formulas; and by "
      "simulation, from above as the lowest speed of pure sliding, from below as the highest "
      "with stick.",
      held(shown(paper, {"equation", "threshold", "last_stick", "driven_threshold"}))};
}

Claim rheology_drops_out(const Paper& paper) {
  return {
      "Under a rigid drive an isotropic contact has the critical velocity of an elastic one, "
      "whatever its rheology.",
      fmt::format("Derived for all {} rheologies that can be a contact; simulated for δ = 1, 2, "
                  "10, 100.",
                  paper.proofs.rheologies.size()),
      held(shown(paper, {"no_rheology", "threshold", "last_stick"}))};
}

Claim amplitudes_hold(const Paper& paper) {
  return {"The contact stays closed up to D = 0.71, 0.45, 0.1, 0.01 for δ = 1, 2, 10, 100.",
          "1/√(1 + δ²), found again by bisection on two checks.",
          held(shown(paper, {"jump_printed", "jump_admissible", "jump_simulator"}))};
}

Claim reduced_curves(const Paper& paper) {
  return {"Friction below v* follows (47) to (51), and so the curves of Fig. 4.",
          "Three methods and 25 digits agree on other values. The equations leave out what the "
          "damper still relaxes after each stick, exp(−(τ − τ₂)/δ); they are right for δ → 0 and "
          "for v₀ → v*.",
          refuted(reduced_model_errs(paper, 0.01))};
}

Claim weaker_effect(const Paper& paper) {
  return {
      "At the largest amplitude without jumping, viscosity weakens the reduction of friction at "
      "small speeds.",
      "It follows from what was left out. In the full motion friction tends to the least normal "
      "force over its mean, 1 − D √(1 + δ²), for every δ, that is to zero at the largest "
      "amplitude: viscosity does not weaken the effect there. By the reduced model up to "
      "1 − 1/π = 0.68 of it would remain.",
      refuted(shown(paper, {"static_full", "static_rate", "static_reduced"}) &&
              reduced_model_errs(paper, 0.3))};
}

}  // namespace

const char* to_text(Claim::Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::does_not_hold:
      return "does not hold";
    case Verdict::not_shown:
      return "not shown";
  }
  throw Bug("a verdict without a name");
}

std::vector<Claim> judge(const Paper& paper) {
  return {critical_velocity_holds(paper), rheology_drops_out(paper), amplitudes_hold(paper),
          reduced_curves(paper), weaker_effect(paper)};
}

}  // namespace vcrit::validation::paper
