// What the points say: one line a method and setting, and the exact method against the fastest peer
// that is accurate enough.
#pragma once

#include <map>
#include <optional>

#include "simulators/measurement.hpp"

namespace vcrit::simulators {

/// One setting of one peer over the rows of a problem.
struct SettingLine {
  const Peer* peer = nullptr;
  const Peer::Setting* setting = nullptr;
  std::size_t rows = 0, answered = 0;
  double seconds = 0;  ///< median over the rows answered
  double error = 0;    ///< largest over them
  std::map<RunVerdict, std::size_t> failures = {};
  bool front = false;  ///< no other setting without failures is both faster and more accurate
};

/// Which rows count.
using Taken = std::function<bool(const Case&)>;

std::vector<SettingLine> work_precision(const std::vector<PeerSolve>& points, const Taken& taken);

/// On one row, the exact method and the fastest solve of GSL or CVODE with at most so large an
/// error.
struct Race {
  const Case* row = nullptr;
  PeerSolve exact;
  std::optional<PeerSolve> best;
  double factor() const { return best ? best->seconds / exact.seconds : 0; }
};

struct PeerComparison {
  double largest_error = 0;  ///< of the exact method; infinite where it gave no answer
  std::vector<Race> races;
  std::size_t lost = 0;          ///< rows on which no peer was accurate enough
  double exact_median = 0;       ///< s, over the rows
  double least = 0, median = 0;  ///< of the factors, over rows where a peer was accurate enough
  /// The fastest setting that is accurate enough on every row, as one must choose it who does not
  /// know the answers.
  std::optional<SettingLine> one_setting;
};

PeerComparison compare(const std::vector<PeerSolve>& points, double error, const Taken& taken);

}  // namespace vcrit::simulators
