#include "speed/samples.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/constants.hpp"
#include "critical/certified.hpp"

namespace vcrit::speed {

namespace {

constexpr unsigned seed = 20261121;  // any: the same values in every run

Problem with_values(const Subject& subject, const Samples& samples, std::size_t i) {
  Values values;
  for (std::size_t j = 0; j < subject.columns.size(); ++j)
    values[subject.columns[j].symbol] = samples.value(j, i);
  // v* does not depend on it.
  values[subject.problem->indentation.symbol] = 1;
  return subject.problem.with(values);
}

}  // namespace

Samples::Samples(const Subject& subject, CallMode mode, std::size_t size) : mode_(mode) {
  std::mt19937_64 random(seed);
  for (const VariedParameter& column : subject.columns) {
    std::uniform_real_distribution exponent(std::log(column.least), std::log(column.greatest));
    std::vector<double> values(size);
    for (double& value : values) value = std::exp(exponent(random));
    columns_.push_back(std::move(values));
  }
  if (mode == CallMode::sweep)
    std::sort(columns_[omega_column].begin(), columns_[omega_column].end());
  for (const std::vector<double>& column : columns_) pointers_.push_back(column.data());
}

std::vector<double> reference(const Subject& subject, const Samples& samples) {
  std::vector<double> values(samples.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = certified_critical_velocity(with_values(subject, samples, i)).value;
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
