#include "figures/drawn.hpp"

#include <cmath>

namespace vcrit::validation::figures {

FigureScales scales_of(const Figure& figure, int x_ticks, int y_ticks) {
  std::vector<double> x, y;
  for (const FigureSeries& series : figure.series)
    for (const Point& point : series.points) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
      x.push_back(point.x);
      y.push_back(point.y);
    }
  for (const Rule& rule : figure.rules) (rule.horizontal ? y : x).push_back(rule.at);
  for (const Band& band : figure.bands) x.insert(x.end(), {band.from, band.to});
  return {{figure.x, x, x_ticks}, {figure.y, y, y_ticks}};
}

}  // namespace vcrit::validation::figures
