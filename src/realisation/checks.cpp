#include "realisation/checks.hpp"
#include "base/rounded.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace vcrit::realisation {

namespace {

using Eigen::Index;

// What a table of four digits rounds away is no fault of a row.
constexpr double least_fault = 1e-3;

template <class Size>
std::vector<RowRange> stretches_of(Index count, const Size& size) {
  std::vector<RowRange> found;
  for (Index i = 0; i < count; ++i) {
    const double wrong = size(i);
    if (!(wrong > 0)) continue;
    if (found.empty() || found.back().last + 1 < i) found.push_back({i, i, 0});
    found.back().last = i;
    found.back().size = std::max(found.back().size, wrong);
  }
  return found;
}

std::vector<RowRange> beyond_noise(const Rows& rows, double noise, double sign) {
  // Beyond 5 standard deviations lies one row in 3.5 million.
  const double least = std::max(5 * noise, least_fault);
  return stretches_of(rows.size(), [&](Index i) {
    const double share = sign * rows.value[i].imag() * rows.weight[i];
    return share > least ? share : 0;
  });
}

const Receptance::Row& row_of(const Receptance& table, Index place) {
  return table.rows[static_cast<std::size_t>(place)];
}

std::string lines_of(const Receptance& table, const RowRange& stretch) {
  const auto &first = row_of(table, stretch.first), &last = row_of(table, stretch.last);
  if (stretch.first == stretch.last) return "at " + rounded_frequency(first.omega);
  return fmt::format("from {} to {} ({} rows)", rounded_frequency(first.omega),
                     rounded_frequency(last.omega), stretch.last - stretch.first + 1);
}

std::string place_of(const Receptance& table, const RowRange& stretch) {
  return to_text(Place{table.file, row_of(table, stretch.first).line});
}

// Rows in a run of at least five whose `part` has one sign and exceeds twice the noise.
template <class Part>
void mark_runs(const CausalFit& fit, double least, const Part& part, std::vector<bool>& marked) {
  constexpr Index long_run = 5;
  Index begin = 0;
  double sign = 0;
  for (Index i = 0; i <= fit.left.size(); ++i) {
    const double value = i < fit.left.size() ? part(fit.left[i]) : 0;
    const double now = std::abs(value) > least ? std::copysign(1, value) : 0;
    if (now == sign && i < fit.left.size()) continue;
    if (sign != 0 && i - begin >= long_run)
      std::fill(marked.begin() + begin, marked.begin() + i, true);
    begin = i, sign = now;
  }
}

}  // namespace

std::vector<RowRange> giving_energy(const Rows& rows, double noise) {
  return beyond_noise(rows, noise, 1);
}

std::vector<RowRange> taking_energy(const Rows& rows, double noise) {
  return beyond_noise(rows, noise, -1);
}

std::vector<RowRange> not_causal(const CausalFit& fit, double noise) {
  const auto count = static_cast<double>(fit.left.size());
  // |left| beyond x noise has the chance exp(-x^2/2) in each row.
  const double level = std::max(noise * std::sqrt(2 * std::log(1000 * count)), least_fault);
  std::vector<bool> marked(static_cast<std::size_t>(fit.left.size()));
  const double least = std::max(2 * noise, least_fault);
  mark_runs(
      fit, least, [](const Complex& left) { return left.real(); }, marked);
  mark_runs(
      fit, least, [](const Complex& left) { return left.imag(); }, marked);
  return stretches_of(fit.left.size(), [&](Index i) {
    const double size = std::abs(fit.left[i]);
    return size > level || marked[static_cast<std::size_t>(i)] ? size : 0;
  });
}

std::vector<Unresolved> unresolved(const Rows& rows, const Structure& structure, double noise) {
  constexpr std::ptrdiff_t enough_rows = 3;
  constexpr double least_height = 0.01;
  std::vector<Unresolved> found;
  const Eigen::MatrixXd damping = structure.damping_matrix();
  for (Index k = 0; k < structure.modes(); ++k) {
    const double w = structure.frequency[k], width = damping(k + 1, k + 1);
    if (w < rows.omega[0] || w > rows.last()) continue;
    const double height = std::pow(structure.phi[k], 2) / std::max(width * w, 1e-300);
    if (height < std::max(10 * noise, least_height) * std::abs(structure.response(w))) continue;
    const auto from = std::lower_bound(rows.omega.begin(), rows.omega.end(), w - width / 2);
    const auto to = std::upper_bound(rows.omega.begin(), rows.omega.end(), w + width / 2);
    if (to - from < enough_rows) found.push_back({w, static_cast<int>(to - from)});
  }
  std::sort(found.begin(), found.end(),
            [](const Unresolved& a, const Unresolved& b) { return a.omega < b.omega; });
  return found;
}

std::string energy_words(const Receptance& table, const RowRange& stretch) {
  return fmt::format(
      "{}: Im R > 0 {}: a drive cannot give energy (exp(+i omega t): losses make Im negative)",
      place_of(table, stretch), lines_of(table, stretch));
}

std::string causality_words(const Receptance& table, const RowRange& stretch, double noise) {
  return fmt::format("{}: R {} differs by {:.2g} % from any causal response, noise {:.2g} %",
                     place_of(table, stretch), lines_of(table, stretch), 100 * stretch.size,
                     100 * noise);
}

std::string resolution_words(const Receptance& table, double omega, int rows) {
  if (rows < 2)
    return fmt::format(
        "{}: the resonance at {} is narrower than the rows' distance: its height is not "
        "in the table",
        table.file, rounded_frequency(omega));
  return fmt::format(
      "{}: the resonance at {} has {} rows within its width: its height rests on the fit",
      table.file, rounded_frequency(omega), rows);
}

}  // namespace vcrit::realisation
