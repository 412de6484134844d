// Modes of any number of pairs: to the modes, along them and back is what e^{At} does, by
// scaling and squaring of the whole matrix, which knows no modes.
#include "modes/general_modes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "support/exponential.hpp"

BOOST_AUTO_TEST_SUITE(test_general_modes)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;
using Wide = test::WideMatrix;

Dense<long double> dense(const Wide& a) {
  Dense<long double> result(static_cast<std::size_t>(a.rows()), static_cast<std::size_t>(a.cols()));
  for (std::size_t i = 0; i < result.rows(); ++i)
    for (std::size_t j = 0; j < result.columns(); ++j)
      result(i, j) = a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  return result;
}

// The largest difference of an entry of from_modes e^{modes t} to_modes from one of e^{At}.
double worst_difference(const Wide& a, const GeneralModes& found, double t) {
  const Modes& modes = found.modes;
  const Wide exact = test::exponential(a * t);
  const ModalFactors factors(modes.spectrum, t);
  double worst = 0;
  const auto n = static_cast<std::size_t>(a.rows());
  for (std::size_t j = 0; j < n; ++j) {
    Vector moved(n);
    factors.apply(modes.to_modes.column(j), [&](Index mode, const Integrals<double>& after) {
      add(modes.from_modes.column(mode), after[0], moved);
    });
    for (std::size_t i = 0; i < n; ++i)
      worst = std::max(
          worst, std::abs(moved[i] - static_cast<double>(exact(static_cast<Eigen::Index>(i),
                                                               static_cast<Eigen::Index>(j)))));
  }
  return worst;
}

// Masses on springs and dampers in units of energy: | -C -G; G^T -T |.
Wide passive(std::mt19937& random, int masses, int elongations, double damping) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Wide g(masses, elongations), c(masses, masses);
  for (Eigen::Index i = 0; i < g.size(); ++i) g.data()[i] = uniform(-2, 2);
  for (Eigen::Index i = 0; i < c.size(); ++i) c.data()[i] = uniform(-1, 1);
  Wide a = Wide::Zero(masses + elongations, masses + elongations);
  a.topLeftCorner(masses, masses) = -damping * c * c.transpose();
  a.topRightCorner(masses, elongations) = -g;
  a.bottomLeftCorner(elongations, masses) = g.transpose();
  for (int i = masses; i < elongations; ++i) a(masses + i, masses + i) = -uniform(0.1, 3);
  return a;
}

bool equal(const Matrix& one, const Matrix& two) {
  for (Index j = 0; j < one.columns(); ++j)
    if (!std::ranges::equal(one.column(j), two.column(j))) return false;
  return one.columns() == two.columns();
}

bool same(const GeneralModes& one, const GeneralModes& two) {
  const auto numbers = [](const ModePair& pair) { return std::pair(pair.decay, pair.q); };
  return std::ranges::equal(one.modes.spectrum.rates, two.modes.spectrum.rates) &&
         std::ranges::equal(one.modes.spectrum.pairs, two.modes.spectrum.pairs, {}, numbers,
                            numbers) &&
         equal(one.modes.to_modes, two.modes.to_modes) &&
         equal(one.modes.from_modes, two.modes.from_modes) &&
         one.amplification == two.amplification && one.change == two.change;
}

}  // namespace

// Two roundings of each of some 10 terms that the modes amplify.
BOOST_AUTO_TEST_CASE(random_passive_systems) {
  std::mt19937 random(7);
  for (int i = 0; i < 60; ++i) {
    const Wide a = passive(random, 1 + i % 5, 1 + i % 5 + i % 3, i % 4 == 0 ? 0 : 0.3);
    const GeneralModes found = general_modes(dense(a));
    BOOST_TEST_CONTEXT("system " << i) {
      for (const double t : {0.01, 0.7, 5.0})
        BOOST_TEST(worst_difference(a, found, t) <= 2e-15 * (1 + t) * found.amplification);
      Index oscillating = 0;
      for (const ModePair& pair : found.modes.spectrum.pairs) {
        BOOST_TEST(pair.decay >= 0);
        if (pair.q < 0) ++oscillating;
      }
      BOOST_TEST(oscillating <= static_cast<Index>(1 + i % 5));  // no more than masses
    }
  }
}

// Those of A/unit, of a matrix that was asked for before in another unit, and of one beside it.
BOOST_AUTO_TEST_CASE(in_other_units_of_time) {
  std::mt19937 random(11);
  const Wide first = passive(random, 3, 4, 0.3);
  Wide second = first;
  second(0, 0) -= 1e-3L;
  for (const double unit : {1.0, 0.3, 1.2566e5})
    for (const Wide& a : {first, second}) {
      const GeneralModes found = general_modes(dense(a), unit);
      for (const double t : {0.7, 5.0})
        BOOST_TEST(worst_difference(a / unit, found, t) <= 2e-15 * (1 + t) * found.amplification);
    }
}

// v' = -2 z v - h, h' = v: both rates meet at z = 1, where a pair keeps all digits.
BOOST_AUTO_TEST_CASE(through_critical_damping) {
  for (const double off : {-1e-3, -1e-9, -1e-15, 0.0, 1e-15, 1e-9, 1e-3}) {
    Wide a(2, 2);
    a << -2 * (1 + off), -1, 1, 0;
    const GeneralModes found = general_modes(dense(a));
    BOOST_TEST(found.modes.spectrum.pairs.size() == 1u);
    BOOST_TEST(found.amplification < 10);
    for (const double t : {0.1, 3.0}) BOOST_TEST(worst_difference(a, found, t) < 1e-15);
  }
}

// Two equal pairs, one pushing the other by `link`: they are no planes of their own at 0 distance.
// The modes are kept apart by the change that they tell.
BOOST_AUTO_TEST_CASE(merging_pairs_tell_what_they_lose) {
  for (const double apart : {1e-2, 1e-4, 1e-6, 1e-8, 0.0}) {
    Wide a = Wide::Zero(4, 4);
    a << -0.1, -1, 0, 0, 1, -0.1, 0, 0, 1, 0, -0.1, -1 - apart, 0, 0, 1 + apart, -0.1;
    const GeneralModes found = general_modes(dense(a));
    const double lost = found.change + 2.2e-16 * found.amplification;
    BOOST_TEST(lost < 1e-9);
    for (const double t : {0.3, 4.0}) BOOST_TEST(worst_difference(a, found, t) <= 20 * lost);
  }
}

// A force that a spring holds relaxes at no rate.
BOOST_AUTO_TEST_CASE(a_rate_of_zero_is_zero) {
  Wide a = Wide::Zero(3, 3);
  a << -0.3, -1, -2, 1, 0, 0, 2, 0, 0;
  const GeneralModes found = general_modes(dense(a));
  BOOST_REQUIRE(found.modes.spectrum.singles() == 1u);
  BOOST_TEST(found.modes.spectrum.rates[0] == 0);
}

// Of six drives, more than are remembered, in units of their own, each asked for again and again: a
// memory answers as none does, bit by bit, and each memory is its own.
BOOST_AUTO_TEST_CASE(known_modes_are_the_modes) {
  std::mt19937 random(5);
  KnownModes known, other;
  std::vector<Dense<long double>> drives;
  for (int i = 0; i < 6; ++i) drives.push_back(dense(passive(random, 2 + i % 3, 3, 0.3)));
  for (int turn = 0; turn < 3; ++turn)
    for (std::size_t i = 0; i < drives.size(); ++i)
      for (const double unit : {1.0, 1.0, 3e4}) {
        const GeneralModes found = general_modes(drives[i], unit);
        BOOST_TEST(same(known.of(drives[i], unit), found));
        BOOST_TEST(same(general_modes(drives[i], unit, &other), found));
      }
}

// 1/(s + 1/2) of one decay, and of a spring and a mass (s, -1; 1, s)/(s^2 + 1).
BOOST_AUTO_TEST_CASE(responses) {
  const std::complex<double> s(0.3, 2);
  Wide decay(1, 1);
  decay << -0.5L;
  BOOST_TEST(std::abs(response(dense(decay), s)[0] - 1.0 / (s + 0.5)) < 1e-15);
  Wide swing(2, 2);
  swing << 0, -1, 1, 0;
  const auto found = response(dense(swing), s);
  BOOST_TEST(std::abs(found[0] - s / (s * s + 1.0)) < 1e-15);
  BOOST_TEST(std::abs(found[1] - 1.0 / (s * s + 1.0)) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
