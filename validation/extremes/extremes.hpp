// All families at all their extremes.
#pragma once

#include "extremes/contents.hpp"
#include "extremes/examine.hpp"
#include "run/workers.hpp"

namespace vcrit::validation::extremes {

/// Side by side, as many as there are cores; `watch` is told of each step. Half a minute on two
/// cores, most of it compiling. Throws std::runtime_error when a generated evaluator does not
/// compile.
Extremes go_to_extremes(const Watch& watch);

}  // namespace vcrit::validation::extremes
