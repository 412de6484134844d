// Every cell of the rulebook: which questions a scene of each kind has no answer for, by hand, and
// in what words.
#include "rules/rulebook.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "base/errors.hpp"
#include "indenter/half_space.hpp"
#include "scene/scene.hpp"
#include "scene/stiffness_data.hpp"
#include "simulation/system/system.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_rulebook)

using namespace vcrit;
using namespace vcrit::rules;

namespace {

// Parts of a scene, with omega = 1/s; k and c are 1.
struct Parts {
  const char* normal = "k";
  test::Toml tangential{};
  bool separation = false;
  const char* indenter = "";
  test::Toml drive{}, mount{}, mount_mass{};
  double amplitude = 0.5, indentation = 1, coefficient = 0.5;
  test::Toml force{};  // in place of the indentation
};

Scene scene_of(const Parts& parts) {
  return test::scene_of(
      {.normal = parts.normal,
       .tangential = parts.tangential,
       .separation = parts.separation,
       .indenter = parts.indenter,
       .network = parts.drive,
       .mount = parts.mount,
       .mount_mass = parts.mount_mass,
       .angular_frequency = 1,
       .amplitude = parts.amplitude,
       .indentation = parts.indentation,
       .force = parts.force,
       .coefficient = parts.coefficient,
       .elements = {{"k", 1}, {"c", 1}, {"kd", 1}, {"m1", 1}, {"l", 1}, {"slow", 1e3}}});
}

const char* const kelvin = "k | c";
const char* const cone = "shape = \"cone\"\nangle = 0.1\n";

Scene measured() {
  Scene scene = scene_of({});
  scene.receptance = parse_receptance("omega,Re,Im\n0.5,1,0\n2,1,0\n", "drive.csv");
  return scene;
}

// K = (1 + 0.1 i) N/m at all frequencies of its table.
Scene measured_pad() {
  const Symbol storage{"k"}, loss_factor{"l"}, rest{"kd"};
  Scene scene = scene_of({});
  scene.normal = Network{Element{ElementKind::measured, storage, loss_factor, rest}};
  scene.elements = {{storage, {}}, {loss_factor, {}}, {rest, 1}};
  scene.measured = {{storage, loss_factor, rest,
                     std::make_shared<StiffnessTable>(parse_stiffness_table(
                         "omega,storage,loss\n0.5,1,0.1\n1,1,0.1\n2,1,0.1\n", "pad.csv"))}};
  return scene;
}

// One scene of each kind, in which nothing else is unusual.
Scene scene_of(SceneKind kind) {
  switch (kind) {
    case SceneKind::measured_drive:
      return measured();
    case SceneKind::masses_in_drive:
      return scene_of({.drive = "kd - (mass(m1) | k)"});
    case SceneKind::lossy_spring:
      return scene_of({.normal = "lossy(k, l)"});
    case SceneKind::indenter:
      return scene_of({.indenter = cone});
    case SceneKind::no_indenter:
      return scene_of(Parts{});
    case SceneKind::separating:
      return scene_of({.separation = true});
    case SceneKind::separating_without_memory:
      return scene_of({.normal = kelvin, .separation = true});
    case SceneKind::separating_with_memory:
      return scene_of({.tangential = "k | c", .separation = true});
    case SceneKind::no_static_load:
      return scene_of({.normal = "k - c"});
    case SceneKind::no_static_load_below_indenter:
      return scene_of({.normal = "k - c", .indenter = cone});
    case SceneKind::no_friction:
      return scene_of({.coefficient = 0});
    case SceneKind::no_indentation:
      return scene_of({.indentation = 0});
    case SceneKind::tapping:
      return scene_of({.separation = true, .indentation = 0});
    case SceneKind::never_closing:
      return scene_of({.separation = true, .indenter = cone, .amplitude = 0, .indentation = 0});
    case SceneKind::amplitude_too_large:
      return scene_of({.amplitude = 1});
    case SceneKind::deep_amplitude:
      return scene_of({.separation = true, .amplitude = 2});
    case SceneKind::opening:
      return scene_of({.normal = kelvin, .amplitude = 0.8});
    case SceneKind::opening_below_indenter:
      return scene_of({.normal = kelvin, .indenter = cone, .amplitude = 0.8});
    case SceneKind::opening_with_memory:
      return scene_of({.tangential = "k | c", .separation = true, .amplitude = 2});
    case SceneKind::open_where_steepest:
      return scene_of({.normal = "k | damper(slow)", .separation = true, .amplitude = 0.9});
    case SceneKind::sinking:
      return scene_of({.normal = "k - c", .force = 1});
    case SceneKind::sinking_opening:
      return scene_of({.normal = "k - c", .separation = true, .amplitude = 2, .force = 1});
    case SceneKind::mount:
      return scene_of({.mount = "kd"});
    case SceneKind::separating_mount:
      return scene_of({.separation = true, .mount = "kd"});
    case SceneKind::separating_with_mass:
      return scene_of({.separation = true, .mount = "kd", .mount_mass = 0.1});
    case SceneKind::indenter_on_drive:
      return scene_of({.indenter = cone, .drive = "kd | c"});
    case SceneKind::viscoelastic_indenter_on_drive:
      return scene_of({.normal = kelvin, .indenter = cone, .drive = "kd"});
    case SceneKind::measured_contact:
      return measured_pad();
  }
  throw Bug("a kind without a scene");
}

using Names = std::set<std::string>;

Names operator+(Names a, const Names& b) {
  a.insert(b.begin(), b.end());
  return a;
}

// What has no answer: for one contact, and below an indenter, where the contact never opens or part
// without a memory.
const Names contact{"motion_below_indenter"};
const Names half_space{"motion", "other_methods", "report_explorer", "report_stability"};
const Names may_part{"report_stability"};
const Names outside{"admissible", "report_stability"};

Names without_answer(SceneKind kind) {
  switch (kind) {
    case SceneKind::measured_drive:
      return contact + Names{"rational_form", "all_frequencies", "report_stability"};
    case SceneKind::masses_in_drive:
      return contact + Names{"report_stability"};
    case SceneKind::lossy_spring:
      return contact + Names{"rational_form",     "all_frequencies", "motion",
                             "normal_motion",     "motion_in_time",  "comparison",
                             "report_simulation", "report_stability"};
    case SceneKind::indenter:
      return half_space;
    case SceneKind::no_indenter:
      return contact;
    case SceneKind::separating:
      return contact + may_part;
    case SceneKind::separating_without_memory:
      return contact + may_part + Names{"formula_of_all_values", "evaluator"};
    case SceneKind::separating_with_memory:
      return contact + may_part + Names{"formula_of_all_values", "evaluator", "closed_form"};
    case SceneKind::no_static_load:
      return contact + outside + Names{"motion", "normal_motion", "comparison", "mean_load"};
    case SceneKind::no_static_load_below_indenter:
      return half_space + outside +
             Names{"motion_below_indenter", "normal_motion", "comparison", "mean_load"};
    case SceneKind::no_friction:
      return contact + Names{"motion", "comparison"};
    case SceneKind::no_indentation:
      return contact + outside + Names{"motion", "mean_load", "closed_range"};
    case SceneKind::tapping:
      return contact + may_part + Names{"closed_range", "closed_amplitude"};
    case SceneKind::never_closing:
      return half_space + outside +
             Names{"motion_below_indenter", "comparison", "closed_range", "closed_amplitude"};
    case SceneKind::amplitude_too_large:
      return contact + outside + Names{"motion", "closed_range"};
    case SceneKind::deep_amplitude:
      return contact + may_part + Names{"closed_range"};
    case SceneKind::opening:
      return contact + outside + Names{"motion"};
    case SceneKind::opening_below_indenter:
      return half_space + outside + Names{"motion_below_indenter"};
    case SceneKind::opening_with_memory:
      return without_answer(SceneKind::separating_with_memory) +
             Names{"formula", "comparison", "closed_range"};
    case SceneKind::open_where_steepest:
      return without_answer(SceneKind::separating_without_memory) + Names{"formula", "comparison"};
    case SceneKind::sinking:
      return contact;
    case SceneKind::sinking_opening:
      return without_answer(SceneKind::separating_without_memory) +
             Names{"admissible", "formula", "motion", "normal_motion", "comparison"};
    case SceneKind::mount:
      return contact + Names{"closed_range"};
    case SceneKind::separating_mount:
    case SceneKind::separating_with_mass:
      return without_answer(SceneKind::mount) + may_part + outside +
             Names{"formula",        "closed_form", "formula_of_all_values",
                   "evaluator",      "motion",      "normal_motion",
                   "motion_in_time", "comparison",  "report_simulation",
                   "report_explorer"};
    case SceneKind::indenter_on_drive:
      return half_space + Names{"formula",   "closed_form",   "formula_of_all_values",
                                "evaluator", "rational_form", "comparison",
                                "derivation"};
    case SceneKind::viscoelastic_indenter_on_drive:
      return without_answer(SceneKind::indenter_on_drive);
    case SceneKind::measured_contact:
      return without_answer(SceneKind::lossy_spring) +
             Names{"formula_of_all_values", "evaluator", "report_explorer", "closed_range"};
  }
  throw Bug("a kind without its questions");
}

template <class Use>
void for_each_kind(const Use& use) {
  for (std::size_t i = 0; i < kinds; ++i) use(static_cast<SceneKind>(i));
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const ModelError& error) {
    return error.what();
  }
  return {};
}

std::string words(Question question, SceneKind kind) {
  const Scene scene = scene_of(kind);
  return answer(question, scene).reason;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_scene_of_each_kind_is_of_it) {
  for_each_kind([](SceneKind kind) {
    const Scene scene = scene_of(kind);
    BOOST_TEST(Facts(scene).is(kind), name_of(kind));
  });
}

BOOST_AUTO_TEST_CASE(each_cell_says_what_it_says_by_hand) {
  for_each_kind([](SceneKind kind) {
    const Scene scene = scene_of(kind);
    Names found;
    for (std::size_t q = 0; q < questions; ++q) {
      const auto question = static_cast<Question>(q);
      const Answer given = answer(question, scene);
      if (!given) found.insert(name_of(question));
      BOOST_TEST(given.reason.empty() == bool{given});
      BOOST_TEST(given.reason.find('{') == std::string::npos, given.reason);
      BOOST_TEST((given.status() == 3) == (given.verdict == Ruling::refused));
      BOOST_TEST(bool{given} == reasons(question, scene).empty());
    }
    BOOST_TEST(found == without_answer(kind), name_of(kind));
  });
}

// So that no cell is a dead letter: each decides for the scene of its kind, unless an earlier kind
// of that scene has decided already.
BOOST_AUTO_TEST_CASE(each_refusal_is_reached) {
  for_each_kind([](SceneKind kind) {
    const Scene scene = scene_of(kind);
    for (std::size_t q = 0; q < questions; ++q) {
      const auto question = static_cast<Question>(q);
      const Answer here = cell(question, kind), given = answer(question, scene);
      if (here) continue;
      BOOST_TEST(!given);
      const std::vector<std::string> all = reasons(question, scene);
      BOOST_TEST((given.key == std::string(name_of(kind)) || all.size() > 1),
                 name_of(question) << ", " << name_of(kind) << ": " << given.key);
    }
  });
}

BOOST_AUTO_TEST_CASE(who_is_refused_by_the_rulebook_is_refused_in_its_words) {
  for_each_kind([](SceneKind kind) {
    const Scene scene = scene_of(kind);
    const auto expected = [&](Question question) {
      const Answer given = answer(question, scene);
      return given.advice.empty() ? given.reason : given.reason + "; " + given.advice;
    };
    BOOST_TEST(refusal([&] { simulation::system_of(scene); }) == expected(Question::motion));
    BOOST_TEST(refusal([&] { indenter::HalfSpace{scene}; }) ==
               expected(Question::motion_below_indenter));
  });
}

// 0.8 m times 1/sqrt 2, rounded down; (3) with K_n = K_n(0) is (4).
BOOST_AUTO_TEST_CASE(an_amplitude_that_keeps_the_contact_closed_is_named) {
  const auto advice = [](Question question, SceneKind kind) {
    const Scene scene = scene_of(kind);
    return answer(question, scene).advice;
  };
  const std::string separation = ", or let the contact open: separation = true in [contact]";
  BOOST_TEST(advice(Question::motion, SceneKind::opening) ==
             "take an amplitude below 707.1 mm" + separation);
  BOOST_TEST(advice(Question::closed_range, SceneKind::deep_amplitude).empty());
}

BOOST_AUTO_TEST_CASE(numbers_stand_in_the_words) {
  BOOST_TEST(words(Question::motion, SceneKind::amplitude_too_large) ==
             "the amplitude du_z = 1 m is not below the indentation u_z0 = 1 m (Eq. 3)");
  // |1 + i| = sqrt 2
  BOOST_TEST(words(Question::motion, SceneKind::opening) ==
             "the contact opens: F_n oscillates by 1.131 N about a mean of 1 N (Eq. 4)");
  BOOST_TEST(words(Question::admissible, SceneKind::opening) ==
             "the contact opens: the normal force oscillates by du_z |K_n| = 1.131 N about a "
             "mean of K_n(0) u_z0 = 1 N (Eq. 4)");
  BOOST_TEST(words(Question::motion_below_indenter, SceneKind::opening_below_indenter) ==
             "the whole contact opens: at the tip F_n oscillates by 1.131 times its mean (Eq. 4)");
  BOOST_TEST(words(Question::motion, SceneKind::no_friction) ==
             "with mu0 = 0 there is no friction to compare with");
  BOOST_TEST(words(Question::mean_load, SceneKind::no_indentation) ==
             "without an indentation u_z0 the contact carries no load");
  BOOST_TEST(words(Question::closed_amplitude, SceneKind::tapping) ==
             "without an indentation u_z0 the contact opens at every amplitude");
}

// So light that the mean depth lies above the surface, where no amplitude is below it.
BOOST_AUTO_TEST_CASE(a_load_that_hardly_touches_has_to_be_larger) {
  const Scene scene = scene_of({.indenter = cone, .force = 1e-3});
  BOOST_TEST(
      answer(Question::motion_below_indenter, scene).advice ==
      "take a smaller amplitude or a larger load, or let the contact open: separation = true "
      "in [contact]");
}

// |K_n(i)| = |1 + i|, and (3) is W/K_n(0): nothing else is asked of an indentation.
BOOST_AUTO_TEST_CASE(a_load_takes_the_place_of_the_indentation) {
  const Scene scene = scene_of({.normal = kelvin, .amplitude = 0.8, .force = 1});
  BOOST_TEST(answer(Question::admissible, scene).reason ==
             "the contact opens: the normal force oscillates by du_z |K_n| = 1.131 N about a "
             "mean of W = 1 N (Eq. 4)");
  BOOST_TEST(answer(Question::admissible, scene).advice ==
             "take an amplitude below 707.1 mm, or let the contact open: separation = true in "
             "[contact]");
  BOOST_TEST(bool{
      answer(Question::admissible, scene_of({.normal = kelvin, .amplitude = 0.7, .force = 1}))});
}

// v* is then 0 with a memory as without, and needs no motion.
BOOST_AUTO_TEST_CASE(without_friction_the_formula_holds_where_the_contact_opens) {
  for (const SceneKind kind : {SceneKind::opening_with_memory, SceneKind::open_where_steepest}) {
    Scene scene = scene_of(kind);
    BOOST_TEST(!answer(Question::formula, scene));
    scene.coefficient.value = 0;
    BOOST_TEST(bool{answer(Question::formula, scene)}, name_of(kind));
  }
}

// Cells on one body: a network of springs and dampers, and no other, whatever the cells remember.
BOOST_AUTO_TEST_CASE(an_indenter_on_a_drive_says_what_it_needs) {
  const auto why = [](const char* normal, const char* drive, bool separation) {
    return answer(
               Question::motion_below_indenter,
               scene_of(
                   {.normal = normal, .separation = separation, .indenter = cone, .drive = drive}))
        .reason;
  };
  for (const bool separation : {false, true}) {
    BOOST_TEST(why("k", "kd | c", separation).empty());
    BOOST_TEST(why("k", "kd - (mass(m1) | kd)", separation).find("this one has masses") !=
               std::string::npos);
    BOOST_TEST(why(kelvin, "kd", separation).empty());
  }
}

BOOST_AUTO_TEST_CASE(cells_move_below_an_indenter_and_an_amplitude_lifts_a_pressed_one) {
  BOOST_TEST((motion_question(scene_of({.indenter = cone})) == Question::motion_below_indenter));
  BOOST_TEST((motion_question(scene_of({.force = 1})) == Question::motion));
  BOOST_TEST(Facts(scene_of({.indenter = cone, .force = 1})).depth_falls_with_amplitude());
  for (const Parts& parts : {Parts{.indenter = cone}, Parts{.force = 1}})
    BOOST_TEST(!Facts(scene_of(parts)).depth_falls_with_amplitude());
}

BOOST_AUTO_TEST_CASE(kinds_seen_without_values_need_none) {
  Scene scene = scene_of(SceneKind::separating_without_memory);
  scene.amplitude.value.reset();
  BOOST_TEST(!answer(Question::evaluator, scene));
  BOOST_TEST(bool{answer(Question::closed_form, scene)});
  BOOST_CHECK_THROW(answer(Question::formula, scene), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
