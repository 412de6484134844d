#include "report/paper_record.hpp"

#include <algorithm>
#include <cmath>

#include "paper/verdicts.hpp"
#include "report/records.hpp"
#include "report/verdict.hpp"

namespace vcrit::record {

namespace paper = validation::paper;
using validation::Comparison;

void fields(Fields& f, const paper::EquationProof& it) {
  f("equation", it.equation)("words", it.words)("derived", it.derived)("by_hand", it.by_hand);
  f("legible", it.legible);
}

namespace {

constexpr const char* derived_equations[] = {"(27)", "(29)", "(30)", "(31)"};

/// The comparisons begin with those of the proofs, in their order.
Json by_equation(const Fields& f, const paper::Proofs& it) {
  Json all = Json::array();
  for (const char* number : derived_equations) {
    Json ways = Json::array(), by_hand;
    bool legible = false;
    for (std::size_t i = 0; i < it.proofs.size(); ++i) {
      const paper::EquationProof& proof = it.proofs[i];
      if (proof.equation != number) continue;
      const bool held = outcome(it.comparisons.at(i)) == Comparison::Outcome::passed;
      ways.push_back({{"words", proof.words}, {"equal", held}, {"v", f.written(proof.derived)}});
      by_hand = f.written(proof.by_hand);
      legible = proof.legible;
    }
    all.push_back({{"number", number}, {"legible", legible}, {"by_hand", by_hand}, {"ways", ways}});
  }
  return all;
}

}  // namespace

void fields(Fields& f, const paper::Proofs& it) {
  f("proofs", it.proofs)("rheologies", it.rheologies);
  if (f.for_page()) f("by_equation", by_equation(f, it));
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::PaperPart& it) {
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::Figure4& it) {
  f("reduced", it.reduced)("full", it.full);
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::DifferenceMap& it) {
  f("allowed", it.allowed)("safe_delta", it.safe_delta)("figure", it.figure);
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::AmplitudeLimit& it) {
  f("delta", it.delta)("printed", it.printed)("formula", it.formula);
  f("by_admissibility", it.by_admissibility)("by_simulator", it.by_simulator);
}

void fields(Fields& f, const paper::AmplitudeLimits& it) {
  f("rows", it.rows);
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::StaticRow& it) {
  f("delta", it.delta)("limit", it.limit)("full", it.full)("slopes", it.slopes);
  f("reduced", it.reduced)("reduced_limit", it.reduced_limit);
  f.page("last_slope", it.slopes.back());
}

void fields(Fields& f, const paper::StaticLimit& it) {
  f("normal_force_amplitude_ratio", it.a)("velocity_ratios", it.ratios)("rows", it.rows);
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::Crossing& it) {
  f("delta", it.delta)("velocity_ratio", it.ratio)("most_weakening", it.weakening);
  f("most_strengthening", it.strengthening);
  f.page("small", it.delta == 0).page("large", std::isinf(it.delta));
}

void fields(Fields& f, const paper::Viscosity& it) {
  f("crossings", it.crossings)("figures", it.figures);
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::PunchRow& it) {
  f("velocity_ratio", it.ratio)("reference", it.reference)("closed_form", it.closed_form);
  f("simulated", it.simulated)("fit", it.fit).page("simulated_off", it.simulated - it.reference);
  f.page("closed_form_off", it.closed_form - it.reference).page("fit_off", it.fit - it.reference);
}

void fields(Fields& f, const paper::FlatPunch& it) {
  f("rows", it.rows)("figure", it.figure);
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::Misprints& it) {
  f("velocity_as_printed", it.velocity_as_printed)("force_as_printed", it.force_as_printed);
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::Witness& it) {
  f("delta", it.delta)("velocity_ratio", it.ratio)("reference", it.reference);
  f("exact", it.exact)("exact_error", it.exact_error)("moreau", it.moreau);
  f("adaptive", it.adaptive)("adaptive_error", it.adaptive_error)("reduced", it.reduced);
  std::vector<double> moreau_off;
  for (const double value : it.moreau) moreau_off.push_back(value - it.reference);
  f.page("exact_off", it.exact - it.reference).page("moreau_off", moreau_off);
  f.page("adaptive_off", it.adaptive - it.reference).page("reduced_off", it.reduced - it.reference);
}

void fields(Fields& f, const paper::Evidence& it) {
  f("normal_force_amplitude_ratio", it.a)("moreau_steps", it.steps)("rows", it.rows);
  validation::report::add_comparisons(f, it.comparisons);
}

void fields(Fields& f, const paper::Claim& it) {
  using Verdict = paper::Claim::Verdict;
  f("number", it.number)("where", it.where)("claim", it.words)("verdict", it.verdict);
  f("evidence", it.evidence)("comparisons", it.keys);
  f.page("verdict_style", it.verdict == Verdict::holds   ? "passed"
                          : it.verdict == Verdict::fails ? "failed"
                                                         : "not-run");
}

namespace {

/// How many comparisons decide a claim, and how many of them passed.
Json decided(const Fields& f, const paper::Paper& it) {
  const std::vector<Comparison> all = all_comparisons(it);
  Json claims = f.written(it.claims);
  for (Json& claim : claims) {
    const Json& keys = claim["comparisons"];
    std::size_t made = 0, passed = 0;
    for (const Comparison& each : all) {
      if (std::find(keys.begin(), keys.end(), each.key) == keys.end()) continue;
      ++made;
      passed += outcome(each) == Comparison::Outcome::passed ? 1 : 0;
    }
    claim["made"] = made;
    claim["passed"] = passed;
  }
  return claims;
}

}  // namespace

void fields(Fields& f, const paper::Paper& it) {
  f("equations", it.proofs)("range", it.range)("figure4", it.figure4)("difference", it.map);
  f("jump_limits", it.amplitudes)("static_limit", it.slow)("viscosity", it.viscosity);
  f("flat_punch", it.punch)("shapes", it.shapes)("misprints", it.misprints);
  f("evidence", it.evidence);
  if (f.for_page())
    f("claims", decided(f, it));
  else
    f("claims", it.claims);
}

}  // namespace vcrit::record

namespace vcrit::validation::report {

const char* const paper_command = "vcrit validate --paper --out report";

bool passed(const paper::Paper& paper) {
  return count(all_comparisons(paper), Comparison::Outcome::failed) == 0;
}

std::string paper_json(const PaperContents& contents) {
  record::Json report = report_head(contents.origin, passed(contents.paper));
  report["paper"] = record::json_of(contents.paper);
  return text_of(report);
}

}  // namespace vcrit::validation::report
