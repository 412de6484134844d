#include "extremes/summary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vcrit::validation::extremes {

namespace {

template <class Visit>
void for_each_tally(const Extremes& extremes, const std::string& way, const Visit& visit) {
  for (const FamilyResult& family : extremes.families)
    for (const Region& region : family.regions)
      for (const Tally& tally : region.tallies)
        if (tally.way == way) visit(family, region, tally);
}

/// "12 in resonance (elastic, zener), 3 in limits (kelvin)": where there are any.
std::string where(const Extremes& extremes, const std::string& way, std::size_t Tally::*count) {
  std::map<std::string, std::size_t> counts;
  std::map<std::string, std::string> names;
  for_each_tally(extremes, way, [&](const auto& family, const auto& region, const Tally& tally) {
    if (tally.*count == 0) return;
    counts[region.key] += tally.*count;
    std::string& list = names[region.key];
    list += (list.empty() ? "" : ", ") + family.key;
  });
  std::string text;
  for (const RegionName& region : regions())
    if (counts.contains(region.key))
      text += fmt::format("{}{} in {} ({})", text.empty() ? "" : ", ", counts[region.key],
                          region.key, names[region.key]);
  return text;
}

std::string certainty(const Extremes& extremes, const std::string& way) {
  const Tally all = total(extremes, way);
  std::string text = fmt::format("By “{}”, {} of {} values of v* are certified", way_name(way),
                                 all.values - all.uncertified, all.values);
  text += all.violated == 0
              ? fmt::format(
                    ", every one within its bound (the largest error is {:.2g} of what is "
                    "allowed).",
                    all.over_bound)
              : fmt::format(", {} of them beyond the bound: {}.", all.violated,
                            where(extremes, way, &Tally::violated));
  if (all.uncertified == 0) return text;
  const double sharpest = std::min(total(extremes, way, "resonance").uncertified_from,
                                   total(extremes, way, "antiresonance").uncertified_from);
  text += fmt::format(" Without a bound: {}.", where(extremes, way, &Tally::uncertified));
  if (std::isfinite(sharpest))
    text += fmt::format(
        " Near resonance and antiresonance that begins at a condition number of {:.1g}; elsewhere "
        "numbers leave the range that the generated header looks at.",
        sharpest);
  return text;
}

std::string losses(const Extremes& extremes, const std::string& way) {
  const Tally all = total(extremes, way);
  std::string text = fmt::format("By “{}”, ", way_name(way));
  if (all.lost + all.no_number == 0)
    return text + fmt::format("no digit is lost beyond conditioning in {} values.", all.values);
  if (all.lost > 0)
    text += fmt::format("of {} values digits are lost beyond conditioning (up to {:.1f}): {}. ",
                        all.values, all.worst_lost, where(extremes, way, &Tally::lost));
  if (all.no_number > 0)
    text += fmt::format("there is no number where v* is one: {}.",
                        where(extremes, way, &Tally::no_number));
  return text;
}

std::string of_simulator(const Simulated& all) {
  return fmt::format(
      "The simulator, asked {} times just below and just above v*, is right {} times, wrong {} "
      "times, and gives no answer {} times. It was not asked {} times.",
      all.asked, all.right, all.wrong, all.silent, all.left_out);
}

}  // namespace

Tally total(const Extremes& extremes, const std::string& way, const std::string& key) {
  Tally sum;
  sum.way = way;
  for_each_tally(extremes, way, [&](const auto&, const auto& region, const Tally& tally) {
    if (!key.empty() && region.key != key) return;
    sum.values += tally.values;
    sum.lost += tally.lost;
    sum.no_number += tally.no_number;
    sum.uncertified += tally.uncertified;
    sum.violated += tally.violated;
    sum.worst_lost = std::max(sum.worst_lost, tally.worst_lost);
    sum.over_bound = std::max(sum.over_bound, tally.over_bound);
    sum.uncertified_from = std::min(sum.uncertified_from, tally.uncertified_from);
  });
  return sum;
}

Simulated simulated_total(const Extremes& extremes) {
  Simulated sum;
  for (const FamilyResult& family : extremes.families)
    for (const Region& region : family.regions) {
      if (!region.simulated) continue;
      sum.asked += region.simulated->asked;
      sum.right += region.simulated->right;
      sum.wrong += region.simulated->wrong;
      sum.silent += region.simulated->silent;
      sum.left_out += region.simulated->left_out;
    }
  return sum;
}

std::vector<std::string> in_words(const Extremes& extremes) {
  std::vector<std::string> words;
  if (extremes.compiler.empty())
    words.emplace_back("There was no C++ compiler: nothing is said of generated evaluators.");
  else
    words = {certainty(extremes, "certified"), certainty(extremes, "fast"),
             losses(extremes, "fast")};
  words.push_back(losses(extremes, "library"));
  words.push_back(of_simulator(simulated_total(extremes)));
  return words;
}

}  // namespace vcrit::validation::extremes
