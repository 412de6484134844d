// Computer algebra in several threads at once says what it says in one.
#include <boost/test/unit_test.hpp>
#include <thread>

#include "analysis/limits.hpp"
#include "analysis/sensitivities.hpp"
#include "derivation/derivation.hpp"
#include "document/print.hpp"
#include "emit/generate.hpp"
#include "formula/text.hpp"
#include "scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(test_algebra_threads)

using namespace vcrit;

namespace {

constexpr int rounds = 30, threads = 4;

/// All that is asked of a scene by results that hold expressions, and by texts.
std::string everything(const Scene& scene) {
  const symbolic::Derivation derivation = symbolic::derive(scene);
  std::string text = symbolic::to_text(derivation.critical_velocity);
  for (const symbolic::Limit& limit : symbolic::limits(derivation))
    text += symbolic::to_latex(limit.result);
  for (const symbolic::Sensitivity& sensitivity : symbolic::sensitivities(derivation).each)
    text += symbolic::to_mathml(sensitivity.derivative);
  return text + symbolic::print(scene, {}) + symbolic::emit_header(derivation, "scene");
}

}  // namespace

BOOST_AUTO_TEST_CASE(as_many_threads_as_one_likes) {
  const Scene zener = read_scene(VCRIT_SCENES "/zener.toml"),
              drive = read_scene(VCRIT_SCENES "/elastic_drive.toml");
  const std::string expected[] = {everything(zener), everything(drive)};
  std::vector<int> equal(threads);
  {
    std::vector<std::jthread> running;
    for (int i = 0; i < threads; ++i)
      running.emplace_back([&, i] {
        for (int round = 0; round < rounds; ++round)
          equal[static_cast<std::size_t>(i)] +=
              everything((i + round) % 2 == 0 ? zener : drive) == expected[(i + round) % 2];
      });
  }
  for (const int count : equal) BOOST_TEST(count == rounds);
}

// Results that threads copy, keep and drop share their numbers.
BOOST_AUTO_TEST_CASE(results_are_copied_and_dropped_anywhere) {
  const symbolic::Derivation derivation = symbolic::derive(read_scene(VCRIT_SCENES "/zener.toml"));
  const std::string expected = symbolic::to_text(derivation.critical_velocity);
  std::vector<symbolic::Derivation> kept(threads, derivation);
  {
    std::vector<std::jthread> running;
    for (symbolic::Derivation& mine : kept)
      running.emplace_back([&] {
        for (int round = 0; round < 1000; ++round) {
          symbolic::Derivation copy = derivation;
          mine = copy;
        }
      });
  }
  for (const symbolic::Derivation& mine : kept)
    BOOST_TEST(symbolic::to_text(mine.critical_velocity) == expected);
}

BOOST_AUTO_TEST_SUITE_END()
