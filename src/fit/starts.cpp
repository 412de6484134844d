#include "fit/starts.hpp"

#include <algorithm>
#include <cmath>

#include "linear/orthogonal.hpp"

namespace vcrit::fit {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A branch's response is a decade wide: a twelfth of that is as good as a continuum.
constexpr double per_decade = 12;

MaxwellBranch joined_branch(const MaxwellBranch& a, const MaxwellBranch& b) {
  const double sum = a.stiffness + b.stiffness;
  return {sum, std::exp((a.stiffness * std::log(a.time) + b.stiffness * std::log(b.time)) / sum)};
}

}  // namespace

std::vector<double> grid_of_times(const Weighed& data) {
  const auto [from, to] = time_range(data);
  const int steps = static_cast<int>(std::ceil(per_decade * std::log10(to / from)));
  std::vector<double> times;
  for (int i = 0; i <= steps; ++i)
    times.push_back(from * std::pow(to / from, static_cast<double>(i) / steps));
  return times;
}

Relaxation dense_spectrum(const Weighed& data, const Terms& terms) {
  Relaxation spectrum = linear_fit(data, terms, grid_of_times(data));
  std::erase_if(spectrum.branches, [](const MaxwellBranch& b) { return b.stiffness == 0; });
  return spectrum;
}

std::optional<Relaxation> merged(Relaxation spectrum, int branches) {
  auto& list = spectrum.branches;
  if (static_cast<int>(list.size()) < branches) return std::nullopt;
  while (static_cast<int>(list.size()) > branches) {
    if (list.size() == 1) {
      list.clear();
      break;
    }
    std::size_t nearest = 0;
    const auto gap = [&](std::size_t i) { return list[i + 1].time / list[i].time; };
    for (std::size_t i = 1; i + 1 < list.size(); ++i)
      if (gap(i) < gap(nearest)) nearest = i;
    list[nearest] = joined_branch(list[nearest], list[nearest + 1]);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(nearest) + 1);
  }
  return spectrum;
}

// What a new branch cannot share with changes of those that are there (its part across their
// slopes) meets the residual: the fall of the sum of squares is (a.r)^2/|a|^2.
std::optional<Relaxation> with_another_branch(const Weighed& data, const Terms& terms,
                                              const Refined& fit) {
  const VectorXd missing = -data.residual(fit.series);
  const MatrixXd across =
      fit.slopes.cols() > 0 ? linear::Qr(fit.slopes).basis() : MatrixXd(data.size(), 0);
  double best = 0, time = 0;
  for (const double candidate : grid_of_times(data)) {
    const VectorXd column = data.branch(candidate);
    const VectorXd own = column - across * (across.transpose() * column);
    const double length = own.norm(), along = own.dot(missing);
    if (!(along > 0) || length < 1e-9 * column.norm()) continue;
    const double fall = along / length;
    if (fall > best) best = fall, time = candidate;
  }
  if (time == 0) return std::nullopt;
  std::vector<double> times{time};
  for (const MaxwellBranch& branch : fit.series.branches) times.push_back(branch.time);
  std::sort(times.begin(), times.end());
  return linear_fit(data, terms, times);
}

}  // namespace vcrit::fit
