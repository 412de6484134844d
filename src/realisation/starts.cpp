#include "realisation/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "fit/nnls.hpp"
#include "linear/elimination.hpp"
#include "linear/orthogonal.hpp"
#include "realisation/causal_fit.hpp"

namespace vcrit::realisation {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

struct Resonance {
  double frequency, damping;  ///< w, share of critical
};

Complex response_of(const Resonance& mode, double omega) {
  return Mode{mode.frequency, mode.damping, 1}.response(omega);
}

VectorXd weighted(const Rows& rows, const VectorXcd& values) {
  VectorXd both(2 * rows.size());
  both << rows.weight.cwiseProduct(values.real()), rows.weight.cwiseProduct(values.imag());
  return both;
}

template <class Response>
VectorXd column_of(const Rows& rows, const Response& response) {
  VectorXcd values(rows.size());
  for (Index i = 0; i < rows.size(); ++i) values[i] = response(rows.omega[i]);
  return weighted(rows, values);
}

std::array<double, 4> relaxation_times(const Rows& rows) {
  return {0.01 / rows.last(), 0.3 / rows.last(), 1 / std::sqrt(rows.first() * rows.last()),
          3 / rows.first()};
}

// phi^2 and alpha^2 by nonnegative least squares; of the relaxation times the one that takes most.
Structure structure_with(const Rows& rows, const std::vector<Resonance>& modes) {
  const auto count = static_cast<Index>(modes.size());
  const auto times = relaxation_times(rows);
  MatrixXd columns(2 * rows.size(), count + static_cast<Index>(times.size()));
  for (Index k = 0; k < count; ++k)
    columns.col(k) = column_of(
        rows, [&](double omega) { return response_of(modes[static_cast<std::size_t>(k)], omega); });
  for (std::size_t j = 0; j < times.size(); ++j)
    columns.col(count + static_cast<Index>(j)) =
        column_of(rows, [&](double omega) { return 1.0 / Complex(1, omega * times[j]); });
  const VectorXd shares = fit::nonnegative_least_squares(columns, weighted(rows, rows.value));

  Structure structure{
      0, 0, VectorXd(count), VectorXd(count), MatrixXd::Zero(count, count), VectorXd::Zero(count)};
  const auto springs = shares.tail(static_cast<Index>(times.size()));
  Index largest = 0;
  springs.maxCoeff(&largest);
  structure.tau = times[static_cast<std::size_t>(largest)];
  // At 0 all derivatives vanish, and the search would not leave it.
  structure.alpha = std::sqrt(std::max(springs.sum(), 1e-6));
  for (Index k = 0; k < count; ++k) {
    const auto& [w, damping] = modes[static_cast<std::size_t>(k)];
    structure.frequency[k] = w;
    structure.factor(k, k) = std::sqrt(2 * damping * w);
    structure.phi[k] = std::sqrt(std::max(shares[k], 1e-6 * w * w * damping));
  }
  return structure;
}

constexpr double least_damping = 1e-6, usual_damping = 0.02;

std::vector<Resonance> resonances_of(const CausalFit& fit) {
  std::vector<Resonance> modes;
  for (const Complex& pole : fit.poles)
    if (pole.imag() > 0)
      modes.push_back({std::abs(pole), std::max(-pole.real() / std::abs(pole), least_damping)});
  return modes;
}

Structure from_causal_fit(const Rows& rows, Index modes, bool by_factor) {
  std::vector<Resonance> found = resonances_of(causal_fit(rows, modes, by_factor));
  // Poles that became real leave modes to be found: above the rows and below, in turn.
  for (double beyond = 1.5; static_cast<Index>(found.size()) < modes; beyond *= 1.5) {
    found.push_back({rows.last() * beyond, usual_damping});
    if (static_cast<Index>(found.size()) < modes)
      found.push_back({rows.first() / beyond, usual_damping});
  }
  found.resize(static_cast<std::size_t>(modes));
  return structure_with(rows, found);
}

// The drive as absorbers on its end: K_d = k + c s + sum m s^2 (w^2 + 2 zeta w s)/(s^2 + 2 zeta w s
// + w^2), linear in k, c and m >= 0, with the resonances of 1/R.
struct Absorbers {
  double stiffness, damping;
  VectorXd frequency, decay, mass;  ///< w, 2 zeta w, m
};

Absorbers absorbers_of(const Rows& rows, const std::vector<Resonance>& modes) {
  const auto count = static_cast<Index>(modes.size());
  // Relative errors of K_d are those of R_d, to first order.
  const auto column = [&](const auto& stiffness) {
    VectorXcd values(rows.size());
    for (Index i = 0; i < rows.size(); ++i)
      values[i] =
          stiffness(Complex(0, rows.omega[i])) * rows.value[i] * (rows.weight[i] > 0 ? 1.0 : 0.0);
    VectorXd both(2 * rows.size());
    both << values.real(), values.imag();
    return both;
  };
  MatrixXd columns(2 * rows.size(), count + 2);
  columns.col(0) = column([](const Complex&) { return Complex(1); });
  columns.col(1) = column([](const Complex& s) { return s; });
  Absorbers found{0, 0, VectorXd(count), VectorXd(count), VectorXd(count)};
  for (Index k = 0; k < count; ++k) {
    const auto& [w, share] = modes[static_cast<std::size_t>(k)];
    const double decay = 2 * share * w;
    found.frequency[k] = w, found.decay[k] = decay;
    columns.col(k + 2) = column([&, w = w](const Complex& s) {
      return s * s * (w * w + decay * s) / (s * s + decay * s + w * w);
    });
  }
  VectorXd ones = VectorXd::Zero(2 * rows.size());
  ones.head(rows.size()) = (rows.weight.array() > 0).cast<double>();
  const VectorXd shares = fit::nonnegative_least_squares(columns, ones);
  found.stiffness = shares[0], found.damping = shares[1], found.mass = shares.tail(count);
  return found;
}

// In coordinates x of the end and q of the masses; then x = y + phi.q, so that no damper couples y
// and q, and q along the axes of its stiffness.
Structure structure_of_absorbers(const Rows& rows, const Absorbers& absorbers) {
  const Index count = absorbers.mass.size();
  const VectorXd root = absorbers.mass.cwiseMax(1e-9).cwiseSqrt();
  const VectorXd square = absorbers.frequency.array().square();
  const VectorXd pull = -root.cwiseProduct(square), drag = -root.cwiseProduct(absorbers.decay);
  const double k = std::max(absorbers.stiffness, 1e-9) - root.dot(pull);
  const double c = std::max(absorbers.damping, 1e-9 * k / rows.last()) - root.dot(drag);
  const VectorXd phi = -drag / c, held = k * phi + pull;
  MatrixXd stiffness = square.asDiagonal(), damping = absorbers.decay.asDiagonal();
  stiffness += pull * phi.transpose() + phi * pull.transpose() + k * phi * phi.transpose();
  damping -= drag * drag.transpose() / c;

  const auto [squares, turn, converged] = linear::symmetric_eigen(stiffness);
  Structure structure;
  structure.alpha = 1 / std::sqrt(k);
  structure.tau = c / k;
  structure.phi = turn.transpose() * phi;
  structure.frequency = squares.cwiseMax(1e-12).cwiseSqrt();
  MatrixXd turned = turn.transpose() * damping * turn;
  turned.diagonal().array() += 1e-9 * turned.trace() + 1e-12;
  structure.factor = linear::Cholesky(turned.cast<long double>()).lower().cast<double>();
  const VectorXd share =
      (turn.transpose() * held).cwiseQuotient(structure.frequency) / std::sqrt(k);
  structure.lean = share / std::sqrt(std::max(1 - share.squaredNorm(), 1e-6));
  if (!structure.factor.allFinite()) structure.factor = MatrixXd::Identity(count, count) * 0.1;
  return structure;
}

VectorXd misfit_of(const Rows& rows, const Structure& structure) {
  return weighted(rows, rows.value) -
         column_of(rows, [&](double omega) { return structure.response(omega); });
}

}  // namespace

double Deviates::normal() {
  const double size = std::sqrt(-2 * std::log(uniform()));
  return size * std::cos(two_pi * uniform());
}

Structure series_spring(const Rows& rows) { return structure_with(rows, {}); }

std::vector<double> places_of_new_mode(const Rows& rows, const Structure& structure) {
  const VectorXd misfit = misfit_of(rows, structure);
  Index worst = 0;
  (misfit.head(rows.size()).array().square() + misfit.tail(rows.size()).array().square())
      .maxCoeff(&worst);
  return {std::max(rows.omega[worst], rows.first()), 1.5 * rows.last(), rows.first() / 2,
          std::sqrt(rows.first() * rows.last())};
}

std::vector<Structure> absorber_starts(const Rows& rows, Index modes) {
  Rows inverse = rows;
  for (Index i = 0; i < rows.size(); ++i)
    if (rows.weight[i] > 0) {
      // 1/(s^2 R), which stays finite where the frequency grows.
      const Complex s(0, std::max(rows.omega[i], rows.first()));
      inverse.value[i] = 1.0 / (s * s * rows.value[i]);
      inverse.weight[i] = 1 / std::abs(inverse.value[i]);
    }
  std::vector<Structure> starts;
  for (const bool by_factor : {false, true}) {
    std::vector<Resonance> found = resonances_of(causal_fit(inverse, modes + 1, by_factor));
    found.resize(static_cast<std::size_t>(modes), {1.5 * rows.last(), usual_damping});
    starts.push_back(structure_of_absorbers(rows, absorbers_of(rows, found)));
  }
  return starts;
}

Structure with_mode(const Rows& rows, const Structure& structure, double frequency,
                    double damping) {
  const VectorXd column = column_of(rows, [&](double omega) {
    return response_of({frequency, damping}, omega);
  });
  const double size = column.squaredNorm();
  const double share = size > 0 ? column.dot(misfit_of(rows, structure)) / size : 0;
  const double least = size > 0 ? 1e-4 / std::sqrt(size) : 1e-6;
  return plus_mode(structure, {frequency, damping, std::max(share, least)});
}

std::vector<Structure> first_starts(const Rows& rows, Index modes, const Structure* less) {
  std::vector<Structure> starts;
  for (const bool by_factor : {false, true}) {
    starts.push_back(from_causal_fit(rows, modes, by_factor));
    // A fit easily mistakes damping that is not modal for a relaxing spring.
    starts.push_back(starts.back());
    starts.back().tau = relaxation_times(rows).front();
  }
  if (less == nullptr) return starts;
  for (const double place : places_of_new_mode(rows, *less))
    starts.push_back(with_mode(rows, *less, place, usual_damping));
  return starts;
}

Structure shaken(const Structure& structure, Deviates& deviates) {
  Structure moved = structure;
  const auto by = [&](double part) { return std::exp(part * deviates.normal()); };
  moved.alpha *= by(0.3);
  moved.tau *= by(0.5);
  for (Index k = 0; k < moved.modes(); ++k) {
    moved.phi[k] *= by(0.5);
    moved.frequency[k] *= by(0.2);
    for (Index j = 0; j <= k; ++j)
      moved.factor(k, j) = moved.factor(k, j) * by(0.5) +
                           (j < k ? 0.2 * deviates.normal() * structure.factor(j, j) : 0.0);
  }
  return moved;
}

}  // namespace vcrit::realisation
