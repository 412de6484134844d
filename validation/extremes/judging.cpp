#include "extremes/judging.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/stability.hpp"
#include "base/constants.hpp"
#include "base/sort_stably.hpp"
#include "critical/conditioning.hpp"
#include "extremes/comparing.hpp"

namespace vcrit::validation::extremes {

namespace {

constexpr std::size_t most_worst = 3;  // of each region, a line each in its table

bool is_number(double found) { return std::isfinite(found) && found != 0; }

double lost_beyond(double found, double right, double condition) {
  const double explained = formula_tolerance(condition), off = std::abs(found - right) / right;
  return off > explained ? std::log10(off / explained) : 0;
}

struct Judge {
  const Claimed& claimed;
  const Known& known;
  Tally result;

  void add_worst(const char* words, std::size_t i, double lost) {
    result.worst.push_back({words, known.inputs[i], claimed.values[i], known.right[i], lost});
  }

  void bound(std::size_t i) {
    const double over = over_bound(claimed.values[i], known.right[i], claimed.bounds[i]);
    if (over > result.over_bound) {
      result.over_bound = over;
      result.over_bound_at = known.inputs[i];
    }
    if (!(over > 1)) return;
    ++result.violated;
    add_worst("beyond its bound", i, infinity);
  }

  void value(std::size_t i) {
    const double lost = lost_beyond(claimed.values[i], known.right[i], known.condition[i]);
    if (!(lost > 0)) return;
    ++result.lost;
    result.worst_lost = std::max(result.worst_lost, lost);
    add_worst("digits lost", i, lost);
  }

  void cell(std::size_t i) {
    const bool has_bounds = !claimed.bounds.empty();
    const bool claims = has_bounds && std::isfinite(claimed.bounds[i]);
    if (claims) bound(i);
    const bool normal = std::isnormal(known.right[i]);
    const double found = claimed.values[i];
    result.digits.push_back(normal ? accuracy::digits_lost(found, known.right[i])
                                   : std::numeric_limits<double>::quiet_NaN());
    if (!normal) return;
    ++result.values;
    if (has_bounds && !claims) {
      ++result.uncertified;
      result.uncertified_from = std::min(result.uncertified_from, known.condition[i]);
      add_worst("not certified", i, 0);
    }
    if (is_number(found)) {
      value(i);
    } else {
      ++result.no_number;
      add_worst("no number", i, infinity);
    }
  }
};

}  // namespace

double over_bound(double found, double right, double bound) {
  if (found == right) return 0;
  if (!std::isfinite(found) || !std::isfinite(right)) return infinity;
  // Below the normal doubles both sides are known to half a last place.
  const double allowed = bound * right + std::max(0x1p-53 * right, 0x1p-1074);
  return std::abs(found - right) / allowed;
}

Tally tally(const Claimed& claimed, const Known& known) {
  Judge judge{claimed, known, {}};
  judge.result.way = claimed.way;
  for (std::size_t i = 0; i < known.right.size(); ++i) judge.cell(i);
  keep_worst(judge.result.worst);
  return judge.result;
}

void keep_worst(std::vector<BadAnswer>& answers) {
  sort_stably(answers, [](const BadAnswer& a, const BadAnswer& b) { return a.lost > b.lost; });
  answers.resize(std::min(answers.size(), most_worst));
}

Comparison bounds_hold(const Tally& tally, const std::string& where) {
  return at_most(
      {tally.way, where + ": " + way_name(tally.way) + " within its bound", "v* correctly rounded",
       "the largest error over the claimed bound and one rounding of the reference"},
      tally.over_bound, 1, tally.over_bound_at);
}

}  // namespace vcrit::validation::extremes
