#include "realisation/search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "realisation/least_squares.hpp"

namespace vcrit::realisation {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Misfits of the size of rounding errors count as equal.
constexpr double least_misfit = 1e-13;
// What the least tau leaves of a spring that does not relax (keep_in_reach), which no mode is to
// mend.
constexpr double least_telling = 1e-9;

// Twice Schwarz's price of a parameter: misfits of rounded numbers are no normal deviates (their
// size steps tenfold with the decade), and a mode too many costs more than one too few that noise
// hides.
double criterion_of(const StructureShape& shape, const Rows& rows, double sum) {
  const auto numbers = static_cast<double>(2 * rows.size());
  return numbers * std::log(std::max(sum / numbers, least_telling * least_telling)) +
         2 * static_cast<double>(shape.parameters()) * std::log(numbers);
}

Minimum minimised(const Rows& rows, const StructureShape& shape, const VectorXd& start, int steps,
                  double enough) {
  const LeastSquares problem{[&](const VectorXd& at, VectorXd& residual, Eigen::MatrixXd* slope) {
                               residuals(shape, rows, at, residual, slope);
                             },
                             [&](VectorXd& at) { keep_in_reach(shape, rows, at); }};
  return minimise(problem, start, steps, enough);
}

/// The search in one order after the other, over rows that are few enough for many starts.
class Orders {
 public:
  Orders(const Rows& rows, double noise, Damping most_general)
      : rows_(rows),
        most_general_(most_general),
        few_(thinned(rows, most_rows)),
        enough_(2 * static_cast<double>(few_.size()) * std::max(noise, least_misfit) *
                std::max(noise, least_misfit)) {}

  bool holds(Index modes) const { return StructureShape{modes}.parameters() < 2 * rows_.size(); }

  void take(Index modes) {
    if (modes == 0) {
      keep(minimum_from(StructureShape{}, {series_spring(few_)}), StructureShape{});
      return;
    }
    const Structure* less = last_modal_ ? &*last_modal_ : nullptr;
    const std::vector<Structure> starts = first_starts(few_, modes, less);
    std::vector<Structure> found = modal(modes, starts);
    if (modes > 1) {
      // Modes of full damping are not near the best modal ones: the starts count once more.
      found.insert(found.end(), starts.begin(), starts.end());
      found = full(modes, found);
    }
    if (most_general_ == Damping::coupled) coupled(modes, found.front());
  }

  const std::vector<Candidate>& all() const { return all_; }

 private:
  static constexpr Index most_rows = 400;
  static constexpr int start_steps = 25, follow_steps = 100, refine_steps = 150;
  static constexpr std::size_t all_starts = 10, best_starts = 3;

  struct Found {
    Structure structure;
    double sum;
  };

  Found descended(const StructureShape& shape, const Structure& start, int steps) const {
    const Minimum minimum = minimised(few_, shape, parameters_of(shape, start), steps, enough_ / 2);
    return {structure_of(shape, minimum.parameters), minimum.sum};
  }

  // Best first, and the best followed on. Those that come after one that is as good as the noise
  // lets it be are not tried.
  std::vector<Found> minimum_from(const StructureShape& shape,
                                  const std::vector<Structure>& starts) const {
    std::vector<Found> found;
    for (const Structure& start : starts) {
      if (start.modes() != shape.modes) continue;
      found.push_back(descended(shape, start, start_steps));
      if (good_enough(found.back())) break;
    }
    sort(found);
    for (std::size_t i = 0; i < std::min(found.size(), best_starts); ++i) {
      if (good_enough(found.front())) break;
      found[i] = descended(shape, found[i].structure, follow_steps);
    }
    sort(found);
    return found;
  }

  bool good_enough(const Found& found) const { return found.sum <= 1.1 * enough_; }

  static void sort(std::vector<Found>& found) {
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.sum < b.sum; });
  }

  std::vector<Structure> keep(std::vector<Found> found, const StructureShape& shape) {
    if (found.size() > best_starts) found.resize(best_starts);
    std::vector<Structure> best;
    for (const Found& each : found) best.push_back(each.structure);
    if (shape.parameters() >= 2 * rows_.size()) return best;
    const Found last = descended(shape, best.front(), refine_steps);
    all_.push_back(refined(rows_, shape, parameters_of(shape, last.structure), all_row_steps()));
    best.front() = last.structure;
    return best;
  }

  int all_row_steps() const { return rows_.size() == few_.size() ? 1 : 20; }

  std::vector<Structure> modal(Index modes, const std::vector<Structure>& starts) {
    const StructureShape shape{modes, Damping::modal};
    std::vector<Found> found = minimum_from(shape, starts);
    found = with_shaken(shape, std::move(found));
    std::vector<Structure> best = keep(std::move(found), shape);
    last_modal_ = best.front();
    return best;
  }

  std::vector<Structure> full(Index modes, std::vector<Structure> starts) {
    const StructureShape shape{modes, Damping::full};
    if (last_full_)
      for (const double place : places_of_new_mode(few_, *last_full_))
        starts.push_back(with_mode(few_, *last_full_, place, 0.02));
    std::vector<Found> found = minimum_from(shape, starts);
    found = with_shaken(shape, std::move(found));
    std::vector<Structure> best = keep(std::move(found), shape);
    last_full_ = best.front();
    return best;
  }

  void coupled(Index modes, const Structure& start) {
    const StructureShape shape{modes, Damping::coupled};
    std::vector<Structure> starts{start};
    for (const Structure& each : absorber_starts(few_, modes)) starts.push_back(each);
    if (last_coupled_)
      for (const double place : places_of_new_mode(few_, *last_coupled_))
        starts.push_back(with_mode(few_, *last_coupled_, place, 0.02));
    last_coupled_ = keep(minimum_from(shape, starts), shape).front();
  }

  std::vector<Found> with_shaken(const StructureShape& shape, std::vector<Found> found) {
    const std::size_t first = found.size();
    for (std::size_t i = first; i < all_starts && !good_enough(found.front()); ++i) {
      Found next = descended(shape, shaken(found.front().structure, deviates_), start_steps);
      if (next.sum < found.front().sum) std::swap(next, found.front());
      found.push_back(std::move(next));
    }
    return found;
  }

  const Rows& rows_;
  Damping most_general_;
  const Rows few_;
  double enough_;
  Deviates deviates_;
  std::optional<Structure> last_modal_, last_full_, last_coupled_;
  std::vector<Candidate> all_;
};

const Candidate& least(const std::vector<Candidate>& all, std::optional<Index> modes) {
  const Candidate* best = nullptr;
  for (const Candidate& each : all)
    if ((!modes || each.shape.modes == *modes) && (!best || each.criterion < best->criterion))
      best = &each;
  return *best;
}

// A structure of one mode more fits at least as well; one of a mode less may, if noise hides that
// mode.
bool allowed(const Candidate& rival, const Candidate& best) {
  constexpr double slack = 1.3;
  return !(rival.shape == best.shape) && std::isfinite(rival.sum) &&
         std::abs(rival.shape.modes - best.shape.modes) <= 1 &&
         rival.sum <= slack * slack * best.sum;
}

}  // namespace

Candidate refined(const Rows& rows, const StructureShape& shape, const VectorXd& parameters,
                  int steps) {
  const Minimum minimum = minimised(rows, shape, parameters, steps, 0);
  return {shape, minimum.parameters, minimum.sum, criterion_of(shape, rows, minimum.sum)};
}

FoundStructures search(const Rows& rows, double noise, std::optional<Index> order,
                       Damping most_general) {
  Orders orders(rows, noise, most_general);
  if (order && (!orders.holds(*order) || *order > most_order))
    throw InputError({}, fmt::format("order = {} for {} rows", *order, rows.size()),
                     fmt::format("an order of at most {}, with fewer parameters than the table has "
                                 "numbers",
                                 most_order));
  const Index last = order ? *order + 1 : most_fitted_modes;
  double before = std::numeric_limits<double>::infinity();
  int idle = 0;
  for (Index modes = 0; modes <= last && orders.holds(modes) && (order || idle < 2); ++modes) {
    orders.take(modes);
    const Candidate& now = least(orders.all(), modes);
    idle = now.criterion < before ? 0 : idle + 1;
    before = std::min(before, now.criterion);
  }
  FoundStructures result{least(orders.all(), order), {}};
  for (const Candidate& each : orders.all())
    if (allowed(each, result.best)) result.rivals.push_back(each);
  return result;
}

}  // namespace vcrit::realisation
