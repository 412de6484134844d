// v* of contacts that open, by what it means: just below it the steady motion sticks or slips
// back, just above it only slips forward. And against an independent program's numbers.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "simulation/random_systems.hpp"
#include "simulation/reference_tables.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "support/refusal.hpp"
#include "support/table.hpp"

BOOST_AUTO_TEST_SUITE(test_forward_sliding)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

bool slips_forward_alone(const System& system, double velocity) {
  return steady_state(system, velocity).regime == Regime::sliding_separated;
}

// Whether the kind of motion changes at v*, by a billionth of it; the steady state next to it is
// not always found, which says nothing of v*.
enum class Border { there, elsewhere, not_found };
Border border(const System& system, double velocity) {
  try {
    return !slips_forward_alone(system, velocity * (1 - 1e-9)) &&
                   slips_forward_alone(system, velocity * (1 + 1e-9))
               ? Border::there
               : Border::elsewhere;
  } catch (const ModelError&) {
    return Border::not_found;
  }
}

std::optional<System> random_system(reference::RandomSystems& random, double largest_mass) {
  System system = random.system();
  const Relaxation normal = random.network(true);
  const double dynamic = std::abs(dynamic_stiffness(normal, 1)), mean = random.uniform(-0.5, 1);
  const double amplitude = random.logarithmic(0.3, 10);
  if (mean + amplitude < 0.1 || dynamic * amplitude < 1.02 * normal.equilibrium * mean)
    return std::nullopt;
  if (system.mass) system.mass = random.logarithmic(0.01, largest_mass);
  system.opening = {normal, mean, amplitude};
  return system;
}

/// A body on a spring, K_d = m n^2 (1 + detuning).
System tuned(int n, double detuning) {
  System system;
  system.contact = {0.7, 0.05, {}};
  system.drive = Relaxation{n * n * (1 + detuning), 0, {}};
  system.mass = 1;
  system.omega = system.friction = 1;
  system.opening = {{1, 0, {}}, 0.5, 1};
  return system;
}

}  // namespace

// 34 digits, two step lengths that agree in 25; all of them with a body.
BOOST_AUTO_TEST_CASE(agrees_with_an_independent_program) {
  for (const auto& c : test::rows_of("opening_onset.csv", 101)) {
    System system;
    system.contact = reference::network(c.at(1));
    system.drive = reference::network(c.at(3));
    system.mass = std::stod(c.at(4));
    system.omega = c.at(9).empty() ? two_pi * std::stod(c.at(8)) : std::stod(c.at(9));
    system.friction = std::stod(c.at(7));
    system.opening = {reference::network(c.at(2)), std::stod(c.at(5)), std::stod(c.at(6))};
    const double velocity = std::stod(c.at(10));
    const Onset found = sliding_threshold(system);
    // Some tens of rounding errors, times a swing of some tens.
    BOOST_TEST(std::abs(found.contact_velocity / velocity - 1) <= 1e-13, c.at(0));
    BOOST_TEST((border(system, found.drive_velocity) == Border::there), c.at(0));
  }
}

BOOST_AUTO_TEST_CASE(is_the_border_of_stick) {
  reference::RandomSystems random(33, 2);
  int tried = 0, infinite = 0, missing = 0;
  while (tried < 1000) {
    const auto system = random_system(random, 30);
    if (!system) continue;
    ++tried;
    const Onset found = sliding_threshold(*system);
    if (std::isinf(found.contact_velocity)) {
      BOOST_TEST(!found.why_infinite.empty());
      ++infinite;
      continue;
    }
    BOOST_TEST(found.contact_velocity > 0);
    const Border here = border(*system, found.drive_velocity);
    BOOST_TEST((here != Border::elsewhere), "system " << tried);
    missing += here == Border::not_found ? 1 : 0;
  }
  BOOST_TEST_MESSAGE(infinite << " infinite, " << missing << " without steady motion");
  BOOST_TEST(infinite < 400);
  BOOST_TEST(missing == 0);
}

// An undamped drive at a harmonic of the force swings without bound; near it, far.
BOOST_AUTO_TEST_CASE(undamped_harmonics) {
  for (const int n : {1, 2, 3, 4, 7, 10}) {
    const Onset at = sliding_threshold(tuned(n, 0));
    BOOST_TEST(std::isinf(at.contact_velocity));
    BOOST_TEST(at.why_infinite.find("harmonic") != std::string::npos);
    double last = 0;
    for (const double detuning : {1e-2, 1e-4, 1e-6, -1e-6})
      BOOST_TEST_CONTEXT(n << " " << detuning) {
        const System system = tuned(n, detuning);
        const Onset near = sliding_threshold(system);
        if (detuning > 0) {
          BOOST_TEST(near.contact_velocity > last);
          last = near.contact_velocity;
        }
        // The swing grows like the inverse of the detuning.
        if (detuning == -1e-6) BOOST_TEST(std::abs(near.contact_velocity / last - 1) < 1e-2);
      }
  }
}

// Closer than doubles tell: refused, or the number to six digits; nothing runs on. The second and
// third harmonic are large in this force.
BOOST_AUTO_TEST_CASE(lost_in_rounding) {
  const auto distance = [](const System& system, int n) {
    return system.drive->equilibrium / (n * n) - 1;  // exact, as both are near 1
  };
  int refused = 0;
  for (const int n : {1, 2, 3})
    for (const double detuning : {1e-7, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15}) try {
        const System near = tuned(n, detuning), far = tuned(n, 2 * detuning);
        const double share =
            sliding_threshold(near).contact_velocity / sliding_threshold(far).contact_velocity;
        BOOST_TEST(std::abs(share / (distance(far, n) / distance(near, n)) - 1) < 1e-5,
                   n << ", " << detuning);
      } catch (const ModelError&) {
        ++refused;
      }
  BOOST_TEST_MESSAGE(refused << " refused");
  BOOST_TEST(refused > 0);
}

// The surface is back within some c of a radian. It closes with the force c u', to which the
// contact point answers by c u'/(c/2): v* = 2 u' where it closes, u = 0. Its rounding error grows
// as that force becomes small beside the others, and has to be said; where nothing is left, that.
BOOST_AUTO_TEST_CASE(a_surface_that_comes_back_at_once_meets_softly) {
  const auto velocity = [](double c) {
    System system;
    system.contact = {1, c / 2, {}};
    system.omega = system.friction = 1;
    system.opening = {{1, c, {}}, 0.3, 1};
    return sliding_threshold(system);
  };
  const double exact = 2 * std::sqrt(1 - 0.09);
  for (const double c : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const Onset found = velocity(c);
    // Less by what is left of the deformation when the contact closes: none after 1/c radians.
    BOOST_TEST(std::abs(found.contact_velocity - exact) <= found.uncertainty, c);
    BOOST_TEST(found.uncertainty <= 1e-14 / c + 1e-14,
               c);  // ten to twenty roundings of a force of 1
  }
  // Beyond 1e-100 the dampers leave the motion, but v* stays 2 u': another number would be wrong.
  for (const double c : {1e-15, 1e-40, 1e-99, 1e-101, 1e-160, 1e-250})
    BOOST_TEST(test::refused<ModelError>([&] { velocity(c); }, "damper of the contact is so weak"),
               c);
}

// What the search stumbled over is not what is wrong.
BOOST_AUTO_TEST_CASE(parts_that_lie_too_far_apart_are_named) {
  const auto words = [](double contact, double drive, double mass) {
    System system;
    system.contact = {contact, 0.3, {}};
    system.drive = Relaxation{drive, 0.1, {}};
    system.mass = mass;
    system.omega = system.friction = 1;
    system.opening = {{1, 0, {{0.5, 2}}}, 0.3, 1};
    return test::refusal<ModelError>([&] { sliding_threshold(system); });
  };
  BOOST_TEST(test::has(words(1, 1e46, 1), "below the stiffness of the drive"));
  // Where modes leave the range of doubles, no network relaxes as fast as another.
  BOOST_TEST(test::has(words(1, 0.3, 1e160), "leave the range of doubles"));
}

// In newtons, whose squares the search takes.
BOOST_AUTO_TEST_CASE(forces_beyond_doubles_are_told) {
  for (const double unit : {1e-200, 1e-100, 1e100, 1e160, 1e290}) {
    System system;
    system.contact = {unit, 0, {{0.5 * unit, 2}}};
    system.omega = system.friction = 1;
    system.opening = {system.contact, 0.3, 1};
    const std::string told = test::refusal<ModelError>([&] { sliding_threshold(system); });
    BOOST_TEST(test::has(told, unit < 1e-150 || unit > 1e150 ? "in SI units" : "accepted"), unit);
  }
}

// The force with which it closes is of both branches, for as long as the faster one lasts.
BOOST_AUTO_TEST_CASE(a_branch_that_relaxes_at_once_leaves_no_velocity) {
  for (const double time : {1e-90, 1e-99, 1e-101, 1e-155, 1e-250}) {
    System system;
    system.contact = {1, 0, {{0.5, time}}};
    system.drive = Relaxation{0.3, 0.1, {}};
    system.mass = 2;
    system.omega = system.friction = 1;
    system.opening = {{1, 0, {{0.5, time}}}, 0.3, 1};
    BOOST_TEST(
        test::refused<ModelError>([&] { sliding_threshold(system); }, "Maxwell branch so fast"),
        time);
  }
}

BOOST_AUTO_TEST_SUITE_END()
