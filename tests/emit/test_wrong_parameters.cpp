// Parameters that no scene has, negative, infinite or not a number: whatever the value, there is no
// bound, in any language.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

#include "derivation/scenes.hpp"
#include "emit/language_files.hpp"
#include "support/numbers.hpp"

BOOST_AUTO_TEST_SUITE(test_wrong_parameters)

using namespace vcrit;
using test::LanguageCall;
using test::scene_of;

namespace {

/// All that a parameter can be.
std::vector<Scene> scenes() {
  return {scene_of("normal = \"prony(k0, k, tau, 3)\"\npoisson = \"nu\"", "kd | cd", "m"),
          scene_of("normal = \"k1 - c1\"\ntangential_ratio = \"r\"", "kd"),
          scene_of("normal = \"bridge\"\ntangential = \"kt\"", "", "", test::bridge_network)};
}

/// `number` in the place of one parameter after the other.
void set(Scene& scene, const Symbol& symbol, double number) {
  for (auto& [name, value] : scene.elements)
    if (name == symbol) value = number;
  auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
  for (Quantity* quantity :
       {&scene.coefficient, &scene.angular_frequency, &scene.amplitude,
        isotropic != nullptr ? &isotropic->quantity : nullptr, scene.mass ? &*scene.mass : nullptr})
    if (quantity != nullptr && quantity->symbol == symbol) quantity->value = number;
}

LanguageCall call_of(std::size_t library, const Scene& scene) {
  LanguageCall call;
  call.library = library;
  call.scene = scene;
  return call;
}

std::vector<LanguageCall> wrong_calls(const std::vector<Scene>& shapes) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  test::Draw draw(5);
  std::vector<LanguageCall> calls;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Scene scene = draw.values_for(shapes[i], 0);
    for (const auto& [symbol, value] : test::numbers_of(scene)) {
      if (symbol.name == "u_z0") continue;
      std::vector<double> numbers{-value, -1e30, -1e-300, -tiny, -inf, inf, std::nan("")};
      // Negative Poisson's ratios exist.
      if (symbol.name == "nu") numbers = {-1.0, -7.0, 0.75, 1.5, -inf, inf, std::nan("")};
      for (const double number : numbers) {
        calls.push_back(call_of(i, scene));
        set(calls.back().scene, symbol, number);
      }
    }
  }
  // Branches that cancel.
  calls.push_back(call_of(0, draw.values_for(shapes[0], 0)));
  set(calls.back().scene, {"k", 1}, 1e30);
  set(calls.back().scene, {"k", 2}, -1e30);
  set(calls.back().scene, {"tau", 2}, test::numbers_of(calls.back().scene).at({"tau", 1}));
  return calls;
}

void check(const std::vector<LanguageCall>& calls) {
  for (const LanguageCall& call : calls) {
    std::string text;
    for (const auto& [symbol, value] : test::numbers_of(call.scene))
      text += fmt::format(" {} = {}", to_text(symbol), value);
    BOOST_TEST(call.bound() == HUGE_VAL, text);
    BOOST_TEST(call.fast_bound() == HUGE_VAL, text);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(cpp_has_no_bound) {
  const std::vector<Scene> shapes = scenes();
  std::vector<LanguageCall> calls = wrong_calls(shapes);
  const test::Libraries libraries(shapes);
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {"-O1"}), "");
  std::vector<test::Call> found;
  for (const LanguageCall& call : calls) {
    found.emplace_back();
    found.back().library = call.library;
    found.back().scene = call.scene;
  }
  libraries.evaluate(found);
  for (std::size_t i = 0; i < calls.size(); ++i)
    calls[i].answers = {found[i].value, found[i].bound, found[i].fast_value, found[i].fast_bound};
  check(calls);
}

BOOST_AUTO_TEST_CASE(no_other_language_has_a_bound) {
  const std::vector<Scene> shapes = scenes();
  std::vector<LanguageCall> calls = wrong_calls(shapes);
  const test::LanguageFiles files(shapes);
  files.with_each_tool([&](const test::Tool& tool) {
    files.evaluate(tool, calls);
    check(calls);
  });
}

// clang takes no more than 256 arguments of a fold expression. g++ has no such limit, but its time
// grows with the square.
BOOST_AUTO_TEST_CASE(a_thousand_branches_compile) {
  const auto prony = [](int branches) {
    const std::string series = fmt::format("normal = \"prony(k0, k, tau, {})\"\n", branches);
    return scene_of(series + "poisson = 0.3", "kd", "m");
  };
  const test::PrivateFolder folder;
  for (const std::string& compiler : test::compilers(folder)) {
    const test::Libraries libraries({prony(compiler == "g++" ? 300 : 1000)});
    BOOST_TEST(libraries.compile(compiler, {"-fsyntax-only"}) == "", compiler);
  }
}

BOOST_AUTO_TEST_SUITE_END()
