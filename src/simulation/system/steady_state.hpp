// What a simulation of steady motion answers, whatever its method.
#pragma once

#include <optional>
#include <vector>

#include "base/numbers.hpp"

namespace vcrit::simulation {

enum class Start { sliding, rest };
enum class Motion { slip, stick, backslip, separated };
enum class Regime {
  sliding,
  stick_slip,
  stick_slip_backslip,
  stick,
  sliding_separated,  ///< and the contact opens once in a while
  stick_slip_separated,
  stick_slip_backslip_separated
};

// The overloads below hide none of the others.
using vcrit::to_text;
const char* to_text(Motion motion);  ///< "slip", "stick", "backslip", "apart"
/// "sliding", "stick-slip", "stick-slip-backslip", "stick", and all but the last with "-apart".
const char* to_text(Regime regime);

struct Event {
  double phase = 0;  ///< omega t in [0, 2 pi)
  Motion to = Motion::slip;
};

/// The motion at one instant of the steady cycle.
struct CyclePoint {
  double phase = 0;             ///< rad
  double contact_velocity = 0;  ///< m/s, of the surface also while open
  double force = 0;             ///< N, of the contact network on the contact point
  double friction_bound = 0;    ///< mu0 F_n, N
};

/// What the search leads to from the other start: the same friction, or one of the two has stopped
/// short of the steady state.
struct OtherStart {
  double friction_ratio = 0, friction_ratio_error = 0;
  Regime regime = Regime::sliding;
  bool agrees = true;  ///< within the errors of both searches
};

struct SteadyState {
  double friction_ratio = 0;        ///< mu_macro/mu0 = <F>/(mu0 <F_n>)
  double friction_ratio_error = 0;  ///< estimate of its absolute error, of both starts if two ran
  Regime regime = Regime::sliding;
  std::optional<int> periods;     ///< length of the steady cycle in oscillation periods
  std::vector<Event> events;      ///< of one cycle, by time
  std::vector<CyclePoint> cycle;  ///< `samples` points over one oscillation period
  std::optional<OtherStart> other_start = {};  ///< of a contact that opens, by the exact method
};

/// Throws InputError unless the mean velocity of the drive, m/s, is above 0 and finite.
void require_forward(double velocity);

}  // namespace vcrit::simulation
