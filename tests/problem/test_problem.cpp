// A scene resolved: valid when made, never changed, its networks reduced once, safe to hold.
#include "problem/problem.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <thread>
#include <type_traits>

#include "base/constants.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "rules/kinds.hpp"
#include "scene/scene.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_problem)

namespace {

using namespace vcrit;

Scene driven() {
  return test::scene_of(
      {.normal = "k", .network = "kd", .mass = 1, .elements = {{"k", 3}, {"kd", 2}}});
}

Scene without_values() {
  return test::scene_of({.normal = "k", .network = "kd", .mass = "M", .amplitude = "u"});
}

BOOST_AUTO_TEST_CASE(it_has_the_numbers_of_its_scene) {
  const Problem problem = resolve(driven());
  BOOST_TEST(problem.values().size() == 8U);
  BOOST_TEST(problem.value(*problem->mass) == 1);
  BOOST_TEST(problem.values().at({"kd"}) == 2);
  BOOST_TEST(problem->drive_network() != nullptr);
  BOOST_TEST(!problem->rigid());
  BOOST_TEST(!problem->has_masses());
}

BOOST_AUTO_TEST_CASE(missing_values_are_named_together_where_they_are_asked_for) {
  const Problem problem = resolve(without_values());
  const std::string words = test::refusal([&] { problem.values(); });
  BOOST_TEST(words.find("no value for k, kd, ") != std::string::npos, words);
  BOOST_TEST(words.find("M") != std::string::npos, words);
  BOOST_TEST(problem.known_values().contains({"omega"}));
  BOOST_TEST(!problem.known_values().contains({"k"}));
}

// The struct is public: what was changed in it is checked when it is resolved.
BOOST_AUTO_TEST_CASE(a_changed_scene_is_checked) {
  const auto refused = [&](const std::string& expected, auto change) {
    Scene changed = driven();
    change(changed);
    const std::string words = test::refusal([&] { resolve(changed); });
    BOOST_TEST(words.find("found " + expected + "; expected ") != std::string::npos, words);
  };
  refused("mu0 = -1", [](Scene& s) { s.coefficient.value = -1; });
  refused("omega = 0", [](Scene& s) { s.angular_frequency.value = 0; });
  refused("du_z = inf", [](Scene& s) { s.amplitude.value = HUGE_VAL; });
  refused("u_z0 = nan", [](Scene& s) { s.indentation.value = NAN; });
  refused("m = 0", [](Scene& s) { s.mass->value = 0; });
  refused("poisson = 0.6",
          [](Scene& s) { std::get<Isotropic>(s.tangential).quantity.value = 0.6; });
  for (const double wrong : {-5.0, 0.0})
    refused(wrong == 0 ? "k = 0" : "k = -5", [wrong](Scene& s) { s.elements[0].second = wrong; });
}

BOOST_AUTO_TEST_CASE(other_numbers_make_another_problem) {
  const Problem problem = driven();
  const Problem other = problem.with({{{"k"}, 5}, {{"omega"}, 7}, {{"poisson"}, 0.25}});
  BOOST_TEST(other.values().at({"k"}) == 5);
  BOOST_TEST(*other->angular_frequency.value == 7);
  BOOST_TEST(tangential_network(other).factor == 2 * 0.75 / 1.75);
  BOOST_TEST(problem.values().at({"k"}) == 3);
  BOOST_TEST(&other->normal.network() == &problem->normal.network());
  BOOST_CHECK_THROW(problem.with({{{"k"}, 0}}), InputError);
  BOOST_CHECK_THROW(problem.with({{{"k2"}, 1}}), InputError);
  BOOST_TEST(resolve(without_values())
                 .with({{{"k"}, 1}, {{"kd"}, 1}, {{"m"}, 1}, {{"du_z"}, 1}})
                 .values()
                 .size() == 8U);
}

// Its symbols know their places among its numbers; those of another problem lie elsewhere.
BOOST_AUTO_TEST_CASE(symbols_of_one_problem_are_no_places_of_another) {
  const Problem one = resolve(test::scene_of({.normal = "k", .elements = {{"k", 3}}}));
  const Problem other = resolve(test::scene_of({.normal = "k",
                                                .network = "kd | c",
                                                .mass = 1,
                                                .elements = {{"c", 7}, {"k", 5}, {"kd", 2}}}));
  const auto spring_of = [](const Problem& problem) {
    return std::get<Element>(problem->normal.network().form).coefficient.symbol();
  };
  const Symbol here = spring_of(one), there = spring_of(other);
  BOOST_TEST(here.place >= 0);
  BOOST_TEST(there.place >= 0);
  BOOST_TEST(here.place != there.place);  // c is before k
  BOOST_TEST(one.values().at(here) == 3);
  BOOST_TEST(other.values().at(there) == 5);
  BOOST_TEST(one.values().at(there) == 3);
  BOOST_TEST(other.values().at(here) == 5);
  const Problem changed = other.with({{here, 4}});
  BOOST_TEST(changed.values().at({"k"}) == 4);
  BOOST_TEST(changed.values().at({"c"}) == 7);
  BOOST_TEST(dynamic_stiffness(changed->normal.reduction(), changed.values(), 1).real() == 4);
  BOOST_TEST(dynamic_stiffness(one->normal.reduction(), other.values(), 1).real() == 5);
}

// 2 pi f is known as such to those who carry it exactly.
BOOST_AUTO_TEST_CASE(a_frequency_is_kept_beside_omega) {
  const Problem there = resolve(driven()).with({{frequency_symbol, 3}});
  BOOST_TEST(there.value(there->angular_frequency) == two_pi * 3);
  BOOST_TEST(there->frequency->value == 3);
}

BOOST_AUTO_TEST_CASE(its_networks_are_reduced_once) {
  const Problem problem = driven();
  const std::size_t before = reductions_made();
  for (const double omega : {1.0, 2.0, 3.0}) {
    const Problem there = problem.with({{{"omega"}, omega}});
    critical_velocity(there);
    certified_critical_velocity(there);
    creep_velocity(there);
  }
  BOOST_TEST(reductions_made() - before == 2U);  // K_n and K_d
}

BOOST_AUTO_TEST_CASE(threads_share_a_reduction) {
  const Problem problem = driven();
  const std::size_t before = reductions_made();
  std::vector<const Reduction*> found(8);
  std::vector<std::thread> threads;
  for (const Reduction*& each : found)
    threads.emplace_back([&each, problem] { each = &problem->normal.reduction(); });
  for (std::thread& thread : threads) thread.join();
  for (const Reduction* each : found) BOOST_TEST(each == &problem->normal.reduction());
  BOOST_TEST(reductions_made() - before == 1U);
}

// All that holds a problem may be made of a scene that is gone: the sanitizers look.
BOOST_AUTO_TEST_CASE(what_it_is_made_of_may_go) {
  const rules::Facts facts(driven());
  BOOST_TEST(facts.is(rules::SceneKind::no_indenter));
  BOOST_TEST(facts.value(facts.problem()->amplitude) == 0.1);
  const ScaledNetwork tangential = tangential_network(driven());
  BOOST_TEST(tangential.network.reduction().steps.size() == 1U);
  static_assert(std::is_same_v<decltype(resolve(driven()).values()), Values>);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
