#include "scene/measured_contact.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <set>

#include "scene/measured_table.hpp"
#include "scene/quantities.hpp"

namespace vcrit {

namespace {

constexpr const char* rest_key = "static_stiffness";

const char* table_key(MeasuredSide side) {
  return side == MeasuredSide::normal ? "dynamic_stiffness" : "tangential_dynamic_stiffness";
}

std::optional<TypedNumber> given_rest(const document::Section& contact) {
  const toml::node* node = contact.find(rest_key);
  if (node == nullptr) return std::nullopt;
  const auto given = number(*node, Dimension::stiffness, rest_key, contact.place(rest_key));
  if (given) checked(*given, positive, rest_key, contact.place(rest_key));
  return given;
}

}  // namespace

bool has_measured(const document::Section& contact, MeasuredSide side) {
  return contact.find(table_key(side)) != nullptr;
}

Network read_measured_contact(const document::Section& contact, MeasuredSide side, Scene& scene,
                              Networks& networks, std::vector<Warning>& warnings) {
  const char* const key = table_key(side);
  const Place place = contact.place(key);
  const bool normal = side == MeasuredSide::normal;
  if (normal && contact.find("normal") != nullptr)
    throw InputError(place, "normal and dynamic_stiffness", "one of the two in [contact]");
  const std::filesystem::path folder = std::filesystem::path(scene.file).parent_path();
  MeasuredStiffness measured{{normal ? "k_n" : "k_t"},
                             {normal ? "eta_n" : "eta_t"},
                             {normal ? "k_n0" : ""},
                             read_measured_stiffness(folder / contact.text(key), place, warnings)};
  Element element{ElementKind::measured, measured.storage, measured.loss_factor};
  std::map<Symbol, TypedNumber> numbers;
  if (normal) {
    element.rest = measured.rest;
    if (const auto rest = given_rest(contact)) numbers[measured.rest] = *rest;
  }
  const std::set<std::string> tabulated{measured.storage.name, measured.loss_factor.name};
  for (const std::string& name : tabulated) scene.tabulated[name] = contact.text(key);
  scene.measured.push_back(std::move(measured));
  return networks.given({element}, numbers, tabulated, place);
}

void refuse_static_stiffness(const document::Section& contact) {
  if (contact.find(rest_key) != nullptr)
    throw InputError(contact.place(rest_key), fmt::format("{} without dynamic_stiffness", rest_key),
                     "dynamic_stiffness = \"TABLE.csv\", which it is of; a network has its own");
}

}  // namespace vcrit
