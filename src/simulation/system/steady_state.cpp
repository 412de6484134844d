#include "simulation/system/steady_state.hpp"

#include "base/errors.hpp"
#include "base/speeds.hpp"

namespace vcrit::simulation {

const char* to_text(Motion motion) {
  switch (motion) {
    case Motion::slip:
      return "slip";
    case Motion::stick:
      return "stick";
    case Motion::backslip:
      return "backslip";
    case Motion::separated:
      return "apart";
  }
  throw Bug("a motion is slip, stick, backslip or separated");
}

const char* to_text(Regime regime) {
  switch (regime) {
    case Regime::sliding:
      return "sliding";
    case Regime::stick_slip:
      return "stick-slip";
    case Regime::stick_slip_backslip:
      return "stick-slip-backslip";
    case Regime::stick:
      return "stick";
    case Regime::sliding_separated:
      return "sliding-apart";
    case Regime::stick_slip_separated:
      return "stick-slip-apart";
    case Regime::stick_slip_backslip_separated:
      return "stick-slip-backslip-apart";
  }
  throw Bug("a regime is one of seven");
}

void require_forward(double velocity) { check_speed(velocity, {"velocity"}); }

}  // namespace vcrit::simulation
