// Bounds on amplitude and frequency against the paper's (52) for a Kelvin contact, and against the
// scene reader's own admissibility on both sides.
#include "design/opening.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "critical/admissibility.hpp"
#include "design/range.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_opening)

namespace {

using namespace vcrit;
using design::NormalContact;

Scene scene(const std::string& name) { return read_scene(VCRIT_SCENES "/" + name); }

// Kelvin: |K_n|/k_n = sqrt(1 + (omega c/k)^2), so D sqrt(1 + delta^2) < 1 (52).
BOOST_AUTO_TEST_CASE(a_kelvin_contact_opens_where_the_paper_says) {
  const NormalContact contact(scene("kelvin.toml"));  // kn 10 N/um, cn 20 N s/m, u_z0 0.3 um
  const double omega = 2 * std::numbers::pi * 20e3, delta = omega * 20 / 10e6;
  // A handful of roundings each way.
  BOOST_TEST(std::abs(contact.largest_amplitude(omega) * std::sqrt(1 + delta * delta) / 0.3e-6 -
                      1) < 1e-14);
  // 0.1 um of 0.3 um: sqrt(1 + delta^2) = 3, omega = sqrt(8) k/c.
  const auto most = contact.largest_angular_frequency(0.1e-6);
  BOOST_TEST_REQUIRE(most.has_value());
  BOOST_TEST(std::abs(*most / (std::sqrt(8.0) * 10e6 / 20) - 1) < 1e-14);
}

BOOST_AUTO_TEST_CASE(both_bounds_part_admissible_scenes_from_others) {
  for (const char* name : {"kelvin.toml", "zener.toml", "prony.toml", "bridge.toml"}) {
    const Scene given = scene(name);
    const NormalContact contact(given);
    const double most = contact.largest_amplitude(*given.angular_frequency.value);
    BOOST_TEST(inadmissible_reasons(design::with_amplitude(given, most * (1 - 1e-12))).empty());
    BOOST_TEST(!inadmissible_reasons(design::with_amplitude(given, most * (1 + 1e-12))).empty());
    if (const auto bound = contact.largest_angular_frequency(*given.amplitude.value)) {
      // |K_n| may change slowly with omega, so that its rounding moves the bound: 1e-9 leaves room.
      const auto at = [&](double part) {
        return inadmissible_reasons(design::with_angular_frequency(given, *bound * part)).empty();
      };
      BOOST_TEST(at(1 - 1e-9));
      BOOST_TEST(!at(1 + 1e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(springs_that_end_the_rise_leave_no_bound) {
  // zener.toml at most stiffens from 8 to 12 N/um: 0.1 um against 0.5 um never opens it, 0.4 um
  // does.
  const NormalContact contact(scene("zener.toml"));
  BOOST_TEST(!contact.largest_angular_frequency(0.1e-6).has_value());
  BOOST_TEST(contact.largest_angular_frequency(0.4e-6).has_value());
  BOOST_CHECK_THROW(contact.largest_angular_frequency(0.5e-6), ModelError);
}

BOOST_AUTO_TEST_CASE(a_contact_without_load_is_outside_the_model) {
  test::SceneText text{.normal = "k1 - c1", .amplitude = {}, .elements = {{"k1", 1}, {"c1", 1}}};
  BOOST_CHECK_THROW(NormalContact(test::scene_of(text)), ModelError);
  text.elements.pop_back();
  BOOST_CHECK_THROW(NormalContact(test::scene_of(test::symbolic(text))), InputError);
}

// Springs: du_z kn = 0.3 N opens the contact, and 0.3/(1 - 0.9) N is the load of which the limit at
// rest is 0.9.
BOOST_AUTO_TEST_CASE(loads_are_searched_from_where_the_contact_opens) {
  const Problem problem = test::scene_of(
      {.tangential = "kt", .amplitude = 0.1, .force = 1, .elements = {{"kn", 3}, {"kt", 4}}});
  const design::SearchRange range =
      design::range_of({problem, design::Sought::force, 0.9, 0.01, {}, {}}, NormalContact(problem));
  BOOST_TEST(std::abs(range.from * 0.999999 / 0.3 - 1) < 1e-14);
  BOOST_TEST(std::abs(range.to / (2 * 0.3 / 0.1) - 1) < 1e-14);
}

// In resonance v* is infinite; speeds begin at 1e-9 of mu0 du_z kn omega (1/kt + 1/(kd + m
// omega^2)).
BOOST_AUTO_TEST_CASE(speeds_in_resonance_begin_at_those_out_of_it) {
  const Problem problem = test::scene_of({.tangential = "kt",
                                          .network = "kd",
                                          .mass = 2,
                                          .angular_frequency = 1,
                                          .elements = {{"kn", 3}, {"kt", 4}, {"kd", 2}}});
  const design::DesignQuestion asked{problem, design::Sought::velocity, 0.9, 0, {}, 10};
  const design::SearchRange range = design::range_of(asked, NormalContact(problem));
  BOOST_TEST(std::abs(range.from / (1e-9 * 0.5 * 0.1 * 3 * (0.25 + 0.25)) - 1) < 1e-14);
  BOOST_TEST(range.to == 10);
}

// kelvin.toml opens from sqrt(8) k/c = 1.414e6 rad/s on.
BOOST_AUTO_TEST_CASE(a_range_in_which_the_contact_opens_is_refused) {
  const Problem problem = scene("kelvin.toml");
  const std::string why = test::refusal<ModelError>([&] {
    design::range_of({problem, design::Sought::frequency, 0.9, 0.001, 300e3, 400e3},
                     NormalContact(problem));
  });
  BOOST_TEST(test::has(why, "the contact opens at all frequencies from 225.1 kHz on"), why);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
