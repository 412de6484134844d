#include "report/extremes_json.hpp"

#include <nlohmann/json.hpp>

#include "extremes/pictures.hpp"
#include "extremes/summary.hpp"
#include "report/html.hpp"
#include "report/json_parts.hpp"

namespace vcrit::validation::report {

namespace {

using nlohmann::ordered_json;

ordered_json bad_answer_json(const extremes::BadAnswer& answer) {
  return {{"words", answer.words},
          {"inputs", answer.inputs},
          {"found", json_number(answer.found)},
          {"right", json_number(answer.right)},
          {"digits_lost", json_number(answer.lost)}};
}

ordered_json tally_json(const extremes::Tally& tally) {
  return {{"way", tally.way},
          {"values", tally.values},
          {"lost", tally.lost},
          {"no_number", tally.no_number},
          {"uncertified", tally.uncertified},
          {"violated", tally.violated},
          {"worst_digits_lost", json_number(tally.worst_lost)},
          {"error_over_bound", json_number(tally.over_bound)},
          {"uncertified_from_condition", json_number(tally.uncertified_from)},
          {"worst_inputs", json_list(tally.worst, bad_answer_json)}};
}

ordered_json simulated_json(const extremes::Simulated& simulated) {
  return {{"asked", simulated.asked},
          {"right", simulated.right},
          {"wrong", simulated.wrong},
          {"no_answer", simulated.silent},
          {"not_asked", simulated.left_out},
          {"worst_inputs", json_list(simulated.worst, [](const extremes::BadAnswer& answer) {
             ordered_json object = bad_answer_json(answer);
             object.erase("digits_lost");
             return object;
           })}};
}

ordered_json region_json(const extremes::Region& region) {
  ordered_json object{{"key", region.key}, {"evaluators", json_list(region.tallies, tally_json)}};
  if (region.simulated) object["simulator"] = simulated_json(*region.simulated);
  object["comparisons"] =
      json_list(region.comparisons, [](const Comparison& each) { return json(each); });
  return object;
}

}  // namespace

const char* const extremes_command = "vcrit validate --extremes --out report";

bool passed(const extremes::Extremes& extremes) {
  return count(all_comparisons(extremes), Comparison::Outcome::failed) == 0;
}

std::string extremes_json(const ExtremesContents& contents) {
  const extremes::Extremes& all = contents.extremes;
  ordered_json report = report_head(contents.origin, passed(all));
  report["extremes"] = {
      {"compiler", all.compiler},
      {"in_words", in_words(all)},
      {"families", json_list(all.families,
                             [](const extremes::FamilyResult& family) -> ordered_json {
                               return {{"key", family.key},
                                       {"title", family.title},
                                       {"regions", json_list(family.regions, region_json)}};
                             })},
      {"figures",
       json_list(pictures(all), [](const figures::Figure& figure) { return json(figure); })}};
  return text_of(report);
}

}  // namespace vcrit::validation::report
