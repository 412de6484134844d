#include "compare/periodic_motion.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "compare/velocity_comparisons.hpp"
#include "critical/conditioning.hpp"
#include "linear/elimination.hpp"
#include "normal/mount.hpp"

namespace vcrit::validation {

namespace {

constexpr std::size_t points = 256;  // instants of a period; the work goes with their square

// Answers larger than this, in units of the contact's own, are those of a free swing: a resistance
// so large lets such a swing do what it likes for next to no force.
constexpr double freest = 1e9;

// What a free swing of the size of the speed costs at most at one point of the grid.
constexpr double swing_cost = 1e3 / freest;

// Speeds that are tried, in units of what the contact's own stiffness gives. Long doubles tell less
// from 0 at an antiresonance, and a drive that gives more from a resonance.
constexpr double slowest_speed = 1e-17, fastest_speed = 0.1 * freest;

// Rounding of the long doubles that the networks are solved in, over that of doubles.
constexpr double extended = 0x1p-11;

// A border is searched for to this share of it.
constexpr double precision = 1e-6;

// Exchanges of all points that break the law at once; then of the first one alone, which ends.
constexpr int most_exchanges = 60, most_single_exchanges = 500;

using Complex = std::complex<double>;

Complex bounded(Complex answer) { return std::abs(answer) < freest ? answer : freest; }

// What the grid cannot resolve is given a resistance, which grows with the frequency and takes
// nothing from low ones: no answer is without one, so that the motion is one. It does not move the
// border, above which the friction on the contact point has one harmonic alone.
Complex resistive(Complex answer, std::size_t n) {
  const double high = static_cast<double>(n) / (points / 2);
  return Complex(std::max(answer.real(), 0.0), answer.imag()) + 0.1 * high +
         std::abs(answer.imag()) * high;
}

}  // namespace

PeriodicMotion::PeriodicMotion(const Problem& problem) : push_(points), kernel_(points) {
  const NodalResponse response(problem);
  const Values& values = problem.values();
  const double omega = values.at(problem->angular_frequency.symbol);
  const auto own = static_cast<double>(omega * std::abs(response.contact_alone(omega)));
  amplitude_ =
      static_cast<double>(values.at(problem->coefficient.symbol) * contact_amplitude(problem) *
                          std::abs(response.normal_stiffness(omega)));
  unit_ = amplitude_ * own;
  std::vector<Complex> answers{1e-3};
  for (std::size_t n = 1; n <= points / 2; ++n) {
    const double frequency = static_cast<double>(n) * omega;
    const LongComplex velocity = LongComplex(0, frequency) * response.contact_point(frequency);
    const auto answer = bounded(static_cast<Complex>(velocity / static_cast<long double>(own)));
    swings_freely_ = swings_freely_ || answer == freest;
    for (std::size_t j = 0; n == 1 && j < points; ++j)
      push_[j] = (answer * std::polar(1.0, two_pi * static_cast<double>(j) / points)).real();
    answers.push_back(resistive(answer, n));
  }
  for (std::size_t j = 0; j < points; ++j) {
    double sum = answers.front().real();
    for (std::size_t n = 1; n <= points / 2; ++n) {
      const double phase = two_pi * static_cast<double>(n * j % points) / points;
      sum += (2 * n == points ? 1 : 2) * (answers[n] * std::polar(1.0, phase)).real();
    }
    kernel_[j] = sum / points;
  }
}

double PeriodicMotion::resolution() { return 0.5 * (pi / points) * (pi / points); }

// A linear complementarity problem, by exchanging points between stick and slip.
std::vector<double> PeriodicMotion::lost(double velocity) const {
  std::vector<char> stuck(points, 1);
  std::vector<double> x(points), w(points);
  for (int exchange = 0; exchange < most_exchanges + most_single_exchanges; ++exchange) {
    std::vector<std::size_t> at;
    for (std::size_t j = 0; j < points; ++j)
      if (stuck[j]) at.push_back(j);
    const auto count = static_cast<Eigen::Index>(at.size());
    Eigen::MatrixXd matrix(count, count);
    Eigen::VectorXd right(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::size_t row = at[static_cast<std::size_t>(i)];
      right(i) = push_[row] - velocity;
      for (Eigen::Index j = 0; j < count; ++j)
        matrix(i, j) = kernel_[(row + points - at[static_cast<std::size_t>(j)]) % points];
    }
    const Eigen::VectorXd solution = linear::Lu<double>(matrix).solve(right);
    std::fill(x.begin(), x.end(), 0.0);
    for (Eigen::Index i = 0; i < count; ++i) x[at[static_cast<std::size_t>(i)]] = solution(i);
    bool lawful = true;
    for (std::size_t i = 0; i < points; ++i) {
      if (stuck[i] != 0) {
        w[i] = 0;
      } else {
        w[i] = velocity - push_[i];
        for (const std::size_t j : at) w[i] += kernel_[(i + points - j) % points] * x[j];
      }
      if (!(stuck[i] != 0 ? x[i] < 0 : w[i] < 0)) continue;
      if (!lawful && exchange >= most_exchanges) break;
      stuck[i] = stuck[i] != 0 ? 0 : 1;
      lawful = false;
    }
    if (lawful) return x;
  }
  throw ModelError("no periodic motion found on the grid");
}

double PeriodicMotion::missing_friction(double velocity) const {
  const std::vector<double> x = lost(velocity / unit_);
  return amplitude_ * std::accumulate(x.begin(), x.end(), 0.0) / points;
}

double PeriodicMotion::highest() const { return fastest_speed * unit_; }

// Beside an antiresonance digits are lost as the border falls: as many as the grid leaves open.
double PeriodicMotion::lowest() const {
  return extended * formula_tolerance(1) / resolution() * unit_;
}

double PeriodicMotion::border() const {
  const auto sticks = [&](double velocity) {
    const std::vector<double> x = lost(velocity);
    const double least = swings_freely_ ? swing_cost * velocity : 0;
    return *std::max_element(x.begin(), x.end()) > least;
  };
  if (!sticks(slowest_speed)) return 0;
  if (sticks(fastest_speed)) return infinity;
  double low = slowest_speed, high = fastest_speed;
  while (high > low * (1 + precision)) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    (sticks(middle) ? low : high) = middle;
  }
  return low * unit_;
}

Comparison compare_periodic_motion(const SceneReport& report) {
  Comparison comparison = velocity_comparison(
      report, "periodic", "periodic motion on a grid of one period: where its last stick ends");
  if (!report.free_harmonics.empty()) {
    comparison.expected = report.sliding_from;
    comparison.reference = "v* less what free swings take off it";
  }
  // A free swing hides as much again.
  comparison.tolerance = 2 * PeriodicMotion::resolution();
  comparison.reason = fmt::format(
      "a border falls between the points of the grid, {} in a period: {:.2g}; and as much again",
      points, PeriodicMotion::resolution());
  try {
    const PeriodicMotion motion(report.problem);
    if (std::isnan(comparison.expected))
      return not_run(comparison, "the border of so many free swings is not known");
    if (is_speed(comparison.expected) &&
        (comparison.expected > motion.highest() || comparison.expected < motion.lowest()))
      return not_run(comparison, lost_digits);
    comparison.found = motion.border();
  } catch (const ModelError& error) {
    return not_run(comparison, error.what());
  }
  return comparison;
}

}  // namespace vcrit::validation
