// A figure as the record that charts.js draws in the page.
#pragma once

#include <nlohmann/json.hpp>

#include "figures/figure.hpp"

namespace vcrit::validation::figures {

/// All that a figure says, but its caption. Numbers have seven digits: enough for a picture. A
/// number that has no place on its axis is null. A point is [x, y] or [x, y, words], a tick
/// [value, words]. Of a map and of bars the record has the edges, not the middles.
nlohmann::ordered_json figure_json(const Figure& given);

}  // namespace vcrit::validation::figures
