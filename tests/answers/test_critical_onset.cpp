// v* where the surfaces part: Eq. (24) against the simulator, which does not know it, where the
// closed form is said to hold; and the simulator's own where it is not.
#include "answers/critical_onset.hpp"

#include <fmt/core.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "simulation/steady/normal_force.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_critical_onset)

using namespace vcrit;

namespace {

std::string scene_text(const std::string& contact, double amplitude, const std::string& rest) {
  return "[contact]\n" + contact + "\nseparation = true\n[oscillation]\nangular_frequency = 1.0\n" +
         "amplitude = " + std::to_string(amplitude) +
         "\nindentation = 1.0\n[friction]\ncoefficient = 0.5\n" + rest;
}

Scene scene_of(const std::string& contact, double amplitude, const std::string& rest) {
  return parse_scene(scene_text(contact, amplitude, rest), "s.toml");
}

double simulated(const Scene& scene) {
  return simulation::sliding_threshold(simulation::system_of(scene)).contact_velocity;
}

// Both lose some hundred roundings: the simulator its modes, over a few decades of rates.
constexpr double rounding = 1e-11;

}  // namespace

BOOST_AUTO_TEST_CASE(elastic_paths_keep_the_closed_form) {
  for (const double amplitude : {1.5, 4.0, 300.0}) {
    const Scene rigid = scene_of("normal = \"k\"\ntangential = \"kt\"", amplitude,
                                 "[elements]\nk = 3.0\nkt = 2.0\n");
    const CriticalOnset onset = critical_onset(rigid);
    BOOST_TEST((onset.by == CriticalOnset::By::formula));
    BOOST_TEST(onset.contact_velocity == certified_critical_velocity(rigid).value);
    BOOST_TEST(std::abs(simulated(rigid) / onset.contact_velocity - 1) <= rounding);
    const Scene drive =
        scene_of("normal = \"k\"\ntangential = \"kt\"", amplitude,
                 "[drive]\nnetwork = \"kd\"\n[elements]\nk = 3.0\nkt = 2.0\nkd = 0.7\n");
    const CriticalOnset driven = critical_onset(drive);
    BOOST_TEST((driven.by == CriticalOnset::By::formula));
    BOOST_TEST(std::abs(simulated(drive) / driven.contact_velocity - 1) <= rounding);
  }
}

// A body remembers where it was when the surfaces met, whatever the springs.
BOOST_AUTO_TEST_CASE(a_body_on_springs_has_no_closed_form) {
  const Scene scene = scene_of(
      "normal = \"k\"\ntangential = \"kt\"", 3,
      "[drive]\nnetwork = \"kd\"\n[body]\nmass = 0.3\n[elements]\nk = 3.0\nkt = 2.0\nkd = 0.7\n");
  const CriticalOnset onset = critical_onset(scene);
  BOOST_TEST((onset.by == CriticalOnset::By::simulation));
  BOOST_TEST(onset.contact_velocity == simulated(scene));
  BOOST_TEST(std::abs(certified_critical_velocity(scene).value / onset.contact_velocity - 1) >
             0.01);
}

// m omega^2 and the share of it that its swing in between takes are below 1e-12 of the drive's
// stiffness; without the mass contact and drive are one network, and nothing swings.
BOOST_AUTO_TEST_CASE(a_light_body_on_a_damped_drive_is_none) {
  const std::string elements =
      "[elements]\nk = 3.0\nkt = 2.0\nkd = 0.7\ncd = 0.4\nk1 = 0.9\nc1 = 5.0\n";
  for (const std::string drive : {"kd | cd", "kd | cd | (k1 - c1)", "cd - c1"}) {
    const std::string contact = "normal = \"k\"\ntangential = \"kt\"";
    const std::string drawn = "[drive]\nnetwork = \"" + drive + "\"\n";
    const double without = simulated(scene_of(contact, 3, drawn + elements));
    for (const std::string mass : {"1e-13", "1e-16", "1e-20", "1e-40", "1e-100"}) {
      const Scene scene = scene_of(contact, 3, drawn + "[body]\nmass = " + mass + "\n" + elements);
      BOOST_TEST(std::abs(simulated(scene) / without - 1) <= rounding);
    }
  }
}

// A drive so stiff, or a body so heavy, that friction moves it by less than 1e-12 of the contact is
// rigid, in whatever units of the contact's velocity its own would be lost.
BOOST_AUTO_TEST_CASE(a_body_that_keeps_still_is_none) {
  const std::string contact = "normal = \"k | (k2 - c2)\"\ntangential = \"kt | (k1 - c1)\"";
  const std::string elements =
      "[elements]\nk = 3.0\nk2 = 1.0\nc2 = 0.7\nkt = 2.0\nk1 = 0.9\nc1 = 5.0\n";
  const double rigid = simulated(scene_of(contact, 3, elements));
  const auto near_rigid = [&](const std::string& drive, const std::string& mass,
                              const std::string& more) {
    const Scene scene = scene_of(
        contact, 3,
        "[drive]\nnetwork = \"" + drive + "\"\n[body]\nmass = " + mass + "\n" + elements + more);
    BOOST_TEST(std::abs(simulated(scene) / rigid - 1) <= rounding, drive << mass << more);
  };
  for (const std::string mass : {"1.0", "1e3", "1e6"})
    for (const std::string stiffness : {"1.7e13", "1.7e14", "1.7e16"})
      near_rigid("kd", mass, "kd = " + stiffness + "\n");
  for (const std::string mass : {"1e13", "1e16", "1e20", "1e40"}) {
    near_rigid("kd", mass, "kd = 0.7\n");
    near_rigid("kd | cd", mass, "kd = 0.7\ncd = 0.4\n");
    near_rigid("kd | (kb - cb)", mass, "kd = 0.7\nkb = 3e6\ncb = 4e9\n");
  }
}

// In sliding the tangential deformations are mu0 K_n/K_t times the normal ones whatever the
// network: v* is Eq. (24) where the surfaces touch as u_z rises fastest, and less elsewhere.
BOOST_AUTO_TEST_CASE(isotropic_contacts_under_a_rigid_drive) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-1.5, 1.5), size(1.2, 6);
  int kept = 0, lower = 0, opened = 0;
  for (int i = 0; i < 120; ++i) {
    const auto number = [&] { return std::to_string(std::pow(10, exponent(random))); };
    const char* const networks[] = {"k0 | c1", "zener(k0, k1, c1)", "(k0 | c1) - k1",
                                    "k0 | (k1 - c1) | c2"};
    const Scene scene = scene_of(
        std::string("normal = \"") + networks[i % 4] + "\"\ntangential_ratio = 0.8", size(random),
        "[elements]\nk0 = " + number() + "\nk1 = " + number() + "\nc1 = " + number() +
            "\nc2 = " + number() + "\n");
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

// With a network of its own the tangential contact remembers: the last stick of a start at rest,
// the simulator's other witness, vanishes at the same speed, and Eq. (24) is off.
BOOST_AUTO_TEST_CASE(other_contacts_are_simulated) {
  const Scene scene = scene_of("normal = \"k | c\"\ntangential = \"kt | ct\"", 3,
                               "[elements]\nk = 1.0\nc = 0.6\nkt = 0.8\nct = 2.0\n");
  const CriticalOnset onset = critical_onset(scene);
  BOOST_TEST((onset.by == CriticalOnset::By::simulation));
  BOOST_TEST(std::isnan(onset.relative_error_bound));
  const double rest = simulation::stick_onset(simulation::system_of(scene)).contact_velocity;
  // Sticks that last less than 1e-6 of a period are found.
  BOOST_TEST(std::abs(onset.contact_velocity / rest - 1) <= 1e-11);
  BOOST_TEST(std::abs(certified_critical_velocity(scene).value / rest - 1) > 0.01);
}

BOOST_AUTO_TEST_CASE(a_force_that_jumps_sticks_at_any_speed) {
  const CriticalOnset onset = critical_onset(scene_of("normal = \"k | c\"\ntangential = \"kt\"", 3,
                                                      "[elements]\nk = 1.0\nc = 0.6\nkt = 0.8\n"));
  BOOST_TEST(std::isinf(onset.contact_velocity));
  BOOST_TEST(onset.reason.find("sticks for a moment") != std::string::npos);
}

// Surfaces that may part and do not: the same numbers as without.
BOOST_AUTO_TEST_CASE(closed_contacts_are_as_ever) {
  const std::string text = scene_text("normal = \"k | c\"\ntangential = \"kt | ct\"", 0.2,
                                      "[elements]\nk = 1.0\nc = 0.6\nkt = 0.8\nct = 2.0\n");
  const Scene may = parse_scene(text, "s.toml");
  BOOST_TEST(!opens(may));
  std::string closed = text;
  closed.erase(closed.find("separation = true\n"), 18);
  const Scene never = parse_scene(closed, "s.toml");
  BOOST_TEST(critical_onset(may).contact_velocity == critical_onset(never).contact_velocity);
  BOOST_TEST((critical_onset(may).by == CriticalOnset::By::formula));
}

// d ln v*/d ln p of a scene whose v* is simulated: differences of an independent program's v*, in
// 34 digits, given to nine.
// By hand, omega = 1: K_d = k1 b/(k1 + b) of a chain with b = k2 - m1 n^2, and k + ka b/(ka + b) of
// a spring and an absorber with b = -ma n^2. A mass m = K_d/n^2 at its end swings freely.
BOOST_AUTO_TEST_CASE(drives_with_masses_swing_at_harmonics_too) {
  const auto onset = [](const std::string& drive, double mass, const std::string& elements) {
    return critical_onset(parse_scene(
        "[contact]\nnormal = \"kn | cn\"\ntangential = \"kt\"\n[drive]\nnetwork = \"" + drive +
            "\"\n[body]\nmass = " + fmt::format("{}", mass) +
            "\n[oscillation]\nangular_frequency = 1\namplitude = 0.1\nindentation = 1\n"
            "[friction]\ncoefficient = 0.5\n[elements]\nkn = 3.0\ncn = 0.4\nkt = 2.0\n" +
            elements,
        "s.toml"));
  };
  const auto swings = [](const CriticalOnset& found, int n) {
    BOOST_TEST(found.free_harmonics == (n > 1 ? std::vector{n} : std::vector<int>{}));
    const double share = n > 1 ? std::cos(std::numbers::pi / (2 * n)) : 1;
    BOOST_TEST(std::abs(found.sliding_from / (share * found.contact_velocity) - 1) < 1e-15);
  };
  for (const int n : {2, 3, 17}) {
    const double b = 7.0 * n * n - 0.4 * n * n, chain = 5.0 * b / (5 + b) / n / n;
    const std::string springs = fmt::format("k1 = 5.0\nk2 = {}\nm1 = 0.4\n", 7.0 * n * n);
    swings(onset("k1 - (mass(m1) | k2)", chain, springs), n);
    swings(onset("k1 - (mass(m1) | k2)", 1.0001 * chain, springs), 0);
    swings(onset("k1 - (mass(m1) | k2 | c2)", chain, springs + "c2 = 1e-4\n"), 0);
    const double a = -0.9 * n * n, absorber = (60.0 * n * n + 2 * a / (2 + a)) / n / n;
    const std::string tuned = fmt::format("kd = {}\nka = 2.0\nma = 0.9\n", 60.0 * n * n);
    swings(onset("kd | ka - mass(ma)", absorber, tuned), n);
    // Tuned to n, an absorber holds the body still there.
    swings(onset("kd | ka - mass(ma)", 1, fmt::format("kd = 5\nka = {}\nma = 1\n", n * n)), 0);
  }
}

// K_d = k1 (k2 - m1 n^2)/(k1 + k2 - m1 n^2) is m n^2 at n = 2 and n = 3: 2/3 and 3/2. Both swings
// together leave 1/(2 cos(pi/5)) of v* (Fejer), and the drive alone swings at n where k2 = m1 n^2.
BOOST_AUTO_TEST_CASE(several_swings_lower_the_border_further) {
  const auto onset = [](const std::string& drive, const std::string& body, double k2) {
    return critical_onset(parse_scene(
        "[contact]\nnormal = \"kn | cn\"\ntangential = \"kt\"\n[drive]\nnetwork = \"" + drive +
            "\"\n" + body +
            "[oscillation]\nangular_frequency = 1\namplitude = 0.1\nindentation = 1\n[friction]\n"
            "coefficient = 0.5\n[elements]\nkn = 3.0\ncn = 0.4\nkt = 2.0\nk1 = 1.0\nm1 = 1.0\n" +
            fmt::format("k2 = {}\n", k2),
        "s.toml"));
  };
  const std::string chain = "k1 - (mass(m1) | k2)", body = "[body]\nmass = 0.16666666666666666\n";
  const CriticalOnset both = onset(chain, body, 6);
  BOOST_TEST(both.free_harmonics == (std::vector{2, 3}));
  const double share = 1 / (2 * std::cos(std::numbers::pi / 5));
  BOOST_TEST(std::abs(both.sliding_from / both.contact_velocity / share - 1) <= 1e-11);
  BOOST_TEST(onset(chain, body, 6.001).free_harmonics.empty());
  const CriticalOnset light = onset(chain, "", 9);
  BOOST_TEST(light.free_harmonics == std::vector{3});
  BOOST_TEST(light.sliding_from == light.contact_velocity * std::cos(std::numbers::pi / 6));
}

BOOST_AUTO_TEST_CASE(sensitivities_are_those_of_the_simulated_velocity) {
  const Scene scene = parse_scene(
      "[contact]\nnormal = \"zener(k0, k1, c1)\"\ntangential_ratio = 0.8\nseparation = true\n"
      "[oscillation]\nangular_frequency = 1e5\namplitude = 1e-6\nindentation = 3e-7\n"
      "[friction]\ncoefficient = 0.3\n[elements]\nk0 = 2e5\nk1 = 2e6\nc1 = 40\n",
      "memory.toml");
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
  const Scene closed = scene_of("normal = \"k | c\"\ntangential = \"kt\"", 0.2,
                                "[elements]\nk = 1.0\nc = 0.6\nkt = 0.8\n");
  BOOST_TEST(onset_log_derivative(closed, {"kt"}) == -1);
}

BOOST_AUTO_TEST_SUITE_END()
