// Numbers with units, in every dimension. What is accepted is finite, reads back from its own
// print, and belongs to one dimension only unless it is a plain number or an angle, which is one.
#include <array>
#include <cmath>

#include "base/numbers.hpp"
#include "base/units.hpp"
#include "fuzz.hpp"

using namespace vcrit;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array dimensions{
      Dimension::none,     Dimension::stiffness, Dimension::damping,
      Dimension::time,     Dimension::mass,      Dimension::length,
      Dimension::velocity, Dimension::frequency, Dimension::angular_frequency};
  const std::string text = fuzz::text_of(data, size);
  std::size_t accepted = 0;
  for (const Dimension dimension : dimensions)
    fuzz::answered([&] {
      const double value = parse_quantity(text, dimension, {"scene.toml", 1, 1});
      ++accepted;
      fuzz::check(std::isfinite(value), "a quantity is finite");
      fuzz::check(parse_quantity(to_text(value), dimension, {}) == value, "a number reads back");
    });
  fuzz::check(
      accepted <= 1 || to_double(text.substr(0, text.find_last_not_of(" \t") + 1)
                                     .substr(std::min(text.find_first_not_of(" \t"), text.size()))),
      "a unit is one of one dimension");
  return 0;
}
