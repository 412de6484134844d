#include "accuracy/decades.hpp"

#include <algorithm>
#include <cmath>

namespace vcrit::validation::accuracy {

namespace {

constexpr int most_ticks = 8;

struct Range {
  double least = HUGE_VAL, greatest = 0;
  void include(double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
};

/// So that no point is cut at the edge.
figures::Axis with_room(figures::Axis axis, const Range& range) {
  axis.range = {range.least / 2, range.greatest * 2};
  return axis;
}

}  // namespace

std::string power_of_ten(int exponent) {
  if (exponent == 0) return "1";
  if (exponent == 1) return "10";
  static const char* const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += raised[digit - '0'];
  return text;
}

figures::Axis decades(std::string title, double least, double greatest) {
  const int first = static_cast<int>(std::floor(std::log10(least)));
  const int last = static_cast<int>(std::ceil(std::log10(greatest)));
  const int step = std::max(1, (last - first + most_ticks - 1) / most_ticks);
  figures::Axis axis{std::move(title), true, {}, {}};
  for (int exponent = first; exponent <= last; ++exponent)
    if (exponent % step == 0)
      axis.ticks.emplace_back(std::pow(10, exponent), power_of_ten(exponent));
  return axis;
}

void set_decades(figures::Figure& figure) {
  Range x, y;
  for (const figures::Series& series : figure.series)
    for (const figures::Point& point : series.points) {
      x.include(point.x);
      y.include(point.y);
    }
  if (x.greatest == 0 || y.greatest == 0) return;
  figure.x = with_room(decades(figure.x.title, x.least, x.greatest), x);
  figure.y = with_room(decades(figure.y.title, y.least, y.greatest), y);
}

}  // namespace vcrit::validation::accuracy
