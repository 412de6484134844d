#include "answers/shares.hpp"

#include <algorithm>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "base/errors.hpp"
#include "base/sort_stably.hpp"

namespace vcrit {

namespace {

/// Less than anyone reads, and more than differences of a simulated v* leave.
constexpr double least_that_matters = 1e-7;

bool belongs_to(const Share& share, const Symbol& called) {
  return share.is_array && called.entry > 0 && share.called.name == called.name;
}

}  // namespace

std::vector<Share> shares_of(const Problem& problem, std::span<const Symbol> symbols) {
  std::vector<Share> all;
  try {
    for (const Symbol& symbol : symbols) {
      const double share = onset_log_derivative(problem, symbol);
      const Symbol called = as_called(problem, symbol);
      const auto array = std::find_if(all.begin(), all.end(),
                                      [&](const Share& it) { return belongs_to(it, called); });
      if (array != all.end())
        array->share += share;
      else if (called.entry > 0)
        all.push_back({Symbol{called.name, 0}, symbol, true, share});
      else
        all.push_back({called, symbol, false, share});
    }
  } catch (const ModelError&) {
    return {};
  }
  std::erase_if(all, [](const Share& it) { return !(std::abs(it.share) > least_that_matters); });
  sort_stably(all,
              [](const Share& a, const Share& b) { return std::abs(a.share) > std::abs(b.share); });
  return all;
}

}  // namespace vcrit
