// Extremes of one family: nothing fails, and planted faults do, in the region they are in.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "critical/certified.hpp"
#include "extremes/handover.hpp"
#include "extremes/judging.hpp"
#include "extremes/summary.hpp"
#include "problem/problem.hpp"
#include "scene/scene.hpp"
#include "simulation/steady/exact.hpp"
#include "support/scene_text.hpp"
#include "validation/extreme_family.hpp"

BOOST_AUTO_TEST_SUITE(test_extremes)

using namespace vcrit;
using namespace vcrit::validation;
using namespace vcrit::validation::extremes;
using example::extremes_of;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

const FamilyResult& honest_result() {
  static const FamilyResult result = example::elastic(example::honest());
  return result;
}

const Region& region_of(const FamilyResult& result, const std::string& key) {
  const auto found = std::find_if(result.regions.begin(), result.regions.end(),
                                  [&](const Region& region) { return region.key == key; });
  BOOST_REQUIRE(found != result.regions.end());
  return *found;
}

/// "resonance/accurate", ...: what failed.
std::vector<std::string> failures(const FamilyResult& result) {
  std::vector<std::string> names;
  for (const Region& region : result.regions)
    for (const Comparison& comparison : region.comparisons)
      if (outcome(comparison) == Comparison::Outcome::failed)
        names.push_back(region.key + "/" + comparison.key);
  return names;
}

const Tally& tally_of(const Region& region, const std::string& way) {
  return *std::find_if(region.tallies.begin(), region.tallies.end(),
                       [&](const Tally& tally) { return tally.way == way; });
}

Tally judged(double found, double right, std::vector<double> bounds, double condition = 1) {
  return tally({"accurate", {found}, std::move(bounds)}, {{right}, {condition}, {"here"}});
}

bool is_resonance(const accuracy::Cells& cells) { return cells.omega.empty(); }

}  // namespace

BOOST_AUTO_TEST_CASE(errors_over_bounds_by_hand) {
  BOOST_TEST(over_bound(1, 1, 0) == 0);
  BOOST_TEST(over_bound(1 + 0x1p-52, 1, 0x1p-53) == 1);  // bound and rounding: 2^-52
  BOOST_TEST(over_bound(1 + 0x1p-51, 1, 0x1p-53) == 2);
  BOOST_TEST(over_bound(infinite, infinite, 0) == 0);  // on resonance
  BOOST_TEST(over_bound(1e308, infinite, 0x1p-53) == infinite);
  BOOST_TEST(over_bound(none, 1, 1) == infinite);
  BOOST_TEST(over_bound(1, none, 1) == infinite);  // 0/0 has no value to be near
  BOOST_TEST(over_bound(0x1p-1074, 0, 0) == 1);    // half a last place each
  BOOST_TEST(over_bound(1e-300, 0, 1) > 1);        // on antiresonance
}

BOOST_AUTO_TEST_CASE(losses_by_hand) {
  // 2^-40 off, where 32 x 2^-53 = 2^-48 is explained: lost 8 log10(2) digits.
  const Tally lost = judged(1 + 0x1p-40, 1, {});
  BOOST_TEST(lost.lost == 1u);
  BOOST_TEST(std::abs(lost.worst_lost - 8 * std::log10(2)) < 1e-12);
  BOOST_TEST(lost.violated == 0u);
  BOOST_TEST(judged(1 + 0x1p-40, 1, {}, 0x1p8).lost == 0u);  // conditioning explains it
  BOOST_TEST(judged(1 + 0x1p-40, 1, {0x1p-42}).violated == 1u);
  BOOST_TEST(judged(1 + 0x1p-40, 1, {infinite}).uncertified == 1u);
  BOOST_TEST(judged(1 + 0x1p-40, 1, {infinite}).violated == 0u);
  BOOST_TEST(judged(none, 1, {}).no_number == 1u);
  BOOST_TEST(judged(0, 1, {}).no_number == 1u);
  BOOST_TEST(judged(none, 1, {0x1p-53}).violated == 1u);
  const Tally on_resonance = judged(infinite, infinite, {0});
  BOOST_TEST(on_resonance.values + on_resonance.no_number + on_resonance.violated == 0u);
  BOOST_TEST(judged(infinite, infinite, {infinite}).uncertified == 0u);
}

BOOST_AUTO_TEST_CASE(honest_witnesses_pass) {
  BOOST_TEST(failures(honest_result()).empty());
  for (const char* key : {"stiffness", "corners", "resonance", "antiresonance", "limits"})
    for (const char* way : {"library", "fast", "accurate", "accurate_batch", "certified"}) {
      const Tally& tally = tally_of(region_of(honest_result(), key), way);
      BOOST_TEST(tally.values > 0u);
      BOOST_TEST(tally.lost + tally.violated == 0u, key << " " << way);
    }
  const Region& resonance = region_of(honest_result(), "resonance");
  BOOST_REQUIRE(resonance.simulated);
  BOOST_TEST(resonance.simulated->right > 10u);
  // 15 distances on both sides; on the resonance itself v* is infinite.
  BOOST_TEST(tally_of(resonance, "accurate").values == 30u);
  BOOST_TEST(resonance.x.size() == 31u);
}

// (30): v* = mu0 omega du_z kn/kt |kt + kd - m omega^2|/|kd - m omega^2|, at powers of two a few
// roundings by hand: kn = 2, kt = 3, kd = 1, m = 1/4, mu0 = 1/4, du_z = 2^-20.
BOOST_AUTO_TEST_CASE(closed_formula_at_extremes) {
  struct Point {
    double omega, scale;
  };
  const Problem scene = problem_of(example::family("elastic"));
  accuracy::Cells cells;
  std::vector<double> expected;
  for (const Point& p : {Point{0x1p-20, 0x1p-100}, Point{0x1p50, 0x1p-100}, Point{0x1p-20, 0x1p100},
                         Point{0x1p50, 0x1p100}, Point{0x1p50, 1}}) {
    Values values = scene.values();
    values[{"omega"}] = p.omega;
    values[{"kn"}] *= p.scale;
    values[{"kt"}] *= p.scale;
    cells.values.push_back(values);
    const double inertia = p.omega * p.omega / 4;
    expected.push_back(0x1p-22 * p.omega * (2.0 / 3) *
                       std::abs((3 * p.scale + (1 - inertia)) / (1 - inertia)));
  }
  for (const Claimed& claimed : example::honest().evaluate(cells))
    for (std::size_t i = 0; i < expected.size(); ++i)
      // Nine roundings above, thirty in the plain evaluators; nothing cancels here.
      BOOST_TEST(std::abs(claimed.values[i] / expected[i] - 1) < 40 * 0x1p-53,
                 claimed.way << " " << i);
}

// (30) where it cancels: omega = 2 (1 +- 2^-k) makes |D| = 2^(1-k) +- 2^-2k, exactly.
BOOST_AUTO_TEST_CASE(resonance_by_hand) {
  const Problem scene = problem_of(example::family("elastic"));
  accuracy::Cells cells;
  std::vector<double> expected;
  for (const int k : {4, 10, 20, 25})
    for (const double sign : {-1.0, 1.0}) {
      const double d = std::ldexp(sign, -k);
      Values values = scene.values();
      values[{"omega"}] = 2 * (1 + d);
      cells.values.push_back(values);
      const double excess = d * (2 + d);  // m omega^2 - kd, exact: 2k + 1 bits
      expected.push_back(0x1p-22 * 2 * (1 + d) * (2.0 / 3) * (3 - excess) / std::abs(excess));
    }
  for (const Claimed& claimed : example::honest().evaluate(cells))
    if (claimed.way.starts_with("accurate"))
      for (std::size_t i = 0; i < expected.size(); ++i)
        // Seven roundings above and one unit in the last place.
        BOOST_TEST(std::abs(claimed.values[i] / expected[i] - 1) < 10 * 0x1p-53);
}

BOOST_AUTO_TEST_CASE(an_evaluator_that_loses_digits_is_seen) {
  const auto losing = example::faulty("library", [](Claimed& claimed, const auto& cells) {
    if (is_resonance(cells)) claimed.values.front() *= 1 + 1e-9;
  });
  const FamilyResult result = example::elastic(losing);
  BOOST_TEST(failures(result).empty());  // it claims nothing: a loss
  const Tally& tally = tally_of(region_of(result, "resonance"), "library");
  BOOST_REQUIRE(tally.lost == 1u);
  BOOST_TEST(tally.worst.front().inputs.starts_with("omega = 0x1.cc"));  // 2 (1 - 0.1)
  BOOST_TEST(tally_of(region_of(result, "stiffness"), "library").lost == 0u);
  const auto words = in_words(extremes_of(result));
  BOOST_TEST(std::any_of(words.begin(), words.end(), [](const std::string& sentence) {
    return sentence.find("Eq. 24 in doubles") != sentence.npos &&
           sentence.find("1 in resonance (elastic)") != sentence.npos;
  }));
}

BOOST_AUTO_TEST_CASE(a_bound_that_is_too_small_fails) {
  for (const char* way : {"accurate", "accurate_batch", "certified", "fast"}) {
    const auto proud = example::faulty(way, [](Claimed& claimed, const accuracy::Cells& cells) {
      if (cells.omega.empty()) return;
      claimed.values.at(3) *= 1 + 0x1p-40;
      claimed.bounds.at(3) = 0x1p-42;
    });
    BOOST_TEST((failures(example::elastic(proud)) == std::vector{std::string("stiffness/") + way}));
  }
}

BOOST_AUTO_TEST_CASE(no_number_where_it_is_certified_fails) {
  const auto silent = example::faulty("accurate_batch", [](Claimed& claimed, const auto& cells) {
    if (!cells.omega.empty()) claimed.values.back() = none;
  });
  BOOST_TEST(
      (failures(example::elastic(silent)) == std::vector<std::string>{"stiffness/accurate_batch"}));
}

// The massless value in place of v*: right at 1e-300 kg, and far beyond what Eq. 24 allows at 1e-3.
BOOST_AUTO_TEST_CASE(a_limit_that_is_reached_too_soon_or_never_fails) {
  for (const double factor : {1 - 0x1p-8, 1 + 0x1p-50}) {
    const auto wrong = example::faulty("accurate", [&](Claimed& claimed, const auto& cells) {
      if (!cells.omega.empty() || claimed.values.size() != 18) return;  // limits: 2 of 9 values
      for (double& value : claimed.values) value *= factor;
      std::fill(claimed.bounds.begin(), claimed.bounds.end(), infinite);
    });
    BOOST_TEST((failures(example::elastic(wrong)) ==
                std::vector<std::string>{"limits/limit", "limits/limit"}));
  }
}

BOOST_AUTO_TEST_CASE(a_simulator_that_always_slides_fails) {
  extremes::Subjects subjects = example::honest();
  subjects.ask = [](const Problem&, double right) {
    return accuracy::SimulatedCell{right, "misses the stick below v*"};
  };
  const FamilyResult result = example::elastic(subjects);
  BOOST_TEST((failures(result) ==
              std::vector<std::string>{"stiffness/simulation", "corners/simulation",
                                       "resonance/simulation", "antiresonance/simulation"}));
  BOOST_TEST(region_of(result, "corners").simulated->right == 0u);
}

BOOST_AUTO_TEST_CASE(a_simulator_without_answers_is_a_loss) {
  extremes::Subjects subjects = example::honest();
  subjects.ask = [](const Problem&, double) {
    return accuracy::SimulatedCell{none, "no answer: tired"};
  };
  const FamilyResult result = example::elastic(subjects);
  BOOST_TEST(failures(result).empty());
  const Simulated all = simulated_total(extremes_of(result));
  BOOST_TEST(all.silent == all.asked);
  BOOST_TEST(all.asked > 20u);
}

BOOST_AUTO_TEST_CASE(results_survive_the_way_between_processes) {
  const FamilyResult copy = taken_over(handed_over(honest_result()));
  BOOST_TEST(handed_over(copy) == handed_over(honest_result()));
  BOOST_TEST(copy.regions.size() == honest_result().regions.size());
  const Region& region = region_of(copy, "resonance");
  BOOST_TEST(region.condition == region_of(honest_result(), "resonance").condition);
  // On resonance itself: infinite, and no digits to count.
  BOOST_TEST(std::isinf(region.condition.at(15)));
  BOOST_TEST(std::isnan(tally_of(region, "fast").digits.at(15)));
}

BOOST_AUTO_TEST_CASE(it_is_the_same_in_every_run) {
  BOOST_TEST(handed_over(example::elastic(example::honest())) == handed_over(honest_result()));
}

// Why no omega of the grid divides the 2 rad/s of body and drive: at 2/200 the body may swing
// freely in each period alike, as slip leaves it alone, and v0 - v* cos(x) + a cos(200 x) with a =
// v* - v0 = 1e-6 v* is nowhere below 0, since 1 - cos(x) >= 2e-6 wherever cos(200 x) < 0, from x =
// pi/400 on. So all of friction is left below v*; off that frequency it is not.
BOOST_AUTO_TEST_CASE(harmonics_slide_below_v) {
  const auto friction_lost = [](double omega) {
    const Problem scene = problem_of(example::family("elastic")).with({{{"omega"}, omega}});
    const double below = certified_critical_velocity(scene).value * (1 - 1e-6);
    return 1 - simulation::steady_state(simulation::system_of(scene), below).friction_ratio;
  };
  // Slip in parts: a few roundings. Off it, some 1e-12, found by the simulator; its error is 1e-14.
  BOOST_TEST(std::abs(friction_lost(0.01)) < 1e-14);
  BOOST_TEST(friction_lost(0.0100123) > 1e-13);
}

// sqrt(k_d/m) = 2 omega, undamped: the swing -b cos 2t lowers the largest of cos t + that to b +
// 1/(8 b), least 1/sqrt(2) = 0.7071067... at b = 1/sqrt(8). Friction is full above, within the
// simulator's roundings, and by hand less than full below.
BOOST_AUTO_TEST_CASE(the_second_harmonic_slides_down_to_v_over_root_two) {
  const Scene scene = test::scene_of({.tangential = "kt",
                                      .network = "kd",
                                      .mass = 1,
                                      .angular_frequency = 1,
                                      .elements = {{"kn", 1}, {"kt", 1}, {"kd", 4}}});
  const double v = certified_critical_velocity(scene).value;
  const auto lost = [&](double ratio) {
    return 1 - simulation::steady_state(simulation::system_of(scene), ratio * v).friction_ratio;
  };
  BOOST_TEST(std::abs(lost(0.7072)) < 1e-13);
  BOOST_TEST(lost(0.7070) > 1e-11);
}

BOOST_AUTO_TEST_SUITE_END()
