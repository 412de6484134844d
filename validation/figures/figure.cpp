#include "figures/figure.hpp"

#include <array>
#include <cmath>

#include "base/errors.hpp"

namespace vcrit::validation::figures {

const char* name_of(Style style) {
  switch (style) {
    case Style::line:
      return "line";
    case Style::dashed:
      return "dashed";
    case Style::dotted:
      return "dotted";
    case Style::circles:
      return "circles";
    case Style::dots:
      return "dots";
    case Style::crosses:
      return "crosses";
    case Style::squares:
      return "squares";
    case Style::triangles:
      return "triangles";
    case Style::diamonds:
      return "diamonds";
    case Style::bars:
      return "bars";
  }
  throw Bug("a style without a name");
}

bool is_marks(Style style) {
  switch (style) {
    case Style::circles:
    case Style::dots:
    case Style::crosses:
    case Style::squares:
    case Style::triangles:
    case Style::diamonds:
      return true;
    case Style::line:
    case Style::dashed:
    case Style::dotted:
    case Style::bars:
      return false;
  }
  throw Bug("a style that is neither points nor a line");
}

Style shape_of(std::size_t number) {
  static constexpr std::array shapes{Style::circles,  Style::squares, Style::triangles,
                                     Style::diamonds, Style::dots,    Style::crosses};
  return shapes.at(number % shapes.size());
}

const char* palette(int colour) {
  static constexpr std::array colours{"#123f6d", "#b3380a", "#6b7280", "#0e8a7d",
                                      "#9a6bd1", "#b3261e", "#1d2126", "#8a5a00"};
  return colours.at(static_cast<std::size_t>(colour) % colours.size());
}

const char* class_colour(int number) { return number == 2 ? "#dfe2e6" : palette(number); }

const char* dashes_of(Style style, int colour) {
  static constexpr std::array lines{"none", "6 3", "4 4", "2 3", "8 3 2 3", "4 2", "10 3", "1 3"};
  if (style == Style::dashed) return "6 4";
  if (style == Style::dotted) return "2 3";
  return lines.at(static_cast<std::size_t>(colour) % lines.size());
}

std::vector<double> edges(const std::vector<double>& middles, bool logarithmic) {
  const auto between = [&](double a, double b) {
    return logarithmic ? std::sqrt(a) * std::sqrt(b) : a + (b - a) / 2;
  };
  const auto beyond = [&](double inner, double outer) {
    return logarithmic ? outer * (outer / inner) : 2 * outer - inner;
  };
  std::vector<double> result;
  for (std::size_t i = 1; i < middles.size(); ++i)
    result.push_back(between(middles[i - 1], middles[i]));
  const double first = beyond(result.front(), middles.front());
  const double last = beyond(result.back(), middles.back());
  result.insert(result.begin(), first);
  result.push_back(last);
  return result;
}

FigureAxis cells_axis(const std::string& title, const std::vector<double>& middles) {
  const std::vector<double> ends = edges(middles, true);
  return {title, true, std::pair{ends.front(), ends.back()}, {}};
}

}  // namespace vcrit::validation::figures
