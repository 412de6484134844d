#include "indenter/changes.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "indenter/cell.hpp"

namespace vcrit::indenter {

namespace {

constexpr double edge_width = 1e-12;  // of the edge
constexpr int most_changes = 8;       // between two samples

struct Sample {
  double x = 0;
  MotionCounts course{};
};

// Between two samples of different course, each found by bisection.
class ChangeSearch {
 public:
  ChangeSearch(const HalfSpace& half_space, double velocity)
      : half_space_(half_space), velocity_(velocity), narrow_(edge_width * half_space.edge()) {}

  Sample sample(double x) const { return {x, course(half_space_, x, velocity_)}; }

  std::vector<double> between(Sample low, const Sample& high) const {
    std::vector<double> found;
    for (int i = 0; i < most_changes && low.course != high.course; ++i) {
      const Sample changed = first(low, high);
      found.push_back(changed.x);
      low = changed;
    }
    return found;
  }

 private:
  // A sample just behind a place where the course ceases to be that of `low`.
  Sample first(Sample low, Sample high) const {
    while (high.x - low.x > narrow_) {
      const Sample middle = sample(0.5 * (low.x + high.x));
      (middle.course == low.course ? low : high) = middle;
    }
    return high;
  }

  const HalfSpace& half_space_;
  double velocity_, narrow_;
};

// Where to look between two places known before, as parts of their distance: evenly, and ever
// closer to both, where courses change at low speeds.
std::vector<double> parts() {
  // Down to 4^-9/8, 5e-7 of the distance.
  constexpr int even = 8, close = 9;
  std::vector<double> result;
  for (int i = 1; i < even; ++i) result.push_back(static_cast<double>(i) / even);
  double part = 1.0 / even;
  for (int i = 0; i < close; ++i) {
    part /= 4;
    result.push_back(part);
    result.push_back(1 - part);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<double> increasing(std::vector<double> points, double edge) {
  std::sort(points.begin(), points.end());
  std::vector<double> result{0};
  for (const double x : points)
    if (x > result.back() + edge_width * edge && x < edge * (1 - edge_width)) result.push_back(x);
  result.push_back(edge);
  return result;
}

}  // namespace

std::vector<double> changes(const HalfSpace& half_space, double velocity) {
  const double edge = half_space.edge();
  const std::vector<double> known =
      increasing({half_space.closed_radius(), half_space.radius()}, edge);
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < known.size(); ++i)
    for (const double part : parts()) places.push_back(known[i] + (known[i + 1] - known[i]) * part);
  const ChangeSearch search(half_space, velocity);
  std::vector<Sample> all(places.size());
  tbb::parallel_for(std::size_t{0}, all.size(),
                    [&](std::size_t i) { all[i] = search.sample(places[i]); });
  std::vector<std::vector<double>> found(all.size() - 1);
  tbb::parallel_for(std::size_t{0}, found.size(),
                    [&](std::size_t i) { found[i] = search.between(all[i], all[i + 1]); });
  std::vector<double> points = half_space.gap().edges();
  points.insert(points.end(), known.begin(), known.end());
  for (const std::vector<double>& some : found)
    points.insert(points.end(), some.begin(), some.end());
  return increasing(std::move(points), edge);
}

}  // namespace vcrit::indenter
