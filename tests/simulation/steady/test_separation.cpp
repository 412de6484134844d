// Friction of a contact that opens: 20-digit references by another formulation, closed forms, both
// starts, the balance of energy.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "simulation/random_systems.hpp"
#include "simulation/reference_tables.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "support/refusal.hpp"
#include "support/table.hpp"

BOOST_AUTO_TEST_SUITE(test_separation)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

struct Reference {
  std::string name, motions;
  System system;
  double velocity, friction_ratio;
};

std::vector<Reference> references() {
  std::vector<Reference> result;
  for (const auto& c : test::rows_of("opening_friction.csv", 14)) {
    System system;
    system.contact = reference::network(c.at(1));
    if (!c.at(3).empty()) {
      system.drive = reference::network(c.at(3));
      system.mass = std::stod(c.at(4));
    }
    system.omega = 1;
    system.friction = std::stod(c.at(7));
    system.opening = {reference::network(c.at(2)), std::stod(c.at(5)), std::stod(c.at(6))};
    result.push_back({c.at(0), c.at(10), system, std::stod(c.at(8)), std::stod(c.at(9))});
  }
  return result;
}

std::string motions_of(const SteadyState& state) {
  std::set<std::string> motions;
  for (const Event& event : state.events) motions.insert(to_text(event.to));
  std::string all;
  for (const std::string& motion : motions) all += (all.empty() ? "" : " ") + motion;
  return all;
}

System elastic(double mean, double amplitude) {
  System system;
  system.contact = {1, 0, {}};
  system.omega = 1;
  system.friction = 1;
  system.opening = {{1, 0, {}}, mean, amplitude};
  return system;
}

}  // namespace

BOOST_AUTO_TEST_CASE(agrees_with_references) {
  const auto rows = references();
  BOOST_REQUIRE(rows.size() == 14u);
  for (const Reference& row : rows)
    for (const Start start : {Start::sliding, Start::rest}) {
      const SteadyState state = steady_state(row.system, row.velocity, start);
      BOOST_TEST(std::abs(state.friction_ratio - row.friction_ratio) <= state.friction_ratio_error,
                 row.name);
      // Some hundred rounding errors; bodies swing a few times before they come to rest.
      BOOST_TEST(state.friction_ratio_error <= 1e-13, row.name);
      BOOST_TEST(motions_of(state) == row.motions, row.name);
    }
}

// The figures of the flat punch that started this, right to 1e-8 in each digit given.
BOOST_AUTO_TEST_CASE(flat_punch_ten_times_open) {
  const std::pair<double, double> table[] = {{0.1, 0.21837443},
                                             {0.25, 0.47846050},
                                             {0.5, 0.77652343},
                                             {0.75, 0.94298467},
                                             {0.9, 0.98976639}};
  for (const auto& [ratio, friction] : table)
    BOOST_TEST(std::abs(steady_state(elastic(1, 10), 10 * ratio).friction_ratio - friction) <=
               1e-8);
}

// Above v* = du_z K_n/K_t (here the amplitude) the contact slips whenever it is closed.
BOOST_AUTO_TEST_CASE(slides_above_the_critical_velocity) {
  const SteadyState above = steady_state(elastic(1, 3), 3 * (1 + 1e-9));
  BOOST_TEST((above.regime == Regime::sliding_separated));
  BOOST_TEST(std::abs(above.friction_ratio - 1) <= above.friction_ratio_error);
  const SteadyState below = steady_state(elastic(1, 3), 3 * (1 - 1e-6));
  BOOST_TEST((below.regime == Regime::stick_slip_separated));
  BOOST_TEST(below.friction_ratio < 1);
}

// v* of an elastic contact under a rigid drive is that of one that never opens; with two witnesses,
// the minimum of the contact velocity in sliding and the last stick.
BOOST_AUTO_TEST_CASE(critical_velocity) {
  for (const double amplitude : {1.001, 3.0, 1000.0}) {
    const Onset onset = sliding_threshold(elastic(1, amplitude));
    BOOST_TEST(std::abs(onset.contact_velocity / amplitude - 1) <= 1e-14);
    BOOST_TEST(onset.drive_velocity == onset.contact_velocity);
  }
  int infinite = 0;
  for (const Reference& row : references()) {
    const Onset threshold = sliding_threshold(row.system);
    if (std::isinf(threshold.drive_velocity)) {
      ++infinite;
      BOOST_TEST((row.system.opening->network.damper > 0 && row.system.contact.damper == 0));
      const SteadyState fast = steady_state(row.system, 1e6 * row.velocity);
      BOOST_TEST((fast.regime == Regime::stick_slip_separated));
      continue;
    }
    // Sticks that last less than 1e-6 of a period are found.
    const Onset last = stick_onset(row.system);
    BOOST_TEST(std::abs(last.drive_velocity / threshold.drive_velocity - 1) <= 1e-11, row.name);
  }
  BOOST_TEST(infinite == 2);
}

// A contact that hardly closes: 1 - cos t of a part in 1e9 to 1e12 has few digits left, and so has
// their mean force, which the ratio is of. The contact sticks from the first touch on, F = v (t +
// T), until that reaches F_n = a cos t - 1; here at 50 digits, for these doubles.
BOOST_AUTO_TEST_CASE(a_mean_force_of_few_digits_is_no_better_as_a_ratio) {
  struct Row {
    double amplitude, velocity, ratio;
  };
  for (const Row& row : {Row{0x1.000000044b830p+0, 9.486832980505138e-06, 0.51094202811342259},
                         Row{0x1.000000006df38p+0, 3e-06, 0.51094202825549889},
                         Row{0x1.000000000afecp+0, 9.486832980505138e-07, 0.51094202826970649},
                         Row{0x1.0000000001198p+0, 3e-07, 0.51092448620121043}}) {
    const SteadyState state = steady_state(elastic(-1, row.amplitude), row.velocity);
    BOOST_TEST(std::abs(state.friction_ratio - row.ratio) <= state.friction_ratio_error);
    BOOST_TEST(state.friction_ratio_error <= 0.01);
  }
}

BOOST_AUTO_TEST_CASE(outside_the_model) {
  BOOST_CHECK_THROW(steady_state(elastic(-2, 1), 0.5), ModelError);  // never closes
}

BOOST_AUTO_TEST_CASE(contacts_that_never_open_are_closed) {
  const System open = elastic(2, 1);
  System closed = open;
  closed.opening.reset();
  closed.mean_normal_force = 2;
  closed.normal_force_amplitude = 1;
  const SteadyState found = steady_state(open, 0.5), expected = steady_state(closed, 0.5);
  BOOST_TEST(expected.friction_ratio < 0.99);
  BOOST_TEST(std::abs(found.friction_ratio - expected.friction_ratio) <=
             found.friction_ratio_error + expected.friction_ratio_error);
}

// Where the contact hardly opens, friction goes over into that of those that never do.
BOOST_AUTO_TEST_CASE(goes_over_into_contact) {
  System never = elastic(1, 0);
  never.opening.reset();
  never.mean_normal_force = 1;
  never.normal_force_amplitude = 1 - 1e-9;
  for (const double velocity : {0.1, 0.5, 0.9}) {
    const double open = steady_state(elastic(1, 1 + 1e-9), velocity).friction_ratio;
    const double touching = steady_state(never, velocity).friction_ratio;
    // The forces differ by less than 4e-9 of their mean.
    BOOST_TEST(std::abs(open - touching) <= 1e-8);
  }
}

// The mean force falls with the spring that carries it: friction was 2.07 where nothing is left of
// it.
BOOST_AUTO_TEST_CASE(a_mean_force_that_is_lost_is_told) {
  int answered = 0;
  for (int decade = 0; decade >= -300; decade -= 4) {
    System system = elastic(0.5, 1);
    system.contact = {std::pow(10, decade), 0, {{0.5, 1}}};
    system.opening->network = system.contact;
    try {
      const SteadyState found =
          steady_state(system, 0.5 * sliding_threshold(system).drive_velocity);
      BOOST_TEST(found.friction_ratio <= 1 + found.friction_ratio_error, decade);
      BOOST_TEST(found.friction_ratio_error < 0.3, decade);
      ++answered;
    } catch (const ModelError& error) {
      BOOST_TEST(decade < -18, decade);
      BOOST_TEST(test::has(error.what(), "lost in rounding"));
    }
  }
  BOOST_TEST(answered >= 5);
}

// A branch whose force is nothing beside the spring's closes and opens nothing.
BOOST_AUTO_TEST_CASE(weak_branches_are_left_out) {
  const double velocity = 0.4;
  const SteadyState spring = steady_state(elastic(0.5, 1), velocity);
  for (const double stiffness : {1e-20, 1e-80, 1e-120, 1e-155, 1e-250}) {
    System system = elastic(0.5, 1);
    system.contact = system.opening->network = {1, 0, {{stiffness, 1}}};
    const SteadyState found = steady_state(system, velocity);
    BOOST_TEST(std::abs(found.friction_ratio - spring.friction_ratio) <=
                   found.friction_ratio_error + spring.friction_ratio_error,
               stiffness);
  }
}

// What relaxes in c of a radian changes friction by some c: the ratio is that of the spring, or
// none where sums lose a direct damper, whose force lets the contact close. The last two contacts
// hardly touch.
BOOST_AUTO_TEST_CASE(dampers_that_vanish) {
  const double velocity = 0.4;
  for (const double mean : {0.5, -0.9, -0.999}) {
    const SteadyState spring = steady_state(elastic(mean, 1), velocity);
    for (int decade = -8; decade >= -300; decade -= decade > -20 ? 1 : 4) {
      const double c = std::pow(10, decade);
      const auto compare = [&](const Relaxation& network) {
        System system = elastic(mean, 1);
        system.contact = system.opening->network = network;
        const SteadyState found = steady_state(system, velocity);
        BOOST_TEST(std::abs(found.friction_ratio - spring.friction_ratio) <=
                       found.friction_ratio_error + spring.friction_ratio_error + 4 * c,
                   mean << ", 1e" << decade << ": " << found.friction_ratio << ", "
                        << spring.friction_ratio << " +- " << found.friction_ratio_error);
      };
      if (mean == 0.5) compare({1, 0, {{0.5, c}}});
      if (decade >= -15 || decade < -100)
        compare({1, c, {}});
      else
        BOOST_TEST(test::refused<ModelError>(
                       [&] {
                         compare({1, c, {}});
                       },
                       "damper of the contact"),
                   decade);
    }
  }
}

// The drive's work is the heat of friction and dampers, and neither start nor rounding decide.
BOOST_AUTO_TEST_CASE(random_systems) {
  reference::RandomSystems random(21, 2);
  int tried = 0;
  while (tried < 150) {
    System system = random.system();
    const Relaxation normal = random.network(true);
    const double dynamic = std::abs(dynamic_stiffness(normal, 1)), mean = random.uniform(-0.5, 1);
    const double amplitude = random.logarithmic(0.3, 10);
    if (mean + amplitude < 0.1 || dynamic * amplitude < 1.02 * normal.equilibrium * mean) continue;
    system.opening = {normal, mean, amplitude};
    const double velocity = random.logarithmic(0.01, 3);
    ++tried;
    const SteadyState one = steady_state(system, velocity, Start::sliding);
    const SteadyState other = steady_state(system, velocity, Start::rest);
    BOOST_TEST(std::abs(one.friction_ratio - other.friction_ratio) <=
               one.friction_ratio_error + other.friction_ratio_error);
    const auto energy = energy_balance(system, velocity);
    if (!energy) continue;
    BOOST_TEST(std::abs(energy->drive - energy->friction - energy->dampers) <= energy->error);
    BOOST_TEST(energy->friction >= 0);
    BOOST_TEST(energy->dampers >= 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
