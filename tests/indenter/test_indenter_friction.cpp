// Friction of indenters: 20-digit references by another formulation, closed forms, and what it may
// not depend on.
#include <tbb/global_control.h>

#include <boost/math/quadrature/trapezoidal.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "indenter/friction.hpp"
#include "indenter/half_spaces.hpp"
#include "simulation/reference_tables.hpp"
#include "support/scene_text.hpp"
#include "support/table.hpp"

BOOST_AUTO_TEST_SUITE(test_indenter_friction)

namespace {

using namespace vcrit;
using namespace vcrit::indenter;
using simulation::Regime;

constexpr double indentation = 5e-7;  // u_z0 throughout, m
const std::string parabola = "shape = \"parabola\"\nradius = \"10 mm\"";

const std::string zener = "k0 | maxwell(k1, c1)";
// k1/k0 = 2, and c1 = k1/omega to 16 digits.
const std::string zener_elements = "k0 = \"5 GPa\"\nk1 = \"10 GPa\"\nc1 = 79577.47154594767";
const std::string kelvin = "k0 | c0", kelvin_elements = "k0 = \"5 GPa\"\nc0 = \"20 kPa s\"";
const std::string prony = "k0 | maxwell(k1, c1) | maxwell(k2, c2)";
const std::string prony_elements =
    "k0 = \"1 GPa\"\nk1 = \"3 GPa\"\nc1 = \"3 kPa s\"\nk2 = \"4 GPa\"\nc2 = \"4 MPa s\"";

HalfSpace elastic(double amplitude) {
  return HalfSpace(reference::scene_of(parabola, indentation, amplitude * indentation));
}

HalfSpace viscoelastic(double amplitude, const std::string& network, const std::string& elements) {
  return HalfSpace(
      reference::scene_of(parabola, indentation, amplitude * indentation, network, elements));
}

// v* of the elastic half-space times a part of it.
double velocity(double amplitude, double part) {
  return part * reference::elastic_critical_velocity(amplitude * indentation);
}

struct Reference {
  std::string name;
  HalfSpace half_space;
  double velocity, ratio, normal_force, digits;
};

std::string indenter_of(const std::string& shape) {
  if (shape == "cone") return "shape = \"cone\"\nangle = 0.02";
  if (shape == "flat") return "shape = \"flat\"\nradius = \"1 mm\"";
  return shape == "power" ? "shape = \"power\"\nprefactor = 1e4\nexponent = 3" : parabola;
}

// shape, exponent, network, D, w, friction_ratio, normal_force
std::vector<Reference> references() {
  std::vector<Reference> result;
  for (const auto& row : test::rows_of("indenter_friction.csv", 44)) {
    const double amplitude = std::stod(row.at(3)), part = std::stod(row.at(4));
    const bool spring = row.at(2) == "1 0";
    const HalfSpace half_space(reference::scene_of(indenter_of(row.at(0)), indentation,
                                                   amplitude * indentation, spring ? "k0" : zener,
                                                   spring ? "k0 = \"5 GPa\"" : zener_elements));
    const double unit = 2 * half_space.static_modulus() * indentation * half_space.radius();
    result.push_back({row.at(0) + " " + row.at(3) + " " + row.at(4), half_space,
                      velocity(amplitude, part), std::stod(row.at(5)), unit * std::stod(row.at(6)),
                      // The elastic ones are right to all digits of a double, the others to 13.
                      spring ? 2e-16 : 1e-13});
  }
  return result;
}

// <(1 + D sin t)^{3/2}> without negative parts; between its zeros by the trapezoidal rule in a
// variable that makes it periodic.
double mean_depth_power(double amplitude) {
  const double pi = std::numbers::pi;
  const double last = amplitude > 1 ? std::acos(-1 / amplitude) : pi;  // of cos
  const auto f = [&](double s) {
    const double t = last * std::sin(s);
    const double now = std::max(0.0, 1 + amplitude * std::cos(t));
    return now * std::sqrt(now) * last * std::cos(s);
  };
  const auto whole = [&](double t) { return std::pow(1 + amplitude * std::cos(t), 1.5); };
  if (amplitude < 1) return boost::math::quadrature::trapezoidal(whole, -pi, pi, 1e-14) / (2 * pi);
  return boost::math::quadrature::trapezoidal(f, -pi / 2, pi / 2, 1e-14) / (2 * pi);
}

}  // namespace

BOOST_AUTO_TEST_CASE(agrees_with_references) {
  const auto all = references();
  BOOST_REQUIRE(all.size() == 44u);
  for (const Reference& row : all) {
    const Friction found = friction(row.half_space, row.velocity, 1e-13);
    BOOST_TEST(std::abs(found.ratio - row.ratio) <= found.error + row.digits, row.name);
    BOOST_TEST(std::abs(found.normal_force - row.normal_force) <=
                   found.normal_force_error + row.digits * row.normal_force,
               row.name);
    // Asked for 1e-13, and some hundred rounding errors of cells and sums.
    BOOST_TEST(found.error <= 2e-13, row.name);
    BOOST_TEST(found.normal_force_error <= 2e-13 * found.normal_force, row.name);
    // Both starts end in one motion, right to some hundred rounding errors.
    BOOST_TEST(found.disagreement <= 1e-13, row.name);
  }
}

BOOST_AUTO_TEST_CASE(errors_are_as_stated) {
  for (const Reference& row : references())
    for (double tolerance = 1e-2; tolerance > 1e-14; tolerance /= 10) {
      const Friction found = friction(row.half_space, row.velocity, tolerance);
      BOOST_TEST(std::abs(found.ratio - row.ratio) <= found.error + row.digits,
                 row.name << " " << tolerance);
      BOOST_TEST(std::abs(found.normal_force - row.normal_force) <=
                     found.normal_force_error + row.digits * row.normal_force,
                 row.name << " " << tolerance);
      BOOST_TEST(found.error <= tolerance + 1e-13, row.name << " " << tolerance);
    }
}

// Known from the closed form of each cell, to the digits given.
BOOST_AUTO_TEST_CASE(parabola_of_half_the_depth) {
  const std::pair<double, double> table[] = {{0.1, .494772572883},
                                             {0.25, .669307667027},
                                             {0.5, .862834162133},
                                             {0.75, .967325676821},
                                             {0.9, .994875124107}};
  for (const auto& [part, expected] : table)
    BOOST_TEST(std::abs(friction(elastic(0.5), velocity(0.5, part)).ratio - expected) <= 1e-9);
}

// At rest a cell keeps its least friction bound: together the least normal force, (1 - D)^{3/2}. At
// a speed v each carries at most ratio E* dx v T more, T the period, and none less.
BOOST_AUTO_TEST_CASE(static_limit) {
  constexpr double part = 1e-8;
  for (const double amplitude : {0.05, 0.5, 0.9, 1.0}) {
    const double force = 2.0 / 3 * mean_depth_power(amplitude);  // in E* u_z0 a
    const double limit = std::pow(1 - amplitude, 1.5) / mean_depth_power(amplitude);
    const double more = 2 * std::numbers::pi * part * amplitude * std::sqrt(1 + amplitude) / force;
    const Friction found = friction(elastic(amplitude), velocity(amplitude, part));
    BOOST_TEST(found.ratio >= limit - found.error);
    BOOST_TEST(found.ratio <= limit + more + found.error);
  }
}

// Hertz: F_n = 4/3 E* sqrt(R) u_z^{3/2} at each instant.
BOOST_AUTO_TEST_CASE(normal_force_of_a_parabola) {
  for (const double amplitude : {0.05, 0.5, 0.99, 1.5, 10.0}) {
    const HalfSpace h = elastic(amplitude);
    const double expected = 4.0 / 3 * h.static_modulus() * std::sqrt(0.01 * indentation) *
                            indentation * mean_depth_power(amplitude);
    const Friction found = friction(h, velocity(amplitude, 0.5), 1e-13);
    // The trapezoidal rule is asked for 1e-14.
    const double error = 1e-13 * expected;
    BOOST_TEST(std::abs(found.normal_force - expected) <= found.normal_force_error + error);
  }
}

// A cone that is mostly open, on a half-space of mostly damper (omega c0/k0 = 50.3): cells that
// touch for a moment carry a part in 1e12 and are left out. Each cell touches until u + r u' = 0,
// creeps back as exp(-t/r), and meets the surface again where that is as deep as it; integrated
// over the depths from -D to 1, at 34 digits, in units of 2 E*(0) u_z0 a. Twenty roundings of these
// units.
BOOST_AUTO_TEST_CASE(normal_force_of_cells_that_hardly_close) {
  for (const auto& [amplitude, expected] :
       {std::pair(3.0, 7.564043843228346301), std::pair(30.0, 454.00454047409717651)}) {
    const HalfSpace h(reference::scene_of(indenter_of("cone"), indentation, amplitude * indentation,
                                          kelvin, "k0 = \"5 GPa\"\nc0 = \"2 MPa s\""));
    const Friction found = friction(h, velocity(amplitude, 0.3), 1e-14);
    const double unit = 2 * h.static_modulus() * indentation * h.radius();
    BOOST_TEST(std::abs(found.normal_force / unit - expected) <=
               found.normal_force_error / unit + 20 * 0x1p-53 * expected);
    BOOST_TEST(found.normal_force_error <= 1e-11 * found.normal_force);
  }
}

// In sliding the tangential strain is mu0/ratio times the normal one, so that the contact point
// moves at v - mu0/ratio u_z' while it touches.
BOOST_AUTO_TEST_CASE(critical_velocity_of_an_elastic_half_space) {
  for (const double amplitude : {0.05, 0.5, 1.0, 3.0}) {
    const HalfSpace h = elastic(amplitude);
    const double expected = velocity(amplitude, 1);
    BOOST_TEST(std::abs(sliding_threshold(h).drive_velocity / expected - 1) <= 1e-14);
    const Friction above = friction(h, expected * (1 + 1e-9));
    BOOST_TEST((above.regime == Regime::sliding_separated));
    BOOST_TEST(std::abs(above.ratio - 1) <= above.error);
    const Friction below = friction(h, expected * (1 - 1e-3));
    BOOST_TEST((below.regime == Regime::stick_slip_separated));
    BOOST_TEST(below.ratio + below.error < 1);
  }
}

// At most that of the elastic one, whatever the network: it is reached where a cell touches when
// the indenter sinks fastest, and else it is less.
BOOST_AUTO_TEST_CASE(critical_velocity_of_viscoelastic_half_spaces) {
  int less = 0;
  for (const auto& [network, elements] :
       {std::pair(kelvin, kelvin_elements), std::pair(zener, zener_elements),
        std::pair(prony, prony_elements)})
    for (const double amplitude : {0.5, 1.0, 3.0}) {
      const HalfSpace h = viscoelastic(amplitude, network, elements);
      const double threshold = simulation::sliding_threshold(h.cell(0)).drive_velocity;
      const double found = sliding_threshold(h).drive_velocity, most = velocity(amplitude, 1);
      BOOST_TEST(found >= threshold);
      BOOST_TEST(found <= most * (1 + 1e-12));
      less += found < most * (1 - 1e-12) ? 1 : 0;
      const Friction above = friction(h, found * (1 + 1e-9));
      BOOST_TEST((above.regime == Regime::sliding_separated));
      const Friction below = friction(h, found * (1 - 1e-3));
      BOOST_TEST((below.regime == Regime::stick_slip_separated));
      BOOST_TEST(below.ratio < above.ratio);
    }
  BOOST_TEST(less == 2);  // the prony, with amplitudes of 1 and 3
}

BOOST_AUTO_TEST_CASE(any_number_of_threads) {
  const HalfSpace h = viscoelastic(0.5, zener, zener_elements);
  const auto found = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return friction(h, velocity(0.5, 0.3), 1e-10);
  };
  const Friction one = found(1), many = found(7);
  BOOST_TEST(one.ratio == many.ratio);
  BOOST_TEST(one.error == many.error);
  BOOST_TEST(one.normal_force == many.normal_force);
  BOOST_TEST(one.cells == many.cells);
}

// A power's friction depends on D and v/v* alone.
BOOST_AUTO_TEST_CASE(scales) {
  const std::string text = reference::scene_of(parabola, indentation, 0.5 * indentation).text;
  const auto of = [&](const Settings& settings, double speed) {
    return friction(HalfSpace(parse_scene(text, "scene.toml", settings)), speed, 1e-12);
  };
  const double v = velocity(0.5, 0.4);
  const Friction first = of({}, v);
  for (const Friction& other :
       {of({{"k0", "123 MPa"}}, v), of({{"radius", "7 m"}}, v),
        of({{"frequency", "3 Hz"}}, v * 3 / 20e3), of({{"mu0", "0.9"}}, 3 * v),
        of({{"amplitude", "1 mm"}, {"indentation", "2 mm"}}, v * 4000)})
    BOOST_TEST(std::abs(other.ratio - first.ratio) <= other.error + first.error);
}

// Straight lines between 100 rows: g is off by 1.2 h^{3/2} x^{1/2}/R at most (test_gap.cpp), of
// changing sign; h is a 50th of the radius, and friction changes by no more than the depth does.
BOOST_AUTO_TEST_CASE(table_of_a_parabola) {
  Scene scene = reference::scene_of(parabola, indentation, 0.5 * indentation);
  const Friction smooth = friction(HalfSpace(scene), velocity(0.5, 0.4));
  Indenter table{Indenter::Shape::table, {}, Profile{"table.csv", {}}};
  for (int i = 0; i <= 100; ++i) {
    const double r = std::sqrt(0.01 * indentation) * i / 50;
    table.profile->rows.push_back({r, r * r / 0.02});
  }
  scene.indenter = table;
  const Friction lines = friction(HalfSpace(scene), velocity(0.5, 0.4), 1e-6);
  BOOST_TEST(lines.error <= 1.1e-6);
  const Friction finer = friction(HalfSpace(scene), velocity(0.5, 0.4), 1e-12);
  BOOST_TEST(std::abs(lines.ratio - finer.ratio) <= lines.error + finer.error);
  BOOST_TEST(std::abs(lines.ratio - smooth.ratio) <= 1.2 * std::pow(50, -1.5));
  // Cut at half the radius of contact, its rim holds cells that never open.
  table.profile->rows.resize(26);
  scene.indenter = table;
  const Friction cut = friction(HalfSpace(scene), velocity(0.5, 0.4));
  BOOST_TEST((cut.regime == Regime::stick_slip));
  BOOST_TEST(cut.ratio > smooth.ratio);
}

BOOST_AUTO_TEST_CASE(single_cells) {
  const HalfSpace h = elastic(0.5);
  const auto some = cells(h, velocity(0.5, 0.4), 200, 16);
  BOOST_REQUIRE(some.size() == 200u);
  BOOST_TEST(some.front().x == 0);
  double force = 0, friction_force = 0;
  for (const CellMotion& cell : some) {
    BOOST_TEST(cell.state.cycle.size() == 16u);
    const double width = (cell.x == 0 ? 1 : 2) * h.edge() / 200;  // and as much at -x
    force += width * cell.mean_normal_force;
    friction_force += width * cell.mean_normal_force * cell.state.friction_ratio;
  }
  // The trapezoidal rule, with f_n'' of some 2 f_n(0)/edge^2: 1/(6 200^2) of the force.
  const Friction whole = friction(h, velocity(0.5, 0.4));
  BOOST_TEST(std::abs(force / whole.normal_force - 1) <= 1e-5);
  BOOST_TEST(std::abs(friction_force / force - whole.ratio) <= 1e-5);
}

BOOST_AUTO_TEST_CASE(curve) {
  const HalfSpace h = elastic(2);
  const std::vector<double> speeds{velocity(2, 0.9), velocity(2, 0.25), velocity(2, 1.5)};
  const auto points = friction_curve(h, speeds);
  BOOST_REQUIRE(points.size() == 3u);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    BOOST_REQUIRE(points[i].friction.has_value());
    BOOST_TEST(points[i].reason.empty());
    BOOST_TEST(points[i].friction->ratio == friction(h, speeds[i]).ratio);
  }
}

// A bound on the work of all cells together, the same for any number of threads.
BOOST_AUTO_TEST_CASE(cells_share_their_effort) {
  const HalfSpace h = viscoelastic(2, prony, prony_elements);
  const double speed = 0.5 * sliding_threshold(h).contact_velocity;
  const std::vector<std::function<void(const HalfSpace&)>> questions{
      [&](const HalfSpace& each) { friction(each, speed); },
      [](const HalfSpace& each) { sliding_threshold(each); },
      [](const HalfSpace& each) { last_stick(each); }};
  for (const auto& ask : questions) {
    constexpr std::size_t plenty = 4'000'000'000;
    simulation::SharedEffort whole(plenty);
    ask(h.within(whole));
    const std::size_t needed = plenty - whole.left();
    BOOST_TEST(needed > 0U);
    for (const std::size_t threads : {1, 2}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      simulation::SharedEffort enough(needed), too_little(needed - 1);
      BOOST_CHECK_NO_THROW(ask(h.within(enough)));
      BOOST_CHECK_THROW(ask(h.within(too_little)), ModelError);
    }
  }
}

// All cells of a punch are the same, and no other shape's are.
BOOST_AUTO_TEST_CASE(only_cells_that_differ_are_evaluated) {
  for (const double amplitude : {0.5, 2.0}) {
    const auto cells = [&](const std::string& shape) {
      const HalfSpace h(
          reference::scene_of(indenter_of(shape), indentation, amplitude * indentation));
      return friction(h, velocity(amplitude, 0.5)).cells;
    };
    BOOST_TEST(cells("flat") == 1);
    BOOST_TEST(cells("cone") > 20);  // the nodes of one panel
  }
}

// A punch that opens by 6e-9 of its indentation is taken for one that does not, and its error says
// so; where only some cells hardly open, it is theirs alone.
BOOST_AUTO_TEST_CASE(least_separation) {
  const std::string punch = indenter_of("flat");
  const HalfSpace opening(reference::scene_of(punch, indentation, (1 + 6e-9) * indentation));
  const Friction found = friction(opening, velocity(1 + 6e-9, 0.5));
  // D = 1 of the references.
  BOOST_TEST(std::abs(found.ratio - 0.7985477966663313) <= found.error);
  BOOST_TEST(found.error <= 1e-7);
  for (const double amplitude : {0.1, 0.25, 0.6})
    BOOST_TEST(
        friction(viscoelastic(amplitude, kelvin, kelvin_elements), velocity(amplitude, 0.1), 1e-13)
            .error <= 1e-12);
}

// The indenter only dips into a surface that hardly comes back: at the edge forces are lost in
// rounding errors.
BOOST_AUTO_TEST_CASE(dips_into_a_strongly_damped_surface) {
  const HalfSpace h(
      reference::scene_of(parabola, 0, 1e-6, kelvin, "k0 = \"5 GPa\"\nc0 = \"2 MPa s\""));
  for (const double part : {0.01, 0.1, 0.5}) {
    const Friction found = friction(h, part * reference::elastic_critical_velocity(1e-6));
    BOOST_TEST(found.error > 0);
    BOOST_TEST(found.error <= 1.1e-9);
    BOOST_TEST(found.ratio <= 1 + found.error);
  }
}

// As good as elastic: cells at the rim, which hardly touch, find sticks of some roundings at speeds
// at which all of them slide.
BOOST_AUTO_TEST_CASE(sticks_of_rounding_are_none) {
  const HalfSpace half_space(
      test::scene_of({.normal = "k0 | kelvin(k1, c2)",
                      .poisson = 0.21916462755777888,
                      .separation = true,
                      .indenter = "shape = \"cone\"\nangle = \"0.7 deg\"\n",
                      .angular_frequency = 15.6,
                      .amplitude = 5.7e-7,
                      .indentation = 7.3e-7,
                      .coefficient = 0.12,
                      .elements = {{"k0", 4.4e15}, {"k1", 3e10}, {"c2", 4.3}}}));
  // mu0 omega du_z K_n/K_t
  const double border =
      0.12 * 15.6 * 5.7e-7 * (2 - 0.21916462755777888) / (2 * (1 - 0.21916462755777888));
  for (const double part : {1.01, 1.02, 1.03, 1.04, 1.05, 1.1})
    BOOST_TEST((friction(half_space, part * border).regime == Regime::sliding_separated), part);
  BOOST_TEST((friction(half_space, 0.99 * border).regime == Regime::stick_slip_separated));
}

// Nothing oscillates, so nothing ever sticks.
BOOST_AUTO_TEST_CASE(without_oscillation) {
  const Friction found = friction(elastic(0), 1e-3);
  BOOST_TEST((found.regime == Regime::sliding));
  BOOST_TEST(found.ratio == 1);
}

BOOST_AUTO_TEST_SUITE_END()
