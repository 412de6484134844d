// Tables over grids: every row is what a single call says of that scene at that speed.
#include "sweep/sweep.hpp"

#include <fmt/core.h>
#include <tbb/global_control.h>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "problem/variants.hpp"
#include "problem/variation.hpp"
#include "simulation/steady/exact.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_sweep)

namespace {

using namespace vcrit;
using test::has;

Sweep sweep_over(const std::string& scene, const std::vector<std::string>& axes,
                 const std::vector<std::string>& quantities, const Settings& settings = {}) {
  Sweep sweep{read_scene(VCRIT_SCENES "/" + scene, settings), {}, {}, {}, {}};
  for (const std::string& axis : axes) sweep.axes.push_back(parse_axis(axis, sweep.problem));
  for (const std::string& quantity : quantities)
    sweep.quantities.push_back(parse_swept_quantity(quantity, sweep.problem));
  return sweep;
}

std::string message(const Sweep& sweep) {
  return test::refusal([&] { swept(sweep); });
}

BOOST_AUTO_TEST_CASE(columns_have_units) {
  const Problem problem = read_scene(VCRIT_SCENES "/zener.toml");
  const std::vector<std::pair<std::string, std::string>> units{
      {"critical_velocity", "m/s"},  {"friction_ratio", "1"},
      {"friction_ratio_error", "1"}, {"regime", "1"},
      {"admissible", "1"},           {"indentation", "m"},
      {"mean_normal_force", "N"},    {"contact_amplitude", "m"},
      {"sensitivity:k0", "1"}};
  BOOST_TEST(swept_quantity_names().size() == units.size());
  for (const auto& [name, expected] : units)
    BOOST_TEST(unit(parse_swept_quantity(name, problem)) == expected, name);
}

// W = 6 N on a spring of 3 N/m below a mount of 9 N/m, of which a contact of 3 N/m leaves 9/12.
BOOST_AUTO_TEST_CASE(what_presses_the_contact_is_swept) {
  Sweep sweep{test::scene_of({.tangential = "kt",
                              .mount = "km",
                              .amplitude = 0.1,
                              .force = 6,
                              .elements = {{"kn", 3}, {"kt", 4}, {"km", 9}}}),
              {},
              {},
              {},
              {}};
  sweep.axes.push_back(parse_axis("force=lin:6:12:2", sweep.problem));
  for (const char* name : {"indentation", "mean_normal_force", "contact_amplitude"})
    sweep.quantities.push_back(parse_swept_quantity(name, sweep.problem));
  const std::vector<double> expected{6, 2, 6, 0.075, 12, 4, 12, 0.075}, found = swept(sweep).values;
  BOOST_TEST_REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    BOOST_TEST(std::abs(found[i] / expected[i] - 1) < 1e-14, i);
}

// The same contact opens where 3/4 of the vibrator's amplitude is 2 m, and has nothing to tell
// then.
BOOST_AUTO_TEST_CASE(below_a_mount_the_height_that_is_left_decides) {
  Sweep sweep{test::scene_of({.tangential = "kt",
                              .mount = "km",
                              .force = 6,
                              .elements = {{"kn", 3}, {"kt", 4}, {"km", 9}}}),
              {},
              {},
              {},
              {}};
  sweep.axes.push_back(parse_axis("amplitude=lin:2.5:2.7:2", sweep.problem));
  for (const char* name : {"admissible", "contact_amplitude", "sensitivity:kn"})
    sweep.quantities.push_back(parse_swept_quantity(name, sweep.problem));
  const std::vector<double> found = swept(sweep).values;
  BOOST_TEST_REQUIRE(found.size() == 8U);
  BOOST_TEST(found[1] == 1);
  BOOST_TEST(std::abs(found[2] / (0.75 * 2.5) - 1) < 1e-14);
  BOOST_TEST(std::abs(found[3] / 0.75 - 1) < 1e-13);  // of kn km/(kn + km)
  BOOST_TEST(found[5] == 0);
  BOOST_TEST((std::isnan(found[6]) && std::isnan(found[7])));
}

// Springs behind a damper sink at W/c.
BOOST_AUTO_TEST_CASE(a_contact_that_sinks_has_no_mean_indentation) {
  Sweep sweep{test::scene_of({.normal = "k - c",
                              .tangential = "kt",
                              .force = 6,
                              .elements = {{"k", 3}, {"c", 2}, {"kt", 4}}}),
              {},
              {},
              {},
              {}};
  sweep.axes.push_back(parse_axis("force=lin:6:12:2", sweep.problem));
  sweep.quantities.push_back(parse_swept_quantity("indentation", sweep.problem));
  const std::vector<double> found = swept(sweep).values;
  BOOST_TEST((std::isnan(found[1]) && std::isnan(found[3])));
}

BOOST_AUTO_TEST_CASE(rows_are_single_calls_in_row_major_order) {
  const Sweep sweep = sweep_over(
      "zener.toml",
      {"frequency=log:1 kHz:100 kHz:3", "velocity_ratio=lin:0.2:1.2:3", "k1=lin:4e6:8e6:2"},
      {"friction_ratio", "critical_velocity", "friction_ratio_error"});
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
      "kelvin.toml", {"mass=lin:1 g:8 g:5", "velocity_ratio=log:0.01:1:70"}, {"friction_ratio"});
  const std::vector<double> many = swept(sweep).values;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  BOOST_TEST(swept(sweep).values == many, boost::test_tools::per_element());
}

// Where the axis of speeds stands decides how rows are found one from another, not what they are.
BOOST_AUTO_TEST_CASE(the_order_of_axes_is_that_of_the_rows) {
  const std::string speeds = "velocity_ratio=lin:0.1:1.1:40", masses = "mass=lin:1 g:8 g:40";
  const std::vector<std::string> quantities{"friction_ratio", "friction_ratio_error", "regime"};
  const SweptTable last = swept(sweep_over("kelvin.toml", {masses, speeds}, quantities));
  const SweptTable first = swept(sweep_over("kelvin.toml", {speeds, masses}, quantities));
  for (std::size_t i = 0; i < 40; ++i)
    for (std::size_t j = 0; j < 40; ++j) {
      const double* a = &last.values[5 * (40 * i + j)];
      const double* b = &first.values[5 * (40 * j + i)];
      BOOST_TEST((a[0] == b[1] && a[1] == b[0] && a[4] == b[4]));
      BOOST_TEST(std::abs(a[2] - b[2]) <= a[3] + b[3]);
    }
}

// More scenes than are worth a correctly rounded value each: a few rounding errors, eight elements
// far from resonance.
BOOST_AUTO_TEST_CASE(large_sweeps_are_in_doubles) {
  const SweptTable table =
      swept(sweep_over("zener.toml", {"frequency=log:1 kHz:10 kHz:12000"}, {"critical_velocity"}));
  const Variation changing(read_scene(VCRIT_SCENES "/zener.toml"), {"frequency"});
  double worst = 0;
  for (std::size_t row = 0; row < 12000; row += 37) {
    const double* point = &table.values[2 * row];
    const Problem there = as_doubles(changing.at({point, 1}));
    const double expected = certified_critical_velocity(there).value;
    worst = std::max(worst, std::abs(point[1] / expected - 1));
  }
  BOOST_TEST(worst < 1e-14);
  BOOST_TEST(worst > 0);
}

// Against the difference quotient of correctly rounded values, steps of 1e-5: h^2/6 times the third
// derivative, of the order of 1 for smooth laws, and u/h, together below 1e-9.
BOOST_AUTO_TEST_CASE(sensitivities_are_difference_quotients) {
  for (const char* file : {"zener.toml", "bridge.toml", "prony.toml", "kelvin_rigid.toml"}) {
    const Scene scene = read_scene(std::string(VCRIT_SCENES "/") + file);
    std::vector<std::string> names{"frequency", "mu0", "du_z"};
    for (const auto& [symbol, value] : scene.elements) names.push_back(to_text(symbol));
    if (scene.mass) names.emplace_back("mass");
    if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
      names.push_back(isotropic->by == Isotropic::By::poisson ? "poisson" : "tangential_ratio");
    for (const std::string& name : names) {
      Sweep sweep{scene, {{"u_z0", {*scene.indentation.value}}}, {}, {}, {}};
      if (!scene.settable.contains(name)) continue;
      sweep.quantities.push_back(parse_swept_quantity("sensitivity:" + name, scene));
      const Variation changing(scene, {name});
      const auto& [symbol, factor, is_poisson, is_left_out] = changing.targets().front();
      const double p = resolve(scene).values().at(symbol) / factor, h = 1e-5;
      const double up = p * (1 + h), down = p * (1 - h);
      const double above = certified_critical_velocity(changing.at({&up, 1})).value;
      const double below = certified_critical_velocity(changing.at({&down, 1})).value;
      const double expected = (above - below) / (above + below) / h;
      BOOST_TEST_CONTEXT(file << " " << name)
      BOOST_TEST(std::abs(swept(sweep).values[1] - expected) < 1e-9 * (1 + std::abs(expected)));
    }
  }
}

BOOST_AUTO_TEST_CASE(words_say_what_the_regime_is_and_whether_eq_24_applies) {
  const SweptTable table = swept(
      sweep_over("elastic.toml", {"amplitude=lin:0.2 um:0.9 um:2", "velocity_ratio=lin:0.5:1.5:2"},
                 {"admissible", "regime"}));
  // 0.9 um is above the indentation: outside the model, without a motion (0).
  const std::vector<double> admissible{1, 1, 0, 0};
  for (std::size_t row = 0; row < 4; ++row)
    BOOST_TEST(table.values[4 * row + 2] == admissible[row]);
  BOOST_TEST(words(parse_swept_quantity("regime", read_scene(VCRIT_SCENES "/elastic.toml")))
                 .at(static_cast<std::size_t>(table.values[3]) - 1) == "stick-slip");
  BOOST_TEST(table.values[7] == 1);
  BOOST_TEST(table.values[11] == 0);
  BOOST_TEST(table.values[15] == 0);
}

BOOST_AUTO_TEST_CASE(one_speed_for_all_rows) {
  Sweep sweep = sweep_over("elastic.toml", {"amplitude=lin:0.01 um:0.2 um:4"}, {"friction_ratio"});
  sweep.velocity_ratio = 0.5;
  const SweptTable table = swept(sweep);
  // An elastic contact under a rigid drive: 1 - (du_z/u_z0) G(0.5), G of the closed form.
  const double indentation = *sweep.problem->indentation.value;
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(std::abs(table.values[2 * i + 1] -
                        (1 - table.values[2 * i] / indentation * 0.2014522033336686888)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(rows_outside_the_model_are_told) {
  const SweptTable table = swept(
      sweep_over("elastic.toml", {"velocity_ratio=lin:0.2:0.4:2", "amplitude=lin:0.2 um:0.9 um:2"},
                 {"critical_velocity", "friction_ratio"}));
  BOOST_TEST(table.outside == 2U);
  BOOST_TEST(has(table.reason, "(Eq. 3)"));
  BOOST_TEST(std::isfinite(table.values[3]));
  BOOST_TEST(std::isnan(table.values[6]));
  BOOST_TEST(std::isnan(table.values[7]));
}

// Each row as inadmissible_reasons() has it of a scene of its own, whichever of the axes varies.
BOOST_AUTO_TEST_CASE(rows_that_are_not_admissible_have_no_velocity) {
  for (const char* file : {"kelvin.toml", "zener.toml", "bridge.toml", "prony.toml"}) {
    const Scene scene = read_scene(std::string(VCRIT_SCENES "/") + file);
    const double most = *scene.indentation.value;
    const std::string element = to_text(symbols_of(scene.normal).front());
    const std::string amplitudes = fmt::format("amplitude=lin:{}:{}:7", 0.05 * most, 1.2 * most);
    const std::vector<std::string> others{
        "frequency=log:100 Hz:1 MHz:5", "coefficient=lin:0.1:0.5:3",
        fmt::format("indentation=lin:{}:{}:3", 0.5 * most, 2 * most),
        fmt::format("{}=log:1e5:1e8:5", element)};
    for (const std::string& other : others) {
      const Sweep sweep =
          sweep_over(file, {amplitudes, other}, {"critical_velocity", "admissible"});
      const SweptTable table = swept(sweep);
      const Variation changing(sweep.problem, {sweep.axes[0].name, sweep.axes[1].name});
      std::size_t outside = 0;
      for (std::size_t row = 0; row < table.rows; ++row) {
        const double* const cells = table.values.data() + 4 * row;
        const bool admissible = inadmissible_reasons(changing.at({cells, 2})).empty();
        BOOST_TEST(cells[3] == (admissible ? 1 : 0));
        BOOST_TEST(std::isfinite(cells[2]) == admissible);
        outside += admissible ? 0 : 1;
      }
      BOOST_TEST(table.outside == outside);
      BOOST_TEST(outside > 0U);
      BOOST_TEST(outside < table.rows);
    }
  }
}

BOOST_AUTO_TEST_CASE(mistakes_are_named) {
  Sweep sweep = sweep_over("kelvin.toml", {"mass=lin:1:2:2"}, {"friction_ratio"});
  BOOST_TEST(has(message(sweep), "a friction ratio at no speed"));
  BOOST_TEST(has(message(sweep_over("kelvin.toml", {"mass=lin:1:2:2"},
                                    {"critical_velocity", "admissible", "critical_velocity"})),
                 "critical_velocity twice"));
  sweep.velocity = 1;
  sweep.velocity_ratio = 1;
  BOOST_TEST(has(message(sweep), "several speeds"));
  sweep.velocity_ratio.reset();
  sweep.velocity = 0;
  BOOST_TEST(has(message(sweep), "velocity: found a speed of 0 m/s; expected a finite speed"));
  sweep.velocity.reset();
  sweep.velocity_ratio = -1;
  BOOST_TEST(has(message(sweep), "velocity_ratio: found -1; expected a ratio above 0"));
  sweep.velocity_ratio = std::numeric_limits<double>::infinity();
  BOOST_TEST(has(message(sweep), "velocity_ratio: found ∞; expected a finite ratio"));
  BOOST_TEST(has(message(sweep_over("kelvin.toml", {"mass=lin:1:2:2"}, {"critical_velocity"},
                                    {{"mass", "1 g"}})),
                 "a setting of mass as well"));
  BOOST_TEST(has(message(sweep_over("zener.toml", {"mass=lin:1:0:2", "poisson=lin:0.4:0.6:3"},
                                    {"critical_velocity"})),
                 "up to 0.5"));
  BOOST_TEST(has(message(sweep_over("kelvin.toml", {"mass=lin:1:2:2", "mass=lin:1:2:2"},
                                    {"critical_velocity"})),
                 "the same axis again"));
  BOOST_TEST(
      has(message(sweep_over("kelvin.toml", {"velocity=lin:1:2:2", "velocity_ratio=lin:1:2:2"},
                             {"critical_velocity"})),
          "a second axis of speeds"));
  BOOST_TEST(has(message(sweep_over("kelvin.toml", {"amplitude=lin:1:2:2", "du_z=lin:1:2:2"},
                                    {"critical_velocity"})),
                 "du_z as well as amplitude"));
}

// Elements may be named like quantities; columns of one table may not.
BOOST_AUTO_TEST_CASE(an_axis_named_like_a_quantity_is_refused) {
  const auto with = [](const std::string& element, const std::string& quantity) {
    const Scene scene = test::scene_of({.normal = "spring(" + element + ") | c1",
                                        .tangential = "k2",
                                        .elements = {{element, 7}, {"c1", 2}, {"k2", 5}}});
    Sweep sweep{scene, {parse_axis(element + "=lin:1:2:2", scene)}, {}, {}, {}};
    sweep.quantities.push_back(parse_swept_quantity(quantity, scene));
    sweep.velocity_ratio = 0.5;
    return message(sweep);
  };
  for (const char* name :
       {"regime", "admissible", "critical_velocity", "friction_ratio", "friction_ratio_error"}) {
    BOOST_TEST(has(with(name, name), std::string("an axis named like the quantity ") + name));
    BOOST_TEST(with(name, "sensitivity:k2") == "accepted");
  }
  BOOST_TEST(has(with("sensitivity_k2", "sensitivity:k2"), "named like the quantity"));
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
