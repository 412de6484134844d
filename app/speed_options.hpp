// --velocity and --velocity-ratio: the speed of the drive that a command asks about.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "problem/problem.hpp"

namespace vcrit::app {

struct Speed {
  double velocity = 0;  ///< of the drive, m/s
  double ratio = 0;     ///< the same in units of v*
  double critical = 0;  ///< v*, m/s
};

class SpeedOptions {
 public:
  /// One of the two has to be given, unless there is a usual ratio.
  void add_to(CLI::App& command, std::optional<double> usual_ratio = {});

  /// Throws InputError for a speed that is not finite and above 0, ModelError for a ratio where v*
  /// is infinite.
  Speed of(const Problem& problem) const;

  /// The option that was given, or nothing.
  std::string given() const;

 private:
  std::string velocity_;
  std::string ratio_;
  CLI::Option* of_ratio_ = nullptr;
};

}  // namespace vcrit::app
