// Text of a problem for the module in a page: reading it gives the same problem, to the bit.
#include "live/scene_text.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>

#include "answers/critical_onset.hpp"
#include "network/network.hpp"
#include "support/scene_text.hpp"

namespace vcrit {

namespace {

void check_same(const Problem& problem) {
  const std::string text = live::scene_text(problem);
  const Problem read = live::scene_of(text);
  BOOST_TEST(live::scene_text(read) == text);
  BOOST_TEST((read.values() == problem.values()));
  BOOST_TEST((read->normal.network() == problem->normal.network()));
  BOOST_TEST(read->rigid() == problem->rigid());
  BOOST_TEST((read->names == problem->names));
  BOOST_TEST(read->separation == problem->separation);
  if (!problem->indenter)
    BOOST_TEST(quick_onset(read, problem.value(problem->angular_frequency)) ==
               quick_onset(problem, problem.value(problem->angular_frequency)));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_scene_text)

BOOST_AUTO_TEST_CASE(scenes_of_the_repository) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(VCRIT_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    const Problem problem = read_problem(entry.path().string());
    if (problem->indenter) continue;  // no page simulates one
    BOOST_TEST_CONTEXT(entry.path()) { check_same(problem); }
    ++count;
  }
  BOOST_TEST(count > 10);
}

// Names with spaces around them, expressions, a quantity that the scene calls otherwise, a lossy
// spring, own networks both ways, a drive with a mass.
BOOST_AUTO_TEST_CASE(everything_that_a_scene_may_have) {
  const test::SceneText text{
      .normal = "lossy(k1, eta) | (spring(k2) - damper(c1)) | prony(k3, ks, taus)",
      .tangential = "spring(kt) | damper(ct)",
      .network = "spring(kd) | mass(md)",
      .mass = "M",
      .frequency = "20 kHz",
      .amplitude = "0.1 um",
      .indentation = "0.5 um",
      .coefficient = 0.3,
      .elements = {{"k1", "8 N/um"},
                   {"eta", 0.1},
                   {"k2", "2*k1"},
                   {"c1", "k1*t"},
                   {"t", "2 us"},
                   {"k3", "1 N/um"},
                   {"kt", "5 N/um"},
                   {"ct", "3 N.s/m"},
                   {"kd", "2 N/um"},
                   {"md", "1 g"}},
      .more = "ks = [\"1 N/um\", \"2 N/um\"]\ntaus = [\"7 us\", \"70 us\"]\n"};
  check_same(parse_problem(to_toml(text), "a scene with spaces.toml", {{"M", "5 g"}}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace vcrit
