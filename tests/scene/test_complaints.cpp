// All that is wrong with a scene in one reading; and that the usual reading throws the first of it.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scene/findings.hpp"
#include "scene/scene.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_complaints)

using namespace vcrit;
using test::has;

namespace {

const std::string fine =
    "[contact]\nnormal = \"k0 | c0\"\npoisson = 0.3\n"
    "[oscillation]\nfrequency = \"20 kHz\"\namplitude = \"0.1 um\"\nindentation = \"0.5 um\"\n"
    "[friction]\ncoefficient = 0.3\n[elements]\nk0 = \"8 N/um\"\nc0 = \"30 N.s/m\"\n";

/// `fine` with some of its lines replaced, counted from 1.
std::string with_lines(const std::vector<std::pair<int, std::string>>& lines) {
  std::string text;
  std::size_t begin = 0;
  for (int line = 1; begin < fine.size(); ++line) {
    const std::size_t end = fine.find('\n', begin);
    std::string each = fine.substr(begin, end - begin);
    for (const auto& [number, other] : lines)
      if (number == line) each = other;
    text += each + "\n";
    begin = end + 1;
  }
  return text;
}

std::vector<std::string> errors(const std::string& text) {
  std::vector<std::string> all;
  for (const InputError& error : examine_scene(text, "s.toml").errors) all.push_back(error.what());
  return all;
}

std::string first(const std::string& text) {
  return test::refusal([&] { parse_scene(text, "s.toml"); });
}

/// As many errors as `parts`, with one of them each, in that order; each comes from reading, too,
/// once those before it are mended.
void check_errors(const std::string& text, const std::vector<std::string>& parts) {
  const std::vector<std::string> found = errors(text);
  BOOST_TEST_CONTEXT(text) {
    for (const std::string& error : found) BOOST_TEST_MESSAGE(error);
    BOOST_REQUIRE_EQUAL(found.size(), parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) BOOST_TEST(has(found[i], parts[i]), found[i]);
    const auto thrown = std::find(found.begin(), found.end(), first(text));
    BOOST_TEST((thrown != found.end()));
    BOOST_TEST(!examine_scene(text, "s.toml").scene.has_value());
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_scene_that_is_fine_is_read) {
  const SceneFindings found = examine_scene(fine, "s.toml");
  BOOST_TEST(found.errors.empty());
  BOOST_TEST(found.warnings.empty());
  BOOST_REQUIRE(found.scene);
  BOOST_TEST(found.scene->elements.size() == 2U);
}

BOOST_AUTO_TEST_CASE(keys_units_values_and_networks_are_told_at_once) {
  check_errors(
      with_lines({{2, "normal = \"k0 + c0\""},
                  {5, "frequency = \"28 khz\""},
                  {6, "amplitud = \"0.1 um\""},
                  {9, "coefficient = -1"},
                  {11, "k0 = \"0.5 MPa\""},
                  {12, "c0 = \"?\""}}),
      {"s.toml:2:14: found \"+\"", "s.toml:5:13: found \"28 khz\" (unknown unit",
       "s.toml:6:1: found unknown key \"amplitud\" in [oscillation]; expected \"amplitude\"",
       "s.toml:9:15: found coefficient = -1", "s.toml:11:6: found \"0.5 MPa\"",
       "s.toml:12:6: found c0 = \"?\"; expected a damping coefficient in N.s/m; c0 still "
       "has its question mark"});
}

BOOST_AUTO_TEST_CASE(elements_of_unknown_kind_in_several_places) {
  check_errors(with_lines({{2, "normal = \"E0 | (E1 - eta1)\""}, {3, "tangential = \"kt | x\""}}),
               {"s.toml:2:11: found element \"E0\"", "s.toml:2:17: found element \"E1\"",
                "s.toml:2:22: found element \"eta1\"", "s.toml:3:20: found element \"x\""});
}

BOOST_AUTO_TEST_CASE(lines_that_are_no_toml_do_not_hide_the_others) {
  check_errors(with_lines({{2, "normal = k0 | c0"},
                           {5, "frequency = 28 kHz   # a comment"},
                           {6, "amplitude = 0,2"},
                           {11, "k0 = \"8 N/umm\""}}),
               {"s.toml:2:", "s.toml:5:", "s.toml:6:", "s.toml:11:6"});
  BOOST_TEST(has(first(with_lines({{5, "frequency = 28 kHz   # a comment"}})),
                 "found frequency = 28 kHz; expected a number, or a text in quotes; a value with a "
                 "unit needs quotes: \"28 kHz\""));
  BOOST_TEST(has(first(with_lines({{2, "normal = k0 | c0"}})),
                 "a text needs quotes: normal = \"k0 | c0\""));
  BOOST_TEST(has(first(with_lines({{6, "amplitude = 0,2"}})), "write a decimal point: \"0.2\""));
  BOOST_TEST(has(first(with_lines({{11, "k0 = 3\nk0 = 4"}})), "\"k0\" for the second time"));
  BOOST_TEST(has(first(with_lines({{3, "separation = True"}})), "write separation = true"));
  BOOST_TEST(has(first(with_lines({{2, "normal = \"\xe9\""}})), "save the file as UTF-8"));
  BOOST_TEST(has(first("[contact\n"), "no TOML"));
  BOOST_TEST(errors("[contact\nnormal = \n").size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_network_that_two_parts_use_is_complained_of_once) {
  const std::string text = with_lines({{2, "normal = \"pad\""},
                                       {3, "tangential = \"pad | k0\""},
                                       {10, "[networks]\npad = \"k0 | \"\n[elements]"}});
  check_errors(text, {"s.toml:11:"});
}

BOOST_AUTO_TEST_CASE(words_of_the_trade_meet_the_key_that_is_meant) {
  const auto said = [](const std::string& line) { return first(with_lines({{7, line}})); };
  for (const char* word : {"load", "force", "normal_force", "preload"})
    BOOST_TEST(has(said(std::string(word) + " = \"50 N\""), "[load]"), word);
  BOOST_TEST(has(first("load = \"50 N\"\n" + with_lines({})), "force in [load]"));
  const auto without_indentation = [](const std::string& more) {
    return first(with_lines({{7, ""}}) + "\n" + more);
  };
  BOOST_TEST(has(without_indentation("[load]\nweight = 3\n"), "force in [load]"));
  BOOST_TEST(has(without_indentation("[load]\n"), "[load] without force"));
  BOOST_TEST(has(without_indentation("[load]\nforce = 0\n"), "a finite value above 0"));
  const std::string both = first(with_lines({}) + "\n[load]\nforce = \"3 N\"\n");
  BOOST_TEST(has(both, "force in [load] as well as indentation in [oscillation], line 7"), both);
  BOOST_TEST(has(said("velocity = 3"), "vcrit simulate SCENE --velocity"));
  BOOST_TEST(has(said("mass = \"5 g\""), "mass belongs in [body]"));
  BOOST_TEST(has(said("du_z = 3"), "half of peak to peak"));
  BOOST_TEST(has(said("indentatoin = 3"), "expected \"indentation\""));
}

BOOST_AUTO_TEST_CASE(a_bare_number_of_another_size_is_warned_of) {
  const auto warnings = [](const std::string& text) {
    return parse_scene(text, "s.toml").warnings;
  };
  const auto all = warnings(with_lines({{5, "frequency = 28"}, {6, "amplitude = 0.2"}}));
  BOOST_REQUIRE_EQUAL(all.size(), 2U);
  BOOST_TEST(all[0] ==
             "s.toml:5:13: frequency 28 Hz: a bare number is in hertz; if kHz are meant, write "
             "\"28 kHz\"");
  BOOST_TEST(all[1] ==
             "s.toml:6:13: amplitude 0.2 m: a bare number is in metres; if um are meant, write "
             "\"0.2 um\"");
  BOOST_TEST(examine_scene(with_lines({{5, "frequency = 28"}}), "s.toml").warnings.size() == 1U);
  BOOST_TEST(parse_scene(fine, "s.toml", {{"amplitude", "0.2"}}).warnings.size() == 1U);
  BOOST_TEST(parse_scene(fine, "s.toml", {{"frequency", "28"}}).warnings.size() == 1U);
  BOOST_TEST(parse_scene(fine, "s.toml", {{"omega", "28"}}).warnings.size() <= 1U);
  BOOST_TEST(parse_scene(fine, "s.toml", {{"du_z", "0.2"}}).warnings.size() == 1U);
  // In place of a number with a unit: what is of its size in that unit, and not in SI.
  const auto set = [](const std::string& name, const std::string& value) {
    const auto found = parse_scene(fine, "s.toml", {{name, value}}).warnings;
    return found.empty() ? std::string() : std::string(found.front());
  };
  BOOST_TEST(set("k0", "4") ==
             "k0 4 N/m: a bare number is in N/m, and the scene gives k0 in N/um; if that is meant, "
             "write \"4 N/um\"");
  for (const char* value : {"8e6", "1e5", "4 N/m", "0", "3 kN/m"})
    BOOST_TEST(set("k0", value).empty(), value);
  // Of the size that they have, with their units, or 0; and a scene in units of its own.
  BOOST_TEST(warnings(with_lines({{5, "frequency = 20e3"}, {6, "amplitude = 1e-7"}})).empty());
  BOOST_TEST(warnings(with_lines({{5, "frequency = \"28 Hz\""}, {6, "amplitude = 0"}})).empty());
  BOOST_TEST(warnings(with_lines({{5, "frequency = 1"},
                                  {6, "amplitude = 0.1"},
                                  {7, "indentation = 1"},
                                  {11, "k0 = 1"},
                                  {12, "c0 = 2"}}))
                 .empty());
}

BOOST_AUTO_TEST_SUITE_END()
