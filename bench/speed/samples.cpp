#include "speed/samples.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/constants.hpp"
#include "critical/certified.hpp"

namespace vcrit::speed {

namespace {

constexpr unsigned seed = 20261121;

Scene with_values(const Problem& problem, const Samples& samples, std::size_t i) {
  Values values;
  for (std::size_t j = 0; j < problem.columns.size(); ++j)
    values[problem.columns[j].symbol] = samples.value(j, i);
  Scene scene = problem.scene;
  for (auto& [symbol, value] : scene.elements) value = values.at(symbol);
  for (Quantity* quantity : {&scene.coefficient, &scene.angular_frequency, &scene.amplitude})
    quantity->value = values.at(quantity->symbol);
  // v* does not depend on it.
  scene.indentation.value = 1.0;
  if (auto* contact = std::get_if<Isotropic>(&scene.tangential))
    contact->quantity.value = values.at(contact->quantity.symbol);
  scene.mass->value = values.at(scene.mass->symbol);
  return scene;
}

}  // namespace

Samples::Samples(const Problem& problem, Mode mode, std::size_t size) : mode_(mode) {
  std::mt19937_64 random(seed);
  for (const VariedParameter& column : problem.columns) {
    std::uniform_real_distribution exponent(std::log(column.least), std::log(column.greatest));
    std::vector<double> values(size);
    for (double& value : values) value = std::exp(exponent(random));
    columns_.push_back(std::move(values));
  }
  if (mode == Mode::sweep) std::sort(columns_[omega_column].begin(), columns_[omega_column].end());
  for (const std::vector<double>& column : columns_) pointers_.push_back(column.data());
}

std::vector<double> reference(const Problem& problem, const Samples& samples) {
  std::vector<double> values(samples.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = certified_critical_velocity(with_values(problem, samples, i)).value;
  return values;
}

double worst_error(const std::vector<double>& values, const std::vector<double>& reference) {
  double worst = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double ulp = std::nextafter(reference[i], INFINITY) - reference[i];
    const double error = std::abs(values[i] - reference[i]) / ulp;
    if (!(error <= worst)) worst = error;
    if (std::isnan(error)) return infinity;
  }
  return worst;
}

}  // namespace vcrit::speed
