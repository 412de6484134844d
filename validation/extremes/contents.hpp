// What extreme numbers do to everything that computes v* or friction, as plain data: with no way to
// compute it and no way to show it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "accuracy/data.hpp"
#include "base/constants.hpp"
#include "compare/scene_report.hpp"

namespace vcrit::validation::extremes {

/// One bad answer.
struct BadAnswer {
  std::string words;            ///< "digits lost", "not certified", "no number", "beyond its bound"
  std::string inputs;           ///< "omega = 0x1p+3, k = 0x1p+0, ...", hexadecimal doubles, SI
  double found = 0, right = 0;  ///< m/s
  double lost = 0;              ///< decimal digits beyond what conditioning explains; infinite: all
};

/// One way to evaluate v*, over the cells of a region.
struct Tally {
  std::string way;              ///< a key: see ways()
  std::size_t values = 0;       ///< cells in which v* is a normal double; the others are no loss
  std::size_t lost = 0;         ///< off by more than conditioning explains
  std::size_t no_number = 0;    ///< not finite, or 0
  std::size_t uncertified = 0;  ///< the claimed bound is infinite
  std::size_t violated = 0;     ///< off by more than the claimed bound: a failure
  double worst_lost = 0;        ///< decimal digits beyond what conditioning explains
  double over_bound = 0;        ///< the largest error over the claimed bound
  std::string over_bound_at;    ///< where
  /// The least condition number at which the bound is infinite.
  double uncertified_from = infinity;
  std::vector<BadAnswer> worst;  ///< a few, the worst first
  std::vector<double> digits;    ///< lost, of 16, one a cell; NaN: no number or no normal v*
};

/// What the simulator answers at 1 -+ 1e-6 of v*.
struct Simulated {
  std::size_t asked = 0, right = 0;
  std::size_t wrong = 0;              ///< misses the stick below or sticks above: a failure
  std::size_t silent = 0;             ///< no answer, or its own work limit
  std::size_t left_out = 0;           ///< not asked: see Mark::words
  std::vector<BadAnswer> worst;       ///< wrong and silent ones; `lost` says nothing
  std::vector<accuracy::Mark> marks;  ///< wrong, silent, left out
  std::vector<double> digits;         ///< lost by the threshold of sliding; NaN: not asked
};

/// One kind of extreme, of one family of scenes.
struct Region {
  std::string key;                ///< "relaxation", "stiffness", "corners", "resonance", ...
  std::vector<double> x, y;       ///< of maps: omega (rad/s), factor. Of resonance x: its
                                  ///< relative distances, 0: exact, in the order of the cells
  std::vector<double> condition;  ///< number of Eq. 24, one a cell
  std::vector<Tally> tallies;
  std::optional<Simulated> simulated;
  std::vector<Comparison> comparisons;
};

struct FamilyResult {
  std::string key, title;
  std::vector<Region> regions;
};

struct Extremes {
  std::string compiler;  ///< of the generated evaluators, with version; empty without one
  std::vector<FamilyResult> families;
};

/// A way to evaluate v*.
struct WayName {
  std::string key, name;
};
const std::vector<WayName>& ways();
const std::string& way_name(const std::string& key);

/// The kinds of extremes: key, and what is done in them.
struct RegionName {
  std::string key, title, words;
};
const std::vector<RegionName>& regions();

/// Of all regions of all families, in their order.
std::vector<Comparison> all_comparisons(const Extremes& extremes);
std::vector<Comparison> comparisons_of(const Extremes& extremes, const std::string& key);

}  // namespace vcrit::validation::extremes
