// Columns of parameters: each lane is the correctly rounded value of its scene, to the rounding
// errors of doubles.
#include "critical/batch.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "critical/certified.hpp"
#include "critical/kernels.hpp"
#include "problem/variation.hpp"
#include "support/random_scene.hpp"
#include "support/reference_scene.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_batch)

namespace {

using namespace vcrit;
using Table = std::vector<std::vector<double>>;

constexpr double u = std::numeric_limits<double>::epsilon() / 2;

std::vector<double> batch(const Scene& scene, const std::vector<std::string>& names,
                          const Table& table, std::size_t lanes) {
  const std::vector<std::span<const double>> columns(table.begin(), table.end());
  std::vector<double> out(lanes);
  CriticalVelocities(scene, names)(columns, out);
  return out;
}

// The documented bound; a term of 10 for what is no element (mu0 omega du_z, moduli, quotients).
double bound(const Scene& scene) {
  return 1280 * u * (static_cast<double>(scene.elements.size()) + 10);
}

void settle(Scene& scene) {
  for (const auto& [symbol, value] : scene.elements)
    scene.settable[to_text(symbol)] = Dimension::none;
  for (const char* name : {"omega", "frequency", "mu0", "du_z", "u_z0", "m", "poisson"})
    scene.settable[name] = Dimension::none;
}

double lane_of(const std::vector<double>& column, std::size_t lane) {
  return column[column.size() == 1 ? 0 : lane];
}

void check(const Scene& scene, const std::vector<std::string>& names, const Table& table,
           std::size_t lanes) {
  const std::vector<double> out = batch(scene, names, table, lanes);
  const Variation changing(scene, names);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    std::vector<double> values;
    for (const auto& column : table) values.push_back(lane_of(column, lane));
    const double expected = certified_critical_velocity(changing.at(values)).value;
    BOOST_TEST_CONTEXT("lane " << lane)
    BOOST_TEST((out[lane] == expected || std::abs(out[lane] / expected - 1) <= bound(scene)));
  }
}

BOOST_AUTO_TEST_CASE(reference_rows_of_every_size) {
  for (const test::ReferenceRow& row : test::extreme_rows()) {
    if (!row.scene || row.status == "pole") continue;
    Scene scene = *row.scene;
    settle(scene);
    const double omega = *scene.angular_frequency.value;
    BOOST_TEST_CONTEXT("row " << row.id) {
      const double out = batch(scene, {"omega"}, {{omega}}, 1)[0];
      BOOST_TEST((out == row.velocity || std::abs(out / row.velocity - 1) <= bound(scene)));
    }
  }
}

// Lengths around a block of lanes; columns and single values mixed.
BOOST_AUTO_TEST_CASE(random_scenes_in_any_parameters) {
  test::RandomScenes random(70, 5);
  std::mt19937 generator(71);
  for (int i = 0; i < 60; ++i) {
    Scene scene = random.scene(12);
    settle(scene);
    std::vector<std::string> names;
    for (const auto& [symbol, value] : scene.elements)
      if (generator() % 3 == 0) names.push_back(to_text(symbol));
    for (const char* name : {"omega", "mu0", "du_z", "u_z0"})
      if (generator() % 2 == 0) names.emplace_back(name);
    if (scene.mass && generator() % 2 == 0) names.emplace_back("m");
    const std::size_t lanes = 100 + generator() % 200;
    Table table;
    for (std::size_t c = 0; c < names.size(); ++c) {
      std::vector<double> column(generator() % 4 == 0 ? 1 : lanes);
      for (double& value : column)
        value = std::pow(10, std::uniform_real_distribution(-4.0, 4.0)(generator));
      table.push_back(std::move(column));
    }
    BOOST_TEST_CONTEXT("scene " << i) check(scene, names, table, lanes);
  }
}

// Resonance within a few units in the last place, numbers beyond the usual range, an element that
// vanishes, Poisson's ratio of both signs: lanes beside each other.
BOOST_AUTO_TEST_CASE(lanes_that_need_the_certified_value) {
  const Scene scene = test::scene_of(
      {.normal = "k0 | (k1 - c1)",
       .network = "kd | cd",
       .mass = 4,
       .angular_frequency = 1e3,
       .amplitude = 1e-7,
       .indentation = 1e-6,
       .coefficient = 0.3,
       .elements = {{"k0", 8e6}, {"k1", 4e6}, {"c1", 30}, {"kd", 4e6}, {"cd", 1e-9}}});
  Table table(4);
  for (std::size_t lane = 0; lane < 300; ++lane) {
    const double off = 1 + 1e-16 * std::pow(2, static_cast<double>(lane % 50));
    table[0].push_back(1e3 * off);
    table[1].push_back(lane % 7 == 0 ? 0 : lane % 11 == 0 ? 1e-30 : lane % 13 == 0 ? 1e40 : 4e6);
    table[2].push_back(lane % 5 == 0 ? -0.5 : 0.25);
    table[3].push_back(lane % 17 == 0 ? 0 : 1e-7);
  }
  check(scene, {"omega", "k1", "poisson", "amplitude"}, table, 300);
}

BOOST_AUTO_TEST_CASE(frequencies_and_drives_without_kernels) {
  Table hertz(1);
  for (int i = 0; i < 20; ++i) hertz[0].push_back(16e3 + 300 * i);
  for (const char* name : {"zener.toml", "measured_drive.toml", "sonotrode.toml"}) {
    const std::string file = std::string(VCRIT_SCENES "/") + name;
    BOOST_TEST_CONTEXT(name) check(read_scene(file), {"frequency"}, hertz, 20);
  }
}

BOOST_AUTO_TEST_CASE(the_result_may_take_the_place_of_a_column) {
  const Scene scene = read_scene(VCRIT_SCENES "/zener.toml");
  std::vector<double> omega(1000);
  for (std::size_t i = 0; i < omega.size(); ++i) omega[i] = 1e3 + 1e3 * static_cast<double>(i);
  const std::vector<double> apart = batch(scene, {"omega"}, {omega}, omega.size());
  const std::vector<std::span<const double>> columns{omega};
  CriticalVelocities(scene, {"omega"})(columns, omega);
  BOOST_TEST(apart == omega, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(wrong_names_and_values_are_refused) {
  const Scene scene = read_scene(VCRIT_SCENES "/zener.toml");
  const auto refused = [&](const std::vector<std::string>& names, const Table& table) {
    return test::refusal([&] { batch(scene, names, table, table.empty() ? 1 : table[0].size()); });
  };
  BOOST_TEST(refused({"k9"}, {{1}}).find("\"k9\", which this scene does not have") !=
             std::string::npos);
  BOOST_TEST(refused({"omega", "frequency"}, {{1}, {1}}).find("frequency as well as omega") !=
             std::string::npos);
  for (const char* name : {"k1", "u_z0"})
    for (const double value : {-1.0, HUGE_VAL})
      BOOST_TEST(refused({name}, {{1, value}}).find(std::string("set ") + name) == 0U);
}

// u_z0 is no part of v*; a lane without a number has none all the same.
BOOST_AUTO_TEST_CASE(lanes_without_a_number_are_nan) {
  for (const char* file : {"/zener.toml", "/measured_drive.toml"}) {
    const Scene scene = read_scene(std::string(VCRIT_SCENES) + file);
    for (const char* name : {"omega", "u_z0"}) {
      const auto own = scene.angular_frequency.value.value();
      const auto found = batch(scene, {name}, {{own, std::nan(""), own}}, 3);
      BOOST_TEST(std::isfinite(found[0]));
      BOOST_TEST(std::isnan(found[1]));
      BOOST_TEST(found[2] == found[0]);
      BOOST_TEST(std::isnan(batch(scene, {name}, {{std::nan("")}}, 2)[1]));
    }
  }
}

// Levels of the processor differ in speed alone: every kernel gives the same bits in all of them.
BOOST_AUTO_TEST_CASE(all_levels_of_the_processor_give_the_same_bits) {
  using kernels::lanes;
  std::mt19937 generator(72);
  std::vector<std::vector<double>> in(8, std::vector<double>(lanes));
  for (auto& column : in)
    for (double& value : column)
      value = std::pow(10, std::uniform_real_distribution(-6.0, 6.0)(generator));
  const auto answers = [&](const kernels::Kernels& k) {
    std::vector<std::vector<double>> out(16, std::vector<double>(lanes, 0.0));
    const auto pair = [&](std::size_t i) {
      return kernels::StiffnessLanes{in[i].data(), in[i + 1].data()};
    };
    const auto result = [&](std::size_t i) {
      return kernels::LanesResult{out[i].data(), out[i + 1].data()};
    };
    k.multiply(out[0].data(), in[0].data(), in[1].data());
    k.divide(out[1].data(), in[0].data(), in[1].data());
    k.add(out[2].data(), in[0].data(), in[1].data());
    k.maxwell(result(3), in[0].data(), in[1].data(), in[2].data());
    k.series(result(5), pair(0), pair(2));
    k.mesh(result(7), pair(0), pair(2), pair(4));
    k.isotropic(out[9].data(), out[10].data(), in[0].data());
    k.modulus_ratio(out[11].data(), pair(0), pair(2));
    k.drive_factor(out[12].data(), out[13].data(), pair(0),
                   {pair(2), in[4].data(), in[5].data(), false, true});
    k.drive_factor(out[14].data(), out[13].data(), pair(0),
                   {pair(2), nullptr, in[5].data(), true, false});
    k.outside_range(out[15].data(), in[6].data());
    return out;
  };
  const auto baseline = answers(*kernels::all_kernels().front());
  for (const kernels::Kernels* level : kernels::all_kernels()) {
    const auto out = answers(*level);
    for (std::size_t c = 0; c < out.size(); ++c)
      BOOST_TEST(std::memcmp(out[c].data(), baseline[c].data(), lanes * sizeof(double)) == 0);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
