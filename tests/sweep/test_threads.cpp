// Threads that share a sweep or a batch get the answers of one alone. Under ThreadSanitizer
// (./dev sanitize thread) they are seen not to touch each other's memory either; std::thread, as
// its hand-over is one that the sanitizer knows.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <thread>

#include "critical/certified.hpp"
#include "scene/scene.hpp"
#include "simulation/steady/exact.hpp"
#include "sweep/sweep.hpp"

BOOST_AUTO_TEST_SUITE(test_threads)

namespace {

using namespace vcrit;

template <class Work>
void in_threads(const Work& work) {
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < 4; ++i) threads.emplace_back([&work, i] { work(i); });
  for (std::thread& thread : threads) thread.join();
}

Sweep sweep_of(const std::vector<std::string>& axes, const std::vector<std::string>& quantities) {
  Sweep sweep{read_scene(VCRIT_SCENES "/kelvin.toml"), {}, {}, {}, {}};
  for (const std::string& axis : axes) sweep.axes.push_back(parse_axis(axis, sweep.problem));
  for (const std::string& quantity : quantities)
    sweep.quantities.push_back(parse_swept_quantity(quantity, sweep.problem));
  return sweep;
}

void answers_are_those_of_one_thread(const Sweep& sweep) {
  const Sweeping shared(sweep);
  std::vector<BlockAnswer> answers(4);
  const std::size_t blocks = shared.grid().blocks();
  in_threads([&](std::size_t i) { answers[i] = shared.answer(i % blocks); });
  for (std::size_t i = 0; i < answers.size(); ++i)
    BOOST_TEST((answers[i].values == shared.answer(i % blocks).values));
}

}  // namespace

BOOST_AUTO_TEST_CASE(share_a_sweep_of_motion) {
  answers_are_those_of_one_thread(sweep_of(
      {"mass=lin:1 g:8 g:5", "velocity_ratio=log:0.1:1:300"},
      {"friction_ratio", "regime", "admissible", "sensitivity:mass", "critical_velocity"}));
}

BOOST_AUTO_TEST_CASE(share_a_sweep_of_formula) {
  answers_are_those_of_one_thread(
      sweep_of({"frequency=log:1 kHz:100 kHz:60000", "mass=lin:1 g:8 g:5"}, {"critical_velocity"}));
}

// Arb, which keeps constants for each thread, and a network reduced anew by each.
BOOST_AUTO_TEST_CASE(share_a_scene) {
  const Scene scene = read_scene(VCRIT_SCENES "/zener.toml");
  std::vector<double> certified(4), ratio(4);
  in_threads([&](std::size_t i) {
    certified[i] = certified_critical_velocity(scene).value;
    ratio[i] =
        simulation::steady_state(simulation::system_of(scene), 0.5 * certified[i]).friction_ratio;
  });
  for (std::size_t i = 1; i < 4; ++i) {
    BOOST_TEST(certified[i] == certified[0]);
    BOOST_TEST(ratio[i] == ratio[0]);
  }
}

BOOST_AUTO_TEST_SUITE_END()
