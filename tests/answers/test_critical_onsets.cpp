// v* over columns where the contact opens: each lane is that of its scene.
#include "answers/critical_onsets.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "answers/critical_onset.hpp"
#include "critical/certified.hpp"
#include "problem/variation.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_critical_onsets)

using namespace vcrit;

namespace {

using Table = std::vector<std::vector<double>>;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

const Scene& slow() {
  static const Scene scene = test::scene_of(test::slow_zener());
  return scene;
}

std::vector<double> onsets(const Scene& scene, const std::vector<std::string>& names,
                           const Table& table, std::size_t lanes) {
  const std::vector<std::span<const double>> columns(table.begin(), table.end());
  std::vector<double> out(lanes);
  CriticalOnsets(scene, names)(columns, out);
  return out;
}

}  // namespace

// v* as four methods of simulation agree on it, to 6 digits.
BOOST_AUTO_TEST_CASE(lanes_without_the_formula_are_simulated) {
  const auto found = onsets(slow(), {"u_z0"}, {{4e-7, 3e-7, 4e-7, 2e-5}}, 4);
  BOOST_TEST(std::abs(found[0] - 0.033557) < 1e-6);
  BOOST_TEST(std::abs(found[1] - 0.032949) < 1e-6);
  BOOST_TEST(found[2] == found[0]);
  // Pressed in further, by hand: K_n(0) u_z0 = 4 N above du_z |K_n| = 1.97 N. It stays closed, and
  // v* is mu0 omega du_z/0.8 as of any isotropic contact under a rigid drive, in the batch's
  // 1280 u an element.
  BOOST_TEST(std::abs(found[3] / 0.0375 - 1) < 3 * 1280 * 0x1p-53);
}

BOOST_AUTO_TEST_CASE(without_columns_all_lanes_are_the_scene) {
  const auto found = onsets(slow(), {}, {}, 3);
  for (const double each : found) BOOST_TEST(each == critical_onset(slow()).contact_velocity);
}

BOOST_AUTO_TEST_CASE(each_lane_is_that_of_its_scene) {
  const Table table{{4e-7, unknown, 3e-7, 2e-6, 4e-7}, {40, 40, 400, 0, 4}};
  const auto found = onsets(slow(), {"u_z0", "c1"}, table, 5);
  const Variation changing(slow(), {"u_z0", "c1"});
  for (std::size_t lane = 0; lane < 5; ++lane) {
    if (lane == 1) {
      BOOST_TEST(std::isnan(found[lane]));
      continue;
    }
    const CriticalOnset expected =
        critical_onset(changing.at(std::vector{table[0][lane], table[1][lane]}));
    BOOST_TEST(std::abs(found[lane] / expected.contact_velocity - 1) < 3 * 1280 * 0x1p-53, lane);
  }
}

BOOST_AUTO_TEST_CASE(the_result_may_take_the_place_of_a_column) {
  std::vector<double> values;
  for (int i = 0; i < 600; ++i) values.push_back(1e-6 + (i % 7) * 1e-7);
  values[500] = 3e-7;
  const auto expected = onsets(slow(), {"u_z0"}, {values}, values.size());
  const std::vector<std::span<const double>> columns{values};
  CriticalOnsets(slow(), {"u_z0"})(columns, values);
  BOOST_TEST(values == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_first_wrong_lane_is_named) {
  const CriticalOnsets formula(slow(), {"k0", "k1"});
  const auto refused = [&](const std::vector<double>& k0, const std::vector<double>& k1) {
    const std::vector<std::span<const double>> columns{k0, k1};
    return formula.first_refused(columns, k0.size());
  };
  BOOST_TEST(!refused({1e5, 2e5}, {1e6}));
  BOOST_TEST(!refused({1e5, unknown, 0}, {1e6}));
  BOOST_TEST(refused({1e5, 1e5, -1, -1}, {1e6})->lane == 2);
  BOOST_TEST(refused({1e5, 1e5, 1e5}, {1e6, 1e6, INFINITY})->lane == 2);
  // Each may be 0, both may not: nothing is left of the network.
  const auto both = refused({0, 1e5, 0}, {1e6, 0, 0});
  BOOST_TEST(both->lane == 2);
  BOOST_TEST(both->why.find("cut in two") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(closed_contacts_have_the_formula_and_unknown_values_none) {
  const Scene scene = test::scene_of({.normal = "k",
                                      .tangential = "kt",
                                      .angular_frequency = 1,
                                      .amplitude = 1,
                                      .indentation = 2,
                                      .elements = {{"k", 3}, {"kt", 2}}});
  // Eq. (31) by hand: mu0 omega du_z k/kt. v* does not depend on u_z0, but NaN is no number of it.
  const auto found = onsets(scene, {"k", "u_z0"}, {{4, unknown, 8}, {2, 2, unknown}}, 3);
  BOOST_TEST(std::abs(found[0] - 1) < 2 * 1280 * 0x1p-53);
  BOOST_TEST(std::isnan(found[1]));
  BOOST_TEST(std::isnan(found[2]));
}

BOOST_AUTO_TEST_CASE(columns_of_other_lengths_are_wrong_input) {
  const std::vector<double> three{1, 2, 3};
  const std::vector<std::span<const double>> columns{three};
  std::vector<double> out(2);
  const CriticalVelocities formula(slow(), {"k0"});
  BOOST_CHECK_EXCEPTION(formula(columns, out), InputError, [](const InputError& error) {
    return std::string(error.what()).find("k0: found 3 values; expected 2 as in out") !=
           std::string::npos;
  });
  BOOST_CHECK_THROW(formula({}, out), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
