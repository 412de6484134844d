// The generated library as a user meets it: its own test passes with both compilers, at all
// optimisation levels, and its CMake project builds and tests it.
#include <boost/test/unit_test.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "derivation/scenes.hpp"
#include "emit/library.hpp"
#include "emit/names.hpp"

BOOST_AUTO_TEST_SUITE(test_library)

using namespace vcrit;
using test::scene_of;

namespace {

/// With omega = 2 rad/s and m = 0.5 kg, so that k_d = m omega^2 may hold exactly.
Scene swinging(double kd, double amplitude) {
  return read_scene(VCRIT_SCENES "/elastic_drive.toml",
                    {{"kn", "3"},
                     {"kt", "1"},
                     {"kd", fmt::format("{}", kd)},
                     {"mass", "0.5"},
                     {"omega", "2"},
                     {"amplitude", fmt::format("{}", amplitude)}});
}

// The body of 1e20 kg is so heavy that v* hardly depends on any element. At resonance and
// antiresonance v* has no derivatives, and where it is subnormal they have hardly any digits.
std::vector<Scene> scenes() {
  return {read_scene(VCRIT_SCENES "/kelvin.toml"),
          read_scene(VCRIT_SCENES "/bridge.toml"),
          scene_of("normal = \"prony(k0, k, tau, 3)\"\npoisson = 0.38", "kd", "m"),
          scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd | cd", "m"),
          read_scene(VCRIT_SCENES "/zener.toml", {{"mass", "1e20"}}),
          read_scene(VCRIT_SCENES "/sonotrode.toml"),
          read_scene(VCRIT_SCENES "/measured_drive.toml"),
          swinging(2, 0.1),
          swinging(1, 0.1),
          swinging(0.5, 1e-320)};
}

/// What ctest prints. In a build folder that may be there from another time.
std::string build_and_test(const test::PrivateFolder& folder,
                           const std::string& option = "-DCMAKE_BUILD_TYPE=") {
  const std::string source = folder.path().string(), build = (folder.path() / "build").string();
  std::string last;
  for (const std::vector<std::string>& step :
       {std::vector<std::string>{"cmake", "-S", source, "-B", build, option},
        {"cmake", "--build", build},
        {"ctest", "--test-dir", build, "--no-tests=error"}}) {
    const test::Outcome outcome = test::run(step, folder.path());
    BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.output);
    last = outcome.output;
  }
  return last;
}

std::string name_of(std::size_t library) { return fmt::format("library_{}", library); }

/// One program of the own tests of so many libraries.
std::string tests_together(const std::vector<std::string>& names) {
  std::string tests = "#include <cstdio>\n", calls;
  for (const std::string& name : names) {
    tests +=
        fmt::format("#define main main_of_{0}\n#include \"test_{0}.cpp\"\n#undef main\n", name);
    calls += fmt::format("  if (main_of_{0}() == 0) std::puts(\"{0} passes\");\n", name);
  }
  return tests + "int main() {\n" + calls + "}\n";
}

/// Compiles them by the command's words.
void pass(const test::PrivateFolder& folder, const std::vector<std::string>& names,
          std::vector<std::string> command) {
  const std::string source = (folder.path() / "tests.cpp").string();
  const std::string program = (folder.path() / "program").string();
  write_file(source, tests_together(names));
  command.insert(command.end(), test::strict_flags.begin(), test::strict_flags.end());
  command.insert(command.end(), {"-o", program, source});
  const test::Outcome built = test::run(command, folder.path());
  BOOST_REQUIRE_MESSAGE(built.status == 0, built.output);
  const test::Outcome outcome = test::run({program}, folder.path());
  for (const std::string& name : names)
    BOOST_TEST(outcome.output.find(name + " passes\n") != std::string::npos,
               fmt::format("{} {}", name, fmt::join(command, " ")) << outcome.output);
}

std::vector<std::string> names_of(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(name_of(i));
  return names;
}

/// All words of the headers that the own test of a library includes.
std::set<std::string> words_of_headers(const std::string& headers, const std::string& compiler,
                                       const test::PrivateFolder& folder) {
  const std::string source = (folder.path() / "headers.cpp").string();
  write_file(source, headers);
  const test::Outcome read = test::run({compiler, "-std=c++20", "-E", "-P", source}, folder.path());
  std::set<std::string> words;
  std::string word;
  for (const char c : read.output + " ")
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')
      word += c;
    else
      words.insert(std::exchange(word, {}));
  return words;
}

bool is_refused(const std::string& name) {
  try {
    symbolic::check_library_name(name);
    return false;
  } catch (const InputError&) {
    return true;
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(its_own_test_passes) {
  const test::PrivateFolder folder;
  const std::vector<Scene> all = scenes();
  for (std::size_t i = 0; i < all.size(); ++i)
    symbolic::generate(symbolic::derive(all[i]), folder.path(), name_of(i));
  for (const std::string& compiler : test::compilers(folder))
    for (const char* level : {"-O0", "-O3"})
      pass(folder, names_of(all.size()), {compiler, level, "-march=native"});
}

// Some are names of the generated code and of its test.
BOOST_AUTO_TEST_CASE(its_own_test_passes_with_any_name) {
  const test::PrivateFolder folder;
  const std::vector<std::string> names{"Columns", "Gradient", "Varying", "check",
                                       "expect",  "failures", "near",    "size"};
  const symbolic::Derivation derivation = symbolic::derive(read_scene(VCRIT_SCENES "/kelvin.toml"));
  for (const std::string& name : names) symbolic::generate(derivation, folder.path(), name);
  pass(folder, names, {test::compilers(folder).front()});
}

// `index` and `rename` are functions of C, and no namespaces.
BOOST_AUTO_TEST_CASE(names_that_headers_take_are_refused) {
  const test::PrivateFolder folder;
  const std::string headers =
      "#include <array>\n#include <bit>\n#include <cmath>\n#include <cstdio>\n"
      "#include <cstdlib>\n#include <cstring>\n#include <span>\n#include <type_traits>\n";
  for (const std::string& compiler : test::compilers(folder)) {
    std::string text = headers;
    std::size_t count = 0;
    for (const std::string& word : words_of_headers(headers, compiler, folder))
      if (!is_refused(word)) text += fmt::format("namespace {} {{}}\n", word), ++count;
    BOOST_TEST(count > 300u);
    const std::string source = (folder.path() / "names.cpp").string();
    write_file(source, text);
    const test::Outcome compiled =
        test::run({compiler, "-std=c++20", "-fsyntax-only", source}, folder.path());
    BOOST_TEST(compiled.status == 0, compiled.output);
  }
  BOOST_TEST(is_refused("pad_batch"));
  BOOST_TEST(is_refused("pad_quantities"));
}

BOOST_AUTO_TEST_CASE(all_files_of_all_languages_come_from_one_derivation) {
  const test::PrivateFolder folder;
  const std::size_t before = symbolic::derivations_made();
  const symbolic::Derivation derivation = symbolic::derive(read_scene(VCRIT_SCENES "/zener.toml"));
  symbolic::generate(derivation, folder.path(), "library", {{}, true});
  for (const std::string& language : symbolic::language_names())
    if (language != "c++")
      symbolic::generate(derivation, folder.path(), "library", {.language = language});
  BOOST_TEST(symbolic::derivations_made() - before == 1u);
}

BOOST_AUTO_TEST_CASE(its_own_test_passes_with_fixed_parameters) {
  const symbolic::Derivation derivation = symbolic::derive(read_scene(VCRIT_SCENES "/prony.toml"));
  const std::vector<std::vector<std::string>> choices{{"all"}, {"k", "tau[3]"}, {"tau"}};
  const test::PrivateFolder folder;
  for (std::size_t i = 0; i < choices.size(); ++i)
    symbolic::generate(derivation, folder.path(), name_of(i), {choices[i], true});
  pass(folder, names_of(choices.size()), {test::compilers(folder).front()});
}

BOOST_AUTO_TEST_CASE(its_own_test_can_fail) {
  const test::PrivateFolder folder;
  symbolic::generate(symbolic::derive(read_scene(VCRIT_SCENES "/kelvin.toml")), folder.path(),
                     "library");
  const auto header = folder.path() / "library.hpp";
  std::string text = test::contents(header);
  // A sign in front of the inertia.
  const std::string right = "std::fma(-m, w * w, k)", wrong = "std::fma(m, w * w, k)";
  BOOST_REQUIRE(text.find(right) != std::string::npos);
  text.replace(text.find(right), right.size(), wrong);
  write_file(header, text);
  const std::string program = (folder.path() / "program").string();
  const test::Outcome built = test::run({test::compilers(folder).front(), "-std=c++20", "-o",
                                         program, (folder.path() / "test_library.cpp").string()},
                                        folder.path());
  BOOST_REQUIRE_MESSAGE(built.status == 0, built.output);
  BOOST_TEST(test::run({program}, folder.path()).status == 1);
}

// A second scene in the folder does not put the first one out of it; files of another hand that
// end in .cmake are not read.
BOOST_AUTO_TEST_CASE(its_cmake_project_builds_and_tests_one_scene_and_two) {
  const test::PrivateFolder folder;
  symbolic::generate(symbolic::derive(read_scene(VCRIT_SCENES "/kelvin.toml")), folder.path(),
                     "pad");
  write_file(folder.path() / "own.cmake", "message(FATAL_ERROR \"not asked for\")\n");
  build_and_test(folder);
  symbolic::generate(symbolic::derive(read_scene(VCRIT_SCENES "/elastic.toml")), folder.path(),
                     "tip");
  const std::string tests = build_and_test(folder);
  for (const char* name : {"test_pad", "test_tip"})
    BOOST_TEST(tests.find(name) != std::string::npos, tests);
}

// Options and targets of its own: a square root of the other project still sets errno, and its
// tests are those that it adds.
BOOST_AUTO_TEST_CASE(a_project_that_takes_it_in_stays_as_it_is) {
  const test::PrivateFolder folder;
  std::filesystem::create_directory(folder.path() / "pad");
  symbolic::generate(symbolic::derive(read_scene(VCRIT_SCENES "/kelvin.toml")),
                     folder.path() / "pad", "pad");
  write_file(folder.path() / "CMakeLists.txt",
             "cmake_minimum_required(VERSION 3.16)\nproject(mine LANGUAGES CXX)\nenable_testing()\n"
             "add_subdirectory(pad)\nif(DEFINED BUILD_TESTING OR TARGET test_pad)\n"
             "  message(FATAL_ERROR \"the library brings tests\")\nendif()\n"
             "add_executable(mine mine.cpp)\ntarget_link_libraries(mine PRIVATE pad::pad)\n"
             "add_test(NAME mine COMMAND mine)\n");
  write_file(folder.path() / "mine.cpp",
             "#include \"pad.hpp\"\n#include <cerrno>\n#include <cmath>\n"
             "int main() {\n  volatile double x = -1;\n  errno = 0;\n"
             "  volatile double root = std::sqrt(x);\n  (void)root;\n"
             "  return errno == EDOM && pad::critical_velocity({}) != 1 ? 0 : 1;\n}\n");
  build_and_test(folder, "-DCMAKE_BUILD_TYPE=Release");
}

BOOST_AUTO_TEST_SUITE_END()
