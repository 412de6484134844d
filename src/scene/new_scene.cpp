#include "scene/new_scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "base/errors.hpp"
#include "base/joined.hpp"
#include "network/catalogue.hpp"
#include "network/law.hpp"

namespace vcrit {

namespace {

constexpr int branches_shown = 3;  // of arrays, as in the catalogue

using ArgumentNames = std::vector<std::string>;

ArgumentNames argument_names(const Rheology& rheology, const char* suffix = "") {
  ArgumentNames names;
  for (const auto& [name, kind] : rheology.arguments) names.push_back(name + suffix);
  return names;
}

Network network_of(const Rheology& rheology, const ArgumentNames& names) {
  return rheology.build(names, rheology.has_arrays() ? branches_shown : 0);
}

const Rheology& rheology_of_part(const std::string& name, const char* argument_name) {
  for (const Rheology& rheology : catalogue())
    if (rheology.goes_by(name) && !rheology.in_drives_only()) return rheology;
  throw InputError(argument(argument_name), fmt::format("\"{}\"", name),
                   fmt::format("one of {}", joined(rheologies_of_parts(), ", ")));
}

// Typical of a polymer pad of a square millimetre under ultrasound; the n-th of a network.
struct TypicalNumbers {
  NumberRole role;
  std::array<const char*, 4> values;
  const char* words;
};
constexpr std::array<TypicalNumbers, 5> typical_numbers{
    {{NumberRole::stiffness,
      {"8 N/um", "4 N/um", "2 N/um", "1 N/um"},
      "force over displacement: static test, or DMA (vcrit fit)"},
     {NumberRole::damping,
      {"30 N.s/m", "20 N.s/m", "10 N.s/m", "5 N.s/m"},
      "DMA (vcrit fit): loss stiffness/(2 pi f) in parallel"},
     {NumberRole::time,
      {"100 us", "10 us", "1 us", "0.1 us"},
      "one over the angular frequency of a loss peak: DMA"},
     {NumberRole::mass, {"5 g", "2 g", "1 g", "1 g"}, "scales"},
     {NumberRole::factor,
      {"0.1", "0.1", "0.1", "0.1"},
      "tan delta at the frequency: DMA, or the data sheet"}}};

const TypicalNumbers& typical(NumberRole role) {
  const auto found = std::find_if(typical_numbers.begin(), typical_numbers.end(),
                                  [role](const TypicalNumbers& each) { return each.role == role; });
  // What is left is the loss factor of a lossy spring.
  return found == typical_numbers.end() ? typical_numbers.back() : *found;
}

std::map<std::string, NumberRole> roles_of(const Network& network) {
  std::map<std::string, NumberRole> roles;
  for_each_element(network, [&](const Element& element) {
    for_each_number(
        element, [&](const Symbol& symbol, NumberRole role) { roles.emplace(symbol.name, role); });
  });
  return roles;
}

/// One line of the file.
std::string to_fill(const std::string& key, const std::vector<std::string>& typical_values,
                    const std::string& words, bool is_array = false) {
  const std::vector<std::string> marks(typical_values.size(),
                                       fmt::format("\"{}\"", to_be_filled_in));
  const std::string value = joined(marks, ", ");
  return fmt::format("{:<22}# e.g. \"{}\": {}\n",
                     fmt::format("{} = {}", key, is_array ? "[" + value + "]" : value),
                     joined(typical_values, "\", \""), words);
}

std::string elements_of(const Rheology& rheology, const char* suffix) {
  std::string text;
  const ArgumentNames names = argument_names(rheology, suffix);
  const auto roles = roles_of(network_of(rheology, names));
  std::map<NumberRole, std::size_t> used;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const NumberRole role = roles.at(names[i]);
    const TypicalNumbers& row = typical(role);
    const bool is_array = rheology.arguments[i].second == Rheology::Argument::array;
    std::vector<std::string> values;
    for (int j = 0; j < (is_array ? branches_shown : 1); ++j)
      values.emplace_back(row.values.at(std::min(used[role]++, row.values.size() - 1)));
    text += to_fill(names[i], values, row.words, is_array);
  }
  return text;
}

std::string call(const Rheology& rheology, const std::string& name, const char* suffix) {
  return fmt::format("\"{}({})\"", name, joined(argument_names(rheology, suffix), ", "));
}

std::string comment(const std::string& words) {
  constexpr std::size_t widest = 98;
  std::string text, line = "#";
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    if (line.size() + 1 + end - begin > widest) text += std::exchange(line, "#") + "\n";
    line += " " + words.substr(begin, end - begin);
    begin = end + 1;
  }
  return text + line + "\n";
}

std::string contact_section(const NewScene& scene, const Rheology& rheology) {
  return "[contact]\n" + comment(rheology.called + ". " + rheology.meaning) +
         fmt::format("normal = {}\n", call(rheology, scene.rheology, "")) +
         to_fill("poisson", {"0.3"}, "of the softer body, data sheet: metals 0.3, rubber 0.49") +
         (scene.may_open ? "separation = true     # the contact may open in each cycle\n" : "");
}

std::string drive_sections(const NewScene& scene) {
  if (!scene.drive)
    return "# No [drive]: a rigid drive, whose speed is that of the contact.\n"
           "\n# Where a tip's radius and moduli are known, not stiffnesses, remove the # signs, "
           "and\n"
           "# give moduli (\"2.9 GPa\") and viscosities (\"3.5 kPa.s\") to the elements below:\n"
           "# [indenter]\n# shape = \"parabola\"\n# radius = \"5 mm\"\n";
  const Rheology& rheology = rheology_of_part(*scene.drive, "drive");
  std::string text = "[drive]\n" +
                     comment(fmt::format("Between the {} and the end that moves: {}.",
                                         scene.has_body ? "body" : "contact", rheology.called)) +
                     fmt::format("network = {}\n", call(rheology, *scene.drive, "d"));
  if (scene.has_body)
    text += "\n[body]\n" + to_fill("mass", {"5 g"}, "what moves between contact and drive: scales");
  return text;
}

std::string other_sections() {
  return "[oscillation]\n" + to_fill("frequency", {"20 kHz"}, "data sheet of the transducer") +
         to_fill("amplitude", {"0.1 um"}, "half of peak to peak: vibrometer, or the data sheet") +
         to_fill("indentation", {"0.5 um"}, "mean: static force over static stiffness") +
         "\n# Where the static force is known, leave the indentation out and remove the # signs:\n"
         "# [load]\n# force = \"50 N\"\n"
         "\n[friction]\n" +
         to_fill("coefficient", {"0.3"},
                 "friction over normal force without vibration: tribometer");
}

}  // namespace

std::vector<std::string> rheologies_of_parts() {
  std::vector<std::string> names;
  for (const Rheology& rheology : catalogue()) {
    if (rheology.in_drives_only()) continue;
    names.push_back(rheology.name);
    names.insert(names.end(), rheology.also.begin(), rheology.also.end());
  }
  return names;
}

std::string new_scene_text(const NewScene& scene) {
  const Rheology& rheology = rheology_of_part(scene.rheology, "rheology");
  if (scene.has_body && !scene.drive)
    throw InputError(argument("mass"), "a body under a rigid drive", "a drive that gives",
                     "a rigid drive moves the body uniformly, so that its mass has no effect: add "
                     "`drive spring`");
  std::string text = comment(fmt::format("{} under {}{}. Replace each {} by a value with its unit, "
                                         "then: vcrit check FILE",
                                         rheology.called,
                                         scene.drive ? "a drive " + *scene.drive : "a rigid drive",
                                         scene.has_body ? ", with a body" : "", to_be_filled_in)) +
                     fmt::format("title = \"{}\"\n\n", rheology.called) +
                     contact_section(scene, rheology) + "\n" + drive_sections(scene) + "\n" +
                     other_sections() + "\n[elements]\n" + elements_of(rheology, "");
  if (scene.drive) text += elements_of(rheology_of_part(*scene.drive, "drive"), "d");
  return text;
}

std::size_t numbers_to_fill_in(const std::string& text) {
  const std::string mark = fmt::format("\"{}\"", to_be_filled_in);
  std::size_t number = 0;
  for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + 1)) ++number;
  return number;
}

}  // namespace vcrit
