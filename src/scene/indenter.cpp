#include "scene/indenter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/joined.hpp"
#include "scene/members.hpp"
#include "scene/section_keys.hpp"

namespace vcrit {

namespace {

using Shape = Indenter::Shape;

struct Size {
  const char* key;
  Dimension dimension;
  const Range* range;
};

struct Form {
  const char* name;
  Shape shape;
  std::vector<Size> sizes;
};

// The unit of a prefactor depends on the exponent: a number in SI.
const std::vector<Form>& forms() {
  static const std::vector<Form> all{
      {"flat", Shape::flat, {{"radius", Dimension::length, &positive}}},
      {"cone", Shape::cone, {{"angle", Dimension::angle, &slope_range}}},
      {"parabola", Shape::parabola, {{"radius", Dimension::length, &positive}}},
      {"power",
       Shape::power,
       {{"prefactor", Dimension::none, &positive}, {"exponent", Dimension::none, &positive}}},
      {"a table", Shape::table, {}}};
  return all;
}

const Form& form_named(const std::string& name) {
  const auto known = std::find_if(forms().begin(), forms().end() - 1,
                                  [&](const Form& form) { return name == form.name; });
  return *known;
}

const Form& form_by(Shape shape) {
  for (const Form& form : forms())
    if (form.shape == shape) return form;
  throw Bug("an indenter of no shape");
}

}  // namespace

Indenter read_indenter(const document::Section& section, const std::filesystem::path& folder,
                       Quantities& quantities) {
  if (section.find("shape") == nullptr)
    throw InputError(section.place("shape"), "no shape in [indenter]",
                     "shape = \"flat\", \"cone\", \"parabola\" (a sphere) or \"power\", or the "
                     "file of a profile, as \"tip.csv\"");
  const std::string name = section.text("shape");
  const Form& form = form_named(name);
  Indenter indenter{form.shape, {}, {}};
  if (form.shape == Shape::table)  // before its keys: the word may be no file, but a shape unknown
    indenter.profile = read_profile(folder / name, section.place("shape"));
  std::vector<std::string> keys{"shape"};
  for (const Size& size : form.sizes) keys.emplace_back(size.key);
  for (const std::string& key : document::keys_of("indenter"))
    if (section.find(key) != nullptr && std::find(keys.begin(), keys.end(), key) == keys.end())
      throw InputError(section.place(key), fmt::format("{} beside shape = \"{}\"", key, name),
                       fmt::format("for {} no keys but {}", form.name, joined(keys, ", ")));
  for (const Size& size : form.sizes)
    indenter.sizes.push_back(
        quantities.read(section, size.key, size.key, size.dimension, *size.range));
  return indenter;
}

void check_indenter(const Indenter& indenter, const Place& place) {
  const Form& form = form_by(indenter.shape);
  if (indenter.sizes.size() != form.sizes.size())
    throw InputError(place,
                     fmt::format("indenter {} with {} sizes", form.name, indenter.sizes.size()),
                     fmt::format("{}", form.sizes.size()));
  for (std::size_t i = 0; i < form.sizes.size(); ++i) {
    const auto& [key, dimension, range] = form.sizes[i];
    if (!indenter.sizes[i].value)
      throw InputError(place, fmt::format("no value for {} of the indenter", key), range->expected);
    checked(*indenter.sizes[i].value, *range, key, place);
  }
  if (form.shape != Shape::table) return;
  if (!indenter.profile) throw InputError(place, "an indenter by a table without profile", "one");
  check_profile(*indenter.profile, place);
}

}  // namespace vcrit
