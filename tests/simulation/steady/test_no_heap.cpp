// The search for a steady cycle takes no memory from the heap for systems of usual size.
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <new>

#include "simulation/random_systems.hpp"
#include "simulation/steady/steady_cycle.hpp"

namespace {

std::atomic<long> taken = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++taken;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

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
  const double velocity = share * std::abs(model.sliding_velocity) + model.creep;
  const State from =
      start == Start::sliding ? sliding_start(model, velocity) : rest_start(model, velocity);
  const long before = taken;
  const SteadyCycle cycle = steady_cycle(model, velocity, from);
  BOOST_TEST(cycle.period.parts.size() > 1U);
  return taken - before;
}

}  // namespace

BOOST_AUTO_TEST_CASE(memory_is_counted) {
  const long before = taken;
  const std::vector<double> some(100);
  BOOST_TEST(taken == before + 1);
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
