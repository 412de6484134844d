#include "report/material.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
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

/// "µm/N" of "N/µm", "1/GPa" of "GPa", "m/(N.s)" of "N.s/m".
std::string inverse_of(const std::string& unit) {
  const std::size_t slash = unit.find('/');
  const std::string above = unit.substr(0, slash);
  const std::string below = slash == unit.npos ? "1" : unit.substr(slash + 1);
  return below + "/" + (above.find('.') == above.npos ? above : "(" + above + ")");
}

/// Of numbers of that size, whose inverse has the unit.
Scale inverse_scale(double size, const char* unit) {
  const Scale scale = scale_for(1 / size, unit);
  return {1 / scale.factor, inverse_of(scale.unit)};
}

/// An axis over decades: its unit is that of its middle.
struct Decades {
  double from = 0, to = 0;
  Scale scale;
};

Decades decades(double from, double to, const char* unit) {
  return {from, to, scale_for(std::sqrt(from * to), unit)};
}

template <class Function>
FigureSeries curve(const char* name, const Decades& over, int colour, const Scale& scale,
                   const Function& value) {
  FigureSeries series{name, Style::line, {}, colour};
  for (int i = 0; i <= points_of_curve; ++i) {
    const double part = static_cast<double>(i) / points_of_curve;
    const double x = over.from * std::pow(over.to / over.from, part);
    series.points.push_back({x * over.scale.factor, value(x) * scale.factor, ""});
  }
  return series;
}

Figure figure_of(const char* name, const char* title, const char* caption, const char* x,
                 const Decades& over, const std::string& y, bool logarithmic) {
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.caption = caption;
  figure.x = {fmt::format("{}, {}", x, over.scale.unit), true, {}, {}};
  figure.y = {y, logarithmic, {}, {}};
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

std::string inverse_words(double inverse, const char* unit) {
  const Scale scale = inverse_scale(inverse, unit);
  return quantity(inverse * scale.factor, "", few_digits) + " " + scale.unit;
}

std::vector<Figure> material_figures(const MaterialNumbers& numbers, const MaterialUnits& units) {
  const std::vector<double> all = times_of(numbers);
  if (all.empty()) return {};
  const Decades times = decades(*std::min_element(all.begin(), all.end()) / beyond,
                                *std::max_element(all.begin(), all.end()) * beyond, "s");
  const Decades frequencies = decades(1 / (two_pi * times.to), 1 / (two_pi * times.from), "Hz");
  const auto stiffness = [&](double hertz) {
    return dynamic_stiffness(numbers.relaxation, two_pi * hertz);
  };
  const Scale of_stiffness = scale_for(std::abs(stiffness(frequencies.to)), units.stiffness), one;
  const Scale of_force = scale_for(numbers.relaxation_function(times.from), units.stiffness);
  const Scale of_compliance =
      inverse_scale(numbers.creep_function(std::sqrt(times.from * times.to)), units.stiffness);
  Figure dynamic = figure_of(
      "stiffness", units.moduli ? "Storage and loss modulus" : "Storage and loss stiffness",
      "K′ and K″ of K(iω) = K′ + iK″.", "frequency", frequencies,
      fmt::format("{}, {}", units.moduli ? "modulus" : "stiffness", of_stiffness.unit), true);
  dynamic.series = {curve("storage K′", frequencies, 0, of_stiffness,
                          [&](double f) { return stiffness(f).real(); }),
                    curve("loss K″", frequencies, 1, of_stiffness,
                          [&](double f) { return stiffness(f).imag(); })};
  Figure loss =
      figure_of("loss_factor", "Loss factor", "The tangent of the phase between force and motion.",
                "frequency", frequencies, "tan δ = K″/K′", true);
  loss.series = {curve("", frequencies, 0, one,
                       [&](double f) { return stiffness(f).imag() / stiffness(f).real(); })};
  Figure relaxation =
      figure_of("relaxation", "Relaxation", "Force after a unit step of displacement at t = 0.",
                "time", times, "force per displacement, " + of_force.unit, false);
  relaxation.series = {
      curve("", times, 0, of_force, [&](double t) { return numbers.relaxation_function(t); })};
  Figure creep = figure_of(
      "creep", "Creep", "Displacement under a unit step of force from t = 0 on.", "time", times,
      "displacement per force, " + of_compliance.unit, numbers.retardation.fluidity > 0);
  creep.series = {
      curve("", times, 0, of_compliance, [&](double t) { return numbers.creep_function(t); })};
  return {dynamic, loss, relaxation, creep};
}

}  // namespace vcrit::validation::report
