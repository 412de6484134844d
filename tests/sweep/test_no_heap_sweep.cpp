// Points of a sweep take no memory from the heap, but what each stretch of 4096 rows of formula, or
// of 32 speeds, takes for itself.
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "support/heap.hpp"
#include "sweep/sweep.hpp"

BOOST_AUTO_TEST_SUITE(test_no_heap_sweep)

namespace {

using namespace vcrit;

long requests(const std::string& scene, const std::vector<std::string>& axes,
              const std::vector<std::string>& quantities,
              std::optional<double> velocity_ratio = std::nullopt) {
  Sweep sweep{read_scene(VCRIT_SCENES "/" + scene), {}, {}, {}, {}};
  sweep.velocity_ratio = velocity_ratio;
  for (const std::string& axis : axes) sweep.axes.push_back(parse_axis(axis, sweep.problem));
  for (const std::string& quantity : quantities)
    sweep.quantities.push_back(parse_swept_quantity(quantity, sweep.problem));
  const Sweeping sweeping(sweep);
  BOOST_TEST_REQUIRE(sweeping.grid().blocks() == 1U);
  BlockAnswer answer = sweeping.answer(0);
  BOOST_TEST(answer.outside == 0U);
  return test::heap_requests([&] { answer = sweeping.answer(0); });
}

// Of 100 rows over amplitudes, without what sets the sweep up.
long requests_of_100_rows(const std::string& scene, const std::string& amplitudes) {
  const auto rows = [&](int count) {
    return requests(scene, {fmt::format("amplitude=lin:{}:{}", amplitudes, count)},
                    {"friction_ratio"}, 0.5);
  };
  return rows(200) - rows(100);
}

}  // namespace

// Four stretches each, 4000 rows apart.
BOOST_AUTO_TEST_CASE(rows_of_formula) {
  const auto rows = [](int count) {
    return requests("zener.toml", {fmt::format("frequency=log:1 kHz:100 kHz:{}", count)},
                    {"critical_velocity"});
  };
  const long few = rows(12'300);
  BOOST_TEST(rows(16'300) == few);
  BOOST_TEST(few > 0);
}

BOOST_AUTO_TEST_CASE(speeds_of_a_scene) {
  for (const char* scene : {"zener.toml", "kelvin.toml", "kelvin_rigid.toml", "bridge.toml"}) {
    const auto speeds = [scene](int count) {
      return requests(scene, {fmt::format("velocity_ratio=lin:0.05:1.2:{}", count)},
                      {"friction_ratio", "friction_ratio_error", "regime", "critical_velocity"});
    };
    const long few = speeds(8), full = speeds(32);
    BOOST_TEST(full == few);
    // The second stretch costs no more than the first, which sets up the scene as well.
    BOOST_TEST(speeds(64) <= 2 * few);
  }
}

// Each row is a scene of its own, and holds its numbers, its system and their modes. What it does
// not change is neither asked nor made again: a name for a check, say, or the relaxation of an
// isotropic contact twice.
BOOST_AUTO_TEST_CASE(rows_of_other_scenes) {
  BOOST_TEST(requests_of_100_rows("kelvin_rigid.toml", "10 nm:90 nm") <= 100 * 60);
}

// Each row reads its drive anew, but the modes of it, in slip and in stick, are found for the first
// row alone: found for each, they take some forty matrices and columns each time.
BOOST_AUTO_TEST_CASE(rows_of_one_drive_with_masses) {
  BOOST_TEST(requests_of_100_rows("sonotrode.toml", "50 nm:450 nm") <= 100 * 260);
}

BOOST_AUTO_TEST_SUITE_END()
