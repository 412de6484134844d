// v* where the contact opens: Eq. (24) against the simulator, which does not know it, where the
// closed form is said to hold; and the simulator's own where it is not.
#include "answers/critical_onset.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "simulation/steady/normal_force.hpp"
#include "simulation/steady/onset.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_critical_onset)

using namespace vcrit;
using test::SceneText;
using test::Toml;

namespace {

/// At omega = 1, with a contact that may open.
Scene separating(SceneText text) {
  text.angular_frequency = 1;
  text.separation = true;
  return test::scene_of(text);
}

double simulated(const Scene& scene) {
  return simulation::sliding_threshold(simulation::system_of(scene)).contact_velocity;
}

// Both lose some hundred roundings: the simulator its modes, over a few decades of rates.
constexpr double rounding = 1e-11;

}  // namespace

BOOST_AUTO_TEST_CASE(elastic_paths_keep_the_closed_form) {
  for (const double amplitude : {1.5, 4.0, 300.0}) {
    SceneText text{.normal = "k",
                   .tangential = "kt",
                   .amplitude = amplitude,
                   .elements = {{"k", 3}, {"kt", 2}, {"kd", 0.7}}};
    const Scene rigid = separating(text);
    const CriticalOnset onset = critical_onset(rigid);
    BOOST_TEST((onset.by == CriticalOnset::By::formula));
    BOOST_TEST(onset.contact_velocity == certified_critical_velocity(rigid).value);
    BOOST_TEST(std::abs(simulated(rigid) / onset.contact_velocity - 1) <= rounding);
    text.network = "kd";
    const Scene drive = separating(text);
    const CriticalOnset driven = critical_onset(drive);
    BOOST_TEST((driven.by == CriticalOnset::By::formula));
    BOOST_TEST(std::abs(simulated(drive) / driven.contact_velocity - 1) <= rounding);
  }
}

// A body remembers where it was when the contact closed, whatever the springs.
BOOST_AUTO_TEST_CASE(a_body_on_springs_has_no_closed_form) {
  const Scene scene = separating({.normal = "k",
                                  .tangential = "kt",
                                  .network = "kd",
                                  .mass = 0.3,
                                  .amplitude = 3,
                                  .elements = {{"k", 3}, {"kt", 2}, {"kd", 0.7}}});
  const CriticalOnset onset = critical_onset(scene);
  BOOST_TEST((onset.by == CriticalOnset::By::simulation));
  BOOST_TEST(onset.contact_velocity == simulated(scene));
  BOOST_TEST(std::abs(certified_critical_velocity(scene).value / onset.contact_velocity - 1) >
             0.01);
}

// m omega^2 and the share of it that its swing in between takes are below 1e-12 of the drive's
// stiffness; without the mass contact and drive are one network, and nothing swings.
BOOST_AUTO_TEST_CASE(a_light_body_on_a_damped_drive_is_none) {
  for (const char* drive : {"kd | cd", "kd | cd | (k1 - c1)", "cd - c1"}) {
    SceneText text{
        .normal = "k",
        .tangential = "kt",
        .network = drive,
        .amplitude = 3,
        .elements = {{"k", 3}, {"kt", 2}, {"kd", 0.7}, {"cd", 0.4}, {"k1", 0.9}, {"c1", 5}}};
    const double without = simulated(separating(text));
    for (const double mass : {1e-13, 1e-16, 1e-20, 1e-40, 1e-100}) {
      text.mass = mass;
      BOOST_TEST(std::abs(simulated(separating(text)) / without - 1) <= rounding);
    }
  }
}

// A drive so stiff, or a body so heavy, that friction moves it by less than 1e-12 of the contact is
// rigid, in whatever units of the contact's velocity its own would be lost.
BOOST_AUTO_TEST_CASE(a_body_that_keeps_still_is_none) {
  const SceneText text{
      .normal = "k | (k2 - c2)",
      .tangential = "kt | (k1 - c1)",
      .amplitude = 3,
      .elements = {{"k", 3}, {"k2", 1}, {"c2", 0.7}, {"kt", 2}, {"k1", 0.9}, {"c1", 5}}};
  const double rigid = simulated(separating(text));
  const auto near_rigid = [&](const char* drive, double mass, double stiffness) {
    SceneText driven = text;
    driven.network = drive;
    driven.mass = mass;
    for (const auto& [name, value] : {std::pair("kd", stiffness), std::pair("cd", 0.4),
                                      std::pair("kb", 3e6), std::pair("cb", 4e9)})
      driven.elements.emplace_back(name, value);
    BOOST_TEST(std::abs(simulated(separating(driven)) / rigid - 1) <= rounding,
               drive << mass << stiffness);
  };
  for (const double mass : {1.0, 1e3, 1e6})
    for (const double stiffness : {1.7e13, 1.7e14, 1.7e16}) near_rigid("kd", mass, stiffness);
  for (const double mass : {1e13, 1e16, 1e20, 1e40})
    for (const char* drive : {"kd", "kd | cd", "kd | (kb - cb)"}) near_rigid(drive, mass, 0.7);
}

// In sliding the tangential deformations are mu0 K_n/K_t times the normal ones whatever the
// network: v* is Eq. (24) where the contact is closed as u_z rises fastest, and less elsewhere.
BOOST_AUTO_TEST_CASE(isotropic_contacts_under_a_rigid_drive) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-1.5, 1.5), size(1.2, 6);
  int kept = 0, lower = 0, opened = 0;
  for (int i = 0; i < 120; ++i) {
    const auto number = [&] { return std::pow(10, exponent(random)); };
    const char* const networks[] = {"k0 | c1", "zener(k0, k1, c1)", "(k0 | c1) - k1",
                                    "k0 | (k1 - c1) | c2"};
    const Scene scene = separating(
        {.normal = networks[i % 4],
         .tangential_ratio = 0.8,
         .amplitude = size(random),
         .elements = {{"k0", number()}, {"k1", number()}, {"c1", number()}, {"c2", number()}}});
    if (!opens(scene)) continue;
    ++opened;
    const CriticalOnset onset = critical_onset(scene);
    const double formula = certified_critical_velocity(scene).value, found = simulated(scene);
    BOOST_TEST(found <= formula * (1 + rounding), i);
    if (onset.by == CriticalOnset::By::formula) {
      ++kept;
      BOOST_TEST(onset.contact_velocity == formula);
      BOOST_TEST(std::abs(found / formula - 1) <= rounding, i);
    } else {
      ++lower;
      BOOST_TEST(onset.contact_velocity == found);
      BOOST_TEST(found < formula * (1 - 1e-6), i);
    }
  }
  BOOST_TEST(opened >= 100);
  BOOST_TEST(kept >= 30);
  BOOST_TEST(lower >= 5);
}

SceneText kelvin(const char* tangential, double amplitude) {
  return {.normal = "k | c",
          .tangential = tangential,
          .amplitude = amplitude,
          .elements = {{"k", 1}, {"c", 0.6}, {"kt", 0.8}, {"ct", 2}}};
}

// With a network of its own the tangential contact remembers: the last stick of a start at rest,
// the simulator's other witness, vanishes at the same speed, and Eq. (24) is off.
BOOST_AUTO_TEST_CASE(other_contacts_are_simulated) {
  const Scene scene = separating(kelvin("kt | ct", 3));
  const CriticalOnset onset = critical_onset(scene);
  BOOST_TEST((onset.by == CriticalOnset::By::simulation));
  BOOST_TEST(std::isnan(onset.relative_error_bound));
  const double rest = simulation::stick_onset(simulation::system_of(scene)).contact_velocity;
  // Sticks that last less than 1e-6 of a period are found.
  BOOST_TEST(std::abs(onset.contact_velocity / rest - 1) <= 1e-11);
  BOOST_TEST(std::abs(certified_critical_velocity(scene).value / rest - 1) > 0.01);
}

BOOST_AUTO_TEST_CASE(a_force_that_jumps_sticks_at_any_speed) {
  const CriticalOnset onset = critical_onset(separating(kelvin("kt", 3)));
  BOOST_TEST(std::isinf(onset.contact_velocity));
  BOOST_TEST(onset.reason.find("sticks for a moment") != std::string::npos);
}

// A contact that may open and do not: the same numbers as without.
BOOST_AUTO_TEST_CASE(closed_contacts_are_as_ever) {
  const Scene may = separating(kelvin("kt | ct", 0.2));
  BOOST_TEST(!opens(may));
  SceneText closed = kelvin("kt | ct", 0.2);
  closed.angular_frequency = 1;
  const Scene never = test::scene_of(closed);
  BOOST_TEST(critical_onset(may).contact_velocity == critical_onset(never).contact_velocity);
  BOOST_TEST((critical_onset(may).by == CriticalOnset::By::formula));
}

// By hand, omega = 1: K_d = k1 b/(k1 + b) of a chain with b = k2 - m1 n^2, and k + ka b/(ka + b) of
// a spring and an absorber with b = -ma n^2. A mass m = K_d/n^2 at its end swings freely.
CriticalOnset closed_onset(const char* drive, Toml mass, test::Elements elements) {
  for (const auto& [name, value] :
       {std::pair("kn", 3.0), std::pair("cn", 0.4), std::pair("kt", 2.0)})
    elements.emplace_back(name, value);
  return critical_onset(test::scene_of({.normal = "kn | cn",
                                        .tangential = "kt",
                                        .network = drive,
                                        .mass = mass,
                                        .angular_frequency = 1,
                                        .elements = std::move(elements)}));
}

BOOST_AUTO_TEST_CASE(drives_with_masses_swing_at_harmonics_too) {
  const auto swings = [](const char* drive, double mass, const test::Elements& elements, int n) {
    const CriticalOnset found = closed_onset(drive, mass, elements);
    BOOST_TEST(found.free_harmonics == (n > 1 ? std::vector{n} : std::vector<int>{}));
    const double share = n > 1 ? std::cos(std::numbers::pi / (2 * n)) : 1;
    BOOST_TEST(std::abs(found.sliding_from / (share * found.contact_velocity) - 1) < 1e-15);
  };
  for (const int n : {2, 3, 17, 150}) {
    const double b = 7.0 * n * n - 0.4 * n * n, chain = 5.0 * b / (5 + b) / n / n;
    const test::Elements springs{{"k1", 5}, {"k2", 7.0 * n * n}, {"m1", 0.4}, {"c2", 1e-4}};
    swings("k1 - (mass(m1) | k2)", chain, springs, n);
    swings("k1 - (mass(m1) | k2)", 1.0001 * chain, springs, 0);
    swings("k1 - (mass(m1) | k2 | c2)", chain, springs, 0);
    const double a = -0.9 * n * n, absorber = (60.0 * n * n + 2 * a / (2 + a)) / n / n;
    swings("kd | ka - mass(ma)", absorber, {{"kd", 60.0 * n * n}, {"ka", 2}, {"ma", 0.9}}, n);
    // Tuned to n, an absorber holds the body still there.
    swings("kd | ka - mass(ma)", 1, {{"kd", 5}, {"ka", n * n}, {"ma", 1}}, 0);
  }
}

// K_d = k1 (k2 - m1 n^2)/(k1 + k2 - m1 n^2) is m n^2 at n = 2 and n = 3: 2/3 and 3/2. Both swings
// together leave 1/(2 cos(pi/5)) of v* (Fejer), and the drive alone swings at n where k2 = m1 n^2.
BOOST_AUTO_TEST_CASE(several_swings_lower_the_border_further) {
  const auto onset = [](Toml body, double k2) {
    return closed_onset("k1 - (mass(m1) | k2)", body, {{"k1", 1}, {"m1", 1}, {"k2", k2}});
  };
  const double body = 0.16666666666666666;
  const CriticalOnset both = onset(body, 6);
  BOOST_TEST(both.free_harmonics == (std::vector{2, 3}));
  const double share = 1 / (2 * std::cos(std::numbers::pi / 5));
  BOOST_TEST(std::abs(both.sliding_from / both.contact_velocity / share - 1) <= 1e-11);
  BOOST_TEST(onset(body, 6.001).free_harmonics.empty());
  const CriticalOnset light = onset({}, 9);
  BOOST_TEST(light.free_harmonics == std::vector{3});
  BOOST_TEST(light.sliding_from == light.contact_velocity * std::cos(std::numbers::pi / 6));
}

// K_d = k1 (k2 - m1 n^2)/(k1 + k2 - m1 n^2) = (1 + d)/d where m1 n^2 = 2 + d: a million springs,
// and a condition number of 2^20 compared with that, leave ten digits.
BOOST_AUTO_TEST_CASE(a_drive_close_to_its_own_resonance_swings_freely_too) {
  const double d = 0x1p-20, body = (1 + d) / d;
  const auto swings = [&](double mass) {
    return closed_onset("k1 - (mass(m1) | k2)", mass, {{"k1", 1}, {"k2", 1}, {"m1", (2 + d) / 4}})
        .free_harmonics;
  };
  BOOST_TEST(swings(body / 4) == std::vector{2});
  BOOST_TEST(swings(body / 4 * 1.001).empty());
}

// An absorber for each pole between the squares of 2, 3, ..., N, at which all is free: K_d - m n^2
// = -m prod(n^2 - zero)/prod(n^2 - pole), whose residues are the absorbers' k pole.
CriticalOnset free_up_to(int harmonics) {
  const int most = harmonics + 1;
  const long double mass = 0.3L;
  const auto pole = [](int i) { return (i + 0.5L) * (i + 0.5L); };
  long double rest = mass;
  for (int j = 2; j <= most; ++j) rest *= j * j / (j < most ? pole(j) : 1);
  std::string drive = "kd";
  test::Elements elements{{"kd", static_cast<double>(rest)}};
  for (int i = 2; i < most; ++i) {
    long double residue = mass * (most * most - pole(i));
    for (int j = 2; j < most; ++j) {
      residue *= pole(i) - j * j;
      if (j != i) residue /= pole(i) - pole(j);
    }
    const std::string number = std::to_string(i), k = "k" + number, m = "m" + number;
    drive += " | " + k + " - mass(" + m + ")";
    const long double stiffness = residue / pole(i);
    elements.emplace_back(k, static_cast<double>(stiffness));
    elements.emplace_back(m, static_cast<double>(stiffness / pole(i)));
  }
  return closed_onset(drive.c_str(), static_cast<double>(mass), elements);
}

// Fejer: 1/(2 cos(pi/(N + 2))) of v* for all from 2 to N. Of more than nine at once the border is
// not known; v* is.
BOOST_AUTO_TEST_CASE(many_swings_leave_v_known) {
  for (const int count : {3, 9, 10, 12}) {
    const CriticalOnset onset = free_up_to(count);
    std::vector<int> all;
    for (int n = 2; n <= count + 1; ++n) all.push_back(n);
    BOOST_TEST(onset.free_harmonics == all);
    BOOST_TEST((onset.contact_velocity > 0 && std::isfinite(onset.contact_velocity)));
    const double share = 1 / (2 * std::cos(std::numbers::pi / (count + 3)));
    if (count <= 9)
      BOOST_TEST(std::abs(onset.sliding_from / onset.contact_velocity / share - 1) <= 1e-11);
    else
      BOOST_TEST(std::isnan(onset.sliding_from));
  }
}

// d ln v*/d ln p of a scene whose v* is simulated: differences of an independent program's v*, in
// 34 digits, given to nine.
BOOST_AUTO_TEST_CASE(sensitivities_are_those_of_the_simulated_velocity) {
  SceneText slow = test::slow_zener();
  slow.indentation = 3e-7;
  const Scene scene = test::scene_of(slow);
  BOOST_TEST((critical_onset(scene).by == CriticalOnset::By::simulation));
  BOOST_TEST(std::abs(critical_onset(scene).contact_velocity / 0.0329490394820942627 - 1) < 1e-13);
  // The contact point follows in inverse proportion to the ratio.
  const std::pair<const char*, double> known[] = {{"u_z0", 0.058391161},
                                                  {"c1", -0.059194201},
                                                  {"k1", -0.103276908},
                                                  {"k0", 0.162471109},
                                                  {"tangential_ratio", -1}};
  for (const auto& [name, expected] : known)
    BOOST_TEST(std::abs(onset_log_derivative(scene, {name}) - expected) <= 1e-9, name);
  // Of Eq. (24) where that holds.
  BOOST_TEST(onset_log_derivative(separating(kelvin("kt", 0.2)), {"kt"}) == -1);
}

// A contact that opens by the share d lose a force of the order d^(3/2), and the slope changes by
// sqrt(d): just beyond the border, |K_n| du_z = u_z0, it is that of Eq. (24).
BOOST_AUTO_TEST_CASE(sensitivities_are_the_same_on_both_sides_of_the_border) {
  for (const double beyond : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Scene opening = separating(kelvin("kt | ct", (1 + beyond) / std::hypot(1, 0.6)));
    const Scene closed = separating(kelvin("kt | ct", (1 - beyond) / std::hypot(1, 0.6)));
    BOOST_TEST((critical_onset(opening).by == CriticalOnset::By::simulation));
    for (const char* name : {"du_z", "u_z0", "c", "k", "kt", "ct"})
      BOOST_TEST(std::abs(onset_log_derivative(opening, {name}) -
                          onset_log_derivative(closed, {name})) <= 1e-5 + 5 * std::sqrt(beyond),
                 name << " " << beyond);
  }
}

// v* is in inverse proportion to 2 (1 - nu)/(2 - nu), whose relative slope at 1/2, the largest
// nu there is, is -2/3; with a drive as that of the same contact given by its ratio.
BOOST_AUTO_TEST_CASE(sensitivities_to_the_largest_poisson_ratio) {
  SceneText slow = test::slow_zener();
  slow.tangential_ratio = {};
  slow.poisson = 0.5;
  BOOST_TEST((critical_onset(test::scene_of(slow)).by == CriticalOnset::By::simulation));
  BOOST_TEST(std::abs(onset_log_derivative(test::scene_of(slow), {"poisson"}) - 2.0 / 3) <= 1e-15);
  slow.network = "kd";
  slow.elements.emplace_back("kd", 1e6);
  const double by_poisson = onset_log_derivative(test::scene_of(slow), {"poisson"});
  slow.poisson = {};
  slow.tangential_ratio = 2.0 / 3;
  const double by_ratio = onset_log_derivative(test::scene_of(slow), {"tangential_ratio"});
  BOOST_TEST(std::abs(by_poisson / by_ratio + 2.0 / 3) <= 1e-9);
}

// A contact that only taps: v* is Eq. (24) of springs, mu0 omega du_z kn/kt, and without friction 0
// whatever the networks.
BOOST_AUTO_TEST_CASE(tapping_contacts_and_frictionless_ones) {
  SceneText tapping{.normal = "k",
                    .tangential = "kt",
                    .amplitude = 3,
                    .indentation = 0,
                    .elements = {{"k", 3}, {"kt", 2}}};
  BOOST_TEST(inadmissible_reasons(separating(tapping)).empty());
  BOOST_TEST(critical_onset(separating(tapping)).contact_velocity == 2.25);
  BOOST_TEST(std::abs(simulated(separating(tapping)) / 2.25 - 1) <= rounding);
  tapping.amplitude = 0;
  BOOST_TEST(inadmissible_reasons(separating(tapping)) ==
             std::vector<std::string>{"the contact never closes"});
  SceneText slippery = kelvin("kt | ct", 3);
  slippery.coefficient = 0;
  BOOST_TEST(critical_onset(separating(slippery)).contact_velocity == 0);
}

BOOST_AUTO_TEST_SUITE_END()
