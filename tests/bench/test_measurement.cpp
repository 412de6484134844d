// How answers are judged and times compared, with methods made up for it.
#include "simulators/measurement.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

#include "simulators/summary.hpp"

BOOST_AUTO_TEST_SUITE(test_measurement)

namespace {

using namespace vcrit;
using namespace vcrit::simulators;

Case a_case() {
  Case row;
  row.problem = "P1";
  row.name = "a row";
  row.friction_ratio = 0.6;
  row.events = 2;
  return row;
}

Peer::Setting answers(double ratio, std::size_t events, std::optional<double> tolerance) {
  return {"s", tolerance, [=](const Case&) { return PeerAnswer{ratio, events}; }};
}

Peer::Setting says(const std::string& words) {
  return {"s", 1e-8, [=](const Case&) -> PeerAnswer { throw std::runtime_error(words); }};
}

Peer::Setting never_ends() {
  return {"s", 1e-8, [](const Case&) {
            volatile double sum = 0;
            for (;;) sum = sum + 1;
            return PeerAnswer{sum, 0};
          }};
}

std::vector<PeerSolve> measured(const std::vector<Case>& cases, const std::vector<Peer>& peers) {
  return measure(cases, peers, {0.05, 0}, [](const std::string&) {});
}

RunVerdict verdict(const Case& row, Peer peer, const Peer::Setting& setting) {
  peer.settings = {setting};
  return measured({row}, {peer}).at(0).verdict;
}

}  // namespace

BOOST_AUTO_TEST_CASE(answers_near_enough_are_right) {
  const Peer peer{.name = "GSL x"};
  BOOST_TEST((verdict(a_case(), peer, answers(0.6 + 9e-6, 2, 1e-8)) == RunVerdict::right));
  BOOST_TEST((verdict(a_case(), peer, answers(0.6 + 2e-5, 2, 1e-8)) == RunVerdict::wrong));
  BOOST_TEST((verdict(a_case(), peer, answers(0.6 + 0.04, 2, {})) == RunVerdict::right));
  BOOST_TEST((verdict(a_case(), peer, answers(0.6 + 0.06, 2, {})) == RunVerdict::wrong));
  BOOST_TEST((verdict(a_case(), peer, answers(0.6 + 0.06, 2, 1)) == RunVerdict::wrong));
  BOOST_TEST((verdict(a_case(), peer, answers(std::nan(""), 2, 1e-8)) == RunVerdict::wrong));
}

BOOST_AUTO_TEST_CASE(marching_that_stopped_early_has_drifted) {
  const Peer peer{.name = "GSL x", .cycles = true};
  BOOST_TEST((verdict(a_case(), peer, answers(0.6 + 1e-3, 2, 1e-8)) == RunVerdict::drift));
  BOOST_TEST((verdict(a_case(), peer, answers(1, 0, 1e-8)) == RunVerdict::drift));
}

BOOST_AUTO_TEST_CASE(stick_that_was_not_seen_is_missed_however_small_the_error) {
  Case row = a_case();
  row.grazing = true;
  row.friction_ratio = 1 - 1e-5;
  const Peer peer{.name = "GSL x"};
  BOOST_TEST((verdict(row, peer, answers(1, 0, 1e-4)) == RunVerdict::missed_grazing));
  BOOST_TEST((verdict(row, peer, answers(1, 2, 1e-4)) == RunVerdict::right));
  const Peer smooth{.name = "tanh", .idealised = true};
  BOOST_TEST((verdict(row, smooth, answers(1, 0, 1e-4)) == RunVerdict::right));
}

BOOST_AUTO_TEST_CASE(what_a_method_says_is_kept) {
  const Peer peer{.name = "GSL x"};
  BOOST_TEST((verdict(a_case(), peer, says("it is chattering")) == RunVerdict::chattering));
  BOOST_TEST((verdict(a_case(), peer, says("step size underflow")) == RunVerdict::not_finished));
  Peer talking = peer;
  talking.settings = {says("step size underflow")};
  BOOST_TEST(measured({a_case()}, {talking}).at(0).words == "step size underflow");
}

BOOST_AUTO_TEST_CASE(after_one_without_end_the_more_accurate_are_not_tried) {
  Peer peer{.name = "GSL x"};
  peer.settings = {answers(0.6, 2, 1e-4), never_ends(), answers(0.6, 2, 1e-12)};
  const std::vector<Case> cases{a_case()};
  const auto points = measured(cases, {peer});
  BOOST_TEST(points.at(0).answered);
  BOOST_TEST(points.at(1).words == "out of time");
  BOOST_TEST((points.at(2).verdict == RunVerdict::not_finished));
  BOOST_TEST(!points.at(2).answered);
}

BOOST_AUTO_TEST_CASE(a_method_that_crashes_takes_nothing_with_it) {
  Peer peer{.name = "GSL x"};
  peer.settings = {{"s", 1e-8, [](const Case&) -> PeerAnswer { _exit(7); }}, answers(0.6, 2, 1e-8)};
  const auto points = measured({a_case()}, {peer});
  BOOST_TEST(points.at(0).words == "crashed");
  BOOST_TEST(points.at(1).answered);
}

namespace {

/// Two rows; the exact method 1 s, peers as given.
struct Fixture {
  std::vector<Case> cases{a_case(), a_case()};
  std::vector<Peer> peers{{.name = exact_name}, {.name = "GSL x"}, {.name = "Moreau"}};
  std::vector<PeerSolve> points;

  Fixture() {
    for (Peer& peer : peers) peer.settings = {answers(0.6, 2, {}), answers(0.6, 2, {})};
    for (const Case& row : cases) add(row, 0, 0, 1, 1e-15);
  }
  void add(const Case& row, std::size_t peer, std::size_t setting, double seconds, double error,
           RunVerdict verdict = RunVerdict::right) {
    points.push_back(
        {&row, &peers[peer], &peers[peer].settings[setting], verdict, true, seconds, 0.6, error});
  }
  PeerComparison compared(double error) const {
    return compare(points, error, [](const Case&) { return true; });
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_fastest_peer_that_is_accurate_enough_counts_on_each_row) {
  Fixture f;
  f.add(f.cases[0], 1, 0, 3, 1e-6);
  f.add(f.cases[0], 1, 1, 50, 1e-11);
  f.add(f.cases[1], 1, 0, 4, 1e-7);
  f.add(f.cases[1], 2, 0, 0.1, 1e-12);  // no integrator with events: not among the rivals
  BOOST_TEST(f.compared(1e-10).least == 50);
  BOOST_TEST(f.compared(1e-10).lost == 1u);
  BOOST_TEST(f.compared(1e-6).least == 3);
  BOOST_TEST(f.compared(1e-6).lost == 0u);
  BOOST_TEST(!f.compared(1e-10).one_setting.has_value());
  BOOST_REQUIRE(f.compared(1e-6).one_setting.has_value());
  BOOST_TEST(f.compared(1e-6).one_setting->seconds == 4);  // median of 3 and 4, the upper one
  BOOST_TEST(f.compared(1e-6).exact_median == 1);
  BOOST_TEST(f.compared(1e-6).largest_error == 1e-15);
}

BOOST_AUTO_TEST_CASE(no_answer_of_the_exact_method_is_an_infinite_error) {
  Fixture f;
  f.points[1].answered = false;
  BOOST_TEST(std::isinf(f.compared(1e-10).largest_error));
  BOOST_TEST(f.compared(1e-10).races.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_setting_with_wrong_answers_is_out_of_the_ranking) {
  Fixture f;
  for (const Case& row : f.cases) f.add(row, 1, 0, 0.5, 1e-6);
  f.add(f.cases[0], 2, 0, 0.2, 1e-8);
  f.add(f.cases[1], 2, 0, 0.2, 1e-7, RunVerdict::wrong);
  const auto lines = work_precision(f.points, [](const Case&) { return true; });
  BOOST_REQUIRE(lines.size() == 3u);
  BOOST_TEST(lines[0].front);  // slower than the peer, but more accurate
  BOOST_TEST(lines[1].front);  // what is wrong does not push it behind
  BOOST_TEST(lines[1].answered == 2u);
  BOOST_TEST(!lines[2].front);
  BOOST_TEST(lines[2].error == 1e-7);
  BOOST_TEST(lines[2].failures.at(RunVerdict::wrong) == 1u);
}

BOOST_AUTO_TEST_CASE(a_slower_and_less_accurate_setting_is_behind_the_front) {
  Fixture f;
  for (const Case& row : f.cases) f.add(row, 1, 0, 2, 1e-6);
  const auto lines = work_precision(f.points, [](const Case&) { return true; });
  BOOST_TEST(lines[0].front);
  BOOST_TEST(!lines[1].front);
}

BOOST_AUTO_TEST_SUITE_END()
