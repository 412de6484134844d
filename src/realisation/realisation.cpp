#include "realisation/realisation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>

#include "base/errors.hpp"
#include "base/rounded.hpp"
#include "realisation/checks.hpp"

namespace vcrit::realisation {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

Index rows_in(const std::vector<RowRange>& stretches) {
  Index count = 0;
  for (const RowRange& each : stretches) count += each.last - each.first + 1;
  return count;
}

/// The standard deviation of the causal fit's misfit, but for rows at fault.
double noise_of(const CausalFit& fit, const std::vector<RowRange>& faults) {
  double sum = fit.left.squaredNorm();
  for (const RowRange& each : faults)
    sum -= fit.left.segment(each.first, each.last - each.first + 1).squaredNorm();
  const auto numbers = 2 * static_cast<double>(fit.left.size() - rows_in(faults));
  const auto used = 4 * static_cast<double>(fit.poles.size());
  return std::sqrt(std::max(sum, 0.0) / std::max(numbers - used, numbers / 4));
}

}  // namespace

Realisation::Realisation(const Receptance& table, BodyMass body)
    : rows_(rows_of(table)), first_(table.rows.front().omega), last_(table.rows.back().omega) {
  judge_rows(table);
  const FoundStructures found = search(rows_, noise_, table.order,
                                       body == BodyMass::heavy ? Damping::coupled : Damping::full);
  uncertainty_.emplace(rows_, found, noise_);
  structure_ = structure_of(found.best.shape, found.best.parameters);
  judge_fit(table);
  structure_ = in_si(structure_);
  if (table.static_compliance) add_static_compliance(table, *table.static_compliance);
}

namespace {

// Noise alone has no sign: where losses are below it, half of the rows give energy.
void refuse_other_sign(const Receptance& table, const Rows& rows) {
  const auto giving = giving_energy(rows, 0);
  const Index count = rows_in(giving), telling = count + rows_in(taking_energy(rows, 0));
  if (4 * count <= 3 * telling) return;
  throw InputError({table.file, table.rows[static_cast<std::size_t>(giving[0].first)].line},
                   fmt::format("Im R > 0 in {} of {} rows where it is not 0", count, telling),
                   "Im R <= 0, as losses make it with exp(+i omega t)",
                   "change the sign of the column Im if the table uses exp(-i omega t)");
}

}  // namespace

void Realisation::judge_rows(const Receptance& table) {
  refuse_other_sign(table, rows_);
  const CausalFit causal = best_causal_fit(rows_);
  const double robust = robust_noise(causal.left);
  const auto faults = not_causal(causal, robust);
  noise_ = std::max(robust, noise_of(causal, faults));
  const auto sources = giving_energy(rows_, noise_);
  for (const RowRange& each : sources) warnings_.push_back(energy_words(table, each));
  for (const RowRange& each : faults) warnings_.push_back(causality_words(table, each, noise_));
  // Few rows at fault only spoil the fit; many are what the table says.
  if (10 * rows_in(faults) > rows_.size()) return;
  for (const RowRange& each : faults)
    rows_.weight.segment(each.first, each.last - each.first + 1).setZero();
}

void Realisation::judge_fit(const Receptance& table) {
  double sum = 0;
  Index worst = 0, counted = 0;
  for (Index i = 0; i < rows_.size(); ++i) {
    if (std::abs(rows_.value[i]) == 0) continue;
    const double miss =
        std::abs(structure_.response(rows_.omega[i]) - rows_.value[i]) / std::abs(rows_.value[i]);
    if (miss > misfit_) misfit_ = miss, worst = i;
    if (rows_.weight[i] > 0) sum += miss * miss, ++counted;
  }
  const double size = std::sqrt(sum / (2 * static_cast<double>(std::max<Index>(counted, 1))));
  explained_ = size <= 2 * noise_ || size < 1e-6;
  for (const Unresolved& each : unresolved(rows_, structure_, noise_))
    warnings_.push_back(resolution_words(table, each.omega * rows_.frequency_unit, each.rows));
  constexpr double large_misfit = 0.1;
  if (!explained_ && misfit_ > large_misfit)
    warnings_.push_back(fmt::format(
        "{}: the structure that fits best misses R by {:.2g} % at {}, noise {:.2g} %: "
        "friction below v* rests on a poor fit of the drive",
        to_text(Place{table.file, table.rows[static_cast<std::size_t>(worst)].line}), 100 * misfit_,
        rounded_frequency(rows_.omega[worst] * rows_.frequency_unit), 100 * noise_));
}

// A mode so far below the rows that the noise hides it there; damped, so that it comes to rest.
void Realisation::add_static_compliance(const Receptance& table, double compliance) {
  const double fitted = structure_.static_compliance(), missing = compliance - fitted;
  if (missing <= 0) {
    // The structure at rest is an extrapolation as well: a little less is as good as the same.
    constexpr double little = 0.02;
    if (-missing <= little * fitted) return;
    const auto [compliance_words, fitted_words] = rounded_apart(compliance, fitted, "m/N");
    throw InputError(
        {table.file, 0},
        fmt::format("static_compliance = {}, less than the {} of its realisation at rest",
                    compliance_words, fitted_words),
        "a static compliance that is at least that of the modes within the table");
  }
  const double first = rows_.first() * rows_.frequency_unit;
  const double share = std::abs(response(first)) * std::max(noise_, 1e-6) / 10;
  const double w = first * std::min(0.1, std::sqrt(share / std::max(missing, 1e-300)));
  // Half of critical damping.
  resting_ = Mode{w, 0.5, w * w * missing};
  structure_ = plus_mode(structure_, *resting_);
}

double Realisation::caution() const {
  // Found on the 82 chains of tests/data/two_mass_chains.csv, as the factors of Uncertainty::error.
  constexpr double unexplained = 8;
  return explained_ ? 1 : unexplained;
}

Deviation Realisation::deviation(double omega) const {
  Deviation found = uncertainty_->at(omega / rows_.frequency_unit);
  for (double* each : {&found.rivals, &found.noise, &found.hidden, &found.misfit})
    *each *= rows_.value_unit;
  return found;
}

double Realisation::error(double omega) const {
  return caution() * rows_.value_unit * uncertainty_->error(omega / rows_.frequency_unit);
}

Structure Realisation::in_si(const Structure& scaled) const {
  const double frequency = rows_.frequency_unit, value = rows_.value_unit;
  Structure structure = scaled;
  structure.alpha *= std::sqrt(value);
  structure.tau /= frequency;
  structure.phi *= std::sqrt(value) * frequency;
  structure.frequency *= frequency;
  structure.factor *= std::sqrt(frequency);
  return resting_ ? plus_mode(structure, *resting_) : structure;
}

std::vector<Structure> Realisation::all_in_si(const std::vector<Structure>& scaled) const {
  std::vector<Structure> all;
  for (const Structure& each : scaled) all.push_back(in_si(each));
  return all;
}

std::vector<Structure> Realisation::refits() const { return all_in_si(uncertainty_->refits()); }
std::vector<Structure> Realisation::rivals() const { return all_in_si(uncertainty_->rivals()); }

std::optional<Structure> Realisation::with_hidden_mode(double omega) const {
  const auto found = uncertainty_->with_hidden_mode(omega / rows_.frequency_unit);
  return found ? std::optional(in_si(*found)) : std::nullopt;
}

std::shared_ptr<const Realisation> realised(const Receptance& table, BodyMass body) {
  struct Known {
    Receptance table;
    BodyMass body;
    std::shared_ptr<const Realisation> result;
  };
  static std::mutex lock;
  static std::deque<Known> known;
  constexpr std::size_t most_known = 8;
  const std::lock_guard guard(lock);
  for (const Known& each : known)
    if (each.table.file == table.file && each.table.rows == table.rows && each.body == body &&
        each.table.static_compliance == table.static_compliance && each.table.order == table.order)
      return each.result;
  known.push_front({table, body, std::make_shared<const Realisation>(table, body)});
  if (known.size() > most_known) known.pop_back();
  return known.front().result;
}

}  // namespace vcrit::realisation
