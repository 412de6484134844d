// A figure as a Vega-Lite specification, data included.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "figures/figure.hpp"

namespace vcrit::validation::figures {

/// Fills the width of its container. Numbers have seven digits: enough for a picture. A map's data
/// are its edges and values, {"grid": {"x", "y", "v"}}, of which page.js makes a row for each cell:
/// Vega-Lite's rows would be seven times as long.
nlohmann::ordered_json vega_lite(const Figure& given);

}  // namespace vcrit::validation::figures
