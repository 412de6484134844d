// The methods of the benchmark, each at several settings from fast to accurate.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulators/cases.hpp"

namespace vcrit::simulators {

struct PeerAnswer {
  double friction_ratio = 0;
  std::size_t events = 0;  ///< of one period
};

/// One method with one way to the steady cycle: "CVODE BDF, Newton".
struct Peer {
  struct Setting {
    std::string name;                 ///< "1e-8", "2000 steps"
    std::optional<double> tolerance;  ///< asked for, where the method takes one
    std::function<PeerAnswer(const Case&)> solve;
  };

  std::string name;
  bool cycles = false;     ///< marches until periods repeat
  bool idealised = false;  ///< other physics: not expected to come near the reference
  std::function<bool(const Case&)> applies = [](const Case&) { return true; };
  std::vector<Setting> settings = {};  ///< by increasing accuracy and cost
};

inline const std::string exact_name = "exact";

/// The exact method first. `quick`: fewer settings.
std::vector<Peer> all_peers(bool quick);

}  // namespace vcrit::simulators
