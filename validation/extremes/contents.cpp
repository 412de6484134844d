#include "extremes/contents.hpp"

#include <algorithm>

namespace vcrit::validation::extremes {

const std::vector<WayName>& ways() {
  static const std::vector<WayName> all{{"library", "Eq. 24 in doubles"},
                                        {"fast", "generated, fast"},
                                        {"fast_batch", "generated, fast, batch"},
                                        {"accurate", "generated, accurate"},
                                        {"accurate_batch", "generated, accurate, batch"},
                                        {"certified", "generated, certified"}};
  return all;
}

const std::string& way_name(const std::string& key) {
  const auto found = std::find_if(ways().begin(), ways().end(),
                                  [&](const WayName& way) { return way.key == key; });
  ensure(found != ways().end(), "a way has a name");
  return found->name;
}

const std::vector<RegionName>& regions() {
  static const std::vector<RegionName> all{
      {"relaxation", "Relaxation times",
       "All dampers and relaxation times scaled by 10⁻¹² to 10¹², where the scenes relax in "
       "seconds "
       "(ten branches: in 10⁻¹⁰ to 10¹⁰ seconds), and ω from 10⁻⁶ to 10¹⁵ rad/s."},
      {"stiffness", "Stiffnesses",
       "The springs of the contact scaled by 10⁻³⁰ to 10³⁰ against the drive (under a rigid drive, "
       "one spring against the others), and ω from 10⁻⁶ to 10¹⁵ rad/s."},
      {"corners", "Corners",
       "Contact and drive each at 10⁻³⁰ and 10³⁰ times their stiffness, all four, and ω from 10⁻⁶ "
       "to 10¹⁵ rad/s."},
      {"resonance", "Resonance",
       "ω beside the resonance Re K_d = m ω² by a relative 10⁻¹ to 10⁻¹⁵, on both sides, and on "
       "it."},
      {"antiresonance", "Antiresonance", "The same beside Re(K_t + K_d) = m ω²."},
      {"limits", "Limits",
       "What vanishes or grows without end, down to 10⁻³⁰⁰ and up to 10³⁰⁰, against the limit that "
       "computer algebra derives; how fast it must be approached follows from Eq. 24."}};
  return all;
}

namespace {

void append(std::vector<Comparison>& all, const Region& region) {
  all.insert(all.end(), region.comparisons.begin(), region.comparisons.end());
}

}  // namespace

std::vector<Comparison> all_comparisons(const Extremes& extremes) {
  std::vector<Comparison> all;
  for (const FamilyResult& family : extremes.families)
    for (const Region& region : family.regions) append(all, region);
  return all;
}

std::vector<Comparison> comparisons_of(const Extremes& extremes, const std::string& key) {
  std::vector<Comparison> all;
  for (const FamilyResult& family : extremes.families)
    for (const Region& region : family.regions)
      if (region.key == key) append(all, region);
  return all;
}

}  // namespace vcrit::validation::extremes
