// Evaluators of drives that hold masses, in all languages, against nodal elimination at 250 digits:
// at random, and at and beside the zeros and poles of everything that v* is a quotient of.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>

#include "emit/language_files.hpp"
#include "emit/languages/cpp/quantities.hpp"
#include "emit/library.hpp"
#include "emit/mass_drives.hpp"

BOOST_AUTO_TEST_SUITE(test_drives_with_masses)

using namespace vcrit;
using test::Asked;
using test::Call;
using test::LanguageCall;
using test::MassCase;
using test::MassDrive;
using test::scene_of;
using test::Tool;

namespace {

constexpr unsigned seed = 19;

std::vector<Scene> scenes_of(const std::vector<MassDrive>& drives) {
  std::vector<Scene> scenes;
  for (const MassDrive& drive : drives) scenes.push_back(drive.scene);
  return scenes;
}

bool is_smooth(const Call& call) { return call.bound <= 0x1.0001p-53; }

/// Re K_d is finite and v* a number: exact zeros of doubles have cases of their own below.
void check(double value, double bound, double fast_value, double fast_bound,
           const test::Real& exact) {
  BOOST_TEST(test::relative_error(value, exact) <= bound);
  BOOST_TEST(test::relative_error(fast_value, exact) <= fast_bound);
}

}  // namespace

// 6 drives x 17 rounds x 9 values: 918 calls.
BOOST_AUTO_TEST_CASE(values_and_bounds_hold) {
  BOOST_TEST_MESSAGE("seed " << seed);
  const std::vector<MassDrive> drives = test::mass_drives();
  const test::Libraries libraries(scenes_of(drives));
  const std::vector<MassCase> cases = test::mass_cases(drives, seed, 17);
  std::vector<Call> calls;
  for (const MassCase& each : cases) {
    calls.emplace_back();
    calls.back().library = each.index;
    calls.back().scene = each.scene;
  }
  BOOST_REQUIRE_GE(calls.size(), 900U);
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {"-O1"}), "");
  libraries.evaluate(calls);
  std::size_t certified = 0, fast = 0;
  double tightest = 0;
  for (std::size_t i = 0; i < calls.size(); ++i)
    BOOST_TEST_CONTEXT("drive " << calls[i].library << ", call " << i) {
      const Call& call = calls[i];
      check(call.value, call.bound, call.fast_value, call.fast_bound, cases[i].exact);
      // 2^-102 times the roundings is below 2^-10 up to conditions of 1e24, and the nearest double
      // to a zero is off by 1e-17.
      BOOST_TEST(std::isfinite(call.bound));
      certified += is_smooth(call) ? 1 : 0;
      fast += call.fast_bound < 1e-12 ? 1 : 0;
      if (std::isfinite(call.fast_bound))
        tightest = std::max(
            tightest, test::relative_error(call.fast_value, cases[i].exact) / call.fast_bound);
    }
  BOOST_TEST_MESSAGE(certified << " and " << fast << " of " << calls.size() << ", up to "
                               << tightest << " of the bound");
  // The sum of some 50 roundings that rarely have one sign, times 1.5: no bound is a hundred times
  // too large for all calls.
  BOOST_TEST(tightest > 0.01);
  // One in nine of all calls is at a zero of D, as many at one of N: a condition of 1e17 leaves 102
  // - 57 bits less those of some 50 roundings. All others keep half an ulp, but for a few by
  // chance.
  BOOST_TEST(certified * 100 >= calls.size() * 70);
  // At a pole of K_d alone plain double loses nothing.
  BOOST_TEST(fast * 100 >= calls.size() * 40);
}

// The bound counts roundings to the nearest, half a unit each; other modes lose up to a unit.
BOOST_AUTO_TEST_CASE(twice_the_bound_holds_however_the_processor_rounds) {
  const std::vector<MassDrive> drives = test::mass_drives();
  // As for gradients below: compiled once.
  const test::Libraries libraries(scenes_of(drives), Asked::values_and_gradients);
  const std::vector<MassCase> cases = test::mass_cases(drives, seed + 3, 3);
  std::vector<Call> calls;
  for (const MassCase& each : cases) {
    calls.emplace_back();
    calls.back().library = each.index;
    calls.back().scene = each.scene;
  }
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {"-O0"}), "");
  for (const char* rounding : {"FE_UPWARD", "FE_DOWNWARD", "FE_TOWARDZERO"}) {
    libraries.evaluate(calls, {rounding, false});
    for (std::size_t i = 0; i < calls.size(); ++i)
      BOOST_TEST_CONTEXT(rounding << ", drive " << calls[i].library << ", call " << i)
    check(calls[i].value, 2 * calls[i].bound, calls[i].fast_value, 2 * calls[i].fast_bound,
          cases[i].exact);
  }
}

// Terms of a derivative are at most v*/x times the square of the condition, 1e14 here, of which
// 2^-102 is 2e-17; the reference errs by (2^-50 1e7)^2 = 1e-16.
BOOST_AUTO_TEST_CASE(gradients_are_those_of_nodal_elimination) {
  const std::vector<MassDrive> drives = test::mass_drives();
  const test::Libraries libraries(scenes_of(drives), Asked::values_and_gradients);
  test::MassDraw draw(seed + 1);
  std::vector<Call> calls;
  for (std::size_t i = 0; i < drives.size(); ++i)
    for (int n = 0; n < 3; ++n) {
      calls.emplace_back();
      calls.back().library = i;
      calls.back().scene = draw.values_for(drives[i], 0);
    }
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {"-O0"}), "");
  libraries.evaluate(calls);
  for (const Call& call : calls) {
    const test::Real exact = test::critical_velocity_by_nodes(call.scene);
    const symbolic::ParameterList parameters(drives[call.library].scene,
                                             symbolic::derive(drives[call.library].scene));
    const std::vector<double> x = libraries.members_of(call);
    for (std::size_t j = 0; j < x.size(); ++j)
      BOOST_TEST_CONTEXT("drive " << call.library << ", parameter " << j) {
        const auto slope = static_cast<double>(
            test::derivative(call.scene, exact, {parameters.members()[j].name}));
        const double scale = std::abs(slope) + std::abs(call.value / x[j]);
        BOOST_TEST(std::abs(call.partials[j] - slope) <= 1e-13 * scale);
        // 2^-53 in place of 2^-102, for conditions up to 1e3.
        if (call.fast_bound < 1e-13)
          BOOST_TEST(std::abs(call.fast_partials[j] - slope) <= 1e-9 * scale);
      }
  }
}

// Numbers of which each step is exact in doubles, so that zeros are zeros.
BOOST_AUTO_TEST_CASE(exactly_at_each_zero_and_pole) {
  const Scene chain = scene_of("normal = \"kn\"\ntangential = \"kt\"", "kf - (mass(ms) | km)", "m"),
              absorber = scene_of("normal = \"kn | cn\"\ntangential = \"kt | ct\"",
                                  "kd | k1 - mass(m1)", "m");
  const auto call = [](std::size_t library, Scene scene, const Values& values, double omega) {
    Call made;
    made.library = library;
    for (auto& [symbol, value] : scene.elements) value = values.at(symbol);
    scene.mass->value = values.at({"m"});
    scene.coefficient.value = 0.25;
    scene.angular_frequency.value = omega;
    scene.amplitude.value = 1.0;
    scene.indentation.value = 2.0;
    made.scene = scene;
    return made;
  };
  // km - ms omega^2 = 3 in series with 6: K_d = 2.
  const auto at = [&](double m, double kf, double ms) {
    return call(0, chain,
                {{{"kn"}, 4}, {{"kt"}, 1}, {{"kf"}, kf}, {{"ms"}, ms}, {{"km"}, 5}, {{"m"}, m}}, 1);
  };
  // The absorber of tests/matrix/kinds: k1 = m1 omega^2 in doubles, 4.8828125e-4 being 2^-11.
  std::vector<Call> calls{at(2, 6, 2),
                          at(3, 6, 2),
                          at(1, 6, 2),
                          at(0.5, 6, 5),
                          at(0.5, 3, 8),
                          call(1, absorber,
                               {{{"kn"}, 1e7},
                                {{"cn"}, 60},
                                {{"kt"}, 8e6},
                                {{"ct"}, 30},
                                {{"kd"}, 3e6},
                                {{"k1"}, 4882812.5},
                                {{"m1"}, 4.8828125e-4},
                                {{"m"}, 7e-4}},
                               1e5)};
  const test::Libraries libraries({chain, absorber});
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {}), "");
  libraries.evaluate(calls);
  constexpr double inf = std::numeric_limits<double>::infinity();
  BOOST_TEST(calls[0].value == inf);  // D = 0
  BOOST_TEST(calls[0].bound == inf);
  BOOST_TEST(calls[1].value == 0.0);  // N = 0
  BOOST_TEST(calls[1].bound == inf);
  BOOST_TEST(calls[2].value == 2.0);  // kn/kt (1 + 2 - 1)/(2 - 1)/4
  BOOST_TEST(calls[2].bound <= 0x1.001p-53);
  BOOST_TEST(calls[3].value == 1.0);  // K_d = 0: (1 - 0.5)/0.5
  BOOST_TEST(calls[4].value == 1.0);  // K_d infinite: a rigid drive
  BOOST_TEST(calls[4].fast_value == 1.0);
  BOOST_TEST(calls[4].bound <= 0x1.001p-53);
  const test::Real kn(1e7), cn(6e6), kt(8e6), ct(3e6);
  const test::Real rigid = test::Real(0.25) * 1e5 * sqrt((kn * kn + cn * cn) / (kt * kt + ct * ct));
  check(calls[5].value, calls[5].bound, calls[5].fast_value, calls[5].fast_bound, rigid);
  BOOST_TEST(calls[5].bound <= 0x1.001p-53);
  BOOST_TEST(calls[5].fast_bound < 1e-14);
}

// One spring and one mass keep all their digits, whatever is left of them; plain double, too.
BOOST_AUTO_TEST_CASE(a_spring_beside_a_mass_is_an_exact_difference) {
  const Scene scene = scene_of("normal = \"kn\"\ntangential = \"kt\"", "kf - (mass(ms) | km)", "m");
  std::vector<Call> calls;
  for (const double ms : {5e-4, 0x1.0624dd2f1a9fcp-11, 0x1.0624dd2f1a9fep-11}) {
    Call call;
    call.scene = scene;
    // ms omega^2 is 5e6 but for some last digits, and K_d some 1e-10 N/m.
    call.scene.elements = {
        {{"kn"}, 1e7}, {{"kt"}, 8e6}, {{"kf"}, 4e7}, {{"ms"}, ms}, {{"km"}, 5e6}};
    call.scene.coefficient.value = 0.3;
    call.scene.angular_frequency.value = 1e5;
    call.scene.amplitude.value = 1e-7;
    call.scene.mass->value = 1e-30;
    calls.push_back(call);
  }
  const test::Libraries libraries({scene});
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {}), "");
  libraries.evaluate(calls);
  for (const Call& call : calls) {
    const test::Real exact = test::critical_velocity_by_nodes(call.scene);
    check(call.value, call.bound, call.fast_value, call.fast_bound, exact);
    BOOST_TEST(call.bound <= 0x1.001p-53);
    BOOST_TEST(test::relative_error(call.fast_value, exact) <= 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(other_languages) {
  const std::vector<MassDrive> all = test::mass_drives(), drives(all.begin(), all.begin() + 5);
  const std::vector<MassCase> cases = test::mass_cases(drives, seed + 2, 3);
  std::vector<LanguageCall> calls;
  for (const MassCase& each : cases) {
    calls.emplace_back();
    calls.back().library = each.index;
    calls.back().scene = each.scene;
    calls.back().exact = each.exact;
  }
  const test::LanguageFiles files(scenes_of(drives));
  files.with_each_tool(
      [&](const Tool& tool) {
        files.evaluate(tool, calls);
        std::size_t known = 0;
        for (std::size_t i = 0; i < calls.size(); ++i)
          BOOST_TEST_CONTEXT("drive " << calls[i].library << ", call " << i) {
            const LanguageCall& call = calls[i];
            check(call.value(), call.bound(), call.fast_value(), call.fast_bound(), call.exact);
            check(call.answers[6], call.bound(), call.answers[7], call.fast_bound(), call.exact);
            BOOST_TEST(call.answers[4] == call.value());
            if (tool.wide) BOOST_TEST(std::isfinite(call.bound()));
            known += std::isfinite(call.bound()) ? 1 : 0;
          }
        // Out of range is one call in nine, of kind 1.
        BOOST_TEST(known * 8 >= calls.size() * 7);
      },
      test::LanguageFiles::Length::very_large);
}

// The values themselves: tests/matrix.
BOOST_AUTO_TEST_CASE(a_drive_that_may_not_give_at_all_says_so) {
  const auto tells = [](const Scene& scene) {
    return symbolic::emit_quantities(symbolic::derive(scene), "scene")
               .find("NaN where the drive does not give at all") != std::string::npos;
  };
  const std::string contact = "normal = \"kn\"\ntangential = \"kt\"";
  BOOST_TEST(tells(scene_of(contact, "kd - (mass(m2) | k2)", "m")));
  BOOST_TEST(tells(read_scene(VCRIT_SCENES "/measured_drive.toml")));
  BOOST_TEST(!tells(scene_of(contact, "kd - k2", "m")));
}

BOOST_AUTO_TEST_SUITE_END()
