#include "report/paper_json.hpp"

#include <nlohmann/json.hpp>

#include "report/html.hpp"
#include "report/json_parts.hpp"

namespace vcrit::validation::report {

namespace {

using nlohmann::ordered_json;

ordered_json comparisons(const std::vector<Comparison>& all) { return json_list(all, json); }

ordered_json proof(const paper::Proof& proof) {
  return {{"equation", proof.equation},
          {"words", proof.words},
          {"derived", json(proof.derived)},
          {"by_hand", json(proof.by_hand)},
          {"legible", proof.legible}};
}

ordered_json jump_limit(const paper::JumpLimit& row) {
  return {{"delta", row.delta},
          {"printed", row.printed},
          {"formula", row.formula},
          {"by_admissibility", row.by_admissibility},
          {"by_simulator", row.by_simulator}};
}

ordered_json static_row(const paper::StaticRow& row) {
  return {{"delta", row.delta},
          {"limit", row.limit},
          {"full", numbers(row.full)},
          {"slopes", numbers(row.slopes)},
          {"reduced", numbers(row.reduced)},
          {"reduced_limit", row.reduced_limit}};
}

ordered_json punch_row(const paper::PunchRow& row) {
  return {{"velocity_ratio", row.ratio},
          {"reference", row.reference},
          {"closed_form", json_number(row.closed_form)},
          {"simulated", json_number(row.simulated)},
          {"fit", row.fit}};
}

ordered_json witness(const paper::Witness& row) {
  return {{"delta", row.delta},
          {"velocity_ratio", row.ratio},
          {"reference", row.reference},
          {"exact", json_number(row.exact)},
          {"exact_error", json_number(row.exact_error)},
          {"moreau", numbers(row.moreau)},
          {"adaptive", json_number(row.adaptive)},
          {"adaptive_error", json_number(row.adaptive_error)},
          {"reduced", json_number(row.reduced)}};
}

ordered_json claim(const paper::Claim& claim) {
  return {{"number", claim.number},     {"where", claim.where},
          {"claim", claim.words},       {"verdict", paper::to_text(claim.verdict)},
          {"evidence", claim.evidence}, {"comparisons", claim.keys}};
}

ordered_json crossing(const paper::Crossing& row) {
  return {{"delta", json_number(row.delta)},
          {"velocity_ratio", json_number(row.ratio)},
          {"most_weakening", json_number(row.weakening)},
          {"most_strengthening", json_number(row.strengthening)}};
}

ordered_json parts(const paper::Paper& paper) {
  return {{"equations",
           {{"proofs", json_list(paper.proofs.proofs, proof)},
            {"rheologies", paper.proofs.rheologies},
            {"comparisons", comparisons(paper.proofs.comparisons)}}},
          {"range", {{"comparisons", comparisons(paper.range.comparisons)}}},
          {"figure4",
           {{"reduced", json_list(paper.figure4.reduced, json)},
            {"full", json_list(paper.figure4.full, json)},
            {"comparisons", comparisons(paper.figure4.comparisons)}}},
          {"difference",
           {{"allowed", paper.map.allowed},
            {"safe_delta", paper.map.safe_delta},
            {"figure", json(paper.map.figure)},
            {"comparisons", comparisons(paper.map.comparisons)}}},
          {"jump_limits",
           {{"rows", json_list(paper.jumps.rows, jump_limit)},
            {"comparisons", comparisons(paper.jumps.comparisons)}}},
          {"static_limit",
           {{"normal_force_amplitude_ratio", paper.slow.a},
            {"velocity_ratios", numbers(paper.slow.ratios)},
            {"rows", json_list(paper.slow.rows, static_row)},
            {"comparisons", comparisons(paper.slow.comparisons)}}},
          {"viscosity",
           {{"crossings", json_list(paper.viscosity.crossings, crossing)},
            {"figures", json_list(paper.viscosity.figures, json)},
            {"comparisons", comparisons(paper.viscosity.comparisons)}}},
          {"flat_punch",
           {{"rows", json_list(paper.punch.rows, punch_row)},
            {"figure", json(paper.punch.figure)},
            {"comparisons", comparisons(paper.punch.comparisons)}}},
          {"shapes", {{"comparisons", comparisons(paper.shapes.comparisons)}}},
          {"misprints",
           {{"velocity_as_printed", json_number(paper.misprints.velocity_as_printed)},
            {"force_as_printed", json_number(paper.misprints.force_as_printed)},
            {"comparisons", comparisons(paper.misprints.comparisons)}}},
          {"evidence",
           {{"normal_force_amplitude_ratio", paper.evidence.a},
            {"moreau_steps", paper.evidence.steps},
            {"rows", json_list(paper.evidence.rows, witness)},
            {"comparisons", comparisons(paper.evidence.comparisons)}}},
          {"claims", json_list(paper.claims, claim)}};
}

}  // namespace

const char* const paper_command = "vcrit validate --paper --out report";

bool passed(const paper::Paper& paper) {
  return count(all_comparisons(paper), Comparison::Outcome::failed) == 0;
}

std::string paper_json(const PaperContents& contents) {
  ordered_json report = report_head(contents.origin, passed(contents.paper));
  report["paper"] = parts(contents.paper);
  return text_of(report);
}

}  // namespace vcrit::validation::report
