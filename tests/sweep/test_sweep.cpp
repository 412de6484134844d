// Tables over grids: every row is what a single call says of that scene at that speed.
#include "sweep/sweep.hpp"

#include <tbb/global_control.h>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "critical/certified.hpp"
#include "simulation/steady/exact.hpp"

namespace {

using namespace vcrit;
using Q = SweptQuantity;

Sweep sweep_over(const std::string& scene, const std::vector<std::string>& axes,
                 std::vector<Q> quantities) {
  Sweep sweep{read_scene(VCRIT_SCENES "/" + scene), {}, {}, std::move(quantities), {}, {}};
  for (const std::string& axis : axes) sweep.axes.push_back(parse_axis(axis, sweep.scene));
  return sweep;
}

std::string message(const Sweep& sweep) {
  try {
    swept(sweep);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

BOOST_AUTO_TEST_CASE(rows_are_single_calls_in_row_major_order) {
  const Sweep sweep = sweep_over(
      "zener.toml",
      {"frequency=log:1 kHz:100 kHz:3", "velocity_ratio=lin:0.2:1.2:3", "k1=lin:4e6:8e6:2"},
      {Q::friction_ratio, Q::critical_velocity, Q::friction_ratio_error});
  const SweptTable table = swept(sweep);
  BOOST_TEST((table.columns == std::vector<std::string>{"frequency", "velocity_ratio", "k1",
                                                        "friction_ratio", "critical_velocity",
                                                        "friction_ratio_error"}));
  BOOST_TEST_REQUIRE(table.rows == 18U);
  auto row = table.values.begin();
  for (const double frequency : {1e3, 1e4, 1e5}) {
    for (const double ratio : {0.2, 0.7, 1.2}) {
      for (const char* k1 : {"4e6", "8e6"}) {
        const Scene scene = read_scene(VCRIT_SCENES "/zener.toml",
                                       {{"frequency", std::to_string(frequency)}, {"k1", k1}});
        const double critical = certified_critical_velocity(scene).value;
        const auto state = simulation::steady_state(simulation::system_of(scene), ratio * critical);
        BOOST_TEST(row[0] == frequency);
        BOOST_TEST(row[1] == ratio);
        BOOST_TEST(row[2] == std::stod(k1));
        // One speed is found from another, so that the last digits may differ by what both say.
        BOOST_TEST(std::abs(row[3] - state.friction_ratio) <= row[5] + state.friction_ratio_error);
        BOOST_TEST(row[4] == critical);
        row += 6;
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(threads_do_not_change_a_bit) {
  const Sweep sweep = sweep_over(
      "kelvin.toml", {"mass=lin:1 g:8 g:5", "velocity_ratio=log:0.01:1:70"}, {Q::friction_ratio});
  const std::string many = to_csv(swept(sweep));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  BOOST_TEST(to_csv(swept(sweep)) == many);
}

BOOST_AUTO_TEST_CASE(one_speed_for_all_rows) {
  Sweep sweep = sweep_over("elastic.toml", {"amplitude=lin:0.01 um:0.2 um:4"}, {Q::friction_ratio});
  sweep.velocity_ratio = 0.5;
  const SweptTable table = swept(sweep);
  // An elastic contact under a rigid drive: 1 - (du_z/u_z0) G(0.5), G of the closed form.
  const double indentation = *sweep.scene.indentation.value;
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(std::abs(table.values[2 * i + 1] -
                        (1 - table.values[2 * i] / indentation * 0.2014522033336686888)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(rows_outside_the_model_are_told) {
  const SweptTable table = swept(
      sweep_over("elastic.toml", {"velocity_ratio=lin:0.2:0.4:2", "amplitude=lin:0.2 um:0.9 um:2"},
                 {Q::critical_velocity, Q::friction_ratio}));
  BOOST_TEST(table.outside == 2U);
  BOOST_TEST(has(table.reason, "(3)"));
  BOOST_TEST(std::isfinite(table.values[3]));
  BOOST_TEST(std::isfinite(table.values[6]));
  BOOST_TEST(std::isnan(table.values[7]));
  BOOST_TEST(has(to_csv(table), ",nan\n"));
}

BOOST_AUTO_TEST_CASE(mistakes_are_named) {
  Sweep sweep = sweep_over("kelvin.toml", {"mass=lin:1:2:2"}, {Q::friction_ratio});
  BOOST_TEST(has(message(sweep), "a friction ratio at no speed"));
  sweep.velocity = 1;
  sweep.velocity_ratio = 1;
  BOOST_TEST(has(message(sweep), "several speeds"));
  sweep.velocity_ratio.reset();
  sweep.velocity = 0;
  BOOST_TEST(has(message(sweep), "speeds above 0"));
  sweep.velocity = 1;
  sweep.settings = {{"mass", "1 g"}};
  BOOST_TEST(has(message(sweep), "--set mass as well"));
  BOOST_TEST(has(message(sweep_over("kelvin.toml", {"mass=lin:1:2:2", "mass=lin:1:2:2"},
                                    {Q::critical_velocity})),
                 "the same axis again"));
  BOOST_TEST(
      has(message(sweep_over("kelvin.toml", {"velocity=lin:1:2:2", "velocity_ratio=lin:1:2:2"},
                             {Q::critical_velocity})),
          "a second axis of speeds"));
  BOOST_TEST(has(message(sweep_over("kelvin.toml", {"amplitude=lin:1:2:2", "du_z=lin:1:2:2"},
                                    {Q::critical_velocity})),
                 "du_z as well as amplitude"));
}

}  // namespace
