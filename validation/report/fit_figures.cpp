#include "report/fit_figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/rounded.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
using figures::FigureSeries;
using figures::Style;

constexpr int points_of_line = 300;  // smooth to the eye

enum Colour { storage_colour = 0, loss_colour = 1 };

/// One unit for all stiffnesses of a page, that of the largest storage.
UnitScale stiffness_scale(const StiffnessTable& data) {
  double largest = 0;
  for (const StiffnessRow& row : data.rows) largest = std::max(largest, row.storage);
  return scale_for(largest, "N/m");
}

FigureSeries measured_series(const StiffnessTable& data, const char* name,
                             double StiffnessRow::*part, int colour, double unit) {
  FigureSeries series{name, Style::circles, {}, colour};
  for (const StiffnessRow& row : data.rows)
    if (row.*part > 0) series.points.push_back({row.omega / two_pi, unit * row.*part, ""});
  return series;
}

FigureSeries fitted_series(const StiffnessTable& data, const Relaxation& form, const char* name,
                           bool storage, double unit) {
  FigureSeries series{name, Style::line, {}, storage ? storage_colour : loss_colour};
  const double from = data.rows.front().omega, to = data.rows.back().omega;
  for (int i = 0; i <= points_of_line; ++i) {
    const double omega = from * std::pow(to / from, static_cast<double>(i) / points_of_line);
    const std::complex<double> k = dynamic_stiffness(form, omega);
    series.points.push_back({omega / two_pi, unit * (storage ? k.real() : k.imag()), ""});
  }
  return series;
}

Figure stiffness(const StiffnessTable& data, const fit::Fit& fit) {
  Figure figure;
  figure.name = "stiffness";
  figure.title = "Storage and loss stiffness, measured and fitted";
  figure.caption = "Circles: measured. Lines: the series.";
  figure.x = {"frequency, Hz", true, {}, {}};
  const auto [unit, name] = stiffness_scale(data);
  figure.y = {"stiffness, " + name, true, {}, {}};
  figure.series = {fitted_series(data, fit.series, "storage", true, unit),
                   fitted_series(data, fit.series, "loss", false, unit),
                   measured_series(data, "storage", &StiffnessRow::storage, storage_colour, unit),
                   measured_series(data, "loss", &StiffnessRow::loss, loss_colour, unit)};
  return figure;
}

// What the fit weighed it by: the given error, else one per cent of |K|.
double unit_of(const StiffnessRow& row, bool errors, bool storage) {
  if (errors) return storage ? row.storage_error : row.loss_error;
  return std::hypot(row.storage, row.loss) / 100;
}

FigureSeries left(const StiffnessTable& data, const fit::Fit& fit, bool storage) {
  FigureSeries series{storage ? "storage" : "loss",
                      storage ? Style::circles : Style::crosses,
                      {},
                      storage ? storage_colour : loss_colour};
  for (const StiffnessRow& row : data.rows) {
    const std::complex<double> difference =
        std::complex<double>(row.storage, row.loss) - dynamic_stiffness(fit.series, row.omega);
    const double part = storage ? difference.real() : difference.imag();
    series.points.push_back(
        {row.omega / two_pi, part / unit_of(row, data.has_errors, storage), ""});
  }
  return series;
}

Figure residuals(const StiffnessTable& data, const fit::Fit& fit) {
  Figure figure;
  figure.name = "residuals";
  figure.title = "Residuals";
  figure.caption =
      data.has_errors
          ? "Measured less fitted, in units of the standard deviations that the data give. Two "
            "thirds of all should lie between -1 and 1, without a pattern."
          : "Measured less fitted, in per cent of |K|. A pattern would be something that the "
            "series "
            "does not have; without one they are noise.";
  figure.x = {"frequency, Hz", true, {}, {}};
  figure.y = {data.has_errors ? "residual, standard deviations" : "residual, %", false, {}, {}};
  figure.series = {left(data, fit, true), left(data, fit, false)};
  figure.rules = {{0, "", true}};
  figure.height = 220;
  return figure;
}

Figure spectrum(const StiffnessTable& data, const fit::Fit& fit) {
  Figure figure;
  figure.name = "branches";
  figure.title = "Relaxation spectrum";
  figure.caption =
      "Stiffness and relaxation time of each branch, with bars of one standard deviation each way. "
      "Shaded: the inverse of the measured angular frequencies.";
  figure.x = {"relaxation time, s", true, {}, {}};
  const auto [unit, name] = stiffness_scale(data);
  figure.y = {"stiffness, " + name, true, {}, {}};
  FigureSeries dots{"", Style::dots, {}, storage_colour};
  for (const fit::FittedBranch& branch : fit.branches) {
    const auto& [k, tau] = branch;
    const double height = unit * k.value;
    dots.points.push_back({tau.value, height,
                           fmt::format("k = {} ± {}, τ = {} ± {}", rounded(k.value, "N/m"),
                                       rounded(k.error, "N/m", 2), rounded(tau.value, "s"),
                                       rounded(tau.error, "s", 2))});
    const double up = 1 + k.error / k.value, aside = 1 + tau.error / tau.value;
    figure.series.push_back({"",
                             Style::line,
                             {{tau.value, height / up, ""}, {tau.value, height * up, ""}},
                             storage_colour});
    figure.series.push_back({"",
                             Style::line,
                             {{tau.value / aside, height, ""}, {tau.value * aside, height, ""}},
                             storage_colour});
  }
  figure.series.push_back(std::move(dots));
  const double first = 1 / data.rows.back().omega, last = 1 / data.rows.front().omega;
  figure.x.range = {std::min(first, fit.branches.front().time.value) / 2,
                    2 * std::max(last, fit.branches.back().time.value)};
  figure.bands = {{first, last, "measured"}};
  figure.height = 260;
  return figure;
}

}  // namespace

std::vector<figures::Figure> fit_figures(const StiffnessTable& data, const fit::Fit& fit) {
  std::vector<Figure> list{stiffness(data, fit), residuals(data, fit)};
  if (!fit.branches.empty()) list.push_back(spectrum(data, fit));
  return list;
}

}  // namespace vcrit::validation::report
