#include "compare/frequency_points.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "critical/critical_velocity.hpp"
#include "network/masses.hpp"
#include "normal/mount.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::validation {

namespace {

constexpr double points_per_decade = 48;  // steps of 5 %; next to resonances more
constexpr double most_points = 600;       // 12.5 decades at that; more are sampled more thinly
constexpr int parts_of_gap = 4;           // of a table, between two of its rows
constexpr std::size_t most_rows = 50000;  // of a table; a longer one is sampled more thinly
constexpr std::size_t most_drawn = 2000;  // points of a curve
// Peaks and dips are no less than this part of what they stand out of: rounding, and noise of
// tables.
constexpr double least_bump = 1e-6, bump_of_tables = 0.05;

/// The problem, and what is asked of it again and again.
class Response {
 public:
  explicit Response(const Problem& problem)
      : problem_(problem),
        values_(problem_.values()),
        tangential_(tangential_network(problem)),
        amplitude_(values_.at(problem->amplitude.symbol)),
        indentation_(rules::Facts(problem).indentation()),
        mean_force_(rules::Facts(problem).mean_force()) {}

  ResponsePoint at(double omega) const {
    ResponsePoint point;
    point.omega = omega;
    point.normal = std::abs(dynamic_stiffness(problem_->normal.reduction(), values_, omega));
    point.tangential = tangential_.factor *
                       std::abs(dynamic_stiffness(tangential_.network.reduction(), values_, omega));
    if (const auto* drive = problem_->drive_network())
      point.drive = std::abs(dynamic_stiffness(drive->reduction(), values_, omega));
    point.velocity = critical_velocity(problem_, omega);
    point.applies =
        problem_->separation ? holds_with_separation(omega) : stays_closed(omega, point.normal);
    return point;
  }

  /// What the drive makes of v*: above 1 near resonance, below near antiresonance.
  double drive_factor(const ResponsePoint& point) const {
    return point.velocity * point.tangential / (point.omega * point.normal);
  }
  double drive_factor(double omega) const { return drive_factor(at(omega)); }

 private:
  /// (3) and (4)
  bool stays_closed(double omega, double stiffness) const {
    const long double amplitude = amplitude_ * mount_factor(problem_, omega);
    return amplitude < indentation_ && amplitude * stiffness < mean_force_;
  }

  /// Whether Eq. 24 is v* of a contact that may open.
  bool holds_with_separation(double omega) const {
    const Problem there = problem_.with({{problem_->angular_frequency.symbol, omega}});
    try {
      return bool{rules::answer(rules::Question::formula, there)};
    } catch (const ModelError&) {
      return false;
    }
  }

  Problem problem_;
  const Values& values_;  // its
  ScaledNetwork tangential_;
  long double amplitude_, indentation_, mean_force_;
};

struct FrequencyRange {
  double from, to;
  void include(double omega) {
    if (!(omega > 0 && std::isfinite(omega))) return;
    from = std::min(from, omega);
    to = std::max(to, omega);
  }
};

void include_relaxation(FrequencyRange& range, const Network& network, const Values& values) {
  if (!of_springs_and_dampers(network)) return;
  for (const auto& branch : relaxation_form(network, values).branches)
    range.include(1 / branch.time);
}

/// The mass against each stiffness that it may swing on.
void include_resonances(FrequencyRange& range, const Problem& problem, const Values& values) {
  if (!problem->mass || problem->drive_network() == nullptr) return;
  const double mass = values.at(problem->mass->symbol),
               omega = values.at(problem->angular_frequency.symbol);
  const double drive =
      std::abs(dynamic_stiffness(problem->drive_network()->reduction(), values, omega));
  const auto [contact, factor] = tangential_network(problem);
  range.include(std::sqrt(drive / mass));
  range.include(std::sqrt(
      (drive + factor * std::abs(dynamic_stiffness(contact.reduction(), values, omega))) / mass));
}

FrequencyRange range_of(const Problem& problem, const Values& values) {
  if (const Receptance* measured = problem->receptance())
    return {measured->rows.front().omega, measured->rows.back().omega};
  const double omega = values.at(problem->angular_frequency.symbol);
  FrequencyRange range{omega, omega};
  include_relaxation(range, problem->normal.network(), values);
  include_relaxation(range, tangential_network(problem).network.network(), values);
  if (problem->drive_network() != nullptr)
    include_relaxation(range, problem->drive_network()->network(), values);
  include_resonances(range, problem, values);
  // Within the range of doubles, as their ratio is: what is that far from the scene's is left out.
  constexpr double farthest = 1e150;
  const double from = range.from / 100, to = range.to * 100;
  range = {from > 0 ? from : range.from, std::isfinite(to) ? to : range.to};
  if (std::isfinite(range.to / range.from)) return range;
  return {std::max(range.from, omega / farthest), std::min(range.to, omega * farthest)};
}

std::vector<double> even_steps(const FrequencyRange& range) {
  const double decades = std::log10(range.to / range.from);
  const auto count =
      static_cast<int>(std::clamp(std::ceil(points_per_decade * decades), 2.0, most_points));
  std::vector<double> omegas{range.from};
  for (int i = 1; i < count; ++i)
    omegas.push_back(range.from * std::pow(range.to / range.from, double(i) / count));
  omegas.push_back(range.to);
  return omegas;
}

// With each row of a table, and places between them: the response is straight there, but v* peaks
// where a mass swings on it.
std::vector<double> frequencies_of(const Problem& problem, const Values& values) {
  std::vector<double> omegas = even_steps(range_of(problem, values));
  if (problem->receptance() == nullptr) return omegas;
  const auto& rows = problem->receptance()->rows;
  double before = rows.front().omega;
  for (std::size_t row = 1; row < rows.size(); row += rows.size() / most_rows + 1) {
    for (int part = 1; part <= parts_of_gap; ++part)
      omegas.push_back(std::lerp(before, rows[row].omega, double(part) / parts_of_gap));
    before = rows[row].omega;
  }
  std::ranges::sort(omegas);
  omegas.erase(std::unique(omegas.begin(), omegas.end()), omegas.end());
  return omegas;
}

/// A long table has more rows than a picture has places.
void thin_out(std::vector<ResponsePoint>& points) {
  const std::size_t step = points.size() / most_drawn + 1;
  std::vector<ResponsePoint> kept;
  for (std::size_t i = 0; i + 1 < points.size(); i += step) kept.push_back(points[i]);
  kept.push_back(points.back());
  points = std::move(kept);
}

/// Where the factors stop rising (sign 1) or falling (-1), numbers of points.
struct Turn {
  std::size_t at;
  double sign;
};

/// Those from which they go back by more than `bump` of their size.
std::vector<Turn> turns_of(const std::vector<double>& factors, double bump) {
  std::vector<Turn> turns;
  double sign = 0;                // of the way to the next turn
  std::size_t high = 0, low = 0;  // since the last one
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (factors[i] > factors[high]) high = i;
    if (factors[i] < factors[low]) low = i;
    const bool falls = sign >= 0 && factors[i] < (1 - bump) * factors[high],
               rises = sign <= 0 && factors[low] < (1 - bump) * factors[i];
    if (!falls && !rises) continue;
    // Of the first way no beginning is known.
    if (sign != 0) turns.push_back({falls ? high : low, sign});
    sign = falls ? -1 : 1;
    (falls ? low : high) = i;
  }
  return turns;
}

/// The peak or dip of the drive's factor between the neighbours of a point.
ResonanceMark mark_at(const Response& response, const std::vector<ResponsePoint>& points,
                      const Turn& turn) {
  const double before = points[turn.at - 1].omega, behind = points[turn.at + 1].omega;
  // exp(log(omega)) is not omega to the last bit, and a measured drive ends with its table.
  const auto omega = [&](double log_omega) {
    return std::clamp(std::exp(log_omega), before, behind);
  };
  const auto height = [&](double log_omega) {
    return -turn.sign * std::log(response.drive_factor(omega(log_omega)));
  };
  const double at =
      boost::math::tools::brent_find_minima(height, std::log(before), std::log(behind), 40).first;
  return {omega(at), turn.sign > 0};
}

/// Peaks are sharper than the grid: more points around them, ever closer.
void add_points_around_marks(const Response& response, FrequencyResponse& result) {
  const double from = result.points.front().omega, to = result.points.back().omega;
  for (const ResonanceMark& mark : result.marks)
    for (double apart = 0.03; apart > 1e-6; apart /= 1.7)
      for (const double side : {-1.0, 1.0})
        if (const double omega = mark.omega * (1 + side * apart); omega > from && omega < to)
          result.points.push_back(response.at(omega));
  std::sort(result.points.begin(), result.points.end(),
            [](const ResponsePoint& a, const ResponsePoint& b) { return a.omega < b.omega; });
}

}  // namespace

FrequencyResponse frequency_points(const Problem& problem) {
  // A measured contact is held at its numbers here, also where the drive's table goes further.
  if (!problem->measured.empty() || (problem->receptance() == nullptr &&
                                     !rules::answer(rules::Question::all_frequencies, problem)))
    return {};
  const Values& values = problem.values();
  const Response response(problem);
  FrequencyResponse result;
  result.omega = values.at(problem->angular_frequency.symbol);
  std::vector<double> factors;
  for (const double omega : frequencies_of(problem, values)) {
    result.points.push_back(response.at(omega));
    factors.push_back(response.drive_factor(result.points.back()));
  }
  if (problem->mass || problem->receptance() != nullptr || rules::drive_resonates(problem)) {
    const double bump = problem->receptance() != nullptr ? bump_of_tables : least_bump;
    for (const Turn& turn : turns_of(factors, bump))
      result.marks.push_back(mark_at(response, result.points, turn));
    std::ranges::stable_partition(result.marks, &ResonanceMark::resonance);
    thin_out(result.points);
    add_points_around_marks(response, result);
  }
  return result;
}

}  // namespace vcrit::validation
