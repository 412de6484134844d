// Drives with masses: 82 chains against two simulators of others, limits that are one mass or none,
// and what holds for every drive.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <memory>
#include <utility>

#include "base/errors.hpp"
#include "base/free_swings.hpp"
#include "simulation/chains.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/mass_amplitudes.hpp"
#include "simulation/steady/onset.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_masses)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

// Of the rows: k0 | c0, two masses, at omega = 1.
test::SceneText chain(const std::string& network, test::Elements elements, test::Toml mass = 0.4) {
  test::SceneText text{.normal = "kn",
                       .tangential = "kt | ct",
                       .network = network,
                       .mass = mass,
                       .angular_frequency = 1,
                       .amplitude = 0.7,
                       .indentation = 1,
                       .coefficient = 0.3,
                       .elements = {{"kn", 1}, {"kt", 1.2}, {"ct", 0.3}}};
  text.elements.insert(text.elements.end(), elements.begin(), elements.end());
  return text;
}

System system(const test::SceneText& text) { return system_of(test::scene_of(text)); }

double friction(const System& of, double velocity) {
  return steady_state(of, velocity).friction_ratio;
}

const std::string two = "(kd1 | cd1) - (mass(m1) | kd2 | cd2)";

test::Elements two_numbers(double kd1, double cd1, double m1, double kd2, double cd2) {
  return {{"kd1", kd1}, {"cd1", cd1}, {"m1", m1}, {"kd2", kd2}, {"cd2", cd2}};
}

std::vector<reference::Chain> group(const std::string& name, std::size_t expected) {
  std::vector<reference::Chain> all = reference::chains();
  std::erase_if(all, [&](const reference::Chain& each) { return each.group != name; });
  test::require_rows(all.size(), expected, name);
  return all;
}

}  // namespace

// The rows are right to 20 digits and the program's own error is some 1e-14; what is promised is
// 1e-10 of friction, 1e-12 of v*, and phases to the 12 decimals that the rows have.
BOOST_AUTO_TEST_CASE(chains_of_two_and_three_masses) {
  for (const reference::Chain& row : reference::chains()) BOOST_TEST_CONTEXT(row.id) {
      const System of = system_of(row.scene);
      for (const Start start : {Start::sliding, Start::rest}) {
        const SteadyState state = steady_state(of, row.velocity, start);
        const double error = std::abs(state.friction_ratio - row.friction_ratio);
        BOOST_TEST(error < 1e-10);
        BOOST_TEST(error <= state.friction_ratio_error + 1.1e-16);
        BOOST_REQUIRE(state.events.size() == row.events.size());
        for (std::size_t i = 0; i < row.events.size(); ++i) {
          BOOST_TEST((state.events[i].to == row.events[i].to));
          BOOST_TEST(std::abs(state.events[i].phase - row.events[i].phase) < 2e-12);
        }
      }
      const double threshold = sliding_threshold(of).contact_velocity;
      BOOST_TEST(std::abs(threshold - row.critical_velocity) < 1e-12 * row.critical_velocity);
      const auto energy = energy_balance(of, row.velocity);
      BOOST_REQUIRE(energy);
      BOOST_TEST(std::abs(energy->drive - energy->friction - energy->dampers) <= energy->error);
      BOOST_TEST(energy->error < 1e-11 * energy->drive);
    }
}

// The last stick from rest, which knows nothing of the linear response.
BOOST_AUTO_TEST_CASE(the_last_stick_is_at_the_critical_velocity) {
  for (const std::string id : {"C-two-01", "C-two-05", "C-three-03", "C-lively-02"})
    for (const reference::Chain& row : reference::chains())
      if (row.id == id) {
        const Onset onset = stick_onset(system_of(row.scene));
        BOOST_TEST(std::abs(onset.contact_velocity - row.critical_velocity) <=
                   1e-9 * row.critical_velocity + onset.uncertainty);
      }
}

// The inner mass vanishes, or becomes one with the body: what is left out is m1/kd or m/kd1.
BOOST_AUTO_TEST_CASE(one_mass_is_a_limit) {
  const System light =
      system(chain("kd1 - (mass(m1) | kd2)", {{"kd1", 2}, {"m1", 1e-11}, {"kd2", 3}}));
  const System single = system(chain("kd", {{"kd", 1.2}}));
  for (const double velocity : {0.02, 0.1, 0.2})
    BOOST_TEST(std::abs(friction(light, velocity) - friction(single, velocity)) < 1e-9);
  const System joined = system(chain(two, two_numbers(1e11, 0, 0.5, 1.7, 0.2)));
  const System sum = system(chain("kd2 | cd2", {{"kd2", 1.7}, {"cd2", 0.2}}, 0.9));
  for (const double velocity : {0.02, 0.1, 0.2})
    BOOST_TEST(std::abs(friction(joined, velocity) - friction(sum, velocity)) < 1e-9);
}

// A heavy mass on a soft spring is a wall that the far end pulls: what it moves is F/m.
BOOST_AUTO_TEST_CASE(a_heavy_mass_is_a_wall) {
  const System wall = system(chain(two, two_numbers(2, 0.1, 1e9, 1e-3, 1e5)));
  const System single = system(chain("kd1 | cd1", {{"kd1", 2}, {"cd1", 0.1}}));
  for (const double velocity : {0.03, 0.15})
    BOOST_TEST(std::abs(friction(wall, velocity) - friction(single, velocity)) < 2e-8);
}

// Undamped absorbers tuned to omega: v* = mu0 omega du_z K_n/|K_t|, that of a rigid drive, and
// friction below it another one, as the body moves at 2 omega.
BOOST_AUTO_TEST_CASE(a_tuned_absorber_keeps_the_body_still_at_omega_alone) {
  int tuned = 0;
  for (const reference::Chain& row : group("absorber", 8)) {
    if (std::stoi(row.id.substr(row.id.size() - 2)) % 2 == 0) continue;
    ++tuned;
    const System of = system_of(row.scene);
    System rigid = of;
    rigid.masses.reset();
    const double stiffness = std::abs(dynamic_stiffness(of.contact, 1));
    const double critical = of.friction * std::abs(of.normal_force_amplitude) / stiffness;
    BOOST_TEST(std::abs(sliding_threshold(of).contact_velocity - critical) < 1e-12 * critical);
    BOOST_TEST(std::abs(friction(of, row.velocity) - friction(rigid, row.velocity)) > 1e-4);
  }
  BOOST_TEST(tuned == 4);
}

// Damping of 1e-11 of the stiffness moves friction by about as much.
BOOST_AUTO_TEST_CASE(undamped_drives_are_a_limit) {
  const auto damped = [](double c) { return system(chain(two, two_numbers(2.3, c, 0.6, 1.1, c))); };
  for (const double velocity : {0.03, 0.12})
    BOOST_TEST(std::abs(friction(damped(1e-11), velocity) - friction(damped(0), velocity)) < 1e-9);
}

// Two equal absorbers swing against each other unseen; as one of twice the mass they are the same.
BOOST_AUTO_TEST_CASE(hidden_modes_change_nothing) {
  const System twice =
      system(chain("kd | cd | (ka - mass(ma)) | (kb - mass(mb))",
                   {{"kd", 2}, {"cd", 0.1}, {"ka", 0.7}, {"ma", 0.3}, {"kb", 0.7}, {"mb", 0.3}}));
  const System once = system(
      chain("kd | cd | (ka - mass(ma))", {{"kd", 2}, {"cd", 0.1}, {"ka", 1.4}, {"ma", 0.6}}));
  for (const double velocity : {0.03, 0.12})
    for (const Start start : {Start::sliding, Start::rest}) {
      const double difference = steady_state(twice, velocity, start).friction_ratio -
                                steady_state(once, velocity, start).friction_ratio;
      BOOST_TEST(std::abs(difference) < 1e-13);
    }
}

// Both pairs of body and absorber become one where k2/m2 = (k1/m1)/(1 + r)^2 and zeta2^2 =
// r/(1 + r), r = m2/m1: friction there is that between neighbours, by a difference of fourth order
// in 1e-3 of the damper.
BOOST_AUTO_TEST_CASE(through_merging_pairs) {
  const double m1 = 0.4, m2 = 0.1, k1 = 1.9, r = m2 / m1;
  const double k2 = m2 * (k1 / m1) / ((1 + r) * (1 + r)),
               c2 = 2 * std::sqrt(r / (1 + r)) * std::sqrt(k2 * m2);
  const auto at = [&](double share) {
    const System of = system(chain("kd | ((ka | ca) - mass(ma))",
                                   {{"kd", k1}, {"ka", k2}, {"ca", c2 * share}, {"ma", m2}}, m1));
    return steady_state(of, 0.05);
  };
  const SteadyState merged = at(1);
  const double near = (at(1 - 1e-3).friction_ratio + at(1 + 1e-3).friction_ratio) / 2,
               far = (at(1 - 2e-3).friction_ratio + at(1 + 2e-3).friction_ratio) / 2;
  BOOST_TEST(merged.friction_ratio_error < 1e-8);
  BOOST_TEST(std::abs(merged.friction_ratio - (4 * near - far) / 3) <=
             merged.friction_ratio_error + 1e-11);
}

// (v1 - v2)(<F1> - <F2>) >= 0 for any two speeds.
BOOST_AUTO_TEST_CASE(friction_never_falls_with_speed) {
  std::vector<reference::Chain> rows = group("undamped", 8);
  for (reference::Chain& row : group("lively", 10)) rows.push_back(std::move(row));
  for (const reference::Chain& row : rows) BOOST_TEST_CONTEXT(row.id) {
      const System of = system_of(row.scene);
      SteadyState before;
      for (int i = 1; i <= 19; ++i) {
        const SteadyState state = steady_state(of, 0.05 * i * row.critical_velocity);
        BOOST_TEST(state.friction_ratio >= before.friction_ratio - state.friction_ratio_error -
                                               before.friction_ratio_error);
        before = state;
      }
      BOOST_TEST(before.friction_ratio <= 1 + before.friction_ratio_error);
    }
}

// A light body is none: what is left out is m0/kd1.
BOOST_AUTO_TEST_CASE(without_a_body) {
  for (const std::string network :
       {"(kd1 | cd1) - (mass(m1) | kd2 | cd2)", "(kd1 - cd1) - (mass(m1) | kd2 | cd2)"}) {
    const System none = system(chain(network, two_numbers(2, 0.4, 0.6, 1.3, 0.1), test::Toml{}));
    const System light = system(chain(network, two_numbers(2, 0.4, 0.6, 1.3, 0.1), 1e-9));
    for (const double velocity : {0.05, 0.15}) {
      for (const Start start : {Start::sliding, Start::rest})
        BOOST_TEST(std::abs(steady_state(none, velocity, start).friction_ratio -
                            friction(light, velocity)) < 1e-7);
    }
  }
}

// At n omega for two n: sliding from the least maximum of free_swings.hpp on, from where on
// friction is full. Below it is not.
BOOST_AUTO_TEST_CASE(free_swings_at_two_harmonics) {
  const System of =
      system(chain("kf - (mass(ms) | km)", {{"kf", 1}, {"ms", 1}, {"km", 6}}, 1.0 / 6));
  BOOST_TEST((undamped_harmonics(of) == std::vector{2, 3}));
  // |1/K_t + 1/(K_d - m)|, K_d = 1/(1/1 + 1/(6 - 1)) = 5/6
  const std::complex<double> contact(1.2, 0.3);
  const double formula = 0.3 * 0.7 * std::abs(1.0 / contact + 1 / (5.0 / 6 - 1.0 / 6));
  const double from = formula * least_maximum({2, 3})->upper;
  BOOST_TEST(std::abs(sliding_threshold(of).contact_velocity - from) < 1e-12 * from);
  BOOST_TEST(friction(of, 1.001 * from) == 1);
  BOOST_TEST(friction(of, 0.98 * from) < 1 - 1e-6);
  // The swing that makes it steady stops the contact, and no more, at the threshold.
  double least = 1;
  const SteadyState sliding = steady_state(of, from * (1 + 1e-9), Start::sliding, 4000);
  for (const CyclePoint& point : sliding.cycle) least = std::min(least, point.contact_velocity);
  BOOST_TEST(std::abs(least) < 1e-5 * from);
}

// In sliding the friction is mu0 F_n, and the chain answers it at omega: by its two equations,
//   (kd1 + i cd1 - m0) q0 - (kd1 + i cd1) q1 = -F,   -(kd1 + i cd1) q0 + (kd1 + i cd1 + kd2 + i cd2
//   - m1) q1 = 0.
// Below v* the harmonic is that of the samples of the cycle, good to the square of their distance.
BOOST_AUTO_TEST_CASE(how_far_the_masses_swing) {
  const test::SceneText text = chain(two, two_numbers(2, 0.4, 0.6, 1.3, 0.1));
  const System of = system(text);
  const std::complex<double> first(2, 0.4), second(1.3, 0.1);
  const std::complex<double> a = first - 0.4, d = first + second - 0.6;
  const std::complex<double> q0 = d / (a * d - first * first), q1 = first / d * q0;
  const auto compare = [&](double velocity, double force, double within) {
    const auto found = mass_amplitudes(of, velocity);
    BOOST_REQUIRE(found.size() == 2u);
    BOOST_TEST(found[0].symbol.name == "m");
    BOOST_TEST(found[1].symbol.name == "m1");
    BOOST_TEST(std::abs(found[0].amplitude - force * std::abs(q0)) < within * force);
    BOOST_TEST(std::abs(found[1].amplitude - force * std::abs(q1)) < within * force);
  };
  const double threshold = sliding_threshold(of).contact_velocity;
  compare(1.5 * threshold, 0.3 * 0.7, 1e-13);
  const SteadyState state = steady_state(of, 0.4 * threshold, Start::sliding, 20'000);
  std::complex<double> harmonic;
  for (const CyclePoint& point : state.cycle)
    harmonic += point.force * std::polar(1.0, -point.phase) * (2.0 / 20'000);
  compare(0.4 * threshold, std::abs(harmonic), 1e-6);
  BOOST_TEST(mass_amplitudes(system(chain("kd", {{"kd", 1.2}})), 0.1).empty());
}

// A resonance with the oscillation has no sliding, and friction from drives beside it; its own
// neighbours by hand are the witness.
BOOST_AUTO_TEST_CASE(in_undamped_resonance) {
  const auto at = [](double share) {
    return system(
        chain("kf - (mass(ms) | km)", {{"kf", 1 * share}, {"ms", 1}, {"km", 6 * share}}, 5.0 / 6));
  };
  const System resonant = at(1);
  BOOST_TEST(std::isinf(sliding_threshold(resonant).contact_velocity));
  const double velocity = 0.3;
  const double between = (friction(at(1 - 1e-4), velocity) + friction(at(1 + 1e-4), velocity)) / 2;
  const SteadyState state = steady_state(resonant, velocity);
  BOOST_TEST(std::abs(state.friction_ratio - between) < 1e-6);
  BOOST_TEST(mass_amplitudes(resonant, velocity).empty());
}

// A damper that joins two masses to one cancels in the force on either, and resonates with nothing.
// Beyond what doubles hold it is refused by its right name; sliding is known all the same.
BOOST_AUTO_TEST_CASE(a_stiff_damper_is_no_resonance) {
  const auto linked = [](double damper) {
    return system(chain("(ks | cs) - (mass(ms) | km | cm)",
                        {{"ks", 1e8}, {"cs", damper}, {"ms", 1}, {"km", 2}, {"cm", 0.4}}));
  };
  const System of = linked(1e6), rigid = system(chain("kd | cd", {{"kd", 2}, {"cd", 0.4}}, 1.4));
  const double velocity = sliding_threshold(rigid).contact_velocity;
  BOOST_TEST(std::abs(sliding_threshold(of).contact_velocity - velocity) < 1e-7 * velocity);
  BOOST_TEST(std::abs(friction(of, velocity / 2) - friction(rigid, velocity / 2)) < 1e-7);
  const System beyond = linked(1e10);
  BOOST_TEST(std::abs(sliding_threshold(beyond).contact_velocity - velocity) < 1e-7 * velocity);
  BOOST_TEST(test::refused<ModelError>([&] { friction(beyond, velocity / 2); },
                                       "parts of the drive are so different"));
}

// What rounding takes of a drive is a share of how it gives: a drive that is stiffer by this share
// has its v* within the error of either answer, which is no more than some of those shares.
BOOST_AUTO_TEST_CASE(rounding_of_a_drive_is_in_the_error_of_its_critical_velocity) {
  constexpr double share = 1e-7;
  const System exact = system(chain(two, two_numbers(20, 1, 0.2, 15, 1)));
  System stiff = exact, rounded = exact;
  hold_by(stiff, stiffer(exact.masses->structure, 1 + share));
  DriveWithMasses masses = *exact.masses;
  masses.rounding = share;
  rounded.masses = std::make_shared<DriveWithMasses>(std::move(masses));
  const double velocity = sliding_threshold(exact).contact_velocity;
  const double change = std::abs(sliding_threshold(stiff).contact_velocity - velocity);
  BOOST_TEST(change > 0.01 * share * velocity);
  for (const Onset& onset : {sliding_threshold(rounded), stick_onset(rounded)}) {
    BOOST_TEST(onset.uncertainty >= change);
    BOOST_TEST(onset.uncertainty <= 10 * share * velocity);
  }
}

BOOST_AUTO_TEST_SUITE_END()
