#include "design/first_reach.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace vcrit::design {

namespace {

// Half the digits: the bottom of a dip is no better known.
constexpr int bits_of_minimum = 26;
// Two bits above rounding, where a root finder's bracket no longer shrinks.
constexpr int bits_of_root = 50;
constexpr std::uintmax_t most_search_steps = 200;
// Ratios are at most 1, and those wanted above 0. Much more would overflow in the root finder.
constexpr double excess_without_answer = 1;

class Searching {
 public:
  Searching(const Measured& measured, double wanted) : measured_(measured), wanted_(wanted) {}

  ReachSearch along(const std::vector<double>& places) {
    std::vector<double> excess;
    for (std::size_t i = 0; i < places.size() && !search_.reach; ++i) {
      excess.push_back(above(places[i]));
      if (excess[i] <= 0)
        search_.reach =
            i == 0 ? Reach{places[0], places[0], places[0]} : refined(places[i - 1], places[i]);
      else if (i >= 2 && excess[i - 1] < excess[i - 2] && excess[i - 1] < excess[i])
        look_into_dip(places[i - 2], places[i]);
    }
    return search_;
  }

 private:
  // By how much the wanted value is missed. A place without an answer does not reach it.
  double above(double place) {
    ++search_.evaluations;
    const std::optional<double> value = measured_(place);
    if (!value) {
      ++search_.unanswered;
      return excess_without_answer;
    }
    if (!search_.least || *value < *search_.least) search_.least = value, search_.least_at = place;
    return *value - wanted_;
  }

  Reach refined(double before, double at) {
    std::uintmax_t steps = most_search_steps;
    const auto [a, b] = boost::math::tools::toms748_solve(
        [&](double x) { return above(x); }, std::min(before, at), std::max(before, at),
        boost::math::tools::eps_tolerance<double>(bits_of_root), steps);
    const double near = before < at ? a : b, far = before < at ? b : a;
    return {above(near) <= 0 ? near : far, near, before};
  }

  void look_into_dip(double before, double after) {
    std::optional<double> reached;
    std::uintmax_t steps = most_search_steps;
    boost::math::tools::brent_find_minima(
        [&](double x) {
          const double value = above(x);
          if (value <= 0 && (!reached || std::abs(x - before) < std::abs(*reached - before)))
            reached = x;
          return value;
        },
        std::min(before, after), std::max(before, after), bits_of_minimum, steps);
    if (reached) search_.reach = refined(before, *reached);
  }

  const Measured& measured_;
  double wanted_;
  ReachSearch search_;
};

}  // namespace

ReachSearch first_reach(const Measured& measured, const std::vector<double>& places,
                        double wanted) {
  return Searching(measured, wanted).along(places);
}

}  // namespace vcrit::design
