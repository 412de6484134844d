// The search for a steady cycle takes no memory from the heap for systems of usual size.
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <functional>
#include <new>

#include "simulation/chains.hpp"
#include "simulation/random_systems.hpp"
#include "simulation/steady/answers.hpp"
#include "simulation/steady/steady_cycle.hpp"
#include "support/heap.hpp"

BOOST_AUTO_TEST_SUITE(test_no_heap)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

// Four Maxwell branches, and spring and damper as they come.
Relaxation four_branches(reference::RandomSystems& random) {
  Relaxation form{
      random.logarithmic(0.1, 10), random.chance(0.5) ? random.logarithmic(0.1, 10) : 0, {}};
  double time = 0.01;
  for (int j = 0; j < 4; ++j)
    form.branches.push_back({random.logarithmic(0.1, 10), time *= random.logarithmic(2, 30)});
  return form;
}

long taken_by_search(const System& system, double share, Start start) {
  const Model model(system);
  const double velocity = share * std::abs(model.sliding_velocity);
  const State from =
      start == Start::sliding ? sliding_start(model, velocity) : rest_start(model, velocity);
  return test::heap_requests([&] {
    const SteadyCycle cycle = steady_cycle(model, velocity, from);
    if (cycle.period.parts.size() < 2) throw Bug("a cycle without events");
  });
}

}  // namespace

// All ways to the heap.
BOOST_AUTO_TEST_CASE(memory_is_counted) {
  [[maybe_unused]] static void* volatile kept;  // nothing is left out as unused
  const auto keep = [](void* memory) {
    kept = memory;
    return memory;
  };
  constexpr std::align_val_t line{64};
  const std::vector<std::function<void()>> ways{
      [&] { ::operator delete(keep(::operator new(10))); },
      [&] { ::operator delete[](keep(::operator new[](64, line)), line); },
      [&] { std::free(keep(std::malloc(10))); },
      [&] { std::free(keep(std::calloc(10, 1))); },
      [&] { std::free(keep(std::realloc(nullptr, 10))); },
      [&] { std::free(keep(std::aligned_alloc(64, 64))); },
  };
  for (std::size_t i = 0; i < ways.size(); ++i)
    BOOST_TEST(test::heap_requests(ways[i]) == 1, "way " << i);
  BOOST_TEST(test::heap_requests([] {}) == 0);
}

BOOST_AUTO_TEST_CASE(search_of_up_to_four_branches_each) {
  for (unsigned i = 0; i < 60; ++i) {
    reference::RandomSystems random(7000 + i, 1);
    System system = random.system();
    system.contact = four_branches(random);
    system.drive = four_branches(random);
    system.mass = random.logarithmic(0.1, 10);
    for (const Start start : {Start::sliding, Start::rest})
      BOOST_TEST(taken_by_search(system, 0.5, start) == 0, "system " << i);
  }
}

// With room for what is common, one speed after the other takes none, down to v*/50.
BOOST_AUTO_TEST_CASE(speeds_of_a_curve) {
  for (unsigned i = 0; i < 20; ++i) {
    reference::RandomSystems random(7100 + i, 1);
    System system = random.system();
    system.contact = four_branches(random);
    system.drive = four_branches(random);
    system.mass = random.logarithmic(0.1, 10);
    const Model model(system);
    const double threshold = std::abs(model.sliding_velocity) + model.creep;
    Answers answers(system);
    const auto run = [&](int first, int last) {
      for (int j = first; j > last; --j) answers.next(0.01 * j * threshold * model.velocity_unit);
    };
    run(101, 99);
    BOOST_TEST(test::heap_requests([&] { run(99, 2); }) == 0);
  }
}

// A pair of modes for each mass.
BOOST_AUTO_TEST_CASE(speeds_of_drives_with_masses) {
  int found = 0;
  for (const reference::Chain& chain : reference::chains()) {
    if (chain.group != "two" && chain.group != "three") continue;
    Answers answers(system_of(Problem(chain.scene)));
    const auto run = [&](int first, int last) {
      for (int j = first; j > last; --j) answers.next(0.01 * j * chain.critical_velocity);
    };
    run(101, 99);
    BOOST_TEST(test::heap_requests([&] { run(99, 2); }) == 0, chain.id);
    ++found;
  }
  BOOST_TEST(found > 20);
}

BOOST_AUTO_TEST_SUITE_END()
