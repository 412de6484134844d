// From scene files to the two files of a report.
#include "report/validate.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "derivation/derivation.hpp"
#include "record/json_text.hpp"
#include "run/compiler.hpp"
#include "support/scene_text.hpp"
#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_validate)

using namespace vcrit;
using namespace vcrit::validation;
using nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

const std::string scenes = VCRIT_SCENES;

report::Validation run(const std::vector<std::string>& files, const fs::path& directory,
                       const fs::path& figures = {}) {
  return report::validate({files, directory, figures}, [](const Standing&) {});
}

void check_figures(const fs::path& folder) {
  BOOST_TEST(read_file(folder / "critical_velocity.svg").find("<svg") != std::string::npos);
  BOOST_TEST(read_file(folder / "critical_velocity.pdf").rfind("%PDF", 0) == 0u);
  BOOST_TEST(fs::exists(folder / "critical_velocity.gp"));
  BOOST_TEST(fs::exists(folder / "friction.svg"));
}

ordered_json comparison(const ordered_json& scene, const std::string& key) {
  for (const ordered_json& one : scene["comparisons"])
    if (one["key"] == key) return one;
  BOOST_FAIL("no comparison " + key);
  return {};
}

}  // namespace

// The figures of one scene are in the folder that they are asked for in.
BOOST_AUTO_TEST_CASE(a_rigid_scene_passes_everything_and_is_drawn) {
  const PrivateFolder folder;
  const auto validation =
      run({scenes + "/elastic.toml"}, folder.path() / "new" / "out", folder.path() / "one");
  BOOST_TEST(validation.passed);
  BOOST_TEST(validation.failed.empty());
  BOOST_TEST(validation.not_run.empty());
  BOOST_TEST(validation.page == folder.path() / "new" / "out" / "index.html");
  const ordered_json scene =
      record::read_json(read_file(folder.path() / "new" / "out" / "report.json"))["scenes"][0];
  for (const char* key : {"formula", "derived", "generated", "generated_batch", "generated_fast",
                          "generated_certified", "balance", "simulation", "evaluators", "marched",
                          "starts", "closed_form"})
    BOOST_TEST(comparison(scene, key)["outcome"] == "passed", key);
  BOOST_TEST(scene["friction_curve"].size() >= 40u);
  BOOST_TEST(scene["cycle"]["points"].size() >= 100u);
  check_figures(folder.path() / "one");
}

// The scene itself, and its normal contact over one spring, whose evaluator the page's reader
// moves.
BOOST_AUTO_TEST_CASE(a_scene_is_derived_at_most_twice) {
  for (const char* file : {"/elastic.toml", "/separation.toml"}) {
    const std::size_t before = symbolic::derivations_made();
    const auto contents = report::compare(read_scene(scenes + file), [](const std::string&) {});
    BOOST_TEST(contents.report.comparisons.size() >= 5u);
    BOOST_TEST(contents.accuracy->evaluators.ways.size() >= 1u);
    BOOST_TEST(symbolic::derivations_made() - before <= 2u, file);
  }
}

// Its file gives delta = 2, and a = D sqrt(1 + delta^2) = 0.36 sqrt(5) to four digits.
BOOST_AUTO_TEST_CASE(the_reduced_model_is_held_against_the_papers_own_case) {
  const PrivateFolder folder;
  BOOST_TEST(run({scenes + "/kelvin_rigid.toml", scenes + "/elastic.toml"}, folder.path()).passed);
  const ordered_json all = record::read_json(read_file(folder.path() / "report.json"))["scenes"];
  const ordered_json model = all[0]["reduced_model"];
  BOOST_TEST(std::abs(model["delta"].get<double>() - 2) < 1e-4);
  const double a = model["normal_force_amplitude_ratio"].get<double>();
  BOOST_TEST(std::abs(a - 0.36 * std::sqrt(5.0)) < 1e-4);
  BOOST_TEST(!all[1].contains("reduced_model"));
}

BOOST_AUTO_TEST_CASE(a_rigid_massless_scene_has_neither_mass_nor_drive_from_end_to_end) {
  const PrivateFolder folder;
  write_file(folder.path() / "scene.toml", example::rigid_scene);
  run({(folder.path() / "scene.toml").string()}, folder.path());
  std::string html = read_file(folder.path() / "index.html");
  html.erase(html.find("</main>"));  // the scripts follow
  html.erase(0, html.find("<main"));
  const std::string data = read_file(folder.path() / "report.json");
  for (const std::string absent :
       {"K_d", "<mi>m</mi>", "<mi>d</mi>", " kg", "mass", "drive", " body", "creep"}) {
    BOOST_TEST(html.find(absent) == html.npos, absent);
    BOOST_TEST(data.find(absent) == data.npos, absent);
  }
}

// 30 kHz are beyond the table; the first scene ends exactly where its table does.
BOOST_AUTO_TEST_CASE(a_scene_that_fails_is_red_and_the_others_are_finished) {
  const std::string table_end = VCRIT_TEST_DATA "/table_end/measured.toml";
  const PrivateFolder folder;
  std::filesystem::copy(VCRIT_TEST_DATA "/table_end/measured_drive.csv", folder.path());
  std::string text = read_file(table_end);
  text.replace(text.find("20 kHz"), 6, "30 kHz");
  const std::string beyond = (folder.path() / "beyond.toml").string();
  write_file(beyond, text);
  const report::Validation validation = run({beyond, table_end}, folder.path() / "out");
  BOOST_TEST(!validation.passed);
  BOOST_TEST(validation.failed.size() == 1u);
  const ordered_json all =
      record::read_json(read_file(folder.path() / "out" / "report.json"))["scenes"];
  BOOST_TEST(all[0]["passed"] == false);
  BOOST_TEST(all[0]["failed"] == ordered_json({"scene"}));
  BOOST_TEST(comparison(all[0], "scene")["detail"].get<std::string>().find(
                 "is outside the receptance in") != std::string::npos);
  BOOST_TEST(all[1]["passed"] == true);
  const std::string page = read_file(folder.path() / "out" / "beyond.html");
  BOOST_TEST(page.find("is outside the receptance in") != std::string::npos);
  BOOST_TEST(page.find("v* = ") == std::string::npos);
  BOOST_TEST(read_file(folder.path() / "out" / "index.html").find("<li class=\"failed\">") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_scene_outside_the_model_is_not_simulated) {
  const PrivateFolder folder;
  const auto validation = run({scenes + "/inadmissible.toml"}, folder.path());
  BOOST_TEST(validation.passed);
  const ordered_json scene =
      record::read_json(read_file(folder.path() / "report.json"))["scenes"][0];
  BOOST_TEST(scene["admissible"] == false);
  BOOST_TEST(!scene["reasons"].empty());
  BOOST_TEST(!scene.contains("friction_curve"));
  BOOST_TEST(comparison(scene, "formula")["outcome"] == "passed");
}

// k_d = 9 m omega^2: sliding goes on down to v* cos(pi/6). The page says so, and Eq. 24 has failed.
BOOST_AUTO_TEST_CASE(a_free_swing_is_told) {
  const PrivateFolder folder;
  const fs::path scene = folder.path() / "scene.toml";
  write_file(scene,
             test::to_toml({.tangential = "kt",
                            .network = "kd",
                            .mass = 0.0001220703125,
                            .angular_frequency = 65536,
                            .amplitude = 1e-6,
                            .indentation = 2e-6,
                            .coefficient = 0.3,
                            .elements = {{"kn", 1000000}, {"kt", 700000}, {"kd", 4718592}}}));
  const auto validation = run({scene.string()}, folder.path() / "out");
  BOOST_TEST(!validation.passed);
  const ordered_json one =
      record::read_json(read_file(folder.path() / "out/report.json"))["scenes"][0];
  const ordered_json balance = comparison(one, "balance");
  BOOST_TEST(balance["outcome"] == "failed");
  // 0.0327743571428571 m/s by Eq. 24, by hand, times cos(pi/6).
  BOOST_TEST(std::abs(balance["found"].get<double>() / 0.0283834258784183 - 1) < 1e-14);
  BOOST_TEST(read_file(validation.page).find("swing freely at 3 ω") != std::string::npos);
}

// An isotropic Zener contact that is open where the indentation rises fastest: v* is simulated.
BOOST_AUTO_TEST_CASE(a_formula_that_is_not_v_is_not_drawn_as_v) {
  const PrivateFolder folder;
  const fs::path scene = folder.path() / "scene.toml";
  write_file(scene, test::to_toml({.normal = "zener(k0, k1, c1)",
                                   .tangential_ratio = 0.8,
                                   .separation = true,
                                   .angular_frequency = 100000,
                                   .amplitude = 1e-6,
                                   .indentation = 3e-7,
                                   .coefficient = 0.3,
                                   .elements = {{"k0", 200000}, {"k1", 2000000}, {"c1", 40}}}));
  BOOST_TEST(run({scene.string()}, folder.path() / "out").passed);
  const ordered_json one =
      record::read_json(read_file(folder.path() / "out/report.json"))["scenes"][0];
  double own = 1e9;
  bool applies = true;
  for (const ordered_json& point : one["frequency_response"]["points"]) {
    const double apart = std::abs(std::log(point["angular_frequency"].get<double>() / 1e5));
    if (apart >= own) continue;
    own = apart;
    applies = point["applies"];
  }
  BOOST_TEST(!applies);
}

BOOST_AUTO_TEST_CASE(creep_is_compared_where_the_path_creeps) {
  const PrivateFolder folder;
  BOOST_TEST(run({scenes + "/burgers.toml"}, folder.path()).passed);
  const ordered_json scene =
      record::read_json(read_file(folder.path() / "report.json"))["scenes"][0];
  BOOST_TEST(comparison(scene, "creep")["outcome"] == "passed");
}

BOOST_AUTO_TEST_CASE(wrong_input_leaves_nothing_behind) {
  const PrivateFolder folder;
  const fs::path out = folder.path() / "out", scene = folder.path() / "scene.toml";
  test::SceneText wrong = example::rigid_contact;
  wrong.elements.front() = {"kn", -1};
  write_file(scene, test::to_toml(wrong));
  BOOST_CHECK_THROW(run({scenes + "/elastic.toml", scene.string()}, out), InputError);
  BOOST_TEST(!fs::exists(out));
}

BOOST_AUTO_TEST_CASE(missing_values_are_told_before_anything_is_computed) {
  const PrivateFolder folder;
  const fs::path out = folder.path() / "out", scene = folder.path() / "scene.toml";
  test::SceneText incomplete = example::rigid_contact;
  incomplete.elements.pop_back();
  write_file(scene, test::to_toml(incomplete));
  bool began = false;
  BOOST_CHECK_THROW(report::validate({{scenes + "/elastic.toml", scene.string()}, out, {}},
                                     [&](const Standing&) { began = true; }),
                    InputError);
  BOOST_TEST(!began);
  BOOST_TEST(!fs::exists(out));
}

// Formula, evaluation and evaluators are compared, and the motion: of a measured drive that of the
// structure which is fitted to its table. Figures of several scenes are in a folder for each, as
// their pages are called.
BOOST_AUTO_TEST_CASE(a_drive_with_masses_is_simulated_and_drawn_and_a_measured_one_as_well) {
  const PrivateFolder folder;
  const auto validation = run({scenes + "/sonotrode.toml", scenes + "/measured_drive.toml"},
                              folder.path(), folder.path() / "two");
  BOOST_TEST(validation.passed);
  BOOST_TEST(validation.not_run.empty());
  const ordered_json report = record::read_json(read_file(folder.path() / "report.json"));
  for (const ordered_json& scene : report["scenes"]) {
    BOOST_TEST(comparison(scene, "formula")["outcome"] == "passed");
    BOOST_TEST(comparison(scene, "derived")["outcome"] == "passed");
    for (const char* evaluator :
         {"generated", "generated_batch", "generated_fast", "generated_certified"})
      BOOST_TEST(comparison(scene, evaluator)["outcome"] == "passed", evaluator);
    for (const char* motion : {"balance", "simulation", "marched", "starts"})
      BOOST_TEST(comparison(scene, motion)["outcome"] == "passed", motion);
  }
  for (const char* name : {"sonotrode", "measured_drive"})
    check_figures(folder.path() / "two" / name);
}

// Not even where v* has no formula, where the contact opens, and where a body on a soft spring
// rings for a thousand periods when it starts at rest.
BOOST_AUTO_TEST_CASE(nothing_is_left_out_of_indenters_on_drives_of_what_opens_or_rings) {
  const PrivateFolder folder;
  const auto validation =
      run({scenes + "/leaf_spring.toml", scenes + "/separation.toml", scenes + "/tribometer.toml"},
          folder.path());
  BOOST_TEST(validation.passed);
  BOOST_TEST(validation.not_run.empty());
  const ordered_json report = record::read_json(read_file(folder.path() / "report.json"));
  const ordered_json &ball = report["scenes"][0], &opening = report["scenes"][1],
                     &pin = report["scenes"][2];
  BOOST_TEST(comparison(ball, "harmonics")["tolerance"] < 1e-11);
  BOOST_TEST(comparison(opening, "generated_certified")["detail"] ==
             "the evaluator of the contact that stays closed");
  BOOST_TEST(comparison(pin, "marched")["name"] ==
             "marched by rk8pd: starts in sliding stick at 0.999 v* and slide at 1.001 v*");
}

BOOST_AUTO_TEST_SUITE_END()
