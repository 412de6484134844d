#include "extremes/pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "accuracy/pictures.hpp"

namespace vcrit::validation::extremes {

using accuracy::no_error;
using figures::Figure;
using figures::FigureSeries;
using figures::Style;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// More digits would only make the page longer.
double to_hundredths(double digits) { return std::round(100 * digits) / 100; }

void take_worst(std::vector<double>& worst, const std::vector<double>& digits) {
  worst.resize(digits.size(), none);
  for (std::size_t i = 0; i < digits.size(); ++i)
    if (!(worst[i] >= digits[i]))
      worst[i] = std::isnan(digits[i]) ? worst[i] : to_hundredths(digits[i]);
}

/// What each family says of one cell, put together.
class Marks {
 public:
  void add(double x, double y, const std::string& words) {
    std::string& all = words_[{y, x}];
    all += (all.empty() ? "" : "; ") + words;
  }
  FigureSeries series(Style style, int colour) const {
    FigureSeries result{"", style, {}, colour};
    for (const auto& [at, words] : words_) result.points.push_back({at.second, at.first, words});
    return result;
  }
  bool empty() const { return words_.empty(); }

 private:
  std::map<std::pair<double, double>, std::string> words_;
};

Figure empty_map(const Region& like, const std::string& name, const std::string& title) {
  Figure figure;
  figure.name = like.key + "_" + name;
  figure.title = title;
  figure.x = figures::cells_axis("ω, rad/s", like.x);
  figure.y = figures::cells_axis(like.key == "relaxation" ? "factor on times" : "factor on springs",
                                 like.y);
  figure.map = figures::Map{{"digits lost", false, std::pair{0.0, 16.0}, {}}, like.x, like.y, {}};
  return figure;
}

/// The region of each family that has it.
std::vector<std::pair<const FamilyResult*, const Region*>> all_of(const Extremes& extremes,
                                                                  const std::string& key) {
  std::vector<std::pair<const FamilyResult*, const Region*>> result;
  for (const FamilyResult& family : extremes.families)
    for (const Region& region : family.regions)
      if (region.key == key) result.emplace_back(&family, &region);
  return result;
}

const Tally* tally_of(const Region& region, const std::string& way) {
  const auto found = std::find_if(region.tallies.begin(), region.tallies.end(),
                                  [&](const Tally& tally) { return tally.way == way; });
  return found == region.tallies.end() ? nullptr : &*found;
}

Figure way_map(const Extremes& extremes, const std::string& key, const std::string& way) {
  const auto all = all_of(extremes, key);
  Figure figure = empty_map(*all.front().second, way, way_name(way));
  for (const auto& [family, region] : all)
    if (const Tally* tally = tally_of(*region, way)) take_worst(figure.map->values, tally->digits);
  return figure;
}

Figure simulator_map(const Extremes& extremes, const std::string& key) {
  const auto all = all_of(extremes, key);
  Figure figure = empty_map(*all.front().second, "simulator", "Stick-slip simulation");
  figure.caption =
      "Of the critical speed by simulation, in every second column and row. Crosses: a wrong "
      "answer "
      "or none at 1 ∓ 10⁻⁶ of v*. Dots: at least one family is not simulated.";
  Marks wrong, not_asked;
  for (const auto& [family, region] : all) {
    if (!region->simulated) continue;
    take_worst(figure.map->values, region->simulated->digits);
    for (const accuracy::Mark& mark : region->simulated->marks)
      (mark.words.starts_with("not asked") ? not_asked : wrong)
          .add(mark.omega, mark.factor, family->key + ": " + mark.words);
  }
  if (!not_asked.empty()) figure.series.push_back(not_asked.series(Style::dots, 2));
  if (!wrong.empty()) figure.series.push_back(wrong.series(Style::crosses, 1));
  return figure;
}

/// Of both sides the larger; on the resonance itself there is no distance.
template <class Value>
std::vector<figures::Point> by_distance(const Region& region, const Value& value) {
  std::map<double, double> worst;
  for (std::size_t i = 0; i < region.x.size(); ++i) {
    const double here = value(i);
    if (region.x[i] == 0 || std::isnan(here)) continue;
    double& at = worst[std::abs(region.x[i])];
    at = std::max(at, here);
  }
  std::vector<figures::Point> points;
  for (const auto& [distance, error] : worst) points.push_back({distance, error, {}});
  return points;
}

double error_of(double digits) { return digits == 0 ? no_error : 0x1p-53 * std::pow(10, digits); }

Figure approach_of(const FamilyResult& family, const Region& region) {
  Figure figure;
  figure.name = family.key + "_" + region.key;
  figure.title = family.title;
  figure.caption = fmt::format(
      "Relative error of v* over the relative distance of ω from {}, the larger of both sides. "
      "Errors below 2⁻⁵³ stand at {}. Dashed: 2⁻⁵³ times the condition number, what one rounding "
      "of "
      "the inputs can do.",
      region.key, no_error);
  figure.x = {"|ω/ω₀ − 1|", true, std::pair{5e-16, 0.2}, {}};
  figure.y = {"relative error of v*", true, std::pair{5e-18, 2.0}, {}};
  figure.series.push_back(
      {"conditioning", Style::dashed,
       by_distance(region,
                   [&](std::size_t i) { return std::min(1.0, 0x1p-53 * region.condition[i]); }),
       2});
  const auto add = [&](const char* way, const char* name, Style style, int colour) {
    if (const Tally* tally = tally_of(region, way))
      figure.series.push_back(
          {name, style,
           by_distance(region, [&](std::size_t i) { return error_of(tally->digits[i]); }), colour});
  };
  add("accurate", "accurate", Style::line, 0);
  add("fast", "fast", Style::circles, 1);
  add("library", "in doubles", Style::crosses, 4);
  return figure;
}

}  // namespace

std::vector<Figure> maps(const Extremes& extremes, const std::string& region) {
  if (all_of(extremes, region).empty() || all_of(extremes, region).front().second->y.empty())
    return {};
  std::vector<Figure> result{way_map(extremes, region, "library")};
  for (const char* way : {"fast", "accurate"})
    if (!extremes.compiler.empty()) result.push_back(way_map(extremes, region, way));
  result.push_back(simulator_map(extremes, region));
  return result;
}

std::vector<Figure> approach_pictures(const Extremes& extremes, const std::string& key) {
  std::vector<Figure> result;
  if (!key.ends_with("resonance")) return result;
  for (const char* shown : {"elastic", "damped", "kelvin", "bridge"})
    for (const auto& [family, region] : all_of(extremes, key))
      if (family->key == shown) result.push_back(approach_of(*family, *region));
  return result;
}

std::vector<Figure> pictures(const Extremes& extremes) {
  std::vector<Figure> all;
  for (const RegionName& region : regions())
    for (const auto& figures :
         {maps(extremes, region.key), approach_pictures(extremes, region.key)})
      all.insert(all.end(), figures.begin(), figures.end());
  return all;
}

}  // namespace vcrit::validation::extremes
