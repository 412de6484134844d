// An indenter on a drive that gives: independent tables, limits, and plain cells in small steps.
#include <fmt/ranges.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "indenter/rim_friction.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/table.hpp"

BOOST_AUTO_TEST_SUITE(test_indenter_on_drive)

namespace {

using namespace vcrit;
using namespace vcrit::indenter;

constexpr double pi = std::numbers::pi;
constexpr double modulus = 0.91 / (1 - 0.3 * 0.3), shear_ratio = 2 * (1 - 0.3) / (2 - 0.3);

struct Case {
  double amplitude, spring, damper = 0, mass = 0;
  double coefficient = 0.3;
  std::string indenter = "shape = \"parabola\"\nradius = 1\n";
  double indentation = 1;
  std::string network = {}, elements = {};
};

Problem problem_held(const Case& c) {
  test::SceneText text{.normal = "spring(E0)", .poisson = 0.3, .separation = true};
  text.indenter = c.indenter;
  text.network = !c.network.empty() ? c.network : c.damper > 0 ? "kd | cd" : "kd";
  if (c.mass > 0) text.mass = c.mass;
  text.angular_frequency = 1;
  text.amplitude = c.amplitude;
  text.indentation = c.indentation;
  text.coefficient = c.coefficient;
  text.elements = {{"E0", 0.91}};
  if (c.network.empty() || c.network.find("kd") != std::string::npos)
    text.elements.push_back({"kd", c.spring});
  if (c.damper > 0) text.elements.push_back({"cd", c.damper});
  text.more = c.elements;
  return test::scene_of(text);
}

HalfSpace held(const Case& c) { return HalfSpace(problem_held(c)); }

struct Row {
  std::string id;
  Case scene;
  double critical, velocity, ratio, error, below;
};

std::vector<Row> table() {
  std::vector<Row> rows;
  for (const auto& cells : test::rows_of("coupled_indenter.csv", 8)) {
    const auto number = [&](std::size_t i) { return std::stod(cells[i]); };
    rows.push_back({cells[0],
                    {number(6), number(7), number(8), number(9)},
                    number(10),
                    number(12),
                    number(16),
                    number(17),
                    number(20)});
  }
  return rows;
}

// v* of an elastic parabola on a massless spring, by its formula on a fine grid: flat at its
// maximum, so that 1e-5 of the period tell it to 1e-9 of its curvature.
double massless_threshold(const Case& c) {
  double most = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double t = 2 * pi * i / 200'000, depth = c.indentation + c.amplitude * std::cos(t);
    if (depth <= 0) continue;
    const double shear = shear_ratio * modulus;
    most = std::max(most, -std::sin(t) * (1 + 2 * shear * std::sqrt(depth) / c.spring));
  }
  return c.coefficient / shear_ratio * c.amplitude * most;
}

struct Witness {
  double ratio = 0;
  bool backward = false;
};

// So many cells of equal width, each an elastic spring that slides, and a body by Verlet's method.
Witness by_cells(const Case& c, double velocity, int count, int steps, int periods) {
  const double edge = std::sqrt(c.indentation + c.amplitude), width = edge / count;
  const double shear = shear_ratio * modulus, h = 2 * pi / steps;
  struct Cell {
    double gap, force = 0;
  };
  std::vector<Cell> cells;
  for (int i = 0; i < count; ++i) cells.push_back({std::pow((i + 0.5) * width, 2)});
  double normal = 0;
  const auto friction = [&](double t, double moved) {
    const double depth = c.indentation + c.amplitude * std::cos(t);
    double sum = 0;
    normal = 0;
    for (Cell& cell : cells) {
      const double bound = c.coefficient * modulus * std::max(0.0, depth - cell.gap);
      cell.force = std::clamp(cell.force + shear * moved, -bound, bound);
      sum += 2 * width * cell.force;
      normal += 2 * width * bound;
    }
    return sum;
  };
  double place = 0, speed = 0, force = friction(0, 0), all = 0, most = 0;
  for (int i = 0; i < steps * periods; ++i) {
    const double half = speed + 0.5 * h * (-c.spring * place - c.damper * speed - force) / c.mass;
    place += h * half;
    force = friction(h * (i + 1), h * (velocity + half));
    speed =
        (half + 0.5 * h * (-c.spring * place - force) / c.mass) / (1 + 0.5 * h * c.damper / c.mass);
    if (i < steps * (periods - 1)) continue;
    all += force;
    most += normal;
  }
  return {all / most};
}

}  // namespace

// v* of the table was the largest value on a grid of phases.
BOOST_AUTO_TEST_CASE(critical_velocities_of_the_table) {
  for (const Row& row : table())
    BOOST_TEST(rim_threshold(held(row.scene)).drive_velocity == row.critical,
               boost::test_tools::tolerance(2e-12));
}

// To the error that the table states, and 12 printed digits.
BOOST_AUTO_TEST_CASE(friction_of_the_table) {
  for (const Row& row : table()) {
    const Friction found = friction(held(row.scene), row.velocity);
    BOOST_TEST(std::abs(found.ratio - row.ratio) <= row.error + found.error + 5e-13, row.id);
    BOOST_TEST(found.error < 1e-9, row.id);
    BOOST_TEST(found.cells == 0);
    // The table's by cells, off by up to 6e-7.
    const Friction below = friction(held(row.scene), 0.98 * row.critical);
    BOOST_TEST(std::abs(below.ratio - row.below) < 7e-7, row.id);
    BOOST_TEST(below.ratio < 1);
    BOOST_TEST(friction(held(row.scene), 1.002 * row.critical).ratio == 1);
  }
}

BOOST_AUTO_TEST_CASE(critical_velocity_on_a_massless_spring) {
  for (const Case& c : {Case{0.5, 0.5}, Case{0.9, 40}, Case{1.4, 3}, Case{0.01, 1}})
    BOOST_TEST(rim_threshold(held(c)).drive_velocity == massless_threshold(c),
               boost::test_tools::tolerance(1e-8));
}

// 400 cells and 8000 steps err by some 1e-5 in ratios of 0.1 to 0.4, by halving both; bodies that
// swing far slide back, too.
BOOST_AUTO_TEST_CASE(plain_cells_agree) {
  for (const auto& [c, share] :
       {std::pair{Case{0.7, 1.2, 0.3, 0.5}, 0.2}, std::pair{Case{0.7, 1.2, 0.05, 0.5}, 0.1},
        std::pair{Case{0.7, 1.2, 0.05, 0.5}, 0.03}, std::pair{Case{1.3, 2, 0.1, 0.3}, 0.05},
        std::pair{Case{0.5, 9, 0.02, 1}, 0.03}}) {
    const HalfSpace half_space = held(c);
    const double velocity = share * rim_threshold(half_space).drive_velocity;
    const Friction found = friction(half_space, velocity);
    const Witness cells = by_cells(c, velocity, 200, 4000, 60);
    BOOST_TEST_CONTEXT(c.amplitude << " " << c.spring << " " << share)
    BOOST_TEST(std::abs(found.ratio - cells.ratio) < 3e-5);
  }
}

// Its rim slides back, since a body that swings far comes back faster than the rim opens.
BOOST_AUTO_TEST_CASE(a_rim_slides_back) {
  const HalfSpace half_space = held({0.7, 1.2, 0.05, 0.5});
  const double critical = rim_threshold(half_space).drive_velocity;
  BOOST_TEST(int(friction(half_space, 0.03 * critical).regime) ==
             int(simulation::Regime::stick_slip_backslip_separated));
}

// On a soft drive with losses, cells that slid back together turn as one: at the instant at which
// their layer is used up no rim is left, either.
BOOST_AUTO_TEST_CASE(cells_that_slid_together_turn_together) {
  const Case soft{0.18, 0.2, 0.33, 0.34};
  const HalfSpace half_space = held(soft);
  const double critical = rim_threshold(half_space).drive_velocity;
  double before = 0;
  for (int i = 1; i <= 60; ++i) {
    const Friction found = friction(half_space, critical * i / 61);
    BOOST_TEST(found.ratio >= before - found.error);
    before = found.ratio;
  }
  for (const double share : {0.1, 0.4}) {
    const Witness cells = by_cells(soft, share * critical, 200, 4000, 60);
    BOOST_TEST(std::abs(friction(half_space, share * critical).ratio - cells.ratio) < 3e-5);
  }
}

// A stiffer drive leads to the cells under a rigid one, in proportion to 1/k_d. The reference has
// 17 digits, from closed forms of the cells, at half the v* of a rigid drive.
BOOST_AUTO_TEST_CASE(a_stiff_drive_is_rigid) {
  constexpr double rigid = 0.78905772572136493, velocity = 0.5 * 0.3 / shear_ratio * 0.9;
  const double soft = friction(held({0.9, 1e5}), velocity).ratio - rigid,
               stiff = friction(held({0.9, 1e7}), velocity).ratio - rigid;
  BOOST_TEST(soft / stiff == 100, boost::test_tools::tolerance(0.01));
  BOOST_TEST(std::abs(stiff) < 1e-7);
  BOOST_TEST(friction(held({0.9, 1e12}), velocity).ratio == rigid,
             boost::test_tools::tolerance(2e-12));
  BOOST_TEST(rim_threshold(held({0.9, 1e12})).drive_velocity == 0.3 / shear_ratio * 0.9,
             boost::test_tools::tolerance(1e-11));
}

// All cells are alike: one contact of stiffness 2 a E*.
BOOST_AUTO_TEST_CASE(a_flat_punch_is_one_contact) {
  const HalfSpace punch = held({0.6, 1.5, 0.4, 0.9, 0.3, "shape = \"flat\"\nradius = 0.5\n"});
  test::SceneText text{.normal = "kn",
                       .tangential_ratio = shear_ratio,
                       .network = "kd | cd",
                       .mass = 0.9,
                       .angular_frequency = 1,
                       .amplitude = 0.6,
                       .indentation = 1,
                       .coefficient = 0.3,
                       .elements = {{"kn", 2 * 0.5 * modulus}, {"kd", 1.5}, {"cd", 0.4}}};
  const simulation::System one = simulation::system_of(test::scene_of(text));
  const double critical = simulation::sliding_threshold(one).drive_velocity;
  BOOST_TEST(sliding_threshold(punch).drive_velocity == critical,
             boost::test_tools::tolerance(1e-14));
  for (const double share : {0.1, 0.5, 0.9, 1.1})
    BOOST_TEST(friction(punch, share * critical).ratio ==
                   simulation::steady_state(one, share * critical).friction_ratio,
               boost::test_tools::tolerance(1e-12));
}

// mu0 scales tangential forces and velocities: rounding is left.
BOOST_AUTO_TEST_CASE(friction_does_not_depend_on_its_coefficient) {
  Case c{0.7, 1.2, 0.3, 0.5};
  const double usual = friction(held(c), 0.1).ratio;
  c.coefficient = 0.6;
  BOOST_TEST(friction(held(c), 0.2).ratio == usual, boost::test_tools::tolerance(1e-11));
}

// Energy of the difference of two motions, docs/physics.md; towards rest min F_n/<F_n>, which a
// damped body reaches as the speed does, and a small oscillation lowers nothing.
BOOST_AUTO_TEST_CASE(friction_never_falls_with_the_speed) {
  for (const Case& c : {Case{0.9, 1.647}, Case{1.3, 2, 0.5, 0.3}, Case{0.6, 1.5, 0.4, 0.9}}) {
    const HalfSpace half_space = held(c);
    const double critical = rim_threshold(half_space).drive_velocity;
    const Pressed all = pressed(problem_held(c));
    double before = all.least / all.mean;
    for (const double share : {0.005, 0.02, 0.07, 0.2, 0.5, 0.8, 0.95, 1.1}) {
      const Friction found = friction(half_space, share * critical);
      BOOST_TEST(found.ratio >= before - found.error);
      before = found.ratio;
    }
    BOOST_TEST(before == 1);
  }
  const HalfSpace slow = held({0.5, 0.5});
  const Pressed all = pressed(problem_held({0.5, 0.5}));
  BOOST_TEST(friction(slow, 1e-6).ratio == all.least / all.mean,
             boost::test_tools::tolerance(1e-3));
  const HalfSpace small = held({1e-4, 0.5});
  BOOST_TEST(friction(small, 0.5 * rim_threshold(small).drive_velocity).ratio > 1 - 3e-4);
}

// 4/3 E* sqrt(R) d^(3/2) over a period, by the trapezoidal rule, which is exact to rounding there.
BOOST_AUTO_TEST_CASE(normal_forces) {
  double mean = 0;
  for (int i = 0; i < 1000; ++i) mean += std::pow(1 + 0.9 * std::cos(2 * pi * i / 1000), 1.5);
  mean *= 4.0 / 3 * modulus / 1000;
  const Pressed all = pressed(problem_held({0.9, 1.647}));
  BOOST_TEST(all.mean == mean, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(all.least == 4.0 / 3 * modulus * std::pow(0.1, 1.5),
             boost::test_tools::tolerance(1e-13));
}

// Branches beside the spring, a body on it or none: v* by Fourier's series of the force. Twenty
// were beyond the bound on the work once.
BOOST_AUTO_TEST_CASE(drives_of_several_elements) {
  struct Drive {
    std::vector<double> stiffnesses, times;
    double mass;
  };
  std::vector<Drive> drives{{{0.7}, {1.3 / 0.7}, 0}, {{0.7}, {1.3 / 0.7}, 0.4}, {{}, {}, 0.4}};
  for (int j = 0; j < 20; ++j) {
    drives.back().stiffnesses.push_back(0.05 + 0.01 * (j % 3));
    drives.back().times.push_back(std::pow(10, -1 + 2 * j / 19.0));
  }
  for (const Drive& given : drives) {
    const auto more = fmt::format("k = [{}]\ntau = [{}]\n", fmt::join(given.stiffnesses, ", "),
                                  fmt::join(given.times, ", "));
    const HalfSpace half_space =
        held({0.8, 0.6, 0, given.mass, 0.3, "shape = \"parabola\"\nradius = 1\n", 1,
              "prony(kd, k, tau)", more});
    constexpr int samples = 512, harmonics = 100;  // of a force analytic on the circle
    std::vector<std::complex<double>> swing(harmonics);
    for (int n = 1; n < harmonics; ++n) {
      std::complex<double> force = 0;
      for (int i = 0; i < samples; ++i) {
        const double t = 2 * pi * i / samples;
        force += std::pow(1 + 0.8 * std::cos(t), 1.5) * std::polar(1.0, -n * t);
      }
      force *= 4.0 / 3 * modulus * 2.0 / samples;
      const std::complex<double> s(0, n);
      std::complex<double> drive = 0.6 + given.mass * s * s;
      for (std::size_t j = 0; j < given.times.size(); ++j)
        drive += given.stiffnesses[j] * s / (s + 1 / given.times[j]);
      swing[static_cast<std::size_t>(n)] = s * force / drive;
    }
    double most = 0;
    for (int i = 0; i < 20'000; ++i) {
      const double t = 2 * pi * i / 20'000;
      double rate = -0.8 * std::sin(t) / shear_ratio;
      for (int n = 1; n < harmonics; ++n)
        rate += (swing[static_cast<std::size_t>(n)] * std::polar(1.0, n * t)).real();
      most = std::max(most, 0.3 * rate);
    }
    // 20,000 phases: flat to 1e-8.
    BOOST_TEST(rim_threshold(half_space).drive_velocity == most,
               boost::test_tools::tolerance(3e-8));
    BOOST_TEST(friction(half_space, 0.3 * most).ratio < 1);
  }
}

// A damper alone follows the friction: q' = -mu0 F_n/c, so v* is the largest mu0 (F_n/c +
// u_z'/kappa), on a grid of phases that is flat to 1e-9 at its maximum. At the contact the mean of
// q' is missing.
BOOST_AUTO_TEST_CASE(a_drive_of_a_damper_alone) {
  const HalfSpace half_space =
      held({0.5, 0, 0, 0, 0.3, "shape = \"parabola\"\nradius = 1\n", 1, "cd", "cd = 3\n"});
  double most = 0, mean = 0;
  constexpr int samples = 100'000;
  for (int i = 0; i < samples; ++i) {
    const double t = 2 * pi * i / samples;
    const double force = 4.0 / 3 * modulus * std::pow(1 + 0.5 * std::cos(t), 1.5);
    most = std::max(most, 0.3 * (force / 3 - 0.5 * std::sin(t) / shear_ratio));
    mean += 0.3 * force / 3 / samples;
  }
  const simulation::Onset onset = rim_threshold(half_space);
  BOOST_TEST(onset.drive_velocity == most, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(onset.contact_velocity == most - mean, boost::test_tools::tolerance(1e-8));
  const Friction found = friction(half_space, 0.5 * most);
  BOOST_TEST(found.ratio < 1);
  BOOST_TEST(found.error < 1e-9);
}

// A body of k_d = m (2 omega)^2 swings freely at 2 omega, which a rim makes the force drive.
BOOST_AUTO_TEST_CASE(a_body_in_resonance_with_a_harmonic) {
  const HalfSpace half_space = held({0.5, 4, 0, 1});
  const simulation::Onset onset = rim_threshold(half_space);
  BOOST_TEST(std::isinf(onset.drive_velocity));
  BOOST_TEST(!onset.why_infinite.empty());
  BOOST_TEST(test::refused<ModelError>(
      [] {
        rim_threshold(held({0.5, 4 * (1 + 1e-11), 0, 1}));
      },
      "harmonic 2 of the oscillation, within a part in 1e10"));
}

// Body and drive are at rest as seen from the oscillation: v* = omega du_z mu0 E*/G*, however heavy
// the body.
BOOST_AUTO_TEST_CASE(a_body_too_heavy_to_swing) {
  for (const double mass : {1e13, 1e15, 1e18, 1e24})
    for (const auto& [spring, damper] : {std::pair(1.0, 0.0), {1e4, 0.1}}) {
      const double expected = 0.3 * 0.5 / shear_ratio;
      const HalfSpace half_space = held({0.5, spring, damper, mass});
      BOOST_TEST(rim_threshold(half_space).drive_velocity == expected,
                 boost::test_tools::tolerance(3e-13));
      BOOST_TEST(friction(half_space, 0.5 * expected).ratio < 1);
    }
}

// A branch that hardly relaxes is a spring, but for what relaxes in one period.
BOOST_AUTO_TEST_CASE(a_branch_too_slow_to_relax) {
  const double as_spring = rim_threshold(held({0.5, 7, 0, 0.3})).drive_velocity;
  const double stiffness = 2;
  for (const double damper : {1e11, 1e12, 3e12, 1e13, 3e13, 1e14, 1e16, 1e18}) {
    const HalfSpace half_space = held({.amplitude = 0.5,
                                       .spring = 5,
                                       .mass = 0.3,
                                       .network = "kd | (k2 - c2)",
                                       .elements = fmt::format("k2 = 2\nc2 = {:g}\n", damper)});
    const simulation::Onset onset = rim_threshold(half_space);
    BOOST_TEST_CONTEXT("damper " << damper)
    BOOST_TEST(onset.drive_velocity == as_spring,
               boost::test_tools::tolerance(2e-12 + 2 * pi * stiffness / damper));
  }
}

BOOST_AUTO_TEST_SUITE_END()
