// Comparisons of extremes in few words.
#pragma once

#include <string>

#include "compare/scene_report.hpp"

namespace vcrit::validation::extremes {

struct Words {
  std::string key, name, reference, reason;
};

/// How often (or how far, over what is allowed) something happened, which may reach `most`.
Comparison at_most(const Words& words, double found, double most, const std::string& detail);

/// Two velocities, m/s.
Comparison relative(const Words& words, double expected, double found, double tolerance,
                    const std::string& detail);

/// The one nearest to its tolerance; broken where there are none.
Comparison worst(const Words& words, const std::vector<Comparison>& all);

Comparison not_compared(const Words& words, const std::string& why);

}  // namespace vcrit::validation::extremes
