// Contacts that a given mean normal force presses: the depth that carries it and the friction then,
// against tables, against the same scene with that depth given, and against what was proved of it.
#include "answers/under_load.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "answers/closed_share.hpp"
#include "answers/critical_onset.hpp"
#include "answers/effect.hpp"
#include "answers/friction.hpp"
#include "base/errors.hpp"
#include "indenter/friction.hpp"
#include "normal/mean_indentation.hpp"
#include "normal/normal_force.hpp"
#include "rules/rulebook.hpp"
#include "simulation/reference_tables.hpp"
#include "simulation/steady/normal_force.hpp"
#include "support/scene_text.hpp"
#include "support/table.hpp"

BOOST_AUTO_TEST_SUITE(test_under_load)

using namespace vcrit;

namespace {

/// "k | c | ..." of such elements, whose values are added.
std::string network_of(const Relaxation& form, const std::string& name, test::Elements& elements) {
  std::string text;
  const auto add = [&](const std::string& element, double value, const std::string& written) {
    elements.emplace_back(element, value);
    text += (text.empty() ? "" : " | ") + written;
  };
  if (form.equilibrium > 0) add("k" + name, form.equilibrium, "k" + name);
  if (form.damper > 0) add("c" + name, form.damper, "c" + name);
  for (std::size_t i = 0; i < form.branches.size(); ++i) {
    const std::string number = name + std::to_string(i + 1);
    const auto& [stiffness, time] = form.branches[i];
    elements.emplace_back("c" + number, stiffness * time);
    add("k" + number, stiffness, "(k" + number + " - c" + number + ")");
  }
  return text;
}

struct Row {
  explicit Row(const std::vector<std::string>& c)
      : id(c.at(0)),
        force(std::stod(c.at(8))),
        indentation(std::stod(c.at(9))),
        velocity(std::stod(c.at(10))),
        friction_ratio(std::stod(c.at(11))) {
    text.angular_frequency = 1;
    text.coefficient = std::stod(c.at(6));
    text.amplitude = std::stod(c.at(7));
    text.separation = indentation < std::stod(c.at(7)) || c.at(1) == "parabola";
    if (c.at(1) == "parabola") {
      text.normal = "spring(E)";
      text.elements = {{"E", std::stod(c.at(2))}};
      text.indenter = "shape = \"parabola\"\nradius = 1.0\n";
      return;
    }
    text.normal = network_of(reference::network(c.at(2)), "n", text.elements);
    text.tangential = network_of(reference::network(c.at(3)), "t", text.elements);
    if (c.at(4) == "rigid") return;
    text.mass = std::stod(c.at(5));
    const std::vector<std::string> numbers = test::split(c.at(4), ' ');
    if (numbers.size() < 5) {
      text.network = network_of(reference::network(c.at(4)), "d", text.elements);
      return;
    }
    text.network = "(kd | cd) - (mass(md) | ke | ce)";
    const char* names[] = {"kd", "cd", "md", "ke", "ce"};
    for (std::size_t i = 0; i < 5; ++i) text.elements.emplace_back(names[i], std::stod(numbers[i]));
  }

  Scene under_load() const {
    test::SceneText given = text;
    given.force = force;
    return test::scene_of(given);
  }
  Problem with_indentation(double depth) const {
    Scene scene = test::scene_of(text);
    Problem problem = scene;
    return problem.with({{problem->indentation.symbol, depth}});
  }

  std::string id;
  test::SceneText text;
  double force, indentation, velocity, friction_ratio;
};

std::vector<Row> rows() {
  std::vector<Row> all;
  for (const auto& cells : test::rows_of("load_reference.csv", 20)) all.emplace_back(cells);
  return all;
}

Problem kelvin(double force, double amplitude, bool separation = true) {
  return test::scene_of({.normal = "kn | cn",
                         .tangential = "kt | ct",
                         .separation = separation,
                         .angular_frequency = 1,
                         .amplitude = amplitude,
                         .force = force,
                         .coefficient = 0.3,
                         .elements = {{"kn", 1}, {"cn", 0.5}, {"kt", 0.8}, {"ct", 0.4}}});
}

}  // namespace

// Depth and friction to 1e-10; the parabola's rows have 13 digits, and its friction is asked for to
// 1e-11 of a quadrature of cells.
BOOST_AUTO_TEST_CASE(depth_and_friction_are_those_of_the_table) {
  constexpr double tolerance = 1e-10;
  int moved = 0;
  for (const Row& row : rows()) {
    const Problem problem = row.under_load();
    const double depth = simulation::mean_indentation(problem);
    BOOST_TEST(std::abs(depth - row.indentation) < tolerance, row.id << ": " << depth);
    if (problem->indenter) {
      const auto found = indenter::friction(indenter::HalfSpace(problem), row.velocity, 1e-11);
      BOOST_TEST(std::abs(found.ratio - row.friction_ratio) < tolerance, row.id);
      BOOST_TEST(std::abs(found.normal_force - row.force) < tolerance * row.force, row.id);
      ++moved;
    } else {
      const auto found = SteadyFriction(problem).at(row.velocity);
      BOOST_TEST(std::abs(found.friction_ratio - row.friction_ratio) < tolerance, row.id);
      ++moved;
    }
  }
  BOOST_TEST(moved == 20);
}

// The same to 1e-13, a few hundred roundings: the same motion but for the depth's own rounding,
// which friction follows with a slope of about 1/du_z.
BOOST_AUTO_TEST_CASE(a_load_is_the_scene_with_its_indentation) {
  for (const Row& row : rows()) {
    const Problem problem = row.under_load();
    if (problem->indenter) continue;
    if (row.indentation < 0) continue;  // a scene may not say so
    const Problem same = row.with_indentation(simulation::mean_indentation(problem));
    BOOST_TEST(std::abs(SteadyFriction(problem).at(row.velocity).friction_ratio -
                        SteadyFriction(same).at(row.velocity).friction_ratio) < 1e-13,
               row.id);
    BOOST_TEST(critical_onset(problem).contact_velocity == critical_onset(same).contact_velocity,
               boost::test_tools::tolerance(1e-13));
  }
}

// Elastic: <F_n> = (k/pi)(sqrt(D^2 - u^2) + u arccos(-u/D)), with the slope k arccos(-u/D)/pi.
BOOST_AUTO_TEST_CASE(the_slope_of_an_elastic_contact_is_in_closed_form) {
  using std::numbers::pi;
  const simulation::NormalMotion motion{{2, 0, {}}, 0, 1.5};
  const simulation::ContactModes modes = simulation::modes_of(motion, 1);
  for (double u = -1.49; u < 1.5; u += 0.0731) {
    const auto [cycle, slope] = simulation::pressed_cycle(modes, {u, 1.5});
    const double angle = std::acos(-u / 1.5);
    BOOST_TEST(std::abs(cycle.mean - 2 / pi * (std::sqrt(2.25 - u * u) + u * angle)) < 1e-14);
    BOOST_TEST(std::abs(slope - 2 / pi * angle) < 1e-13);
  }
}

// With memory: against differences of second order, which err by 1e-8 relative of a third
// derivative and of the cycle's 1e-14 over 2e-5.
BOOST_AUTO_TEST_CASE(the_slope_is_that_of_the_cycle) {
  for (const char* form : {"1 0.5", "1 0 1:1", "1 0.05 2:0.2 0.7:5", "1 0 0.5:1e4"}) {
    const simulation::NormalMotion motion{reference::network(form), 0, 1};
    const simulation::ContactModes modes = simulation::modes_of(motion, 1);
    double last = 0;
    for (double u = -0.9; u < 1.2; u += 0.15) {
      constexpr double h = 1e-5;
      const auto mean = [&](double at) { return simulation::normal_cycle(modes, {at, 1}).mean; };
      const auto [cycle, slope] = simulation::pressed_cycle(modes, {u, 1});
      BOOST_TEST(cycle.mean == mean(u));
      BOOST_TEST(std::abs(slope - (mean(u + h) - mean(u - h)) / (2 * h)) < 1e-7, form << " " << u);
      BOOST_TEST((slope > 0 && slope <= 1));
      BOOST_TEST(cycle.mean > last);
      last = cycle.mean;
    }
  }
}

// For every load one depth: it grows with the load, by 1/K_n(0) and more.
BOOST_AUTO_TEST_CASE(depth_grows_with_the_load) {
  double before = -1;
  for (double force = 1e-6; force < 3; force *= 1.7) {
    const Problem problem = kelvin(force, 1);
    const double depth = simulation::mean_indentation(problem);
    BOOST_TEST(depth > before);
    BOOST_TEST((depth > -1 && depth <= force));
    BOOST_TEST(std::abs(simulation::mean_normal_force(simulation::system_of(problem)) - force) <
               1e-12 * std::max(force, 1e-2));
    before = depth;
  }
}

BOOST_AUTO_TEST_CASE(a_closed_contact_is_pressed_by_its_springs) {
  const Problem problem = kelvin(1.5, 0.5, false);
  BOOST_TEST(simulation::mean_indentation(problem) == 1.5);
  const Effect effect = effect_of(problem);
  BOOST_TEST(*effect.indentation == 1.5);
  BOOST_TEST(*effect.mean_normal_force == 1.5);
  // W/|K_n|
  BOOST_TEST(*effect.largest_closed_amplitude == 1.5 / std::hypot(1, 0.5),
             boost::test_tools::tolerance(1e-15));
}

// k - c: |K_n| = 1/sqrt 2 at omega = 1, v* as of a contact with the same force, which sinks at W/c.
BOOST_AUTO_TEST_CASE(a_contact_that_creeps_sinks) {
  const auto scene = [](const std::string& separation, double amplitude) -> Problem {
    return test::scene_of({.normal = "kn - cn",
                           .tangential = "kt",
                           .separation = separation.empty() ? test::Toml() : test::Toml(true),
                           .angular_frequency = 1,
                           .amplitude = amplitude,
                           .force = 3.0,
                           .coefficient = 0.3,
                           .elements = {{"kn", 1}, {"cn", 2}, {"kt", 0.8}}});
  };
  const Problem problem = scene("", 1);
  const auto pressed = under_load(problem);
  BOOST_REQUIRE(pressed.has_value());
  BOOST_TEST(!pressed->indentation);
  BOOST_TEST(*pressed->sinking_velocity == 1.5);
  BOOST_TEST(bool{rules::answer(rules::Question::admissible, problem)});
  // K_n = 2 i/(1 + 2 i), the force of an elastic contact whose spring is |K_n| oscillates alike.
  const double stiffness = 2 / std::sqrt(5.0);
  const Problem elastic = test::scene_of({.normal = "kn",
                                          .tangential = "kt",
                                          .angular_frequency = 1,
                                          .amplitude = 1,
                                          .force = 3.0,
                                          .coefficient = 0.3,
                                          .elements = {{"kn", stiffness}, {"kt", 0.8}}});
  const double v = critical_onset(elastic).contact_velocity;
  BOOST_TEST(critical_onset(problem).contact_velocity == v, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::abs(SteadyFriction(problem).at(0.3 * v).friction_ratio -
                      SteadyFriction(elastic).at(0.3 * v).friction_ratio) < 1e-13);
  BOOST_TEST(bool{rules::answer(rules::Question::motion, scene("opens", 1))});
  BOOST_TEST(!rules::answer(rules::Question::motion, scene("opens", 5)));
}

// Elastic, u_z0 < 0: the indentation grows fastest while the contact is open. It closes at u_z = 0,
// with the rate omega sqrt(du_z^2 - u_z0^2), which is what v* is made of then.
BOOST_AUTO_TEST_CASE(a_contact_that_is_open_most_of_the_time_has_another_velocity) {
  int below = 0;
  for (const Row& row : rows()) {
    if (row.id != "L08" && row.id != "L09" && row.id != "L20") continue;
    const Problem problem = row.under_load();
    const double u = row.indentation, ratio = row.id == "L20" ? 17.0 / 14 : 1 / 0.8;
    const CriticalOnset onset = critical_onset(problem);
    BOOST_TEST(onset.contact_velocity == 0.3 * ratio * std::sqrt(1 - u * u),
               boost::test_tools::tolerance(1e-9));
    const bool simulated = onset.by == CriticalOnset::By::simulation;
    if (u < 0) BOOST_TEST(simulated, row.id);
    below += simulated ? 1 : 0;
  }
  BOOST_TEST(below >= 2);
}

// (4): du_z/W has to stay below 1/|K_n|.
BOOST_AUTO_TEST_CASE(the_closed_share_of_a_load_is_a_compliance) {
  const ClosedShare share(kelvin(1, 0.1, false), {"angular_frequency"});
  const std::vector<double> omega{0.5, 1, 7};
  std::vector<double> found(3);
  const std::span<const double> column = omega;
  share({&column, 1}, found);
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(found[i] == 1 / std::hypot(1, 0.5 * omega[i]), boost::test_tools::tolerance(1e-14));
}

// A small amplitude leaves Hertz's depth (3 W/(4 E* sqrt R))^(2/3), but for (3/16) (du_z/u_z0)^2 of
// the force. The cells at the rim, whose depth is lost in rounding, take no work without end.
BOOST_AUTO_TEST_CASE(a_small_amplitude_leaves_the_depth_of_hertz) {
  for (const double amplitude : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Problem problem = test::scene_of({.normal = "spring(E)",
                                            .poisson = 0.3,
                                            .indenter = "shape = \"parabola\"\nradius = 1\n",
                                            .angular_frequency = 1,
                                            .amplitude = amplitude,
                                            .force = 36,
                                            .coefficient = 0.3,
                                            .elements = {{"E", 0.91}}});
    // E* = 1: the depth at rest is 27^(2/3).
    const double share = amplitude / 9, expected = 9 * (1 - share * share / 8);
    BOOST_TEST(simulation::mean_indentation(problem) == expected,
               boost::test_tools::tolerance(1e-11));
  }
}

// Under a flat punch all cells are one contact of the stiffness 2 a E*.
BOOST_AUTO_TEST_CASE(a_flat_punch_is_pressed_as_one_contact) {
  const auto scene = [](const std::string& indenter, double modulus) -> Problem {
    return test::scene_of({.normal = "spring(E) | damper(eta)",
                           .poisson = 0,
                           .separation = true,
                           .indenter = indenter,
                           .angular_frequency = 1,
                           .amplitude = 1,
                           .force = 0.3,
                           .coefficient = 0.3,
                           .elements = {{"E", modulus}, {"eta", 0.5 * modulus}}});
  };
  const double punch = simulation::mean_indentation(scene("shape = \"flat\"\nradius = 2.0\n", 1));
  const double one = simulation::mean_indentation(scene("", 4));
  BOOST_TEST(std::abs(punch - one) < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
