#include "scene/realisation_keys.hpp"

#include <fmt/core.h>

#include "scene/quantities.hpp"

namespace vcrit {

void read_realisation_keys(const document::Section& drive, Receptance& receptance) {
  if (const toml::node* node = drive.find("static_compliance")) {
    const Place place = drive.place("static_compliance");
    const auto given = number(*node, Dimension::compliance, "static_compliance", place);
    if (!given)
      throw InputError(place, document::describe_node(*node), "a compliance: \"0.08 um/N\"");
    receptance.static_compliance = checked(*given, positive, "static_compliance", place);
  }
  if (const toml::node* node = drive.find("order")) {
    const auto given = node->value_exact<std::int64_t>();
    if (!given || *given < 0 || *given > most_order)
      throw InputError(drive.place("order"), "order = " + document::describe_node(*node),
                       fmt::format("a whole number from 0 to {}", most_order));
    receptance.order = static_cast<int>(*given);
  }
}

void refuse_realisation_keys(const document::Section& drive) {
  for (const char* key : {"static_compliance", "order"})
    if (drive.find(key) != nullptr)
      throw InputError(drive.place(key), fmt::format("{} without receptance", key),
                       "receptance = \"TABLE.csv\", which it is of; a network has its own");
}

}  // namespace vcrit
