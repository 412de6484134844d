// Design questions: the smallest amplitude or frequency, or the largest load or speed, that reaches
// a wanted friction ratio. The simulator says what the ratio is; Eq. 24 only tells where to ask:
// above v* and the creep friction is full.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/numbers.hpp"
#include "base/units.hpp"
#include "problem/problem.hpp"
#include "simulation/system/effort.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::design {

enum class Sought { amplitude, frequency, force, velocity };

// The overload below hides none of the others.
using vcrit::to_text;
const char* to_text(Sought sought);  ///< "amplitude", "frequency", "force", "velocity"
const char* unit_of(Sought sought);  ///< "m", "Hz", "N", "m/s"
Dimension dimension_of(Sought sought);
/// Whether the largest value that reaches the ratio is the answer, as friction rises with it.
bool is_largest(Sought sought);
inline constexpr std::array all_sought{Sought::amplitude, Sought::frequency, Sought::force,
                                       Sought::velocity};

/// What is narrower than a part in 400 of the range is missed; a simulation takes some 0.1 ms.
/// Below an indenter, where one takes some 10 ms to a second, a part in 32.
inline constexpr int usual_samples = 400, usual_samples_below_indenter = 32;
/// Some seconds, of which what a sample costs besides the work that is counted takes the most.
inline constexpr int most_samples = 100'000;

struct DesignQuestion {
  Problem problem;  ///< its value of what is sought is not used, but for the range of frequencies
  Sought sought = Sought::amplitude;
  double friction_ratio = 0;       ///< wanted: mu_macro/mu0 at most this, in (0, 1)
  double velocity = 0;             ///< of the drive, m/s; not for Sought::velocity
  std::optional<double> from, to;  ///< the range to search, in unit_of(sought); none: all that is
                                   ///< admissible, for frequencies two decades to each side
  std::optional<int> samples{};    ///< of the range, 3 to most_samples; none: the usual ones
  /// Of all steady states together; none: effort_of_answer, below an indenter effort_of_cells.
  std::optional<std::size_t> effort{};
};

int samples_of(const DesignQuestion& question);

struct DesignAnswer {
  double value = 0;  ///< in unit_of(sought): reaches the wanted ratio
  double value_error =
      0;                  ///< estimate: by this much less (of a load or speed: more) may do as well
  bool at_start = false;  ///< the range begins with it: what lies before was not searched
  double velocity = 0;    ///< of the drive, m/s
  double critical_velocity = 0;  ///< v* there, m/s
  simulation::SteadyState state;
  double largest_amplitude = 0;             ///< m, at this frequency
  std::optional<double> largest_frequency;  ///< Hz, at this amplitude; nothing without a bound
  double from = 0, to = 0;                  ///< what was searched, in unit_of(sought)
  int samples = 0;                          ///< as asked for; below an indenter, of all the range
  /// Whether friction never falls along the range, so that nothing between its samples is missed.
  bool monotonic = false;
  int evaluations = 0;  ///< steady states that were asked for
  int unanswered = 0;   ///< of them, without an answer
};

/// Throws InputError for a wrong question, ModelError outside the model and where nothing in the
/// range reaches the ratio: it says why, and what would.
DesignAnswer solve(const DesignQuestion& question);

}  // namespace vcrit::design
