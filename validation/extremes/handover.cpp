// MessagePack, which carries every double, infinite and undefined ones too.
#include "extremes/handover.hpp"

#include <nlohmann/json.hpp>

namespace vcrit::validation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Comparison, key, name, reference, unit, measure, expected, found,
                                   tolerance, reason, detail, not_run, broken)

namespace accuracy {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Mark, omega, factor, words)
}  // namespace accuracy

namespace extremes {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BadAnswer, words, inputs, found, right, lost)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Tally, way, values, lost, no_number, uncertified, violated,
                                   worst_lost, over_bound, over_bound_at, uncertified_from, worst,
                                   digits)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Simulated, asked, right, wrong, silent, left_out, worst, marks,
                                   digits)

namespace {

using nlohmann::json;

json to_value(const Region& region) {
  json value{{"key", region.key},
             {"x", region.x},
             {"y", region.y},
             {"condition", region.condition},
             {"tallies", region.tallies},
             {"comparisons", region.comparisons}};
  if (region.simulated) value["simulated"] = *region.simulated;
  return value;
}

Region to_region(const json& value) {
  Region region{value.at("key"),        value.at("x"),       value.at("y"),
                value.at("condition"),  value.at("tallies"), {},
                value.at("comparisons")};
  if (value.contains("simulated")) region.simulated = value.at("simulated").get<Simulated>();
  return region;
}

}  // namespace

std::string handed_over(const FamilyResult& result) {
  json value{{"key", result.key}, {"title", result.title}, {"regions", json::array()}};
  for (const Region& region : result.regions) value["regions"].push_back(to_value(region));
  std::string text;
  json::to_msgpack(value, text);
  return text;
}

FamilyResult taken_over(const std::string& text) {
  const json value = json::from_msgpack(text);
  FamilyResult result{value.at("key"), value.at("title"), {}};
  for (const json& region : value.at("regions")) result.regions.push_back(to_region(region));
  return result;
}

}  // namespace extremes

}  // namespace vcrit::validation
