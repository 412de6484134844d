// What every report.json is made of. Keys: docs/report.md.
#pragma once

#include <nlohmann/json.hpp>
#include <type_traits>

#include "figures/figure.hpp"
#include "report/machine_section.hpp"
#include "scene_report.hpp"

namespace vcrit::validation::report {

nlohmann::ordered_json json(const Comparison& comparison);
nlohmann::ordered_json json(const Formula& formula);
nlohmann::ordered_json json(const figures::Figure& figure);
nlohmann::ordered_json json(const Machine& machine);
nlohmann::ordered_json numbers(const std::vector<double>& values);

/// An array of what `write` makes of each item.
template <class Item>
nlohmann::ordered_json json_list(
    const std::vector<Item>& items,
    nlohmann::ordered_json (*write)(const std::type_identity_t<Item>&)) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const Item& item : items) array.push_back(write(item));
  return array;
}

/// `program`, `version`, `passed`, `command`, `machine`.
nlohmann::ordered_json report_head(const Origin& origin, bool passed);

/// As the file has it.
std::string text_of(const nlohmann::ordered_json& report);

}  // namespace vcrit::validation::report
