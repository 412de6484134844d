// Formulas as the pages show them: the same as `vcrit derive` prints.
#include "compare/formulas.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "derivation/derivation.hpp"
#include "document/print.hpp"
#include "problem/problem.hpp"
#include "record/json_text.hpp"
#include "report/scene_page.hpp"
#include "scene/scene.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_formulas)

namespace {

using namespace vcrit;
using namespace vcrit::validation;

using test::has;

}  // namespace

BOOST_AUTO_TEST_CASE(velocity_is_shown_as_it_is_printed) {
  struct Shown {
    Problem problem;
    bool is_real;
  };
  const test::SceneText long_series{.normal = "prony(k0, k, tau, 100)", .network = "kd"};
  for (const auto& [problem, is_real] :
       {Shown{read_problem(VCRIT_SCENES "/zener.toml"), true},
        Shown{read_problem(VCRIT_SCENES "/bridge.toml"), true},
        Shown{read_problem(VCRIT_SCENES "/measured_drive.toml"), false},
        Shown{test::scene_of(long_series), false}}) {
    BOOST_TEST_CONTEXT(problem->source->title) {
      const auto printed = record::read_json(symbolic::print(problem, {symbolic::Format::json}));
      const ShownVelocity shown = shown_velocity(symbolic::derive(problem));
      BOOST_TEST(shown.is_real == is_real);
      BOOST_TEST(printed["critical_velocity"]["text"] == shown.formula.text);
      BOOST_TEST(printed["definitions"].size() == shown.definitions.size());
      for (std::size_t i = 0; i < shown.definitions.size(); ++i) {
        const ShownEquation& each = shown.definitions[i];
        BOOST_TEST(printed["definitions"].at(i)["text"] ==
                   each.left.text + " = " + each.right.text);
      }
      BOOST_TEST(has(symbolic::print(problem, {}), shown.ratio));
    }
  }
}

// Of real formulas no page says "with s = i omega".
BOOST_AUTO_TEST_CASE(a_real_formula_is_explained_as_one) {
  SceneReport report = example::scene_report(read_scene(VCRIT_SCENES "/zener.toml"));
  report.formula = {example::formula("F"),
                    {{"", example::formula("R"), example::formula("T")}},
                    "g = K_n/K_t",
                    true,
                    "<math>g</math>"};
  const auto shown = [&] { return report::scene_page({report, {}}, example::origin()); };
  BOOST_TEST(has(shown(), "with <math>g</math> and"));
  report.formula.is_real = false;
  BOOST_TEST(!has(shown(), "with <math>g</math>"));
}

BOOST_AUTO_TEST_SUITE_END()
