// Generated code compiled, run, and compared with nodal evaluation at 250 digits: the values, and
// that the error bounds hold.
#include <boost/test/unit_test.hpp>

#include <limits>
#include <map>

#include "derivation/scenes.hpp"
#include "emit/draw.hpp"
#include "emit/extreme_cases.hpp"
#include "emit/library.hpp"

BOOST_AUTO_TEST_SUITE(test_compiled)

using namespace vcrit;
using test::Call;
using test::scene_of;

namespace {

constexpr unsigned seed = 7;

std::vector<Scene> scenes() {
  const std::string bridge = test::bridge_network;
  return {
      test::kelvin_scene(),
      scene_of("normal = \"kn\"\ntangential = \"kt\""),
      scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m"),
      scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = 0.3", "kd", "m"),
      scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd | cd", "m"),
      scene_of("normal = \"k0 | (k1 - c1)\"\ntangential_ratio = \"r\"", "k2 - c2"),
      scene_of("normal = \"kn | cn\"\ntangential = \"burgers(k1, c1, k2, c2)\"", "kd", "m"),
      scene_of("normal = \"prony(k0, k, tau, 10)\"\npoisson = 0.45", "kd | cd", "m"),
      scene_of("normal = \"prony(k0, k, tau, 10)\"\ntangential = \"prony(k1, kt, taut, 2)\""),
      scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", bridge),
      scene_of("normal = \"kn | cn\"\ntangential = \"bridge\"", "k4 - (c4 | k5)", "", bridge),
      // A ladder of ten elements, and every kind of series step: two dampers, a damper and a
      // network.
      scene_of("normal = \"c1 | (k1 - (c2 | (k2 - (c3 | (k3 - (c4 | (k4 - (k5 | c5))))))))\"\n"
               "tangential = \"kt | (ct - ce) | (cf - (kf | cg)) | ((kh | ch) - (ki | ci))\"",
               "kd", "m"),
      scene_of("normal = \"bridge\"\npoisson = 0.3", "", "", bridge),
      scene_of("normal = \"k1 | c1\"\ntangential_ratio = 0.5", "k1 | c1", "m"),
      scene_of("normal = \"kn | cn\"\ntangential = \"kt\"", "cd", "m"),
      test::scene_of_others(),
      scene_of("normal = \"prony(k0, k, t, 2)\"\npoisson = 0.3", "kd", "m", test::made_of_others),
      scene_of("normal = \"bridge\"\npoisson = 0.3", "kd", "m",
               test::bridge_network + test::made_of_others),
  };
}

std::vector<Call> calls(const test::Libraries& libraries) {
  test::Draw draw(seed);
  std::vector<Call> result;
  for (std::size_t i = 0; i < libraries.size(); ++i)
    for (int n = 0; n < 30; ++n) {
      Call call;
      call.library = i;
      call.scene = draw.values_for(libraries.scene(i), n % 3);
      result.push_back(std::move(call));
    }
  return result;
}

}  // namespace

// What a header includes is one question for both compilers; below, both see all headers. Those
// that include the same are compiled together: each has a namespace of its own.
BOOST_AUTO_TEST_CASE(each_header_compiles_alone) {
  const test::Libraries libraries(scenes());
  std::map<std::string, std::string> sources;  // by what their headers include
  for (std::size_t i = 0; i < libraries.size(); ++i) {
    std::istringstream lines(test::contents(libraries.header(i)));
    std::string includes;
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("#include")) includes += line + "\n";
    sources[includes] += fmt::format("#include \"{}\"\n", libraries.header(i).filename().string());
  }
  std::vector<std::string> command{test::compilers(libraries.folder()).front(), "-fsyntax-only"};
  command.insert(command.end(), test::strict_flags.begin(), test::strict_flags.end());
  for (const auto& [includes, source] : sources) {
    command.push_back(libraries.folder().path() / fmt::format("headers_{}.cpp", command.size()));
    write_file(command.back(), source);
  }
  const test::Outcome outcome = test::run(command, libraries.folder().path());
  BOOST_TEST(outcome.status == 0, outcome.output);
}

BOOST_AUTO_TEST_CASE(fast_math_is_refused) {
  const test::Libraries libraries({test::kelvin_scene()});
  for (const std::string& compiler : test::compilers(libraries.folder())) {
    const std::string complaints = libraries.compile(compiler, {"-ffast-math", "-Wfatal-errors"});
    BOOST_TEST(complaints.find("-ffast-math destroys") != std::string::npos, compiler);
  }
}

BOOST_AUTO_TEST_CASE(values_and_bounds_hold) {
  BOOST_TEST_MESSAGE("seed " << seed);
  const test::Libraries libraries(scenes());
  std::vector<Call> all = calls(libraries);
  std::vector<test::Real> exact;
  for (const Call& call : all) exact.push_back(test::critical_velocity_by_nodes(call.scene));

  for (const std::string& compiler : test::compilers(libraries.folder())) {
    BOOST_REQUIRE_EQUAL(libraries.compile(compiler, {"-O1"}), "");
    libraries.evaluate(all);
    int certified = 0, fast_certified = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Call& call = all[i];
      BOOST_TEST_CONTEXT(compiler << ", scene " << call.library << ", call " << i) {
        // The bounds are the claim under test; they are finite for all of these ordinary values.
        BOOST_TEST(std::isfinite(call.bound));
        BOOST_TEST(test::relative_error(call.value, exact[i]) <= call.bound);
        BOOST_TEST(test::relative_error(call.fast_value, exact[i]) <= call.fast_bound);
      }
      certified += call.bound <= 0x1.001p-53 ? 1 : 0;
      fast_certified += call.fast_bound < 1e-13 ? 1 : 0;
    }
    // Half an ulp nearly everywhere: a condition of 1e13 leaves 102 - 44 bits. For fast, all but
    // the cases near resonance, a third of those with a mass.
    BOOST_TEST(certified >= static_cast<int>(all.size()) * 99 / 100);
    BOOST_TEST(fast_certified >= static_cast<int>(all.size()) / 2);
  }
}

// The hard cases from outside: whatever has a bound keeps it. The small ones are the same program
// as in test_emitted_rounding_modes, which is compiled once for both.
BOOST_AUTO_TEST_CASE(bounds_hold_for_every_size_of_value) {
  int count = 0, certified = 0, fast_certified = 0;
  for (const test::ExtremeCases& cases :
       {test::extreme_cases(0, 12, 142), test::extreme_cases(13, 100, 100)}) {
    std::vector<Call> all = test::calls_of(cases);
    const test::Libraries libraries(cases.shapes);
    const std::string compiler = test::compilers(libraries.folder()).front();
    BOOST_REQUIRE_EQUAL(libraries.compile(compiler, test::plainest_flags), "");
    libraries.evaluate(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double expected = cases.rows[i].expected;
      BOOST_TEST(test::holds(all[i].value, all[i].bound, expected), all[i].scene.file);
      BOOST_TEST(test::holds(all[i].fast_value, all[i].fast_bound, expected), all[i].scene.file);
      // Certified to an ulp: the nearest double or one beside it.
      const double inf = std::numeric_limits<double>::infinity();
      if (all[i].bound <= 0x1p-52)
        BOOST_TEST((all[i].value >= std::nextafter(expected, 0.0) &&
                    all[i].value <= std::nextafter(expected, inf)),
                   all[i].scene.file);
      ++count;
      certified += std::isfinite(all[i].bound) ? 1 : 0;
      fast_certified += std::isfinite(all[i].fast_bound) ? 1 : 0;
    }
  }
  BOOST_TEST_MESSAGE(certified << " and " << fast_certified << " of " << count);
  // All but the rows whose condition is above 2^50; plain double only has ordinary ones.
  BOOST_TEST(certified >= count * 98 / 100);
  BOOST_TEST(fast_certified > 25);
}

BOOST_AUTO_TEST_CASE(resonance_antiresonance_and_nothing) {
  Scene scene = scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m");
  const auto with = [&](double kt, double kd, double mass) {
    Call call;
    call.scene = scene;
    call.scene.coefficient.value = call.scene.angular_frequency.value = 1.0;
    call.scene.amplitude.value = call.scene.indentation.value = 1.0;
    call.scene.elements = {{{"kn"}, 1.0}, {{"kt"}, kt}, {{"kd"}, kd}};
    call.scene.mass->value = mass;
    return call;
  };
  std::vector<Call> all{with(1, 3, 3), with(1, 3, 4), with(1, 3, 2)};
  const test::Libraries libraries({scene});
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {}), "");
  libraries.evaluate(all);
  constexpr double inf = std::numeric_limits<double>::infinity();
  BOOST_TEST(all[0].value == inf);
  BOOST_TEST(all[0].bound == inf);
  BOOST_TEST(all[1].value == 0.0);
  BOOST_TEST(all[1].bound == inf);
  // kn/kt (kt + kd - m)/(kd - m) = 2
  BOOST_TEST(all[2].value == 2.0);
  BOOST_TEST(all[2].fast_value == 2.0);
}

BOOST_AUTO_TEST_SUITE_END()
