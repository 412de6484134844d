// The trial of error bounds: its exact values against nodal analysis, its verdicts on made-up
// answers, a small run of it, and that it sees a bound that is too small.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/tables.hpp"
#include "bounds/trial.hpp"
#include "emit/generate.hpp"
#include "run/compiler.hpp"
#include "support/nodal.hpp"

BOOST_AUTO_TEST_SUITE(test_bounds)

using namespace vcrit;
using namespace vcrit::bounds;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

TrialSystem system_named(const std::string& name) {
  for (TrialSystem& system : all_systems())
    if (system.name == name) return system;
  throw std::runtime_error("no system " + name);
}

/// The system's scene with the numbers of a case.
Scene scene_with(const TrialSystem& system, const std::vector<double>& x) {
  Scene scene = parse_scene(system.problem->source->text, system.name);
  Values values;
  for (std::size_t i = 0; i < x.size(); ++i)
    values[{system.slots[i].name, system.slots[i].entry}] = x[i];
  for (auto& [symbol, value] : scene.elements) value = values.at(symbol);
  scene.coefficient.value = x[coefficient_slot];
  scene.angular_frequency.value = x[omega_slot];
  scene.amplitude.value = x[amplitude_slot];
  scene.indentation.value = 1;
  if (system.mass) scene.mass->value = x[*system.mass];
  if (system.poisson) std::get<Isotropic>(scene.tangential).quantity.value = x[*system.poisson];
  return scene;
}

Exact number(double high, double low, int exponent) {
  return {Exact::Kind::number, high, low, exponent};
}

std::optional<Violation> violation(const CertifiedAnswers& answers, const Exact& exact) {
  return judge(answers, exact).violation;
}

TrialTally tried(const TrialSystem& system, const std::string& header, std::uint64_t cases) {
  const validation::PrivateFolder folder;
  CompiledHeader evaluator(system, header, folder.path());
  evaluator.compile();
  return sum_of(try_cases(system, evaluator, {.cases = cases, .seed = 3, .threads = 2}));
}

std::uint64_t count(const TrialTally& tally, Violation violation) {
  return tally.violations[static_cast<std::size_t>(violation)];
}

}  // namespace

// The reference has 112 bits, nodal analysis 200 digits left.
BOOST_AUTO_TEST_CASE(exact_values_are_those_of_nodal_analysis) {
  for (const TrialSystem& system : all_systems()) {
    ExactReference reference(system);
    Cases cases(system, reference, 5);
    std::vector<double> x(system.slots.size());
    for (int i = 0; i < 30; ++i) {
      const Draw draw = i % 3 == 0 ? Draw::moderate : i % 3 == 1 ? Draw::stiff : Draw::powers;
      cases.fill(draw, x);
      const Exact exact = reference.velocity(x);
      BOOST_REQUIRE(exact.kind == Exact::Kind::number);
      const test::Real velocity = test::critical_velocity_by_nodes(scene_with(system, x));
      const test::Real mine = ldexp(test::Real(exact.high) + exact.low, exact.exponent);
      BOOST_TEST(static_cast<double>(abs(test::Real(mine / velocity - 1))) < 0x1p-104,
                 system.name << ", case " << i);
    }
  }
}

// No dampers, kn = kt = 1, kd = 4, omega = 2: K_d - m omega^2 vanishes at m = 1, K_t + K_d - m
// omega^2 at m = 1.25.
BOOST_AUTO_TEST_CASE(zeros_and_poles_are_told_from_their_neighbours) {
  const TrialSystem system = system_named("kelvin");
  ExactReference reference(system);
  const auto kind = [&](double mass, double tangential = 1) {
    return reference.velocity(std::vector<double>{1, 2, 1, 1, 0, tangential, 0, 4, 0, mass}).kind;
  };
  BOOST_TEST((kind(1) == Exact::Kind::pole));
  BOOST_TEST((kind(1.25) == Exact::Kind::zero));
  BOOST_TEST((kind(1 + 0x1p-52) == Exact::Kind::number));
  BOOST_TEST((kind(1.25 - 0x1p-52) == Exact::Kind::number));
  BOOST_TEST((kind(1, 0) == Exact::Kind::undefined));
  BOOST_TEST((kind(2, 0) == Exact::Kind::pole));
}

BOOST_AUTO_TEST_CASE(zeros_are_seen_behind_divisions) {
  // A balanced bridge of springs 3 is 3, by way of thirds; the contact and the drive are such.
  const TrialSystem bridge = system_named("bridge");
  ExactReference reference(bridge);
  std::vector<double> x(bridge.slots.size(), 0.0);
  x[coefficient_slot] = x[omega_slot] = x[amplitude_slot] = 1;
  for (std::size_t i = 0; i < 5; ++i)
    x[bridge.normal.first + i] = x[bridge.tangential.first + i] = x[bridge.driving.first + i] = 3;
  x[*bridge.mass] = 3;
  BOOST_TEST((reference.velocity(x).kind == Exact::Kind::pole));
  x[*bridge.mass] = 6;
  BOOST_TEST((reference.velocity(x).kind == Exact::Kind::zero));
}

BOOST_AUTO_TEST_CASE(a_value_farther_off_than_its_bound_is_a_violation) {
  const Exact exact = number(0.75, 0x1p-56, 0);  // 1/8 of the last place above 0.75
  BOOST_TEST((!violation({0.75, 0x1p-53, 0.75, inf}, exact)));
  BOOST_TEST((violation({0.75, 0x1p-57, 0.75, inf}, exact) == Violation::bound));
  BOOST_TEST((violation({0.75, 0, 0.75, inf}, exact) == Violation::bound));
  BOOST_TEST((violation({0.75, no_number, 0.75, inf}, exact) == Violation::bound));
  BOOST_TEST((violation({0.75, -1, 0.75, inf}, exact) == Violation::bound));
  BOOST_TEST((violation({no_number, 1, 0.75, inf}, exact) == Violation::bound));
  BOOST_TEST((violation({inf, 1, 0.75, inf}, exact) == Violation::bound));
  BOOST_TEST((violation({0.75, inf, 0.5, 0x1p-2}, exact) == Violation::fast_bound));
  BOOST_TEST((!violation({0.75, inf, 0.5, 0.334}, exact)));
  // A bound of 2^-52 would allow it.
  const double above = 0.75 + 0x1p-53;
  BOOST_TEST((!violation({above, 0x1p-52, 0.75, inf}, exact)));
  const Exact largest_fraction = number(1 - 0x1p-53, 0, 0);
  BOOST_TEST((violation({1 - 0x1.8p-52, 0x1p-52, 1, inf}, largest_fraction) == Violation::ulp));
}

BOOST_AUTO_TEST_CASE(a_value_from_nowhere_is_a_violation) {
  const Exact exact = number(0.75, 0, 0);
  BOOST_TEST((violation({no_number, inf, 1, inf}, exact) == Violation::nan));
  BOOST_TEST((violation({inf, inf, 1, inf}, exact) == Violation::infinity));
  BOOST_TEST((violation({0, inf, 1, inf}, exact) == Violation::zero));
  BOOST_TEST((violation({0, 1, 1, inf}, exact) == Violation::zero));
  const Exact zero{Exact::Kind::zero}, pole{Exact::Kind::pole};
  BOOST_TEST((!violation({0, 0, 0, inf}, zero)));
  BOOST_TEST((violation({1e-300, 1, 0, inf}, zero) == Violation::bound));
  BOOST_TEST((violation({inf, inf, 0, inf}, zero) == Violation::infinity));
  BOOST_TEST((!violation({inf, 0, inf, inf}, pole)));
  BOOST_TEST((violation({1e300, 1, inf, inf}, pole) == Violation::bound));
  BOOST_TEST((violation({0, inf, inf, inf}, pole) == Violation::zero));
}

BOOST_AUTO_TEST_CASE(the_ends_of_the_doubles_count_exactly) {
  constexpr double largest = std::numeric_limits<double>::max();
  const Exact above = number(0.75, 0, 1025), at = number(1 - 0x1p-53, 0, 1024);
  BOOST_TEST((!violation({inf, inf, inf, inf}, above)));
  BOOST_TEST((violation({inf, inf, inf, inf}, at) == Violation::infinity));
  BOOST_TEST((!violation({largest, 0, inf, inf}, at)));
  BOOST_TEST((violation({largest, 0x1p-52, inf, inf}, above) == Violation::bound));
  const Exact smallest = number(0.5, 0, -1073), below = number(0.75, 0, -1075);
  BOOST_TEST((violation({0, inf, 0, inf}, smallest) == Violation::zero));
  BOOST_TEST((!violation({0, 1, 0, 1}, below)));
  BOOST_TEST((violation({0, 0.5, 0, 1}, below) == Violation::bound));
  BOOST_TEST((!violation({0x1p-1074, 2.0, 0, 1}, below)));
  // 5 2^-1074, half a unit below it.
  const Exact subnormal = number(0.5625, 0, -1071);
  const Verdict verdict = judge({0x1.4p-1072, 0.2, 0, inf}, subnormal);
  BOOST_TEST((!verdict.violation));
  BOOST_TEST(verdict.certified);
  BOOST_TEST(verdict.ulps == 0.5);
}

BOOST_AUTO_TEST_CASE(no_bound_is_violated) {
  for (const char* name : {"isotropic", "prony10", "bridge"}) {
    const TrialSystem system = system_named(name);
    const TrialTally tally = tried(system, header_for(system), 2000);
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST(tally.cases + tally.undefined == 2000U);
      BOOST_TEST(count(tally, Violation::bound) == 0U);
      BOOST_TEST(count(tally, Violation::fast_bound) == 0U);
      BOOST_TEST(count(tally, Violation::ulp) == 0U);
      // The share of draws of ordinary size.
      BOOST_TEST(tally.certified > tally.doubles / 2);
      BOOST_TEST(tally.ulps > 0.49);
      BOOST_TEST(tally.ulps <= 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_bound_that_is_too_small_is_seen_and_shown) {
  const TrialSystem system = system_named("kelvin");
  const std::string liar = symbolic::emit_header(symbolic::derive(system.problem), "honest") + R"(
namespace evaluator {
using honest::Parameters;
inline honest::Certified critical_velocity_certified(const Parameters& p) noexcept {
  const auto answer = honest::critical_velocity_certified(p);
  return {answer.value, answer.relative_error_bound / 16};
}
namespace fast {
inline honest::Certified critical_velocity_certified(const Parameters& p) noexcept {
  const auto answer = honest::fast::critical_velocity_certified(p);
  return {answer.value, answer.relative_error_bound / 64};
}
}  // namespace fast
}  // namespace evaluator
)";
  const TrialTally tally = tried(system, liar, 2000);
  BOOST_TEST(count(tally, Violation::bound) > 100U);
  BOOST_TEST(count(tally, Violation::fast_bound) > 0U);
  const std::string shown = first_violations({{"kelvin", {{Draw::moderate, tally}}}});
  BOOST_TEST(shown.starts_with("bound violated, kelvin, case "));
  BOOST_TEST(shown.find("Parameters{.mu0 = 0x1.") != std::string::npos);
  BOOST_TEST(shown.find("fast bound violated, kelvin") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(threads_change_nothing) {
  const TrialSystem system = system_named("rigid");
  const validation::PrivateFolder folder;
  CompiledHeader evaluator(system, header_for(system), folder.path());
  evaluator.compile();
  const auto text = [&](unsigned threads) {
    const TrialOptions options{.cases = 25'000, .seed = 11, .threads = threads};
    const std::vector<SystemResult> results{{"rigid", try_cases(system, evaluator, options)}};
    return tables(results, bench::TableStyle::text) + first_violations(results);
  };
  BOOST_TEST(text(1) == text(3));
}

BOOST_AUTO_TEST_SUITE_END()
