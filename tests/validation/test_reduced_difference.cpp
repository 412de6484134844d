// The reduced model and the full motion against 50-digit values of both.
#include "compare/reduced_difference.hpp"
#include "support/scene_text.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(test_reduced_difference)

namespace {

using namespace vcrit;
using namespace vcrit::validation;

// docs/physics.md, where (50) and (51) are discussed: D = 0.9/sqrt(1 + delta^2).
struct Row {
  double delta, ratio, reduced, full;
};
const std::vector<Row> rows{{0, 0.1, 0.31854577586218, 0.31854577586218},
                            {0, 0.5, 0.81869301699970, 0.81869301699970},
                            {1, 0.1, 0.4642607132736, 0.39759612266688192},
                            {1, 0.5, 0.8367398045185, 0.83273654706668833},
                            {10, 0.1, 0.7207052919138, 0.43472823801559018},
                            {10, 0.5, 0.8917875223416, 0.84557858278721111},
                            {100, 0.1, 0.7535068053240, 0.43532479146986869},
                            {100, 0.5, 0.9008758004292, 0.84580444804485728}};

const test::SceneText kelvin{.normal = "kelvin(k, c)",
                             .angular_frequency = 1e5,
                             .amplitude = 1e-7,
                             .indentation = 3e-7,
                             .coefficient = 0.4,
                             .elements = {{"k", 2e6}, {"c", 30}, {"kd", 1e6}}};

}  // namespace

// The reduced model is given to thirteen digits: a unit of the last, for both.
BOOST_AUTO_TEST_CASE(the_known_rows_come_out) {
  for (const Row& row : rows) {
    BOOST_TEST_CONTEXT("delta " << row.delta << " ratio " << row.ratio) {
      const ReducedAndFull found = reduced_and_full(row.delta, row.ratio, 0.9);
      BOOST_TEST(std::abs(found.reduced - row.reduced) < 1e-13);
      BOOST_TEST(std::abs(found.full - row.full) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_table_has_them_in_place) {
  const ReducedTable table = reduced_table(0.9, {0, 1, 10, 100}, {0.1, 0.5});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ReducedAndFull& pair = table.rows.at(i / 2).at(i % 2);
    BOOST_TEST(std::abs(pair.difference() - (rows[i].reduced - rows[i].full)) < 2e-13);
  }
}

// Both motions are b(t) = 1 + a cos with everything else proportional to a.
BOOST_AUTO_TEST_CASE(the_difference_is_proportional_to_the_amplitude) {
  for (const double delta : {0.2, 3.0, 40.0}) {
    const double large = reduced_and_full(delta, 0.3, 0.9).difference();
    const double small = reduced_and_full(delta, 0.3, 0.3).difference();
    BOOST_TEST(std::abs(large - 3 * small) < 1e-12);
    BOOST_TEST(large > 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(it_may_be_used_from_where_the_difference_stays_small) {
  const auto from = usable_from(1, 0.9, 0.01);
  BOOST_REQUIRE(from.has_value());
  BOOST_TEST(reduced_and_full(1, *from, 0.9).difference() <= 0.01);
  BOOST_TEST(reduced_and_full(1, *from - 0.01, 0.9).difference() > 0.01);
  // Half of 0.004, the difference at v0 = 0.5 v*, is too much to ask there.
  BOOST_TEST(*usable_from(1, 0.9, 0.002) > 0.5);
  BOOST_TEST(!usable_from(10, 0.9, 1e-12).has_value());
  BOOST_TEST(*usable_from(1e-6, 0.9, 0.01) == 0.01);
}

BOOST_AUTO_TEST_CASE(a_scene_has_it_where_it_applies) {
  const auto model = reduced_model(test::scene_of(kelvin));
  BOOST_REQUIRE(model.has_value());
  BOOST_TEST(std::abs(model->delta - 1.5) < 1e-14);  // omega c/k
  // (du_z/u_z0) sqrt(1 + delta^2), a rounding error each
  BOOST_TEST(std::abs(model->table.a - std::sqrt(3.25) / 3) < 1e-14);
  const auto& deltas = model->table.deltas;
  BOOST_TEST(std::is_sorted(deltas.begin(), deltas.end()));
  BOOST_TEST((std::find(deltas.begin(), deltas.end(), model->delta) != deltas.end()));
}

BOOST_AUTO_TEST_CASE(a_scene_lacks_it_where_it_does_not) {
  test::SceneText driven = kelvin, other_tangentially = kelvin, elastic = kelvin;
  driven.network = "kd";
  other_tangentially.tangential = "k | kd";
  elastic.normal = "k";
  for (const test::SceneText& text : {driven, other_tangentially, elastic})
    BOOST_TEST(!reduced_model(test::scene_of(text)).has_value(), to_toml(text));
}

BOOST_AUTO_TEST_SUITE_END()
