#include "report/paper_page.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "paper/verdicts.hpp"
#include "report/chart.hpp"
#include "report/document.hpp"
#include "report/equations.hpp"
#include "report/html.hpp"
#include "report/paper_tables.hpp"
#include "report/sections.hpp"

namespace vcrit::validation::report {

namespace {

using paper::Paper;

std::string badge(const Comparison& comparison) {
  const bool held = outcome(comparison) == Comparison::Outcome::passed;
  return fmt::format("<span class=\"badge {}\">{}</span>", held ? "passed" : "failed",
                     held ? "proved equal" : "not equal");
}

/// The comparisons begin with those of the proofs, in their order.
std::string proofs_of(const char* number, const paper::Proofs& proofs) {
  std::string by_hand, ways;
  bool legible = false;
  for (std::size_t i = 0; i < proofs.proofs.size(); ++i) {
    const paper::Proof& proof = proofs.proofs[i];
    if (proof.equation != number) continue;
    by_hand = proof.by_hand.mathml;
    legible = proof.legible;
    ways +=
        fmt::format("<li><p>{} {}</p>{}</li>\n", escape(proof.words),
                    badge(proofs.comparisons.at(i)), equation(velocity_sign, proof.derived.mathml));
  }
  return fmt::format(
      "<h3>Equation {}</h3>\n<p>{}</p>\n{}\n<p>As derived:</p>\n<ol>\n{}</ol>\n", number,
      legible ? "As printed:"
              : "Worked out by hand, since the source at hand does not show it legibly:",
      equation(velocity_sign, by_hand), ways);
}

std::string equations_section(const paper::Proofs& proofs) {
  std::string calls;
  for (const std::string& call : proofs.rheologies)
    calls += (calls.empty() ? "" : ", ") + ("<code>" + escape(call) + "</code>");
  return section(
      "equations", "Equations (27) and (29) to (31), derived",
      "<p>Computer algebra sets up the harmonic balance of contact point and body for each scene "
      "and solves it; the paper’s formula is typed in. Both are positive, and their squares are "
      "rational functions, whose normal form decides whether they are equal.</p>\n" +
          proofs_of("(27)", proofs) + proofs_of("(29)", proofs) + proofs_of("(30)", proofs) +
          proofs_of("(31)", proofs) +
          "<h3>No rheology is left</h3>\n<p>Under a rigid drive an isotropic contact, "
          "K<sub>t</sub> "
          "= r K<sub>n</sub>, has v* = μ₀ ω du<sub>z</sub>/r. Derived for " +
          calls +
          ". Those that flow cannot carry a mean load as normal contact, but have the same "
          "formula.</p>"
          "\n",
      proofs.comparisons);
}

std::string range_section(const paper::Part& part) {
  return section("range", "Where (24) holds",
                 "<p>Springs, dampers and branches in many orders, as contact and as drive, with "
                 "and without a body: simulated, and compared with (24) and with what follows from "
                 "it.</p>\n",
                 part.comparisons);
}

std::string viscosity_section(const paper::Viscosity& viscosity) {
  return section(
      "viscosity", "What viscosity does to the effect",
      "<p>It depends on what is kept. At equal amplitude D = du<sub>z</sub>/u<sub>z0</sub> a "
      "viscous contact loses more friction than an elastic one at every speed below v*. But it "
      "also stays closed only up to a smaller amplitude, D<sub>max</sub> = 1/√(1 + δ²). At equal "
      "relative amplitude a = D/D<sub>max</sub>, which is equal amplitude of the normal force, it "
      "loses less friction for 0 &lt; v₀ &lt; v<sub>c</sub>, and more above. As v₀ → 0 nothing "
      "depends on δ.</p>\n" +
          panels(viscosity.figures) + crossing_table(viscosity),
      viscosity.comparisons);
}

std::string shapes_section(const paper::Part& part) {
  return section(
      "shapes", "Indenters of other shapes",
      "<p>By the method of dimensionality reduction an indenter is a row of independent contacts. "
      "A Zener half-space under a rigid drive: all shapes have one v*, and the rim of a round one "
      "opens in each period. The method takes for granted that pressure and shear do not couple, "
      "that Poisson’s ratio does not change in time, a half-space, and one direction of "
      "sliding.</p>\n",
      part.comparisons);
}

std::string misprints_section(const paper::Misprints& misprints) {
  return section("misprints", "Phases in (41) and (43)",
                 fmt::format("<p>Tried on the steady motion of an elastic contact at v*/2. With "
                             "sin for cos in (43), and ωt₁ for ωt in (41), both are 0 where they "
                             "have to be. As printed they are {} and {}.</p>\n",
                             paper::signed_words(misprints.velocity_as_printed, 4),
                             paper::signed_words(misprints.force_as_printed, 4)),
                 misprints.comparisons);
}

std::string figure4_section(const paper::Figure4& figure) {
  return section(
      "figure4", "Fig. 4, twice",
      "<p>Isotropic Kelvin contact under a rigid drive, δ = ω c/k: friction against speed for six "
      "amplitudes D = du<sub>z</sub>/u<sub>z0</sub>, evenly from 0 to the largest without jumping. "
      "There F<sub>n</sub> touches zero, so 0.999999 of it is drawn. The figure itself is not in "
      "the source at hand; the amplitudes are a reading of its caption. Dashed: an elastic "
      "contact, "
      "δ = 0, with the same amplitudes. Circles: known to 25 digits, at 0.9 of the largest "
      "amplitude; they lie on the dotted curve where the model is right.</p>\n<h3>By the reduced "
      "model, (47) to (51)</h3>\n" +
          panels(figure.reduced) +
          "<h3>By the full motion</h3>\n<p>With the transient that each stick leaves behind, which "
          "(50) and (51) drop.</p>\n" +
          panels(figure.full),
      figure.comparisons);
}

std::string map_section(const paper::DifferenceMap& map) {
  return section("difference", "How far the reduced model is off",
                 fmt::format("<p>It never says too little friction. At any speed it is off by less "
                             "than {} up to δ = {:.2g}, and for every δ above about ¾ v*.</p>\n",
                             map.allowed, map.safe_delta) +
                     chart(map.figure),
                 map.comparisons);
}

std::string jump_section(const paper::JumpLimits& limits) {
  return section(
      "jumping", "Amplitudes without jumping",
      "<p>The contact stays closed while D √(1 + δ²) &lt; 1 (52).</p>\n" + jump_table(limits),
      limits.comparisons);
}

std::string slow_section(const paper::StaticLimit& limit) {
  return section(
      "slow", "Vanishing speed",
      "<p>Friction tends to the least normal force over its mean, 1 − D √(1 + δ²), as the power ⅔ "
      "of "
      "speed: the contact creeps up to its bound and slips only where the bound is least. At the "
      "largest amplitude nothing is left of friction, for every δ. The reduced model tends to "
      "1 − D (δ + π/2 + atan(1/δ))/π instead.</p>\n" +
          static_table(limit),
      limit.comparisons);
}

std::string punch_section(const paper::FlatPunch& punch) {
  return section(
      "flat-punch", "The elastic flat punch",
      "<p>Without damping the friction ratio is 1 − D G(v₀/v*) in closed form. Its slope "
      "is −π at rest, and it ends as 9/(4π) (1 − v₀/v*)². The fit often quoted is ¾ (1 − "
      "v₀/v*)² + ¼ (1 − v₀/v*)⁴.</p>\n" +
          chart(punch.figure) + punch_table(punch),
      punch.comparisons);
}

const char* verdict_style(paper::Claim::Verdict verdict) {
  using Verdict = paper::Claim::Verdict;
  if (verdict == Verdict::holds) return "passed";
  return verdict == Verdict::fails ? "failed" : "not-run";
}

std::string verdict_badge(const paper::Claim& claim) {
  return fmt::format("<span class=\"badge {}\">{}</span>", verdict_style(claim.verdict),
                     paper::to_text(claim.verdict));
}

/// How many comparisons decide the claim, and how many of them passed.
std::string decided_by(const paper::Claim& claim, const Paper& paper) {
  if (claim.keys.empty()) return "Nothing to compare.";
  std::size_t made = 0, passed = 0;
  for (const Comparison& each : all_comparisons(paper)) {
    if (std::find(claim.keys.begin(), claim.keys.end(), each.key) == claim.keys.end()) continue;
    ++made;
    passed += outcome(each) == Comparison::Outcome::passed ? 1 : 0;
  }
  return fmt::format("{} of {} comparisons passed.", passed, made);
}

std::string claims_section(const Paper& paper) {
  std::string claims;
  for (const paper::Claim& claim : paper.claims)
    claims += fmt::format(
        "<li id=\"claim-{}\" value=\"{}\"><p><strong>{}</strong> {}</p><p>{} "
        "<small>In the paper: {}. {}</small></p></li>\n",
        claim.number, claim.number, escape(claim.words), verdict_badge(claim),
        escape(claim.evidence), escape(claim.where), decided_by(claim, paper));
  return section(
      "claims", "What holds",
      "<ol class=\"claims\">\n" + claims +
          "</ol>\n<h3>Three methods</h3>\n<p>They share no code: the exact motion between events, "
          "Moreau’s time stepping, which is blind to events, and an adaptive integrator that "
          "switches at located ones.</p>\n" +
          witness_table(paper.evidence),
      paper.evidence.comparisons);
}

std::string in_short(const std::vector<paper::Claim>& claims) {
  std::string lines;
  for (const paper::Claim& claim : claims)
    lines += fmt::format("<li value=\"{0}\"><a href=\"#claim-{0}\">{1}</a> {2}</li>\n",
                         claim.number, escape(claim.words), verdict_badge(claim));
  return "<p>What the paper says, <a href=\"#claims\">and what holds</a>:</p>\n<ol>\n" + lines +
         "</ol>\n";
}

std::string paper_opening(const PaperContents& contents) {
  const auto comparisons = all_comparisons(contents.paper);
  return fmt::format(
      "<a class=\"skip\" href=\"#content\">To the results</a>\n"
      "<header class=\"page\"><p class=\"program\">vcrit {}</p>\n"
      "<h1>The paper, gone through</h1>\n"
      "<p class=\"lead\">Zughaibi, Schulze, Li: Critical velocity of controllability of "
      "sliding friction by normal oscillations for an arbitrary linear rheology, Physical "
      "Mesomechanics 2018, doi 10.24411/1683-805X-2018-12009. Each number here is compared with "
      "one found in another way.</p>\n{}</header>\n<main id=\"content\">\n",
      escape(contents.origin.machine.program),
      verdict(comparisons) + in_short(contents.paper.claims));
}

}  // namespace

std::string paper_page(const PaperContents& contents) {
  const Paper& paper = contents.paper;
  return document({"The paper, gone through",
                   paper_opening(contents) + equations_section(paper.proofs) +
                       range_section(paper.range) + figure4_section(paper.figure4) +
                       map_section(paper.map) + jump_section(paper.jumps) +
                       slow_section(paper.slow) + viscosity_section(paper.viscosity) +
                       punch_section(paper.punch) + shapes_section(paper.shapes) +
                       misprints_section(paper.misprints) + claims_section(paper) +
                       machine_section(contents.origin) + "</main>\n",
                   true,
                   {}});
}

}  // namespace vcrit::validation::report
