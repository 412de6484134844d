// Design questions of indenters, on a rigid drive and on one that gives: what is answered is what
// was asked for, and no worse than a value that is known to reach it.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "answers/critical_onset.hpp"
#include "answers/friction.hpp"
#include "design/opening.hpp"
#include "design/solve.hpp"
#include "indenter/friction.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_solve_indenter)

namespace {

using namespace vcrit;
using design::DesignAnswer;
using design::DesignQuestion;
using design::Sought;
using test::has;
using test::SceneText;

constexpr double turn = 2 * std::numbers::pi;

const std::string parabola = "shape = \"parabola\"\nradius = 1\n";

/// Of unit modulus and depth, or under a load of 1; half an amplitude.
SceneText tip(const std::string& shape, bool load) {
  SceneText text{.normal = "spring(E)",
                 .poisson = 0.3,
                 .indenter = shape,
                 .angular_frequency = 1,
                 .amplitude = 0.5,
                 .indentation = 1,
                 .coefficient = 0.3,
                 .elements = {{"E", 1}}};
  if (load) text.force = 1;
  return text;
}

SceneText on_drive(SceneText text, double mass) {
  text.network = "spring(kd) | damper(cd)";
  text.elements.insert(text.elements.end(), {{"kd", 2}, {"cd", 0.4}});
  if (mass > 0) text.mass = mass;
  return text;
}

SceneText relaxing(SceneText text) {
  text.normal = "spring(E) | (spring(E1) - damper(eta))";
  text.elements.insert(text.elements.end(), {{"E1", 0.5}, {"eta", 0.4}});
  return text;
}

double ratio_of(const Problem& problem, double velocity) {
  return SteadyFriction(problem).at(velocity).friction_ratio;
}

double ratio_with(const DesignQuestion& asked, double value) {
  switch (asked.sought) {
    case Sought::velocity:
      return ratio_of(asked.problem, value);
    case Sought::amplitude:
      return ratio_of(design::with_amplitude(asked.problem, value), asked.velocity);
    case Sought::frequency:
      return ratio_of(design::with_angular_frequency(asked.problem, turn * value), asked.velocity);
    case Sought::force:
      return ratio_of(design::with_load(asked.problem, value), asked.velocity);
  }
  return 0;
}

std::string refusal(const DesignQuestion& asked) {
  return test::refusal<ModelError>([&] { design::solve(asked); });
}

/// A question that the scene's own value of what is sought is known to answer.
void check(const DesignQuestion& asked, double known) {
  const DesignAnswer answer = design::solve(asked);
  const double side = is_largest(asked.sought) ? 1 : -1;
  BOOST_TEST(answer.state.friction_ratio <= asked.friction_ratio);
  BOOST_TEST(ratio_with(asked, answer.value) == answer.state.friction_ratio);
  BOOST_TEST(answer.unanswered == 0);
  BOOST_TEST(side * (answer.value - known) >= -answer.value_error - 1e-9 * known);
  if (!answer.at_start)
    BOOST_TEST(ratio_with(asked, answer.value + side * (2 * answer.value_error + 1e-6 * known)) >
               asked.friction_ratio - answer.state.friction_ratio_error);
}

void check_all(const SceneText& text, double share, int samples) {
  const Problem problem = test::scene_of(text);
  const double velocity = share * critical_onset(problem).drive_velocity;
  const double wanted = ratio_of(problem, velocity);
  BOOST_TEST_REQUIRE(wanted < 0.99);
  const auto question = [&](Sought sought) {
    return DesignQuestion{problem, sought, wanted, sought == Sought::velocity ? 0 : velocity,
                          {},      {},     samples};
  };
  check(question(Sought::velocity), velocity);
  check(question(Sought::amplitude), problem.value(problem->amplitude));
  DesignQuestion frequency = question(Sought::frequency);
  const double here = problem.value(problem->angular_frequency) / turn;
  frequency.from = 0.9 * here, frequency.to = 1.1 * here;
  check(frequency, here);
  if (problem->load) check(question(Sought::force), problem.value(*problem->load));
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_answered_is_what_was_asked_for) {
  const std::string cone = "shape = \"cone\"\nangle = 0.5\n";
  const std::vector<std::pair<const char*, SceneText>> cases{
      {"rigid", tip(parabola, false)},
      {"rigid, load", tip(parabola, true)},
      {"rigid, relaxing, load", relaxing(tip(cone, true))},
      {"spring and damper", on_drive(tip(parabola, false), 0)},
      {"body", on_drive(tip(parabola, false), 0.3)},
      {"body, load", on_drive(tip(parabola, true), 0.3)},
      {"flat, body", on_drive(tip("shape = \"flat\"\nradius = 0.5\n", false), 0.3)}};
  for (const auto& [name, text] : cases) BOOST_TEST_CONTEXT(name) check_all(text, 0.4, 4);
}

BOOST_AUTO_TEST_CASE(so_it_is_of_cells_in_steps_of_time) {
  const Problem problem = test::scene_of(on_drive(relaxing(tip(parabola, false)), 0));
  const double velocity = 0.4 * critical_onset(problem).drive_velocity;
  const double wanted = ratio_of(problem, velocity);
  check({problem, Sought::velocity, wanted, 0, {}, {}}, velocity);
  check({problem, Sought::amplitude, wanted, velocity, 0.4, 0.6, 3}, 0.5);
}

// A drive that creeps carries less and less as it slows down, c v: any ratio is reached.
BOOST_AUTO_TEST_CASE(a_drive_that_creeps_has_a_speed_for_every_ratio) {
  SceneText text = tip(parabola, true);
  text.network = "damper(cd)";
  text.elements.emplace_back("cd", 4);
  const DesignAnswer answer =
      design::solve({test::scene_of(text), Sought::velocity, 0.01, 0, {}, {}});
  BOOST_TEST(answer.value == 0.01 * 0.3 / 4, boost::test_tools::tolerance(1e-10));
}

// One contact of springs: mu_macro/mu0 = 1 - (du_z/u_z0) G(v/v*), v* = mu0 omega du_z/kappa; 20
// digits of G(1/2) and G(1/4) by an independent computation.
BOOST_AUTO_TEST_CASE(a_flat_punch_has_the_closed_form) {
  const Problem problem = test::scene_of(tip("shape = \"flat\"\nradius = 0.5\n", false));
  const double kappa = 2 * (1 - 0.3) / (2 - 0.3), critical = 0.3 * 0.5 / kappa;
  for (const auto& [share, g] :
       {std::pair{0.5, 0.2014522033336686888}, {0.25, 0.4918816026829403061}}) {
    const double wanted = 1 - 0.5 * g;
    BOOST_TEST(
        design::solve({problem, Sought::velocity, wanted, 0, {}, {}}).value == share * critical,
        boost::test_tools::tolerance(1e-12));
    BOOST_TEST(
        design::solve({problem, Sought::amplitude, wanted, share * critical, {}, {}}).value == 0.5,
        boost::test_tools::tolerance(1e-12));
  }
}

// Lengths along and across the surface scale alike: of a parabola under a rigid drive the ratio
// depends on du_z/u_z0 and v/v* alone, and the load of a given du_z/u_z0 is as u_z0^(3/2).
BOOST_AUTO_TEST_CASE(a_load_and_an_indentation_have_one_answer) {
  const Problem given = test::scene_of(tip(parabola, false));
  const double force = indenter::friction(indenter::HalfSpace(given), 1).normal_force;
  const Problem loaded = design::with_load(test::scene_of(tip(parabola, true)), force);
  const double velocity = 0.3 * critical_onset(given).contact_velocity;
  const double wanted = ratio_of(given, velocity);
  const DesignAnswer answer = design::solve({loaded, Sought::force, wanted, velocity, {}, {}});
  // The depth under a load is right to some 1e-10.
  BOOST_TEST(answer.value == force, boost::test_tools::tolerance(1e-8));
  // At the depth of 0.5 the centre opens: (4/3) E* (3/2)^... of the cells is what the least load
  // is.
  BOOST_TEST(answer.largest_amplitude == design::NormalContact(loaded).largest_amplitude(1),
             boost::test_tools::tolerance(1e-8));
  const DesignAnswer amplitude =
      design::solve({loaded, Sought::amplitude, wanted, velocity, {}, {}});
  BOOST_TEST(amplitude.value == 0.5, boost::test_tools::tolerance(1e-8));
}

// The centre opens at du_z = u_z0 of an elastic half-space, which carries least_force() then.
BOOST_AUTO_TEST_CASE(the_centre_tells_where_the_contact_opens) {
  const Problem loaded = test::scene_of(tip(parabola, true));
  const design::NormalContact contact(loaded);
  const double most = contact.largest_amplitude(1), least = contact.least_force(most, 1);
  BOOST_TEST(least == 1, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(!contact.largest_angular_frequency(0.9 * most).has_value());
  // Of a half-space that relaxes |E| grows, so that a smaller amplitude opens it above a frequency.
  const Problem soft = test::scene_of(relaxing(tip(parabola, true)));
  const design::NormalContact other(soft);
  const double at_one = other.largest_amplitude(1);
  const auto frequency = other.largest_angular_frequency(at_one);
  BOOST_TEST_REQUIRE(frequency.has_value());
  BOOST_TEST(*frequency == 1, boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_reached_is_explained) {
  for (const bool held : {false, true}) {
    const SceneText text = held ? on_drive(tip(parabola, true), 0.3) : tip(parabola, true);
    const Problem problem = test::scene_of(text);
    const double critical = critical_onset(problem).drive_velocity;
    BOOST_TEST_CONTEXT(held) {
      const std::string slow = refusal({problem, Sought::velocity, 0.01, 0, {}, {}});
      BOOST_TEST(has(slow, "no velocity reaches a friction ratio of 0.01"));
      BOOST_TEST(has(slow, "it takes a larger amplitude, or a smaller load"));
      BOOST_TEST(has(slow, "as the velocity vanishes it tends to 0."));
      BOOST_TEST(has(refusal({problem, Sought::amplitude, 0.9, 100 * critical, {}, {}, 4}),
                     "friction stays full at every admissible amplitude"));
      BOOST_TEST(has(refusal({problem, Sought::force, 0.9, 100 * critical, {}, {}, 4}),
                     "friction stays full at every"));
      BOOST_TEST(has(refusal({problem, Sought::frequency, 0.9, 100 * critical, 0.1, 0.2, 4}),
                     "friction stays full at every searched frequency"));
      BOOST_TEST(has(refusal({problem, Sought::amplitude, 0.2, 0.9 * critical, {}, {}, 4}),
                     "it takes a velocity of at most"));
    }
  }
}

// All states share one bound on the work, of which a sentence tells.
BOOST_AUTO_TEST_CASE(the_work_is_bounded) {
  const Problem problem = test::scene_of(on_drive(tip(parabola, false), 0.3));
  BOOST_TEST(has(refusal({problem, Sought::amplitude, 0.9, 0.05, {}, {}, 4, 1000}),
                 "the bound on the work for all steady states together is reached"));
}

BOOST_AUTO_TEST_SUITE_END()
