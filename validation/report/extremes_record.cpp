#include "report/extremes_record.hpp"

#include <fmt/core.h>

#include "extremes/pictures.hpp"
#include "extremes/summary.hpp"
#include "report/records.hpp"

namespace vcrit::record {

namespace extremes = validation::extremes;

void fields(Fields& f, const extremes::BadAnswer& it) {
  f("words", it.words)("inputs", it.inputs)("found", it.found)("right", it.right);
  f("digits_lost", it.lost);
}

namespace {

/// "6 not certified", "2 no number", "3 lose up to 1.5 digits", those that are any.
Json losses(const extremes::Tally& tally) {
  Json all = Json::array();
  const auto add = [&](std::size_t count, const std::string& words) {
    if (count > 0) all.push_back({{"count", count}, {"words", words}});
  };
  add(tally.violated, "beyond the bound");
  add(tally.uncertified, "not certified");
  add(tally.no_number, "no number");
  add(tally.lost, fmt::format("lose up to {:.1f} digits", tally.worst_lost));
  return all;
}

}  // namespace

void fields(Fields& f, const extremes::Tally& it) {
  f("way", it.way)("values", it.values)("lost", it.lost)("no_number", it.no_number);
  f("uncertified", it.uncertified)("violated", it.violated)("worst_digits_lost", it.worst_lost);
  f("error_over_bound", it.over_bound)("uncertified_from_condition", it.uncertified_from);
  f("worst_inputs", it.worst).page("name", extremes::way_name(it.way));
  f.page("claims_a_bound", it.way != "library");
  if (f.for_page()) f("losses", losses(it));
}

void fields(Fields& f, const extremes::Simulated& it) {
  Json worst = f.written(it.worst);
  for (Json& answer : worst) answer.erase("digits_lost");  // says nothing
  f("asked", it.asked)("right", it.right)("wrong", it.wrong)("no_answer", it.silent);
  f("not_asked", it.left_out)("worst_inputs", worst);
  f.page("any_wrong", it.wrong > 0).page("any_silent", it.silent > 0);
}

void fields(Fields& f, const extremes::Region& it) {
  f("key", it.key)("evaluators", it.tallies).some("simulator", it.simulated);
  f("comparisons", it.comparisons);
}

void fields(Fields& f, const extremes::FamilyResult& it) {
  f("key", it.key)("title", it.title)("regions", it.regions);
}

void fields(Fields& f, const extremes::Extremes& it) {
  f("compiler", it.compiler)("in_words", in_words(it))("families", it.families);
  f("figures", pictures(it));
}

}  // namespace vcrit::record

namespace vcrit::validation::report {

const char* const extremes_command = "vcrit validate --extremes --out report";

bool passed(const extremes::Extremes& extremes) {
  return count(all_comparisons(extremes), Comparison::Outcome::failed) == 0;
}

std::string extremes_json(const ExtremesContents& contents) {
  record::Json report = report_head(contents.origin, passed(contents.extremes));
  report["extremes"] = record::json_of(contents.extremes);
  return text_of(report);
}

}  // namespace vcrit::validation::report
