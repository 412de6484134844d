#include "scene/indenter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

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

}  // namespace

Indenter read_indenter(const document::Section& section, const std::filesystem::path& folder,
                       Quantities& quantities) {
  const std::string name = section.text("shape");
  const Form& form = form_named(name);
  std::vector<std::string> keys{"shape"};
  for (const Size& size : form.sizes) keys.emplace_back(size.key);
  for (const char* key : indenter_keys)
    if (section.find(key) != nullptr && std::find(keys.begin(), keys.end(), key) == keys.end())
      throw InputError(section.place(key), fmt::format("{} beside shape = \"{}\"", key, name),
                       fmt::format("for {} no keys but {}", form.name, fmt::join(keys, ", ")));
  Indenter indenter{form.shape, {}, {}};
  for (const Size& size : form.sizes)
    indenter.sizes.push_back(
        quantities.read(section, size.key, size.key, size.dimension, *size.range));
  if (form.shape == Shape::table)
    indenter.profile = read_profile(folder / name, section.place("shape"));
  return indenter;
}

}  // namespace vcrit
