// Modes of a held body: exact ones, critical damping, and the body's own transfer function.
#include "modes/body_modes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <random>

BOOST_AUTO_TEST_SUITE(test_body_modes)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;
using Complex = std::complex<double>;

constexpr double u = 1.1e-16;

// m/chi(s): the Laplace transform of a(t) after a(0) = 1.
Complex transfer(double mass, const PoleSum& holder, Complex s) {
  Complex chi = mass * s + holder.direct;
  for (std::size_t j = 0; j < holder.rates.size(); ++j)
    chi += holder.weights[j] / (s + holder.rates[j]);
  return mass / chi;
}

Vector first_row(const Matrix& a) {
  Vector row;
  for (Index j = 0; j < a.columns(); ++j) row.push_back(a(0, j));
  return row;
}

struct Sum {
  Complex value = 0;
  double size = 0;
  void add(Complex term) {
    value += term;
    size += std::abs(term);
  }
};

// The same from the modes: sum of residues over (s - s_i).
Sum transfer(const Modes& modes, Complex s) {
  const Spectrum& spectrum = modes.spectrum;
  const ConstView start = modes.to_modes.column(0);
  const Vector out = first_row(modes.from_modes);
  Sum sum;
  for (Index i = 0; i < spectrum.singles(); ++i)
    sum.add(out[i] * start[i] / (s + spectrum.rates[i]));
  if (spectrum.pairs.empty()) return sum;
  // Sigma part of W/(s + p - sigma) = W (s + p + sigma)/((s + p)^2 - q).
  const PairNumber w = spectrum.weight(out, 0) * spectrum.amplitude(start, 0);
  const Complex shifted = s + spectrum.pairs[0].decay;
  const Complex denominator = shifted * shifted - spectrum.pairs[0].q;
  sum.value += (w.a + w.b * shifted) / denominator;
  sum.size += (magnitude(w) + std::abs(w.b * shifted)) / std::abs(denominator);
  return sum;
}

// from_modes to_modes against 1, in units of the states' energies: a by sqrt(m), h_j by
// 1/sqrt(k_j).
double identity_error(const Modes& modes, double mass, const PoleSum& holder) {
  const Index n = modes.to_modes.columns();
  Vector unit(n, std::sqrt(mass));
  for (Index j = 1; j < n; ++j) unit[j] = 1 / std::sqrt(holder.weights[j - 1]);
  double worst = 0;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      double sum = i == j ? -1 : 0, size = 0;
      for (Index k = 0; k < n; ++k) {
        const double term = unit[i] * modes.from_modes(i, k) * modes.to_modes(k, j) / unit[j];
        sum += term;
        size += std::abs(term);
      }
      worst = std::max(worst, std::abs(sum) / std::max(size, 1.0));
    }
  return worst;
}

// Velocity at t from v(0) = 1, h = 0.
double velocity_after(const Modes& modes, double t) {
  double sum = 0;
  ModalFactors(modes.spectrum, t).apply(modes.to_modes.column(0), [&](Index i, const auto& passed) {
    sum += modes.from_modes(0, i) * passed[0];
  });
  return sum;
}

}  // namespace

// m = 1, c = 2, k = 1: both rates are 1. v = (1 - t) e^{-t} from v(0) = 1.
BOOST_AUTO_TEST_CASE(critical_damping) {
  const Modes modes = body_modes(1, {2, {0}, {1}});
  BOOST_REQUIRE(modes.spectrum.pairs.size() == 1u);
  BOOST_TEST(std::abs(modes.spectrum.pairs[0].q) <= 4 * u);
  BOOST_TEST(std::abs(modes.spectrum.pairs[0].decay - 1) <= 4 * u);
  for (const double t : {0.0, 0.3, 1.0, 2.5, 7.0}) {
    const double velocity = velocity_after(modes, t);
    // q off by 4 u changes the motion by 4 u t^2 e^{-t} at most.
    BOOST_TEST(std::abs(velocity - (1 - t) * std::exp(-t)) <= 20 * u);
  }
}

// Through critical damping the motion is smooth: compare with the derivative-free closed form in
// long double on both sides, v = e^{-p t} (cosh(w t) - p sinh(w t)/w), p = c/2, w^2 = p^2 - 1.
BOOST_AUTO_TEST_CASE(near_critical_damping) {
  for (const double off :
       {-1e-2, -1e-6, -1e-10, -1e-14, 1e-14, 1e-10, 1e-6, 1e-2, 0.2, 3.0, 100.0}) {
    const double c = 2 * (1 + off);
    const Modes modes = body_modes(1, {c, {0}, {1}});
    for (const double t : {0.1, 1.0, 5.0}) {
      const std::complex<long double> p = 0.5L * static_cast<long double>(c),
                                      w = std::sqrt(p * p - 1.0L),
                                      x = w * static_cast<long double>(t);
      const auto exact = std::exp(-p * static_cast<long double>(t)) *
                         (std::cosh(x) - p * (x == 0.0L ? 1.0L : std::sinh(x) / w));
      const double velocity = velocity_after(modes, t);
      BOOST_TEST(std::abs(velocity - static_cast<double>(exact.real())) <= 60 * u,
                 "c = " << c << ", t = " << t);
    }
  }
}

// Three real rates between two poles, all the cases of where the extra two may lie, and complex
// pairs, against the transfer function. It is a ratio of sums without cancellation for real s > 0;
// residues are good to some 10 u over the relative distance of close rates, no less than 0.1.
BOOST_AUTO_TEST_CASE(transfer_functions) {
  std::mt19937 random(5);
  const auto logarithmic = [&](double decades) {
    return std::pow(10, std::uniform_real_distribution<double>(-decades, decades)(random));
  };
  int pairs = 0;
  for (int i = 0; i < 600; ++i) {
    const double decades = i % 3 == 0 ? 0.5 : (i % 3 == 1 ? 3 : 9);
    PoleSum holder;
    if (i % 2 == 0) holder.direct = logarithmic(1);
    if (i % 5 != 0) {
      holder.rates.push_back(0);
      holder.weights.push_back(logarithmic(1));
    }
    double rate = logarithmic(decades);
    for (int j = 0; j < i % 4; ++j) {
      holder.rates.push_back(rate);
      holder.weights.push_back(logarithmic(1) * (i % 7 == 0 ? 1e-3 : 1));
      rate *= 1 + logarithmic(decades);
    }
    if (holder.rates.empty() && holder.direct == 0) continue;
    const double mass = logarithmic(2);
    const Modes modes = body_modes(mass, holder);
    pairs += modes.spectrum.pairs.empty() ? 0 : 1;
    BOOST_TEST_CONTEXT("body " << i) {
      BOOST_TEST(identity_error(modes, mass, holder) <= 1e3 * u);
      for (double s = 1e-10; s < 1e11; s *= 10) {
        const Complex exact = transfer(mass, holder, s);
        const Sum sum = transfer(modes, s);
        BOOST_TEST(std::abs(sum.value - exact) <= 1e3 * u * sum.size);
      }
    }
  }
  BOOST_TEST(pairs > 100);
}

BOOST_AUTO_TEST_SUITE_END()
