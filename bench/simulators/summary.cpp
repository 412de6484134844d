#include "simulators/summary.hpp"

#include <algorithm>

#include "base/constants.hpp"

namespace vcrit::simulators {

namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool clean(const SettingLine& line) { return line.answered > 0 && line.failures.empty(); }

// Errors below this are rounding and of no account.
constexpr double rounding = 1e-14;

bool beats(const SettingLine& a, const SettingLine& b) {
  return clean(a) && a.seconds < b.seconds &&
         std::max(a.error, rounding) <= std::max(b.error, rounding);
}

/// The peers that the exact method is held against: general integrators with events.
bool is_rival(const Peer& peer) {
  return peer.name.starts_with("GSL") || peer.name.starts_with("CVODE");
}

SettingLine line_of(const std::vector<const PeerSolve*>& points) {
  SettingLine line{points.front()->peer, points.front()->setting};
  std::vector<double> times;
  for (const PeerSolve* point : points) {
    ++line.rows;
    if (point->verdict != RunVerdict::right) ++line.failures[point->verdict];
    if (!point->answered) continue;
    ++line.answered;
    times.push_back(point->seconds);
    line.error = std::max(line.error, point->error);
  }
  line.seconds = median(times);
  return line;
}

Race race(const std::vector<PeerSolve>& points, const Case* row, double error) {
  Race result{row, {}, {}};
  for (const PeerSolve& point : points) {
    if (point.row != row || !point.answered) continue;
    if (point.peer->name == exact_name) result.exact = point;
    if (!is_rival(*point.peer) || point.error > error) continue;
    if (!result.best || point.seconds < result.best->seconds) result.best = point;
  }
  return result;
}

bool accurate(const SettingLine& line, double error, std::size_t rows) {
  return is_rival(*line.peer) && line.answered == rows && line.error <= error;
}

}  // namespace

std::vector<SettingLine> work_precision(const std::vector<PeerSolve>& points, const Taken& taken) {
  std::vector<std::vector<const PeerSolve*>> groups;
  for (const PeerSolve& point : points) {
    if (!taken(*point.row)) continue;
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return group.front()->setting == point.setting;
    });
    (same == groups.end() ? groups.emplace_back() : *same).push_back(&point);
  }
  std::vector<SettingLine> lines;
  for (const auto& group : groups) lines.push_back(line_of(group));
  for (SettingLine& line : lines)
    line.front =
        clean(line) && std::none_of(lines.begin(), lines.end(),
                                    [&](const SettingLine& other) { return beats(other, line); });
  return lines;
}

PeerComparison compare(const std::vector<PeerSolve>& points, double error, const Taken& taken) {
  PeerComparison result;
  std::vector<double> times, factors;
  for (const PeerSolve& point : points) {
    if (point.peer->name != exact_name || !taken(*point.row)) continue;
    if (!point.answered) {
      result.largest_error = infinity;
      continue;
    }
    result.races.push_back(race(points, point.row, error));
    result.largest_error = std::max(result.largest_error, point.error);
    times.push_back(point.seconds);
    if (!result.races.back().best)
      ++result.lost;
    else
      factors.push_back(result.races.back().factor());
  }
  for (const SettingLine& line : work_precision(points, taken))
    if (accurate(line, error, times.size()) &&
        (!result.one_setting || line.seconds < result.one_setting->seconds))
      result.one_setting = line;
  result.exact_median = median(times);
  result.median = median(factors);
  result.least = factors.empty() ? 0 : *std::min_element(factors.begin(), factors.end());
  return result;
}

}  // namespace vcrit::simulators
