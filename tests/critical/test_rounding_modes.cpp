// v* where the caller has changed how the processor rounds, or has it flush subnormal numbers to
// zero: certified values and columns of them.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "critical/batch.hpp"
#include "critical/certified.hpp"
#include "support/arithmetic_state.hpp"
#include "support/reference_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_rounding_modes)

namespace {

using namespace vcrit;

/// Neither parameters nor v* become zero by flushing them.
bool is_normal(const test::ReferenceRow& row) {
  const auto fits = [](double x) { return x == 0 || std::abs(x) >= DBL_MIN; };
  return fits(row.velocity) &&
         std::all_of(row.scene->elements.begin(), row.scene->elements.end(),
                     [&](const auto& element) { return fits(*element.second); });
}

void check(const test::ReferenceRow& row, const test::ArithmeticState& state) {
  Scene scene = *row.scene;
  scene.settable["omega"] = Dimension::none;
  const std::vector<double> omega{*scene.angular_frequency.value};
  const std::vector<std::span<const double>> columns{omega};
  const CriticalVelocities velocities(scene, {"omega"});
  double certified = 0, out = 0;
  bool kept = false;
  {
    const test::WithArithmetic here(state);
    certified = certified_critical_velocity(scene).value;
    velocities(columns, {&out, 1});
    kept = here.is_kept();
  }
  BOOST_TEST(kept);
  // Enclosed by integers: no mode of rounding is used.
  BOOST_TEST(certified == row.velocity);
  // The documented bound of columns counts half units; other modes lose up to whole ones.
  const double unit = state.rounding == FE_TONEAREST ? 0x1p-53 : 0x1p-52;
  const double bound = 1280 * unit * (static_cast<double>(scene.elements.size()) + 10);
  BOOST_TEST((out == row.velocity || std::abs(out / row.velocity - 1) <= bound), out);
}

}  // namespace

BOOST_AUTO_TEST_CASE(reference_rows_in_every_state) {
  for (const test::ReferenceRow& row : test::extreme_rows()) {
    if (!row.scene || row.status == "pole") continue;
    for (const test::ArithmeticState& state : test::all_arithmetic_states())
      if (!state.flush_to_zero || is_normal(row))
        BOOST_TEST_CONTEXT("row " << row.id << ", " << test::to_text(state)) check(row, state);
  }
}

BOOST_AUTO_TEST_SUITE_END()
