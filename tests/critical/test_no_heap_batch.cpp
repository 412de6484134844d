// A batch takes memory from the heap for the call, never for its lanes.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "critical/batch.hpp"
#include "scene/scene.hpp"
#include "support/heap.hpp"

BOOST_AUTO_TEST_SUITE(test_no_heap_batch)

namespace {

using namespace vcrit;

long requests(const CriticalVelocities& formula, const std::vector<double>& first,
              const std::vector<double>& second, std::size_t lanes) {
  const std::vector<std::span<const double>> columns{std::span(first).first(lanes),
                                                     std::span(second).first(lanes)};
  std::vector<double> out(lanes);
  return test::heap_requests([&] { formula(columns, out); });
}

}  // namespace

// The frequency is given in Hz, which takes a column of its own, the amplitude where it lies.
BOOST_AUTO_TEST_CASE(a_million_lanes_take_as_much_as_two) {
  constexpr std::size_t many = 1'000'000;
  std::vector<double> frequency(many), amplitude(many);
  for (std::size_t i = 0; i < many; ++i) {
    frequency[i] = 5e3 + 1e-3 * static_cast<double>(i);
    amplitude[i] = 1e-8 + 1e-14 * static_cast<double>(i);
  }
  for (const char* file : {"zener.toml", "kelvin.toml", "bridge.toml", "prony.toml"}) {
    const CriticalVelocities formula(read_scene(std::string(VCRIT_SCENES "/") + file),
                                     {"frequency", "amplitude"});
    const long two = requests(formula, frequency, amplitude, 2);
    BOOST_TEST(two > 0);  // the call's own columns: the count is at work
    BOOST_TEST(requests(formula, frequency, amplitude, many) == two, file);
  }
}

BOOST_AUTO_TEST_SUITE_END()
