// Every peer at every setting on every case: time, error, and how it went wrong.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/numbers.hpp"
#include "simulators/peers.hpp"

namespace vcrit::simulators {

using vcrit::to_text;  // beside that of a verdict

enum class RunVerdict {
  right,
  missed_grazing,  ///< answers pure sliding where there is stick
  drift,           ///< periods seemed to repeat while the motion still relaxed
  wrong,           ///< another wrong number
  chattering,      ///< switches between slip and stick without end
  not_finished,    ///< in its time, or gave up
};

const char* to_text(RunVerdict verdict);  ///< "right", "missed grazing", ...

/// One solve.
struct PeerSolve {
  const Case* row = nullptr;
  const Peer* peer = nullptr;
  const Peer::Setting* setting = nullptr;
  RunVerdict verdict = RunVerdict::right;
  bool answered = false;
  double seconds = 0;  ///< processor time
  double friction_ratio = 0;
  double error = 0;        ///< absolute, in mu_macro/mu0
  std::string words = {};  ///< what the method said when it gave no answer
};

struct Budget {
  double solve = 1.5;    ///< seconds a solve may take
  double repeat = 0.02;  ///< seconds for repeating short ones
};

/// Told what is about to be measured.
using PeerProgress = std::function<void(const std::string& words)>;

/// Where a setting is out of time on a row, the more accurate ones are not tried there. The points
/// refer to the cases and peers, which must stay.
std::vector<PeerSolve> measure(const std::vector<Case>& cases, const std::vector<Peer>& peers,
                               const Budget& budget, const PeerProgress& progress);

}  // namespace vcrit::simulators
