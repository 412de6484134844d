#include "shortest/search.hpp"

#include <algorithm>
#include <queue>
#include <set>
#include <tuple>

#include "base/interruption.hpp"
#include "shortest/moves.hpp"
#include "shortest/steps.hpp"

namespace vcrit::symbolic::shortest {

namespace {

// Of two formulas with as many operations the one with fewer lines is shorter.
constexpr int operation = 64;

// A way to something shorter may lead over what is this much longer.
constexpr int uphill = 2 * operation;

int length(const Expressions& all, const ExLines& lines) {
  const Steps steps(all, lines);
  return operation * steps.operations() + std::min(steps.shared(), operation - 1);
}

class FormulaSearch {
 public:
  explicit FormulaSearch(Expressions& all) : all_(all), moves_(all) {}

  void begin(const ExLines& start) { meet(start); }

  void run(const SearchEffort& effort) {
    std::size_t expanded = 0;
    const std::size_t end = all_.work() + effort.work;
    while (!open_.empty() && expanded++ < effort.expanded) {
      hear_interruption();
      const auto [cost, order, lines] = open_.top();
      open_.pop();
      if (cost > least_ + uphill) return;
      for (std::size_t i = lines.size(); i-- > 0;) {
        moves_.for_each(lines[i], [&](const Ex& moved) {
          ExLines other = lines;
          other[i] = moved;
          meet(other);
          return all_.work() < end;
        });
        if (all_.work() >= end) return;
      }
    }
  }

  const ExLines& best() const { return best_; }

 private:
  struct Entry {
    int cost;
    std::size_t order;
    ExLines lines;
    friend bool operator<(const Entry& a, const Entry& b) {
      return std::tie(a.cost, a.order) > std::tie(b.cost, b.order);
    }
  };

  void meet(const ExLines& lines) {
    std::vector<ExNode> nodes;
    for (const Ex& each : lines) nodes.push_back(each.node);
    if (!seen_.insert(std::move(nodes)).second) return;
    const int cost = length(all_, lines);
    if (seen_.size() == 1 || cost < least_) least_ = cost, best_ = lines;
    if (cost <= least_ + uphill) open_.push({cost, seen_.size(), lines});
  }

  Expressions& all_;
  Moves moves_;
  std::priority_queue<Entry> open_;
  std::set<std::vector<ExNode>> seen_;
  int least_ = 0;
  ExLines best_;
};

}  // namespace

int operations(const Expressions& all, const Ex& whole) { return Steps(all, whole).operations(); }

int operations(const Expressions& all, const ExLines& lines) {
  return Steps(all, lines).operations();
}

ExLines shortest_of(Expressions& all, const std::vector<ExLines>& starts,
                    const SearchEffort& effort) {
  FormulaSearch search(all);
  for (const ExLines& start : starts) search.begin(start);
  search.run(effort);
  return search.best();
}

Ex shortest_of(Expressions& all, const std::vector<Ex>& starts, const SearchEffort& effort) {
  std::vector<ExLines> formulas;
  for (const Ex& start : starts) formulas.push_back({start});
  return shortest_of(all, formulas, effort).front();
}

}  // namespace vcrit::symbolic::shortest
