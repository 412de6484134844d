// What the paper says, and whether it holds. The verdicts are known; a claim has its verdict only
// while the comparisons that show it pass, and is "not shown" otherwise. Numbers in the words are
// what these comparisons found.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/sort_stably.hpp"
#include "paper/paper.hpp"
#include "paper/verdicts.hpp"

namespace vcrit::validation::paper {

namespace {

using Verdict = Claim::Verdict;

Claim claim(const Paper& paper, Claim told) {
  if (!shown(paper, told.keys)) told.verdict = Verdict::not_shown;
  return told;
}

/// The reduced model errs by more than `least` somewhere, as three methods agree.
bool reduced_model_errs(const Paper& paper, double least) {
  return std::any_of(paper.evidence.rows.begin(), paper.evidence.rows.end(), [&](const Witness& w) {
    return w.reduced - std::max({w.exact, w.moreau.back(), w.adaptive}) > least;
  });
}

/// Friction by both models at one point of the table of three methods.
std::string both_models(const Paper& paper, double delta, double ratio) {
  for (const Witness& row : paper.evidence.rows)
    if (row.delta == delta && row.ratio == ratio)
      return fmt::format("{:.4f} instead of {:.4f} (δ = {}, v₀/v* = {})", row.reduced, row.exact,
                         delta, ratio);
  return {};
}

double only(const std::vector<double>& numbers) { return numbers.empty() ? 0 : numbers.front(); }
double most(const std::vector<double>& numbers) {
  return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
}

std::vector<Claim> about_velocity(const Paper& paper) {
  return {
      {1,
       "abstract, 3.1, (24)",
       "The critical velocity is (24) for any linear rheology.",
       fmt::format(
           "Simulated for many contacts and drives as the lowest speed of continuous sliding, and "
           "for Kelvin contacts from below as the highest with stick. v* is the mean velocity of "
           "the contact point, and the contact has to stay closed. The one exception is an "
           "undamped "
           "drive that swings freely at n ω: there sliding goes on down to v* cos(π/(2n)), {} for "
           "n "
           "= 2 to 5.",
           found_words(paper, "free_swing", 4)),
       {"rheologies", "free_swing", "threshold", "last_stick", "driven_threshold"},
       Verdict::holds},
      {2,
       "abstract, 3.2",
       "All former results are limits of (24).",
       "(27), (29), (30) and (31), derived from scenes by computer algebra and proved equal to the "
       "formulas typed in. Of these only (30) is legible in the source at hand; the others are "
       "worked out by hand. Under a rigid drive no rheology is left in v* of an isotropic contact.",
       {"equation", "no_rheology"},
       Verdict::holds},
      {3,
       "1, 3, 4.2",
       "Above v* the oscillation does not reduce friction.",
       "For every δ: (31) does not contain it. Simulated up to 10 v*; just below v* there is a "
       "reduction.",
       {"above", "below", "threshold"},
       Verdict::holds},
      {4,
       "3.1",
       "Both (3) and (4) have to be checked.",
       "(4) is enough. |K_n(iω)| ≥ K_n(0) for springs and dampers, as the storage stiffness grows "
       "with ω; so the normal force reaches 0 before the body lifts off.",
       {"force_before_height"},
       Verdict::in_part},
      {5,
       "4.2, (52)",
       "The largest D is 0.71, 0.45, 0.1, 0.01 for δ = 1, 2, 10, 100.",
       fmt::format("1/√(1 + δ²) = {}, found again by bisection on two checks.",
                   found_words(paper, "jump_printed", 7)),
       {"jump_printed", "jump_admissible", "jump_simulator"},
       Verdict::holds},
  };
}

std::vector<Claim> about_friction(const Paper& paper) {
  const bool errs = reduced_model_errs(paper, 0.01);
  return {
      {6,
       "4.1, (47)–(51)",
       "Friction below v* follows (47) to (51).",
       fmt::format("Three methods and 25 digits agree on other values: {}; {}. The equations leave "
                   "out what the damper still relaxes after each stick, exp(−(τ − τ₂)/δ). They are "
                   "right for δ → 0 and v₀ → v*.",
                   both_models(paper, 1, 0.1), both_models(paper, 100, 0.1)),
       {"exact", "moreau", "adaptive", "figure4_reduced"},
       errs ? Verdict::fails : Verdict::not_shown},
      {7,
       "4.2",
       "δ = 0 gives the elastic contact.",
       fmt::format("There both models are one: {:.12f} at v₀/v* = 0.1, D = 0.9.",
                   only(found(paper, "elastic"))),
       {"elastic", "figure4_reduced", "punch_simulated", "punch_closed"},
       Verdict::holds},
      {8,
       "4.2",
       "Friction tends to μ₀ with growing speed.",
       fmt::format("Without a body it never falls, and rises ever more slowly. With one it may be "
                   "below the straight line from 0 to v*: {:.4f} at 0.8 v*.",
                   only(found(paper, "below_diagonal"))),
       {"rises", "concave", "above", "below_diagonal"},
       Verdict::holds},
      {14,
       "4.2, Fig. 4",
       "The six curves of each panel.",
       "The figure is not in the source at hand, only its caption. The six amplitudes drawn here "
       "are a reading of “linearly increasing”.",
       {},
       Verdict::not_legible},
  };
}

std::vector<Claim> about_viscosity(const Paper& paper) {
  const std::vector<double> initial = found(paper, "initial");
  return {
      {9,
       "4.2",
       "At D_max the initial reduction is less distinct than that of an elastic contact.",
       fmt::format(
           "As v₀ → 0 there is no difference: μ/μ₀ → 1 − a for every δ, which is 0 at D_max. Up to "
           "v_c (claim 10) it is so, by far less than by the reduced model: at 0.1 v* friction is "
           "{:.4f} for δ = "
           "100 against {:.4f} elastic. The reduced model leaves {:.2f} at rest, where nothing is "
           "left. Above v_c the contrary is true.",
           initial.empty() ? 0 : initial.back(), only(initial),
           most(found(paper, "reduced_remainder"))),
       {"initial", "static_full", "static_rate", "static_reduced", "reduced_remainder", "crossing"},
       Verdict::in_part},
      {10,
       "5",
       "With increasing viscosity the effect declines.",
       fmt::format(
           "Only at equal D/D_max, which is equal amplitude of the normal force, and only for 0 < "
           "v₀ < v_c: v_c/v* = {} for δ → 0, 0.3, 1, 2, 10, 100, ∞. There viscosity takes at most "
           "{:.4f} of μ/μ₀ from the reduction, per a; above v_c it adds at most {:.4f}.",
           found_words(paper, "crossing", 4), most(found(paper, "most_weakening")),
           most(found(paper, "most_strengthening"))),
       {"viscosity", "crossing", "most_weakening", "most_strengthening"},
       Verdict::in_part},
      {11,
       "5",
       "The decline comes from the restricted amplitude.",
       "At equal D nothing declines (claim 12).",
       {"stronger", "any_rheology"},
       Verdict::holds},
      {12,
       "5",
       "At the same amplitude the reduction is stronger than that of an elastic contact.",
       "At every speed below v*, and the more the larger δ is. The proof in docs/physics.md "
       "covers every isotropic rheology under a rigid drive, against the elastic contact with its "
       "stiffness at rest.",
       {"stronger", "any_rheology", "viscosity"},
       Verdict::holds},
      {13,
       "4.2",
       "At high viscosity the reduction is still strong, though the amplitude is tiny.",
       fmt::format(
           "More than by the reduced model. At D = 0.009 and 0.1 v*, δ = 100 and elastic: {}.",
           found_words(paper, "tiny_amplitude", 4)),
       {"tiny_amplitude", "viscosity"},
       Verdict::holds},
  };
}

std::vector<Claim> about_the_rest(const Paper& paper) {
  const Misprints& misprints = paper.misprints;
  const std::vector<double> ratios = found(paper, "stiffness_ratio");
  const bool apart =
      std::min(std::abs(misprints.velocity_as_printed), std::abs(misprints.force_as_printed)) > 0.1;
  return {
      {15,
       "5",
       "It is easily generalized to indenters of any shape.",
       fmt::format(
           "Under a rigid drive all shapes have one v*. But the rim opens in each period, against "
           "(4): {:.1f} % of the width of the parabola tried. An elastic drive couples the "
           "springs, "
           "and (24) is gone. The method needs uncoupled normal and tangential problems (β = "
           "{:.4f} "
           "at ν = 0.3 on a rigid base, 0 at ν = ½) and a constant ν: with a constant bulk modulus "
           "ν goes from 0.3 to 0.48, and K_t/K_n from {:.4f} to {:.4f}.",
           100 * only(found(paper, "rim")), only(found(paper, "coupling")), only(ratios),
           ratios.empty() ? 0 : ratios.back()),
       {"shape", "rim", "coupling", "stiffness_ratio"},
       Verdict::in_part},
      {16,
       "4.1, (43)",
       "v₀ + μ₀ ω du_z (k_n/k_t) cos ωt₁ = 0 where stick begins.",
       fmt::format("A misprint or the scan’s: it must be sin, by (42) put into (34), and by (50). "
                   "With cos the left side is {} of μ₀ ω du_z k_n/k_t at v₀ = v*/2.",
                   signed_words(misprints.velocity_as_printed, 4)),
       {"stick_begins"},
       apart ? Verdict::fails : Verdict::not_shown},
      {17,
       "4.1, (41)",
       "The force of the stuck contact has cos ωt.",
       fmt::format("A misprint or the scan’s: it must be cos ωt₁, by (48), and as the force is "
                   "continuous where stick begins. With cos ωt it is {:.4f} of its amplitude too "
                   "large where stick ends, at v₀ = v*/2.",
                   misprints.force_as_printed),
       {"stick_force"},
       apart ? Verdict::fails : Verdict::not_shown},
  };
}

}  // namespace

std::vector<Claim> judge(const Paper& paper) {
  std::vector<Claim> claims;
  for (const auto& part : {about_velocity(paper), about_friction(paper), about_viscosity(paper),
                           about_the_rest(paper)})
    for (const Claim& each : part) claims.push_back(claim(paper, each));
  sort_stably(claims, [](const Claim& a, const Claim& b) { return a.number < b.number; });
  return claims;
}

}  // namespace vcrit::validation::paper
