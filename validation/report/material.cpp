#include "report/material.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
using figures::FigureAxis;
using figures::FigureSeries;
using figures::Style;

constexpr int points_of_curve = 300;
// The curves go on so far beyond the first and last time of the spectra.
constexpr double beyond = 30;

std::vector<double> times_of(const MaterialNumbers& numbers) {
  std::vector<double> times;
  for (const MaxwellBranch& branch : numbers.relaxation.branches) times.push_back(branch.time);
  for (const KelvinUnit& unit : numbers.retardation.units) times.push_back(unit.time);
  return times;
}

template <class Function>
FigureSeries curve(const char* name, double from, double to, int colour, const Function& value) {
  FigureSeries series{name, Style::line, {}, colour};
  for (int i = 0; i <= points_of_curve; ++i) {
    const double x = from * std::pow(to / from, static_cast<double>(i) / points_of_curve);
    series.points.push_back({x, value(x), ""});
  }
  return series;
}

Figure figure_of(const char* name, const char* title, const char* caption, const char* x,
                 const FigureAxis& y) {
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.caption = caption;
  figure.x = {x, true, {}, {}};
  figure.y = y;
  return figure;
}

}  // namespace

double MaterialNumbers::relaxation_function(double t) const {
  double force = relaxation.equilibrium;
  for (const MaxwellBranch& each : relaxation.branches)
    force += each.stiffness * std::exp(-t / each.time);
  return force;
}

double MaterialNumbers::creep_function(double t) const {
  double displacement = retardation.glassy + retardation.fluidity * t;
  for (const KelvinUnit& each : retardation.units)
    displacement -= each.compliance * std::expm1(-t / each.time);
  return displacement;
}

// 1/(s P(s)) with P = K/s is 1/K: weight/(s + rate) is a Kelvin unit of compliance weight/rate.
MaterialNumbers material_numbers(const Network& network, const Values& values) {
  MaterialNumbers numbers{relaxation_form(network, values), {}};
  const DualPoles compliance = dual(stiffness_poles(numbers.relaxation));
  numbers.retardation.glassy = compliance.direct;
  numbers.retardation.fluidity = compliance.at_rest;
  for (std::size_t i = compliance.rates.size(); i-- > 0;) {
    const double rate = compliance.rates[i].value();
    numbers.retardation.units.push_back({compliance.weights[i] / rate, 1 / rate});
  }
  return numbers;
}

std::vector<Figure> material_figures(const MaterialNumbers& numbers) {
  const std::vector<double> times = times_of(numbers);
  if (times.empty()) return {};
  const double from = *std::min_element(times.begin(), times.end()) / beyond,
               to = *std::max_element(times.begin(), times.end()) * beyond;
  const double low = 1 / (two_pi * to), high = 1 / (two_pi * from);
  const auto stiffness = [&](double hertz) {
    return dynamic_stiffness(numbers.relaxation, two_pi * hertz);
  };
  Figure dynamic =
      figure_of("stiffness", "Storage and loss stiffness", "K′ and K″ of K(iω) = K′ + iK″.",
                "frequency, Hz", {"stiffness, N/m", true, {}, {}});
  dynamic.series = {
      curve("storage K′", low, high, 0, [&](double f) { return stiffness(f).real(); }),
      curve("loss K″", low, high, 1, [&](double f) { return stiffness(f).imag(); })};
  Figure loss =
      figure_of("loss_factor", "Loss factor", "The tangent of the phase between force and motion.",
                "frequency, Hz", {"tan δ = K″/K′", true, {}, {}});
  loss.series = {
      curve("", low, high, 0, [&](double f) { return stiffness(f).imag() / stiffness(f).real(); })};
  Figure relaxation =
      figure_of("relaxation", "Relaxation", "Force after a unit step of displacement at t = 0.",
                "time, s", {"force per displacement, N/m", false, {}, {}});
  relaxation.series = {
      curve("", from, to, 0, [&](double t) { return numbers.relaxation_function(t); })};
  Figure creep = figure_of(
      "creep", "Creep", "Displacement under a unit step of force from t = 0 on.", "time, s",
      {"displacement per force, m/N", numbers.retardation.fluidity > 0, {}, {}});
  creep.series = {curve("", from, to, 0, [&](double t) { return numbers.creep_function(t); })};
  return {dynamic, loss, relaxation, creep};
}

}  // namespace vcrit::validation::report
