// Evaluators in all languages but C++ compiled, run, and compared with nodal evaluation at 250
// digits: values, bounds and gradients.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>
#include <set>

#include "base/errors.hpp"
#include "derivation/scenes.hpp"
#include "emit/draw.hpp"
#include "emit/extreme_cases.hpp"
#include "emit/language_files.hpp"

BOOST_AUTO_TEST_SUITE(test_languages)

using namespace vcrit;
using test::Asked;
using Call = test::LanguageCall;
using Files = test::LanguageFiles;
using test::scene_of;
using test::Tool;

namespace {

constexpr unsigned seed = 11;

std::vector<Scene> scenes() {
  const std::string bridge = test::bridge_network;
  return {
      test::kelvin_scene(),
      scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m"),
      scene_of("normal = \"prony(k0, k, tau, 10)\"\npoisson = 0.45", "kd | cd", "m"),
      scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", bridge),
      scene_of("normal = \"c1 | (k1 - (c2 | (k2 - (c3 | (k3 - (c4 | (k4 - (k5 | c5))))))))\"\n"
               "tangential = \"kt | (ct - ce)\"",
               "kd", "m"),
      test::scene_of_others(),
  };
}

constexpr std::size_t plain_answers = test::plain_answers;

std::vector<Call> calls(const std::vector<Scene>& scenes, int count, double nearest) {
  test::Draw draw(seed, nearest);
  std::vector<Call> all;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (int n = 0; n < count; ++n) {
      Call call;
      call.library = i;
      call.scene = draw.values_for(scenes[i], n % 3);
      call.exact = test::critical_velocity_by_nodes(call.scene);
      all.push_back(std::move(call));
    }
  return all;
}

void check_values(const Tool& tool, const std::vector<Call>& calls) {
  std::size_t certified = 0, known = 0;
  for (std::size_t i = 0; i < calls.size(); ++i)
    BOOST_TEST_CONTEXT("scene " << calls[i].library << ", call " << i) {
      const Call& call = calls[i];
      const std::vector<double>& x = call.answers;
      BOOST_TEST(test::relative_error(call.value(), call.exact) <= call.bound());
      BOOST_TEST(test::relative_error(call.fast_value(), call.exact) <= call.fast_bound());
      // Batches may be compiled differently: they keep the bound.
      BOOST_TEST(test::relative_error(x[6], call.exact) <= call.bound());
      BOOST_TEST(test::relative_error(x[7], call.exact) <= call.fast_bound());
      BOOST_TEST(x[4] == call.value());
      if (x.size() > plain_answers) BOOST_TEST(x[plain_answers] == call.value());
      if (tool.wide) BOOST_TEST(std::isfinite(call.bound()));
      known += std::isfinite(call.bound()) ? 1 : 0;
      certified += call.bound() <= 0x1.001p-53 ? 1 : 0;
    }
  // Half an ulp nearly everywhere (a condition of 1e13 leaves 102 - 44 bits), but for what is out
  // of range: of kind 1, a third of the calls.
  BOOST_TEST(certified * 100 >= known * 98);
  BOOST_TEST(known * 3 >= calls.size() * 2);
}

/// By the library of a scene of springs kn, kt and kd and a mass.
void check_resonance_antiresonance_and_nothing(const Files& files, const Tool& tool,
                                               std::size_t library, const Scene& shape) {
  const auto with = [&](double kn, double mass) {
    Call call;
    call.library = library;
    call.scene = shape;
    call.scene.coefficient.value = call.scene.angular_frequency.value = 1.0;
    call.scene.amplitude.value = call.scene.indentation.value = 1.0;
    call.scene.elements = {{{"kn"}, kn}, {{"kt"}, 1.0}, {{"kd"}, 3.0}};
    call.scene.mass->value = mass;
    return call;
  };
  std::vector<Call> all{with(1, 3), with(1, 4), with(1, 2), with(0x1p-800, 2)};
  constexpr double inf = std::numeric_limits<double>::infinity();
  files.evaluate(tool, all);
  BOOST_TEST(all[0].value() == inf);
  BOOST_TEST(all[0].bound() == inf);
  BOOST_TEST(all[1].value() == 0.0);
  BOOST_TEST(all[1].bound() == inf);
  // kn/kt (kt + kd - m)/(kd - m) = 2 kn
  BOOST_TEST(all[2].value() == 2.0);
  BOOST_TEST(all[2].fast_value() == 2.0);
  BOOST_TEST(all[3].value() == 0x1p-799);
  BOOST_TEST(std::isfinite(all[3].bound()) == tool.wide);
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_and_bounds_hold) {
  BOOST_TEST_MESSAGE("seed " << seed);
  const std::vector<Scene> shapes = scenes();
  const Files files(shapes, Asked::values_and_gradients);
  std::vector<Call> all = calls(shapes, 30, -13.0);
  std::vector<Call> smooth = calls(shapes, 3, -7.0);
  std::vector<symbolic::ParameterList> parameters;
  for (const Scene& shape : shapes) parameters.emplace_back(shape, symbolic::derive(shape));
  std::vector<std::vector<test::Real>> partials;
  for (const Call& call : smooth) {
    partials.emplace_back();
    for (const symbolic::Member& member : parameters[call.library].members())
      for (int entry = member.length == 0 ? 0 : 1; entry <= member.length; ++entry)
        partials.back().push_back(test::derivative(call.scene, call.exact, {member.name, entry}));
  }
  files.with_each_tool([&](const Tool& tool) {
    files.evaluate(tool, all);
    check_values(tool, all);
    check_resonance_antiresonance_and_nothing(files, tool, 1, shapes[1]);
    files.evaluate(tool, smooth);
    for (std::size_t i = 0; i < smooth.size(); ++i) {
      const Call& call = smooth[i];
      if (!std::isfinite(call.bound())) continue;
      const std::vector<double> x = files.members_of(call);
      for (std::size_t j = 0; j < x.size(); ++j)
        BOOST_TEST_CONTEXT("scene " << call.library << ", call " << i << ", parameter " << j) {
          // Terms of a derivative are at most v*/x times the square of the condition, 1e14, of
          // which 2^-102 is 2e-17; the reference errs by (2^-50 1e7)^2 = 1e-16.
          const double exact = static_cast<double>(partials[i][j]);
          const double scale = std::abs(exact) + std::abs(call.value() / x[j]);
          BOOST_TEST(std::abs(call.answers[plain_answers + 1 + j] - exact) <= 1e-13 * scale);
          // A bound of 1e-12 allows conditions of 1e4, terms of 1e8 v*/x, 2^-53 of it, a hundred
          // times.
          if (call.fast_bound() < 1e-12)
            BOOST_TEST(std::abs(call.answers[plain_answers + x.size() + 2 + j] - exact) <=
                       1e-6 * scale);
        }
    }
  });
}

// Too many spanning trees: star-mesh elimination, whose bounds are known at run time.
BOOST_AUTO_TEST_CASE(meshes) {
  std::string edges;
  for (int a = 0, count = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b)
      if (b > 1)
        edges += fmt::format("{}[\"{}{}\", \"{}\", \"{}\"]", edges.empty() ? "" : ", ",
                             count % 2 == 0 ? "k" : "c", count + 1, a, b),
            ++count;
  const std::vector<Scene> shapes{
      scene_of("normal = \"net\"\ntangential = \"kt | ct\"", "", "",
               "[networks.net]\nterminals = [\"0\", \"1\"]\nedges = [" + edges + "]\n")};
  const std::string c = symbolic::emit(symbolic::derive(shapes[0]), "mesh", {.language = "c99"});
  BOOST_REQUIRE(c.find("mesh_unless_moderate(") != std::string::npos);
  const Files files(shapes);
  std::vector<Call> all = calls(shapes, 12, -13.0);
  files.with_each_tool(
      [&](const Tool& tool) {
        files.evaluate(tool, all);
        check_values(tool, all);
      },
      Files::Length::very_large);
}

BOOST_AUTO_TEST_CASE(bounds_hold_for_every_size_of_value) {
  const test::ExtremeCases cases = test::extreme_cases(0, 6, 78);  // compiled in a few seconds
  std::vector<Call> all;
  for (const test::ExtremeCase& row : cases.rows) {
    Call call;
    call.library = row.shape;
    call.scene = row.scene;
    all.push_back(std::move(call));
  }
  const Files files(cases.shapes);
  const auto hold = [&](const Tool& tool) {
    files.evaluate(tool, all);
    std::size_t certified = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double expected = cases.rows[i].expected;
      BOOST_TEST(test::holds(all[i].value(), all[i].bound(), expected), all[i].scene.file);
      BOOST_TEST(test::holds(all[i].fast_value(), all[i].fast_bound(), expected),
                 all[i].scene.file);
      certified += std::isfinite(all[i].bound()) ? 1 : 0;
    }
    BOOST_TEST_MESSAGE(tool.label << ": " << certified << " of " << all.size());
    // Those in range alone, where numbers have no exponents of their own.
    BOOST_TEST(certified > (tool.wide ? 50 : 10));
  };
  files.with_each_tool(hold, Files::Length::large);
}

BOOST_AUTO_TEST_CASE(a_missing_tool_is_no_success) {
  const test::PrivateFolder folder;
  BOOST_CHECK_NO_THROW(test::require_tool("g++", folder.path()));
  BOOST_CHECK_THROW(test::require_tool("no-such-compiler", folder.path()), std::runtime_error);
  // Of all tools, no language hangs on one that may be missing.
  for (const test::LanguageRow& row : test::language_rows())
    BOOST_TEST(std::any_of(row.tools.begin(), row.tools.end(),
                           [](const Tool& t) { return !t.is_optional; }),
               row.name);
}

BOOST_AUTO_TEST_CASE(every_language_has_a_row) {
  std::set<std::string> rows;
  for (const test::LanguageRow& row : test::language_rows()) rows.insert(row.name);
  const std::vector<std::string>& names = symbolic::language_names();
  BOOST_TEST(rows == std::set<std::string>(names.begin(), names.end()),
             boost::test_tools::per_element());
}

// As in generated files, but for what the generator fills in.
BOOST_AUTO_TEST_CASE(the_arithmetic_compiles_as_it_is) {
  const test::PrivateFolder folder;
  for (const test::LanguageRow& row : test::language_rows()) {
    const std::string room = VCRIT_LANGUAGES "/" + (row.name == "c++" ? "cpp" : row.name) + "/";
    test::Command command = row.arithmetic;
    for (std::string& word : command) {
      word = test::replaced_all(word, "FOLDER/", folder.path().string() + "/");
      word = test::replaced_all(word, "HERE/", room);
    }
    const test::Outcome outcome = test::run(command, folder.path());
    BOOST_TEST(outcome.status == 0, row.name << ": " << outcome.output);
  }
}

BOOST_AUTO_TEST_CASE(same_bytes_in_every_run) {
  for (const Scene& scene : scenes())
    for (const std::string& language : symbolic::language_names()) {
      const std::string first =
          symbolic::emit(symbolic::derive(scene), "again", {.language = language});
      for (int run = 1; run < 10; ++run)
        BOOST_TEST(
            (symbolic::emit(symbolic::derive(scene), "again", {.language = language}) == first));
    }
}

BOOST_AUTO_TEST_CASE(names_are_refused_by_the_languages_that_take_them) {
  const auto refused = [](const std::string& element, const std::string& name,
                          const std::string& language) {
    try {
      const std::string contact = "normal = \"spring(" + element + ")\"\ntangential = \"kt\"";
      symbolic::emit(symbolic::derive(scene_of(contact)), name, {.language = language});
      return false;
    } catch (const InputError&) {
      return true;
    }
  };
  const auto is_among = [](const std::string& word, const test::Command& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  std::set<std::string> elements, libraries;
  for (const test::LanguageRow& row : test::language_rows()) {
    elements.insert(row.elements.begin(), row.elements.end());
    libraries.insert(row.libraries.begin(), row.libraries.end());
  }
  BOOST_TEST(elements.size() > 1);
  BOOST_TEST(libraries.size() > 3);
  for (const test::LanguageRow& row : test::language_rows()) {
    for (const std::string& word : elements)
      BOOST_TEST(refused(word, "good", row.name) == is_among(word, row.elements),
                 row.name << ": " << word);
    for (const std::string& word : libraries)
      BOOST_TEST(refused("kn", word, row.name) == is_among(word, row.libraries),
                 row.name << ": " << word);
    BOOST_TEST(refused("kn", "../up", row.name));
  }
}

BOOST_AUTO_TEST_CASE(names_are_spelled_as_the_language_does) {
  const Scene scene = scene_of("normal = \"prony(k0, k, tau, 3)\"\npoisson = \"nu\"", "kd");
  const auto spelled = [](const std::string& name) { return "r#" + name; };
  const symbolic::ParameterList parameters(scene, symbolic::derive(scene), {}, spelled);
  for (const symbolic::Member& member : parameters.members())
    BOOST_TEST(member.name == "r#" + member.symbol);
  BOOST_TEST(parameters.reference({"k", 2}) == "p.r#k[1]");
  BOOST_TEST(parameters.named("at.THE_OMEGA") == "at.r#omega");
}

BOOST_AUTO_TEST_CASE(an_unknown_language_is_answered_with_all_that_there_are) {
  try {
    symbolic::emit(symbolic::derive(scenes().front()), "good", {.language = "cobol"});
    BOOST_TEST(false);
  } catch (const InputError& error) {
    for (const std::string& name : symbolic::language_names())
      BOOST_TEST(std::string(error.what()).find(name) != std::string::npos, error.what());
  }
}

BOOST_AUTO_TEST_SUITE_END()
