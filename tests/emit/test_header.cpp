// What stands in a generated header, and which names are refused.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <set>

#include "base/errors.hpp"
#include "derivation/scenes.hpp"
#include "emit/generate.hpp"
#include "emit/names.hpp"
#include "emit/words.hpp"
#include "support/program.hpp"

BOOST_AUTO_TEST_SUITE(test_header)

using namespace vcrit;
using namespace vcrit::symbolic;
using test::scene_of;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The identifiers of C++ code, comments left out.
std::set<std::string> identifiers(const std::string& code) {
  std::set<std::string> found;
  std::string word;
  bool in_comment = false;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code.compare(i, 2, "//") == 0) in_comment = true;
    if (code[i] == '\n') in_comment = false;
    const bool part = std::isalnum(static_cast<unsigned char>(code[i])) != 0 || code[i] == '_';
    if (part && !in_comment) word += code[i];
    if (!part && !word.empty()) found.insert(std::exchange(word, ""));
  }
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(kelvin_header_is_short_and_complete) {
  const std::string header = emit_header(derive(test::kelvin_scene()), "kelvin");
  BOOST_TEST(std::count(header.begin(), header.end(), '\n') < 180);
  for (const char* part :
       {"SPDX-License-Identifier: MIT-0", "do not edit", "Scene: test", "v* = mu0*omega*du_z*sqrt(",
        "(27)", "vcrit generate test.toml --out DIR --name kelvin", "operations",
        "Accuracy:", "#error", "__FAST_MATH__", "namespace kelvin {", "namespace fast {",
        "struct Parameters", "critical_velocity_certified(const Parameters& p) noexcept"})
    BOOST_TEST(contains(header, part), part);
  for (const char* absent : {"std::complex", "<vector>", "throw", "iostream", "new "})
    BOOST_TEST(!contains(header, absent), absent);
}

BOOST_AUTO_TEST_CASE(members_stand_in_the_promised_order) {
  const std::string header = emit_header(
      derive(scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd", "m")), "zener");
  BOOST_TEST(
      contains(header, "struct Parameters { double mu0, omega, du_z, m, nu, k0, k1, c1, kd; };"));
  std::string joined = header;  // the comment is broken into lines
  for (std::size_t at; (at = joined.find("\n// ")) != std::string::npos;)
    joined.replace(at, 4, " ");
  BOOST_TEST(contains(joined, "spring k0, k1, kd; damper c1."));
}

BOOST_AUTO_TEST_CASE(massless_rigid_scene_has_neither_mass_nor_drive) {
  const std::string header = emit_header(
      derive(scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"kt | ct\"")), "rigid");
  const std::set<std::string> names = identifiers(header);
  BOOST_TEST(names.contains("kt"));
  for (const char* absent : {"m", "kd", "mass", "drive", "inertia", "less_inertia"})
    BOOST_TEST(!names.contains(absent), absent);
  const Scene scene = scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"kt | ct\"");
  for (const std::string& text :
       {header, emit_batch_header(derive(scene), "rigid"), emit_test(derive(scene), "rigid")})
    for (const char* absent : {"mass", "drive", "body", "K_d"})
      BOOST_TEST(!contains(text, absent), absent);
}

BOOST_AUTO_TEST_CASE(isotropic_rigid_scene_keeps_no_element) {
  const std::string header = emit_header(
      derive(scene_of("normal = \"bridge\"\npoisson = 0.3", "", "", test::bridge_network)), "iso");
  const std::set<std::string> names = identifiers(header);
  for (const char* absent : {"k1", "c1", "k2", "c2", "k3", "m", "Edge"})
    BOOST_TEST(!names.contains(absent), absent);
  BOOST_TEST(contains(header, "v* = 17/14*mu0*omega*du_z"));
}

BOOST_AUTO_TEST_CASE(arrays_become_arrays) {
  const std::string header = emit_header(
      derive(scene_of("normal = \"prony(k0, k, tau, 3)\"\ntangential_ratio = 0.5", "kd")), "prony");
  BOOST_TEST(contains(header, "std::array<double, 3> k, tau;"));
  BOOST_TEST(contains(header, "p.tau[2]"));
  BOOST_TEST(!contains(header, "p.tau[3]"));
}

// Of which a sweep is never multiplied out: s^100 at 20 kHz is no double.
BOOST_AUTO_TEST_CASE(a_hundred_branches_under_a_drive_are_printed) {
  const std::string header = emit_header(
      derive(scene_of("normal = \"prony(k0, k, tau, 100)\"\npoisson = 0.3", "kd | cd", "m")),
      "hundred");
  BOOST_TEST(contains(header, "std::array<double, 100> k"));
}

BOOST_AUTO_TEST_CASE(libraries_have_names_that_cpp_allows) {
  for (const char* good : {"kelvin", "critical", "my_scene_2", "K", "slider"})
    BOOST_CHECK_NO_THROW(check_library_name(good));
  for (const char* bad :
       {"",       "2fast", "a-b",  "../up", "a/b",    "class",      "std",
        "detail", "fast",  "main", "_x",    "a__b",   "Parameters", "critical_velocity",
        "sin",    "sinf",  "y1",   "posix", "time t", "NAN",        "exit",
        "size_t", "a\nb"})
    BOOST_CHECK_THROW(check_library_name(bad), InputError);
}

BOOST_AUTO_TEST_CASE(elements_below_an_indenter_are_moduli) {
  const auto text = [](const char* scene) {
    return symbolic::emit_quantities(derive(read_scene(scene)), "pad", {{}, true});
  };
  const std::string below = text(VCRIT_SCENES "/sphere.toml");
  for (const char* words : {"spring, Pa\n", "damper, Pa s\n", "/// K(i omega), Pa\n"})
    BOOST_TEST(below.find(words) != std::string::npos, words);
  BOOST_TEST(below.find("N/m") == std::string::npos);
  BOOST_TEST(text(VCRIT_SCENES "/zener.toml").find("/// K(i omega), N/m\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(all_parameters_of_quantities_have_their_units) {
  // Those of a mount had none.
  const std::string text =
      symbolic::emit_quantities(derive(read_scene(VCRIT_SCENES "/mount.toml")), "pad", {{}, true});
  for (const char* words :
       {"double mu0;    ///< friction coefficient\n", "///< angular frequency, rad/s\n",
        "///< amplitude of the vibrator, m\n", "///< mean normal force, N\n",
        "///< mass that moves along the normal, kg\n", "///< spring, N/m\n",
        "///< damper, N s/m\n"})
    BOOST_TEST(contains(text, words), words);
}

BOOST_AUTO_TEST_CASE(titles_cannot_break_out_of_their_comment) {
  const std::string hostile = "a\n#error b\r\\";
  const std::string text = comment(hostile);
  BOOST_TEST(std::count(text.begin(), text.end(), '\n') == 1);
  BOOST_TEST(!contains(text, "\\"));
  BOOST_TEST(comment("\xE2\x80\xAEx") == "// x\n");
  BOOST_TEST(comment("Gr\xC3\xBC\xC3\x9F"
                     "e") ==
             "// Gr\xC3\xBC\xC3\x9F"
             "e\n");
}

BOOST_AUTO_TEST_CASE(long_comments_are_broken_at_spaces) {
  std::string words;
  for (int i = 0; i < 60; ++i) words += "word ";
  const std::string text = comment(words);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    BOOST_TEST(line.size() <= 120u);
    BOOST_TEST(line.starts_with("// "));
  }
}

BOOST_AUTO_TEST_CASE(five_files_are_written_and_nothing_else) {
  const test::PrivateFolder folder;
  generate(derive(test::kelvin_scene()), folder.path() / "new" / "out", "kelvin");
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    if (entry.is_regular_file())
      files.insert(entry.path().lexically_relative(folder.path()).string());
  BOOST_TEST(
      (files == std::set<std::string>{"new/out/CMakeLists.txt", "new/out/kelvin.hpp",
                                      "new/out/kelvin_batch.hpp", "new/out/kelvin_evaluator.cmake",
                                      "new/out/test_kelvin.cpp"}));
  BOOST_CHECK_THROW(generate(derive(test::kelvin_scene()), folder.path() / "other", "../kelvin"),
                    InputError);
  BOOST_TEST(!std::filesystem::exists(folder.path() / "other"));
}

BOOST_AUTO_TEST_SUITE_END()
