// Parameters folded into generated code: their numbers are the scene's, exactly, the bounds still
// hold, and nothing is left of their names.
#include <boost/test/unit_test.hpp>

#include <map>
#include <random>

#include "base/errors.hpp"
#include "derivation/scenes.hpp"
#include "emit/library.hpp"
#include "support/patterns.hpp"

BOOST_AUTO_TEST_SUITE(test_fixed)

using namespace vcrit;
using symbolic::GenerateOptions;
using test::Call;
using test::has_match;
using test::scene_of;

namespace {

constexpr unsigned seed = 11;

struct Case {
  Scene scene;
  std::vector<std::string> fixed;
};

Scene stored(const std::string& name, const Settings& settings = {}) {
  return read_scene(VCRIT_SCENES "/" + name + ".toml", settings);
}

/// All pairs of eight nodes but the terminals: too many spanning trees, so that it is meshed.
Scene meshed() {
  std::string edges;
  test::Elements elements{{"kt", 8e6}, {"ct", 3}, {"kd", 5e6}};
  for (int a = 0, n = 0; a < 8; ++a)
    for (int b = std::max(a + 1, 2); b < 8; ++b, ++n) {
      // At node 2 only springs meet.
      const std::string name = (a == 2 || b == 2 || n % 3 == 0 ? "k" : "c") + std::to_string(n);
      edges += fmt::format("[\"{}\", \"{}\", \"{}\"], ", name, a, b);
      elements.emplace_back(name, name[0] == 'k' ? 1e6 + 3e5 * n : 7 + 0.3 * n);
    }
  return scene_of(test::symbolic(
      {.normal = "g",
       .tangential = "kt | ct",
       .network = "kd",
       .mass = 0.0003,
       .elements = elements,
       .more = "[networks.g]\nterminals = [\"0\", \"1\"]\nedges = [" + edges + "]\n"}));
}

std::vector<Case> cases() {
  std::vector<Case> result;
  const std::vector<std::string> all{"all"};
  for (const char* name : {"kelvin", "zener", "prony", "bridge", "burgers", "elastic",
                           "elastic_drive", "kelvin_rigid"})
    result.push_back({stored(name), all});
  result.push_back({stored("kelvin"), {"kn", "ct", "m"}});
  result.push_back({stored("kelvin"), {"kd", "mass", "kt"}});
  result.push_back({stored("zener"), {"c1", "kd"}});
  result.push_back({stored("prony"), {"k", "tau", "k0"}});
  result.push_back({stored("prony"), {"tau[3]", "k[10]", "kd"}});
  result.push_back({stored("bridge"), {"k1", "c2"}});
  // Folded constants far beyond ordinary sizes, and of sums that no double holds.
  result.push_back({stored("kelvin", {{"kn", "1e200"}, {"cn", "1e-190"}}), all});
  result.push_back({stored("kelvin", {{"kn", "3e-210"}, {"kt", "7e300"}, {"ct", "0.1"}}), all});
  result.push_back({scene_of(test::symbolic({.normal = "k1 | k2 | c1",
                                             .tangential = "(k3 | k4) - k5",
                                             .network = "k6 | k7 | cd",
                                             .mass = 0.0003,
                                             .elements = {{"k1", 1e6},
                                                          {"k2", 0.1},
                                                          {"c1", 3.3},
                                                          {"k3", 1e7},
                                                          {"k4", 1e-9},
                                                          {"k5", 3e6},
                                                          {"k6", 1e6},
                                                          {"k7", 1e-11},
                                                          {"cd", 0.7}}})),
                    all});
  return result;
}

/// The scene with other numbers for all that is not fixed.
Scene varied(Scene scene, const std::vector<std::string>& names, std::mt19937& random) {
  const symbolic::FixedValues fixed = symbolic::fixed_values(scene, names);
  const auto vary = [&](const Symbol& symbol, std::optional<double>& value, double otherwise) {
    if (fixed.contains(symbol)) return;
    value =
        value.value_or(otherwise) * std::pow(10, std::uniform_real_distribution(-1.5, 1.5)(random));
  };
  for (auto& [symbol, value] : scene.elements) vary(symbol, value, 1e6);
  vary(scene.coefficient.symbol, scene.coefficient.value, 0.2);
  vary(scene.angular_frequency.symbol, scene.angular_frequency.value, 1e5);
  vary(scene.amplitude.symbol, scene.amplitude.value, 1e-7);
  scene.indentation.value = 1.0;
  if (scene.mass) vary(scene.mass->symbol, scene.mass->value, 1e-4);
  return scene;
}

std::string struct_of_parameters(const std::string& header) {
  const std::size_t begin = header.find("struct Parameters");
  return header.substr(begin, header.find("};", begin) - begin);
}

void refused(const Scene& scene, const std::string& name, const std::string& message) {
  try {
    symbolic::emit_header(symbolic::derive(scene), "scene", {{name}, false});
    BOOST_TEST(false, name << " was taken");
  } catch (const InputError& error) {
    BOOST_TEST(std::string(error.what()) == message);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(fixed_and_unfixed_keep_their_bounds) {
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  std::vector<Scene> scenes;
  std::vector<GenerateOptions> options;
  std::vector<Call> calls;
  std::map<std::string, std::size_t> unfixed_of;  // one for all cases of a file
  for (const Case& each : cases()) {
    const std::size_t fixed = scenes.size();
    scenes.push_back(each.scene);
    options.push_back({each.fixed, false});
    const auto [unfixed, is_new] = unfixed_of.try_emplace(each.scene.file, scenes.size());
    if (is_new) {
      scenes.push_back(each.scene);
      options.emplace_back();
    }
    for (int n = 0; n < 8; ++n) {
      Call call;
      call.scene = varied(each.scene, each.fixed, random);
      for (const std::size_t library : {fixed, unfixed->second}) {
        call.library = library;
        calls.push_back(call);
      }
    }
  }
  const test::Libraries libraries(scenes, test::Asked::values, options);
  std::vector<test::Real> exact;
  for (const Call& call : calls) exact.push_back(test::critical_velocity_by_nodes(call.scene));
  // What is constant is computed by the compiler, by one of them with and by one without
  // optimising.
  const std::vector<std::string> compilers = test::compilers(libraries.folder());
  for (const std::string& compiler : compilers) {
    const char* level = compiler == compilers.front() ? "-O1" : "-O0";
    BOOST_REQUIRE_EQUAL(libraries.compile(compiler, {level}), "");
    libraries.evaluate(calls);
    std::size_t certified = 0;
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const Call& call = calls[i];
      BOOST_TEST_CONTEXT(compiler << ", library " << call.library << ", call " << i) {
        // The bounds are the claim under test.
        if (std::isfinite(call.bound))
          BOOST_TEST(test::relative_error(call.value, exact[i]) <= call.bound);
        if (std::isfinite(call.fast_bound))
          BOOST_TEST(test::relative_error(call.fast_value, exact[i]) <= call.fast_bound);
      }
      certified += std::isfinite(call.bound) ? 1 : 0;
      // Fixed first, then unfixed: each within its bound of one value.
      if (i % 2 == 1 && std::isfinite(call.bound + calls[i - 1].bound))
        BOOST_TEST(std::abs(call.value - calls[i - 1].value) <=
                   (call.bound + calls[i - 1].bound) * 1.01 * std::abs(call.value));
    }
    // Only the two cases beyond ordinary sizes may have none.
    BOOST_TEST(certified >= calls.size() - std::size_t{4 * 8});
  }
}

BOOST_AUTO_TEST_CASE(fixed_names_are_no_parameters) {
  for (const Case& each : cases()) {
    const std::string header =
        symbolic::emit_header(symbolic::derive(each.scene), "scene", {each.fixed, false});
    const std::string code = header.substr(header.find("#ifndef"));
    const std::string members = struct_of_parameters(header);
    for (const std::string& name : each.fixed) {
      if (name == "all") BOOST_TEST(members.ends_with("{ double mu0, omega, du_z; "), members);
      if (name == "all" || name.find('[') != std::string::npos) continue;
      const std::string whole = "\\b" + std::string(name == "mass" ? "m" : name) + "\\b";
      BOOST_TEST(!has_match(members, whole), name);
      BOOST_TEST(!has_match(code, "p\\." + name + "\\b"), name);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_entry_fixed_alone_is_not_read) {
  const std::string header =
      symbolic::emit_header(symbolic::derive(stored("prony")), "scene", {{"k[3]", "tau"}, false});
  BOOST_TEST(struct_of_parameters(header).find("std::array<double, 10> k;") != std::string::npos);
  BOOST_TEST(header.find("p.k[1]") != std::string::npos);
  BOOST_TEST(header.find("p.k[2]") == std::string::npos);
  BOOST_TEST(header.find("p.tau") == std::string::npos);
}

// There the bound is carried along at run time; what it is made of may be constant, too.
BOOST_AUTO_TEST_CASE(a_mesh_keeps_its_bounds) {
  std::mt19937 random(seed);
  const test::Libraries libraries({meshed()}, test::Asked::values, {{{"all"}, false}});
  BOOST_TEST(test::contents(libraries.header(0)).find("unless_moderate(e") != std::string::npos);
  std::vector<Call> calls(6);
  for (Call& call : calls) call.scene = varied(meshed(), {"all"}, random);
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {}), "");
  libraries.evaluate(calls);
  for (const Call& call : calls) {
    const test::Real exact = test::critical_velocity_by_nodes(call.scene);
    BOOST_TEST(std::isfinite(call.bound));
    BOOST_TEST(test::relative_error(call.value, exact) <= call.bound);
    BOOST_TEST(test::relative_error(call.fast_value, exact) <= call.fast_bound);
  }
}

BOOST_AUTO_TEST_CASE(the_banner_tells_how_and_what) {
  const std::string header =
      symbolic::emit_header(symbolic::derive(stored("kelvin")), "scene", {{"kn", "cn"}, true});
  BOOST_TEST(header.find("Fixed: cn = 20, kn = 10000000.") != std::string::npos);
  std::string joined = header;
  for (std::size_t at = 0; (at = joined.find("\n// ", at)) != std::string::npos;)
    joined.replace(at, 4, " ");
  BOOST_TEST(joined.find("vcrit generate kelvin.toml --out DIR --name scene --fix kn,cn "
                         "--quantities") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_there_already_may_be_named) {
  const Scene scene = stored("kelvin", {{"cn", "0"}});
  BOOST_TEST((symbolic::fixed_values(scene, {"cn", "kn"}) == symbolic::FixedValues{{{"kn"}, 1e7}}));
  BOOST_TEST((symbolic::fixed_values(stored("zener"), {"poisson"}) ==
              symbolic::FixedValues{{{"poisson"}, 0.3}}));
}

BOOST_AUTO_TEST_CASE(wrong_names_are_refused) {
  const Scene scene = stored("kelvin");
  refused(scene, "kdd", "fix: found \"kdd\", which this scene does not have; expected \"kd\"");
  for (const char* name : {"omega", "mu0", "du_z", "u_z0", "frequency"})
    refused(scene, name,
            "fix: found \"" + std::string(name) +
                "\", which is a parameter of every call; expected one of all, cn, ct, kd, kn, kt, "
                "m, mass");
  refused(stored("prony"), "k[11]",
          "fix: found \"k[11]\", which this scene does not have; expected \"k[10]\"");
  refused(scene_of("normal = \"kn\"\npoisson = \"nu\"", "kd"), "nu",
          "fix: found \"nu\", which has no number in the scene; expected a number for it, as by "
          "`set nu=VALUE`");
  refused(scene_of("normal = \"prony(k0, k, tau, 3)\"\npoisson = 0.3", "kd"), "tau",
          "fix: found \"tau\", which has no number in the scene; expected a number for it, as by "
          "`set tau[1]=VALUE`");
}

BOOST_AUTO_TEST_SUITE_END()
