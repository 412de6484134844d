// The pictures of a scene's accuracy, cost and stability.
#pragma once

#include <vector>

#include "accuracy/data.hpp"
#include "figures/figure.hpp"

namespace vcrit::validation::accuracy {

/// Where an error of 0 stands on a logarithmic axis.
inline constexpr double no_error = 1e-17;

/// Worst error over time a value; the Pareto front is joined.
figures::Figure evaluator_picture(const EvaluatorErrors& errors);

/// How many sets have an error of so many units in the last place. Ways that answer as others do
/// are left out.
figures::Figure histogram_picture(const EvaluatorErrors& errors);

/// Error over time of the methods at one speed.
figures::Figure simulator_picture(const SpeedSolves& speed);

/// What all layers of a map show, for whoever sees them.
std::string about_maps(const StabilityMap& map);

/// One layer of a map, with its marks and the lines of the map.
figures::Figure map_picture(const StabilityMap& map, const Layer& layer);

/// All of them.
std::vector<figures::Figure> pictures(const Accuracy& accuracy);

}  // namespace vcrit::validation::accuracy
