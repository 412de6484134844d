#include "shortest/search.hpp"

#include <algorithm>
#include <queue>
#include <tuple>
#include <unordered_set>

#include "base/interruption.hpp"
#include "shortest/moves.hpp"
#include "shortest/steps.hpp"

namespace vcrit::symbolic::shortest {

namespace {

// Of two formulas with as many operations the one with fewer lines is shorter.
constexpr int operation = 64;

// A way to something shorter may lead over what is this much longer.
constexpr int uphill = 2 * operation;

int length(const Expressions& all, const Ex& whole) {
  const Steps steps(all, whole);
  return operation * steps.operations() + std::min(steps.shared(), operation - 1);
}

class Search {
 public:
  explicit Search(Expressions& all) : all_(all) {}

  void begin(const Ex& start) { meet(start); }

  void run(const SearchEffort& effort) {
    std::size_t expanded = 0;
    const std::size_t end = all_.work() + effort.work;
    while (!open_.empty() && expanded++ < effort.expanded) {
      hear_interruption();
      const auto [cost, order, ex] = open_.top();
      open_.pop();
      if (cost > least_ + uphill) return;
      for_each_move(all_, ex, [&](const Ex& moved) {
        meet(moved);
        return all_.work() < end;
      });
      if (all_.work() >= end) return;
    }
  }

  const Ex& best() const { return best_; }

 private:
  struct Entry {
    int cost;
    std::size_t order;
    Ex ex;
    friend bool operator<(const Entry& a, const Entry& b) {
      return std::tie(a.cost, a.order) > std::tie(b.cost, b.order);
    }
  };

  void meet(const Ex& ex) {
    if (!seen_.insert(ex.node).second) return;
    const int cost = length(all_, ex);
    if (seen_.size() == 1 || cost < least_) least_ = cost, best_ = ex;
    if (cost <= least_ + uphill) open_.push({cost, seen_.size(), ex});
  }

  Expressions& all_;
  std::priority_queue<Entry> open_;
  std::unordered_set<ExNode> seen_;
  int least_ = 0;
  Ex best_;
};

}  // namespace

int operations(const Expressions& all, const Ex& whole) { return Steps(all, whole).operations(); }

Ex shortest_of(Expressions& all, const std::vector<Ex>& starts, const SearchEffort& effort) {
  Search search(all);
  for (const Ex& start : starts) search.begin(start);
  search.run(effort);
  return search.best();
}

}  // namespace vcrit::symbolic::shortest
