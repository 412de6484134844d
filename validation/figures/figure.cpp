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
    case Style::bars:
      return "bars";
  }
  throw Bug("a style without a name");
}

const char* palette(int colour) {
  static constexpr std::array colours{"#2090ad", "#d07a28", "#8a8f98", "#7a6bc4",
                                      "#3f9a5f", "#c8527a", "#a08a1f", "#5a7fd0"};
  return colours.at(static_cast<std::size_t>(colour) % colours.size());
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
