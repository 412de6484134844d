// What generated evaluators give where the caller has changed how the processor rounds, or has it
// flush subnormal numbers to zero: the cases of every size of value, in all eight states.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "derivation/scenes.hpp"
#include "emit/extreme_cases.hpp"
#include "emit/library.hpp"

BOOST_AUTO_TEST_SUITE(test_emitted_rounding_modes)

using namespace vcrit;
using test::Call;
using test::scene_of;

namespace {

std::vector<test::ArithmeticState> all_states() {
  std::vector<test::ArithmeticState> states;
  for (const char* rounding : {"FE_TONEAREST", "FE_UPWARD", "FE_DOWNWARD", "FE_TOWARDZERO"})
    for (const bool flush : {false, true}) states.push_back({rounding, flush});
  return states;
}

bool is_subnormal(double x) { return x != 0 && std::abs(x) < DBL_MIN; }

/// v* in that state: the table's, but where operands that flush to zero make another scene.
double expected_in(const test::ArithmeticState& state, const test::ExtremeCase& row) {
  Scene scene = row.scene;
  bool is_another = false;
  const auto flush = [&](double& value) {
    is_another |= is_subnormal(value);
    if (is_subnormal(value)) value = 0;
  };
  for (auto& [symbol, value] : scene.elements) flush(*value);
  for (Quantity* quantity : {&scene.coefficient, &scene.angular_frequency, &scene.amplitude})
    flush(*quantity->value);
  if (scene.mass) flush(*scene.mass->value);
  return state.flush_to_zero && is_another
             ? static_cast<double>(test::critical_velocity_by_nodes(scene))
             : row.expected;
}

/// The bound counts roundings to the nearest, half a unit each. Other modes lose up to a unit, so
/// that all is twice as much. Two half units for the table's own rounding, and where v* is
/// subnormal the unit is 2^-1074; flushed, it is 0, or the least normal number where the processor
/// rounds up.
bool is_right(double value, double bound, double expected, const test::ArithmeticState& state) {
  if (std::isnan(value) || std::isnan(expected)) return std::isnan(value) == std::isnan(expected);
  if (value == expected || !std::isfinite(bound)) return true;
  const double times = state.rounding == "FE_TONEAREST" ? 1 : 2;
  if (expected >= DBL_MIN) return std::abs(value / expected - 1) <= times * bound + 0x1p-52;
  if (state.flush_to_zero) return value >= 0 && value <= DBL_MIN;
  return std::abs(value - expected) <= times * bound * expected + 0x1p-1073;
}

/// kn = kt = kd = 1, no damping to speak of, du_z and mu0 far beyond any device: v* is 2^1200.
Call overflowing_call() {
  Call call;
  call.scene = scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd");
  call.scene.angular_frequency.value = call.scene.indentation.value = 1.0;
  call.scene.coefficient.value = call.scene.amplitude.value = 0x1p600;
  for (auto& [symbol, value] : call.scene.elements) value = 1.0;
  return call;
}

}  // namespace

// Infinite; the largest double where the processor rounds to no larger number. Nothing is claimed.
BOOST_AUTO_TEST_CASE(above_the_largest_double) {
  std::vector<Call> calls{overflowing_call()};
  const test::Libraries libraries({calls[0].scene}, test::Asked::values_and_gradients);
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {"-O1"}), "");
  for (const test::ArithmeticState& state : all_states()) {
    libraries.evaluate(calls, state);
    for (const auto& [value, bound] : {std::pair(calls[0].value, calls[0].bound),
                                       std::pair(calls[0].fast_value, calls[0].fast_bound)}) {
      BOOST_TEST(value >= DBL_MAX, state.rounding);
      if (state.rounding == "FE_TONEAREST") BOOST_TEST(std::isinf(value));
      BOOST_TEST(std::isinf(bound), state.rounding);
    }
  }
}

// The driver fails if a function leaves another state behind than it found.
BOOST_AUTO_TEST_CASE(twice_the_bound_in_every_state) {
  const test::ExtremeCases cases = test::extreme_cases(0, 12, 142);
  std::vector<Call> calls = test::calls_of(cases);
  const test::Libraries libraries(cases.shapes);
  const std::string compiler = test::compilers(libraries.folder()).front();
  for (const std::vector<std::string>& flags : {test::plainest_flags, {"-O0", "-march=native"}}) {
    BOOST_REQUIRE_EQUAL(libraries.compile(compiler, flags), "");
    const auto is_bounded = [](const Call& call) { return std::isfinite(call.bound); };
    libraries.evaluate(calls);
    const auto bounded = std::count_if(calls.begin(), calls.end(), is_bounded);
    for (const test::ArithmeticState& state : all_states()) {
      libraries.evaluate(calls, state);
      if (!state.flush_to_zero)
        BOOST_TEST(std::count_if(calls.begin(), calls.end(), is_bounded) == bounded,
                   state.rounding);
      for (std::size_t i = 0; i < calls.size(); ++i) {
        const Call& call = calls[i];
        const double expected = expected_in(state, cases.rows[i]);
        BOOST_TEST_CONTEXT(flags.back()
                           << " " << state.rounding << " " << state.flush_to_zero << ", "
                           << call.scene.file << ": " << call.value << ", fast " << call.fast_value
                           << ", expected " << expected) {
          BOOST_TEST(!std::isnan(call.value));
          BOOST_TEST(!std::isnan(call.fast_value));
          BOOST_TEST(is_right(call.value, call.bound, expected, state));
          BOOST_TEST(is_right(call.fast_value, call.fast_bound, expected, state));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
