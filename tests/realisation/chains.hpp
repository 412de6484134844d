// Drives whose receptance is known: the chains of tests/data/two_mass_chains.csv, by the rules of
// impedances in series and side by side, and tables of them as an instrument would write them.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <complex>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/constants.hpp"
#include "scene/receptance.hpp"
#include "support/table.hpp"

namespace vcrit::test {

struct Chain {
  std::string id, drive;
  std::vector<double> k, c, m;  ///< kd1.., cd1.., m1..; 0 where absent

  /// R_d(i omega). Masses act against the ground, which the far end is to an oscillation.
  std::complex<double> receptance(double omega) const {
    using Complex = std::complex<double>;
    const Complex s(0, omega);
    const auto pad = [&](std::size_t i) { return k[i] + c[i] * s; };
    const auto series = [](const Complex& a, const Complex& b) { return a * b / (a + b); };
    if (drive.starts_with("kd1 | cd1 |")) return 1.0 / (pad(0) + series(pad(1), m[0] * s * s));
    const Complex end = m[1] > 0 ? series(pad(1), m[1] * s * s + pad(2)) : pad(1);
    return 1.0 / pad(0) + 1.0 / (m[0] * s * s + end);
  }
};

inline std::vector<Chain> chains() {
  std::vector<Chain> all;
  const auto number = [](const std::string& cell) { return cell.empty() ? 0 : std::stod(cell); };
  // id,group,contact,k0,c0,k1,tau1,m0,m1,m2,kd1,cd1,kd2,cd2,kd3,cd3,drive,..
  for (const auto& row : rows_of("two_mass_chains.csv", 82))
    all.push_back({row[0],
                   row[16],
                   {number(row[10]), number(row[12]), number(row[14])},
                   {number(row[11]), number(row[13]), number(row[15])},
                   {number(row[8]), number(row[9])}});
  return all;
}

inline Chain chain(const std::string& id) {
  for (const Chain& each : chains())
    if (each.id == id) return each;
  throw std::runtime_error("no chain " + id);
}

/// 200 rows from 0.2 to `last`, five digits each, with noise of that share of |R| in real and
/// imaginary part. A drive has an id and a receptance(omega).
template <class Drive>
Receptance table_of(const Drive& chain, double last, double noise, unsigned seed = 7) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&] {
    const double size = std::sqrt(-2 * std::log(uniform()));
    return size * std::cos(two_pi * uniform());
  };
  const auto rounded = [](double x) { return std::stod(fmt::format("{:.4e}", x)); };
  constexpr int rows = 200;
  Receptance table{chain.id, {}};
  for (int i = 0; i < rows; ++i) {
    const double omega = 0.2 + (last - 0.2) * i / (rows - 1);
    const std::complex<double> r = chain.receptance(omega);
    const double re = r.real() + noise * std::abs(r) * normal(),
                 im = r.imag() + noise * std::abs(r) * normal();
    table.rows.push_back({omega, rounded(re), rounded(im), i + 2});
  }
  return table;
}

}  // namespace vcrit::test
