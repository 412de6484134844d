// A network for peers in other languages.
#pragma once

#include <nlohmann/json.hpp>

#include "network/network.hpp"

namespace vcrit::bench {

/// Its reduction, one array a step, which refers to earlier steps by their numbers: ["spring",
/// "k"],
/// ["damper", "c"], ["maxwell", "k", "tau"], ["parallel", a, b], ["series", a, b],
/// ["mesh", a, b, total].
nlohmann::ordered_json network_json(const Network& network);

}  // namespace vcrit::bench
