#include "normal/pressed_cells.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <complex>
#include <vector>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "normal/gap.hpp"
#include "normal/normal_force.hpp"

namespace vcrit::simulation {

namespace {

// Ten times less than the root is asked for; the panels are halved at most so often.
constexpr double tolerance = 1e-12;
constexpr unsigned most_halvings = 12;
using Kronrod21 = boost::math::quadrature::gauss_kronrod<double, 21>;

constexpr int most_doublings = 1100;  // all exponents of doubles

/// sin x - x cos x for 0 <= x <= pi, the excess of a mean over its clipped part: x^3/3 - x^5/30 ...
double sine_less_arc(double x) {
  if (x > 1) return std::sin(x) - x * std::cos(x);
  double term = x * x * x / 3, sum = term;
  for (int k = 2; std::abs(term) > epsilon * sum; ++k) {
    term *= -x * x / (2 * (k - 1) * (2 * k + 1.0));
    sum += term;
  }
  return sum;
}

class Cells {
 public:
  explicit Cells(const Problem& problem)
      : gap_(*problem->indenter), amplitude_(problem.value(problem->amplitude)) {
    const double poisson = *std::get<Isotropic>(problem->tangential).quantity.value;
    const Relaxation normal = scaled(relaxation_form(problem->normal.network(), problem.values()),
                                     1 / ((1 - poisson) * (1 + poisson)));
    stiffness_ = normal.equilibrium;
    if (!(stiffness_ > 0)) throw ModelError("the half-space carries no static load: E(0) = 0");
    const double omega = problem.value(problem->angular_frequency);
    swing_ = amplitude_ * std::abs(dynamic_stiffness(normal, omega)) / stiffness_;
    elastic_ = !(normal.damper > 0) && normal.branches.empty();
    if (!elastic_) modes_ = modes_of({normal, 0, amplitude_}, omega);
  }

  double indentation(double load) const {
    const auto force = [this](double mean) { return pressed(mean); };
    return pressed_by(force, load, -amplitude_, at_most(load));
  }

  /// Of all cells.
  PressedForce pressed(double mean) const {
    if (gap_.flat()) {
      const PressedForce cell = cell_under(mean);
      return {2 * gap_.end() * cell.force, 2 * gap_.end() * cell.slope};
    }
    const std::vector<double> breaks = breaks_at(mean);
    std::complex<double> whole = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      whole += panel(mean, breaks[i], breaks[i + 1]);
    return {2 * whole.real(), 2 * whole.imag() / (mean + amplitude_)};
  }

 private:
  /// Force, and slope times the depth. At the breaks, functions may turn like (x - x0)^{k/2}: x is
  /// a cubic polynomial with its extrema there, in which that is smooth.
  std::complex<double> panel(double mean, double low, double high) const {
    const double width = high - low, depth = mean + amplitude_;
    const auto at = [&](double s) -> std::complex<double> {
      const double x = low + width * s * s * (3 - 2 * s), weight = width * 6 * s * (1 - s);
      const PressedForce cell = cell_under(mean - gap_.at(x));
      return {weight * cell.force, weight * cell.slope * depth};
    };
    return Kronrod21::integrate(at, 0.0, 1.0, most_halvings, std::max(tolerance, rounding(mean)));
  }

  /// Of what a cell that opens carries, since its depth is a small difference of larger ones. All
  /// these cells carry little together, and the less the larger it is.
  double rounding(double mean) const {
    return amplitude_ > 0 ? 16 * epsilon * (mean + amplitude_) / amplitude_ : 0;
  }

  /// Per length.
  PressedForce cell_under(double depth) const {
    if (depth >= swing_) return {stiffness_ * depth, stiffness_};
    if (!(depth + amplitude_ > 0)) return {};
    if (elastic_) {
      // Closed for 2 arc of a period: depth + amplitude cos t > 0 for |t| < arc.
      const double arc = 2 * std::asin(std::sqrt(0.5 * (1 + depth / amplitude_)));
      return {stiffness_ * amplitude_ * sine_less_arc(arc) / pi, stiffness_ * arc / pi};
    }
    const PressedCycle found = pressed_cycle(modes_, {depth, amplitude_}, &effort_);
    return {found.cycle.mean, found.slope};
  }

  std::vector<double> breaks_at(double mean) const {
    const double edge = gap_.half_width(mean + amplitude_);
    std::vector<double> all = gap_.edges();
    all.insert(all.end(), {gap_.half_width(mean - swing_), gap_.half_width(mean)});
    std::erase_if(all, [&](double x) { return !(x > 0 && x < edge); });
    all.insert(all.end(), {0, edge});
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  /// An indentation at which the force is above the load.
  double at_most(double load) const {
    double mean = amplitude_ > 0 ? amplitude_ : load / stiffness_;
    for (int i = 0; i < most_doublings && std::isfinite(mean); ++i, mean *= 2)
      if (pressed(mean).force >= load) return mean;
    throw ModelError("the indenter ends before it carries the load");
  }

  vcrit::indenter::Gap gap_;
  double amplitude_, stiffness_ = 0, swing_ = 0;
  bool elastic_ = false;
  ContactModes modes_;
  mutable SharedEffort effort_{effort_of_pressing};
};

}  // namespace

double indentation_of_cells(const Problem& problem) {
  return Cells(problem).indentation(problem.value(*problem->load));
}

double mean_force_of_cells(const Problem& problem) {
  return Cells(problem).pressed(mean_indentation(problem)).force;
}

}  // namespace vcrit::simulation
