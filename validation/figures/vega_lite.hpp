// A figure as a Vega-Lite specification, data included.
#pragma once

#include <nlohmann/json.hpp>

#include "figures/figure.hpp"

namespace vcrit::validation::figures {

/// Fills the width of its container. Numbers have seven digits: enough for a picture.
nlohmann::ordered_json vega_lite(const Figure& figure);

}  // namespace vcrit::validation::figures
