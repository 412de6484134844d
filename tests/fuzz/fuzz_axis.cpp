// Axes of a sweep: the text of --over, and behind a first line "list" the text of a list's file.
// What is accepted has finite values, as many as asked for.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "fuzz.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"
#include "sweep/axis.hpp"

using namespace vcrit;

namespace {

const test::SceneText scene_text{.normal = "k0 | c0",
                                 .frequency = "20 kHz",
                                 .amplitude = 1e-7,
                                 .indentation = 1e-6,
                                 .coefficient = 0.3,
                                 .elements = {{"k0", 1e6}, {"c0", 10}}};

// Long axes take long and show nothing that short ones do not.
bool long_axis(const std::string& text) {
  const auto colon = text.find_last_of(':');
  return colon != text.npos && text.size() > colon + 4;
}

void check_values(const std::vector<double>& values) {
  fuzz::check(!values.empty(), "an axis has a value");
  fuzz::check(std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }),
              "values are finite");
}

}  // namespace

void fuzz::read_axis(const std::string& text) {
  static const Scene scene = test::scene_of(scene_text);
  const std::string list = "list\n";
  fuzz::answered([&] {
    if (text.starts_with(list))
      return check_values(parse_list(text.substr(list.size()), "list.txt", Dimension::stiffness));
    if (text.find("list:") != text.npos || long_axis(text)) return;
    const Axis axis = parse_axis(text, scene);
    check_values(axis.values);
    std::size_t asked = 0;
    std::from_chars(text.data() + text.find_last_of(':') + 1, text.data() + text.size(), asked);
    fuzz::check(axis.values.size() == asked, "an axis has as many values as asked for");
    if (asked < 2) return;
    const auto [low, high] = std::minmax(axis.values.front(), axis.values.back());
    for (const double value : axis.values)
      fuzz::check(value >= low && value <= high, "values lie between the ends");
  });
}
