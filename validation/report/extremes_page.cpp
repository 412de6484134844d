#include "report/extremes_page.hpp"

#include "extremes/pictures.hpp"
#include "extremes/summary.hpp"
#include "report/document.hpp"
#include "report/records.hpp"

namespace vcrit::validation::report {

namespace {

using extremes::Extremes, extremes::FamilyResult, extremes::Region, extremes::Tally;
using record::Json, record::page_of;

/// The three ways that a row tells of; the batch calls answer as these do.
bool has_column(const Tally& tally) {
  return tally.way == "library" || tally.way == "fast" || tally.way == "accurate";
}

Json loss_row(const FamilyResult& family, const Region& region) {
  Json ways = Json::array();
  for (const Tally& tally : region.tallies)
    if (has_column(tally)) ways.push_back(page_of(tally));
  return {{"scene", family.key}, {"values", region.tallies.front().values}, {"ways", ways}};
}

/// What one way, or the simulator, answered worst.
void add_answers(const std::string& scene, const std::string& by,
                 const std::vector<extremes::BadAnswer>& worst, Json& rows) {
  for (const extremes::BadAnswer& answer : worst) {
    Json row = page_of(answer);
    row["scene"] = scene;
    row["by"] = by;
    rows.push_back(row);
  }
}

Json region_record(const Extremes& all, const extremes::RegionName& name) {
  Json losses = Json::array(), worst = Json::array();
  for (const FamilyResult& family : all.families)
    for (const Region& region : family.regions) {
      if (region.key != name.key) continue;
      losses.push_back(loss_row(family, region));
      for (const Tally& tally : region.tallies)
        if (!tally.way.ends_with("_batch"))
          add_answers(family.key, extremes::way_name(tally.way), tally.worst, worst);
    }
  std::vector<Comparison> comparisons;
  for (const Comparison& each : comparisons_of(all, name.key))
    if (each.key != "simulation") comparisons.push_back(each);
  std::vector<figures::Figure> figures = maps(all, name.key);
  for (const figures::Figure& figure : approach_pictures(all, name.key)) figures.push_back(figure);
  record::Fields f(record::Reader::page);
  f("key", name.key)("title", name.title)("words", name.words)("figures", figures);
  f("losses", losses)("worst", worst)("compiled", !all.compiler.empty());
  add_comparisons(f, comparisons);
  return f.take();
}

Json simulator_record(const Extremes& all) {
  Json rows = Json::array(), worst = Json::array();
  for (const FamilyResult& family : all.families)
    for (const Region& region : family.regions) {
      if (!region.simulated) continue;
      Json row = page_of(*region.simulated);
      row["scene"] = family.key;
      row["extreme"] = region.key;
      rows.push_back(row);
      add_answers(family.key, region.key, region.simulated->worst, worst);
    }
  std::vector<Comparison> comparisons;
  for (const Comparison& each : all_comparisons(all))
    if (each.key == "simulation") comparisons.push_back(each);
  record::Fields f(record::Reader::page);
  f("rows", rows)("worst", worst);
  add_comparisons(f, comparisons);
  return f.take();
}

}  // namespace

std::string extremes_page(const ExtremesContents& contents) {
  const Extremes& all = contents.extremes;
  Json record{{"families", page_of(all.families)}, {"in_words", in_words(all)}};
  record["regions"] = Json::array();
  for (const extremes::RegionName& name : extremes::regions())
    record["regions"].push_back(region_record(all, name));
  record["simulator"] = simulator_record(all);
  add_verdict(all_comparisons(all), record);
  add_origin(contents.origin, record);
  return document("extremes", record, {"Extremes", true, {}});
}

}  // namespace vcrit::validation::report
