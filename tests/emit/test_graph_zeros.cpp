// Graphs whose elements are 0 at run time, so that nodes keep no edge: values, bounds and gradients
// of all languages against nodal elimination at 250 digits, on random graphs with random zeros.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <random>

#include "base/errors.hpp"
#include "derivation/scenes.hpp"
#include "emit/language_files.hpp"

BOOST_AUTO_TEST_SUITE(test_graph_zeros)

using namespace vcrit;
using test::Asked;
using test::LanguageCall;
using test::scene_of;
using test::Tool;

namespace {

constexpr unsigned seed = 23;

class Drawn {
 public:
  /// A network between "0" and "1" with so many inner nodes, as text of a scene.
  std::string graph(const std::string& name, int inner) {
    std::string edges;
    for (int from = 0; from < inner + 2; ++from)
      for (int to = from + 1; to < inner + 2; ++to) {
        if (below(8) >= 6) continue;
        edges +=
            fmt::format("{}[\"{}\", \"{}\", \"{}\"]", edges.empty() ? "" : ", ", edge(), from, to);
      }
    return fmt::format("[networks.{}]\nterminals = [\"0\", \"1\"]\nedges = [{}]\n", name, edges);
  }

  /// With values within four decades, the share `zeros` of the elements 0.
  Scene values_for(Scene scene, double zeros) {
    scene = draw_.values_for(std::move(scene), 0);
    for (auto& [symbol, value] : scene.elements)
      if (std::bernoulli_distribution(zeros)(random_)) value = 0;
    return scene;
  }

 private:
  int below(int n) { return std::uniform_int_distribution(0, n - 1)(random_); }
  std::string element(char kind) { return kind + std::to_string(++count_); }
  std::string edge() {
    const std::string first = element(below(2) == 0 ? 'k' : 'c');
    switch (below(6)) {
      case 0:
        return first + " | " + element('c');
      case 1:
        return first + " - " + element('k');
      case 2:
        return first + " | (" + element('k') + " - " + element('c') + ")";
      default:
        return first;
    }
  }

  std::mt19937 random_{seed};
  test::Draw draw_{seed};
  int count_ = 0;
};

/// Graphs of each size in each place, some as a drive.
std::vector<Scene> random_scenes(Drawn& drawn) {
  std::vector<Scene> scenes;
  while (scenes.size() < 5) {
    const auto size = static_cast<int>(scenes.size());
    const std::string drive = size % 3 == 2 ? "other" : size % 3 == 1 ? "kd | cd" : "";
    const std::string contact = std::string("normal = \"net\"\ntangential = ") +
                                (drive == "other" ? "\"kt | ct\"" : "\"other\"");
    try {
      const std::string networks = drawn.graph("net", 1 + size % 4) + drawn.graph("other", 2);
      scenes.push_back(scene_of(contact, drive, drive.empty() ? "" : "m", networks));
    } catch (const InputError&) {  // not connected: another one
    }
  }
  return scenes;
}

/// Too many spanning trees: star-mesh elimination.
Scene meshed_scene() {
  std::string edges;
  for (int a = 0, count = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b)
      if (b > 1)
        edges += fmt::format("{}[\"{}{}\", \"{}\", \"{}\"]", edges.empty() ? "" : ", ",
                             count % 2 == 0 ? "k" : "c", count + 1, a, b),
            ++count;
  return scene_of("normal = \"net\"\ntangential = \"kt | ct\"", "", "",
                  "[networks.net]\nterminals = [\"0\", \"1\"]\nedges = [" + edges + "]\n");
}

std::vector<LanguageCall> calls_of(Drawn& drawn, const std::vector<Scene>& scenes, int count) {
  std::vector<LanguageCall> calls;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (int n = 0; n < count; ++n) {
      LanguageCall call;
      call.library = i;
      call.scene = drawn.values_for(scenes[i], 0.1 * (1 + n % 6));
      call.exact = test::critical_velocity_by_nodes(call.scene);
      calls.push_back(std::move(call));
    }
  return calls;
}

bool is_number(const test::Real& exact) { return exact > 0 && isfinite(exact); }

/// K_n or K_t may be 0: v* is 0, infinite or neither, and nothing is claimed of it.
void check_nothing_held(const LanguageCall& call) {
  for (const auto& [value, bound] :
       {std::pair(call.value(), call.bound()), std::pair(call.fast_value(), call.fast_bound())}) {
    BOOST_TEST(!(bound < 1));
    if (std::isnan(static_cast<double>(call.exact)))
      BOOST_TEST(std::isnan(value));
    else
      BOOST_TEST(value == static_cast<double>(call.exact));
  }
}

/// `claims_fast`: whether plain double has a bound where elements are 0.
void check_values(const std::vector<LanguageCall>& calls, bool claims_fast) {
  std::size_t numbers = 0, certified = 0;
  for (const LanguageCall& call : calls)
    BOOST_TEST_CONTEXT("scene " << call.library << ": " << call.value() << " instead of "
                                << call.exact.str(17)) {
      if (!is_number(call.exact)) {
        check_nothing_held(call);
        continue;
      }
      ++numbers;
      const double error = test::relative_error(call.value(), call.exact);
      const double fast_error = test::relative_error(call.fast_value(), call.exact);
      BOOST_TEST(std::isfinite(call.bound()));
      BOOST_TEST(error <= call.bound());
      BOOST_TEST(fast_error <= call.fast_bound());
      // Without a bound, too, plain double keeps half of its digits over these few decades.
      BOOST_TEST(fast_error <= 1e-8);
      if (claims_fast) BOOST_TEST(std::isfinite(call.fast_bound()));
      certified += call.bound() <= 0x1.001p-53 ? 1 : 0;
    }
  BOOST_TEST(numbers * 2 >= calls.size());
  BOOST_TEST(certified * 100 >= numbers * 98);
}

/// Exact partial derivatives by all entries of Parameters, where v* is a number.
std::vector<std::vector<double>> partials_of(const std::vector<LanguageCall>& calls,
                                             const std::vector<Scene>& scenes) {
  std::vector<symbolic::ParameterList> parameters;
  for (const Scene& scene : scenes) parameters.emplace_back(scene, symbolic::derive(scene));
  std::vector<std::vector<double>> partials;
  for (const LanguageCall& call : calls) {
    partials.emplace_back();
    for (const symbolic::Member& member : parameters[call.library].members())
      if (is_number(call.exact))
        partials.back().push_back(
            static_cast<double>(test::derivative(call.scene, call.exact, {member.name})));
  }
  return partials;
}

/// Terms of the size of v*/x cancel; for values over four decades, which are not made to resonate,
/// they are at most 1e8 times that, of which 2^-102 and 2^-53 are lost. Where x is 0 the other
/// elements are of sizes down to 1e-3, a damper of 0.01 times omega of 0.1.
void check_partials(const LanguageCall& call, const std::vector<double>& exact,
                    const std::vector<double>& x, const std::vector<double>& found,
                    const std::vector<double>& fast) {
  for (std::size_t j = 0; j < exact.size(); ++j)
    BOOST_TEST_CONTEXT("scene " << call.library << ", parameter " << j << " = " << x[j] << ", v* "
                                << call.value() << ", fast bound " << call.fast_bound()) {
      const double scale = std::abs(exact[j]) + call.value() / (x[j] > 0 ? x[j] : 1e-3);
      // The reference errs by 2^-50.
      BOOST_TEST(std::abs(found[j] - exact[j]) <= 1e-12 * scale);
      BOOST_TEST(std::abs(fast[j] - exact[j]) <= 1e-7 * scale);
    }
}

struct Cases {
  std::vector<Scene> scenes;
  std::vector<LanguageCall> calls;
  std::vector<std::vector<double>> partials;
};

/// One question to all languages.
const Cases& cases_with_gradients() {
  static const Cases cases = [] {
    Drawn drawn;
    Cases drawn_cases{random_scenes(drawn), {}, {}};
    drawn_cases.calls = calls_of(drawn, drawn_cases.scenes, 54);
    drawn_cases.partials = partials_of(drawn_cases.calls, drawn_cases.scenes);
    return drawn_cases;
  }();
  return cases;
}

}  // namespace

BOOST_AUTO_TEST_CASE(cpp_with_gradients) {
  auto [scenes, calls, partials] = cases_with_gradients();
  const test::Libraries libraries(scenes, Asked::values_and_gradients);
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {"-O0"}), "");
  std::vector<test::Call> found;
  for (const LanguageCall& call : calls) {
    found.emplace_back();
    found.back().library = call.library;
    found.back().scene = call.scene;
  }
  libraries.evaluate(found);
  for (std::size_t i = 0; i < calls.size(); ++i) {
    calls[i].answers = {found[i].value, found[i].bound, found[i].fast_value, found[i].fast_bound};
    check_partials(calls[i], partials[i], libraries.members_of(found[i]), found[i].partials,
                   found[i].fast_partials);
  }
  check_values(calls, false);
}

BOOST_AUTO_TEST_CASE(other_languages_with_gradients) {
  Cases cases = cases_with_gradients();
  std::vector<LanguageCall>& calls = cases.calls;
  const test::LanguageFiles files(cases.scenes, Asked::values_and_gradients);
  files.with_each_tool(
      [&](const Tool& tool) {
        files.evaluate(tool, calls);
        check_values(calls, !tool.wide);
        for (std::size_t i = 0; i < calls.size(); ++i) {
          const LanguageCall& call = calls[i];
          const std::vector<double> x = files.members_of(call);
          const auto from = call.answers.begin() + test::plain_answers + 1;
          const auto count = static_cast<std::ptrdiff_t>(x.size());
          check_partials(call, cases.partials[i], x, {from, from + count},
                         {from + count + 1, from + 2 * count + 1});
        }
      },
      test::LanguageFiles::Length::very_large);
}

BOOST_AUTO_TEST_CASE(meshes) {
  Drawn drawn;
  const std::vector<Scene> scenes{meshed_scene()};
  std::vector<LanguageCall> calls = calls_of(drawn, scenes, 40);
  const test::LanguageFiles files(scenes);
  files.with_each_tool(
      [&](const Tool& tool) {
        files.evaluate(tool, calls);
        check_values(calls, !tool.wide);
      },
      test::LanguageFiles::Length::very_large);
}

BOOST_AUTO_TEST_SUITE_END()
