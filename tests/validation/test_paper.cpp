// The paper checked: numbers against those of docs/physics.md and tests/data, and planted
// faults that must show.
#include "paper/paper.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "formula/symbols.hpp"
#include "paper/evidence.hpp"
#include "paper/motions.hpp"
#include "paper/proofs.hpp"
#include "paper/references.hpp"
#include "support/table.hpp"

BOOST_AUTO_TEST_SUITE(test_paper)

using namespace vcrit;
using namespace vcrit::validation;
using namespace vcrit::validation::paper;

namespace {

const Paper& the_paper() {
  static const Paper paper = go_through([](const std::string&) {});
  return paper;
}

// docs/physics.md, where (50) and (51) are discussed; a = 0.9.
struct Row {
  double delta, ratio, reduced, full;
};
const std::vector<Row> rows{{1, 0.1, 0.4642607132736, 0.39759612266688192},
                            {1, 0.5, 0.8367398045185, 0.83273654706668833},
                            {10, 0.1, 0.7207052919138, 0.43472823801559018},
                            {10, 0.5, 0.8917875223416, 0.84557858278721111},
                            {100, 0.1, 0.7535068053240, 0.43532479146986869},
                            {100, 0.5, 0.9008758004292, 0.84580444804485728}};

double y_at(const figures::FigureSeries& series, double x) {
  const auto point =
      std::find_if(series.points.begin(), series.points.end(),
                   [&](const figures::Point& p) { return std::abs(p.x - x) < 1e-15; });
  BOOST_REQUIRE(point != series.points.end());
  return point->y;
}

const figures::FigureSeries& last_but_one(const figures::Figure& figure) {
  return figure.series.at(figure.series.size() - 2);
}

std::size_t failures(const std::vector<Comparison>& comparisons) {
  return count(comparisons, Comparison::Outcome::failed);
}

}  // namespace

BOOST_AUTO_TEST_CASE(everything_agrees) {
  const auto all = all_comparisons(the_paper());
  for (const Comparison& each : all)
    BOOST_TEST((outcome(each) == Comparison::Outcome::passed), each.name);
  // 10 of equations, 11 of the range, 15 of Fig. 4, 2 of the map, 3 for each delta of the largest
  // amplitude and 4 of rest, 37 of viscosity, 5 of the punch, 7 of shapes, 2 of misprints, 3 for
  // each of nine witnesses, 2 for each delta and one of v*.
  BOOST_TEST(all.size() == 10 + 11 + 15 + 2 + 12 + 16 + 37 + 5 + 7 + 2 + 27 + 9);
}

// The doubles compiled in against the files that they come from: one rounding each.
BOOST_AUTO_TEST_CASE(references_are_those_of_the_files) {
  const auto own = test::rows_of("paper_friction.csv", 24);
  const auto others = test::rows_of("stickslip_reference.csv", 45);
  BOOST_REQUIRE(own.size() == friction_references().size());
  std::size_t shared = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const FrictionValue& row = friction_references()[i];
    BOOST_TEST(row.delta == std::stod(own[i].at(0)));
    BOOST_TEST(row.ratio == std::stod(own[i].at(1)));
    BOOST_TEST(row.friction == std::stod(own[i].at(2)));
    for (const auto& other : others) {  // columns: see its first line
      if (other.at(0) != "P1" || std::stod(other.at(2)) != row.delta ||
          std::stod(other.at(10)) != row.ratio)
        continue;
      ++shared;
      BOOST_TEST(row.friction == std::stod(other.at(13)));
    }
  }
  BOOST_TEST(shared == 9u);  // delta = 1, 10, 100 at 0.1, 0.5, 0.99
}

BOOST_AUTO_TEST_CASE(equations_are_proved_and_others_are_not) {
  const Proofs& proofs = the_paper().proofs;
  for (const char* equation : {"(29)", "(30)", "(31)"})
    BOOST_TEST(std::any_of(proofs.proofs.begin(), proofs.proofs.end(),
                           [&](const EquationProof& p) { return p.equation == equation; }));
  const auto of = [](const char* name) { return symbolic::symbol({name}); };
  const GiNaC::ex value = of("kn") / of("kt");
  BOOST_TEST(
      equal_velocities(value, GiNaC::abs(value) * (of("m") + of("kd")) / (of("kd") + of("m"))));
  BOOST_TEST(!equal_velocities(value, value + of("m")));
  BOOST_TEST(!equal_velocities(value, of("kt") / of("kn")));
  BOOST_TEST(proofs.rheologies.size() >= 7u);
}

// The reduced model is given to 13 digits; the full motion to 17, and promised to 1e-14 here.
BOOST_AUTO_TEST_CASE(panels_have_the_known_values) {
  const Figure4& figure = the_paper().figure4;
  BOOST_REQUIRE(figure.reduced.size() == 4u);
  BOOST_REQUIRE(figure.full.size() == 4u);
  for (const Row& row : rows) {
    const std::size_t panel = row.delta == 1 ? 0 : row.delta == 10 ? 2 : 3;
    const auto& full = figure.full[panel];
    BOOST_TEST(std::abs(y_at(last_but_one(full), row.ratio) - row.full) < 2e-14);
    BOOST_TEST(std::abs(y_at(full.series.back(), row.ratio) - row.full) < 1e-15);
    const auto& reduced = figure.reduced[panel];
    BOOST_TEST(std::abs(y_at(last_but_one(reduced), row.ratio) - row.reduced) < 1e-13);
    BOOST_TEST(std::abs(y_at(reduced.series.back(), row.ratio) - row.full) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(panels_have_six_amplitudes_and_their_elastic_curves) {
  for (const auto* panels : {&the_paper().figure4.full, &the_paper().figure4.reduced})
    for (const figures::Figure& panel : *panels) {
      const auto with = [&](figures::Style style) {
        return std::count_if(panel.series.begin(), panel.series.end(),
                             [&](const figures::FigureSeries& s) { return s.style == style; });
      };
      BOOST_TEST(with(figures::Style::line) == 6);
      BOOST_TEST(with(figures::Style::dashed) == 5);
      BOOST_TEST(with(figures::Style::circles) == 1);
      // Elastic curve of D: 1 - D G(0.1), G in docs/physics.md; D = 0.2/sqrt(1 + delta^2).
      BOOST_TEST(panel.series[0].points[0].y == 1);
    }
  const figures::FigureSeries& elastic = the_paper().figure4.full[0].series.at(2);
  BOOST_TEST((elastic.style == figures::Style::dashed));
  const double d = 0.2 / std::sqrt(2.0);
  // Some twenty roundings of terms up to 4.
  BOOST_TEST(std::abs(y_at(elastic, 0.1) - (1 - d * 0.75717136015312994339)) < 2e-14);
}

BOOST_AUTO_TEST_CASE(the_map_has_the_known_differences) {
  const figures::Map& map = *the_paper().map.figure.map;
  const auto at = [&](double delta, double ratio) {
    const auto near = [](const std::vector<double>& values, double value) {
      const auto found = std::find_if(values.begin(), values.end(),
                                      [&](double v) { return std::abs(v / value - 1) < 1e-12; });
      BOOST_REQUIRE(found != values.end());
      return static_cast<std::size_t>(found - values.begin());
    };
    return map.values.at(near(map.y, ratio) * map.x.size() + near(map.x, delta));
  };
  BOOST_REQUIRE(map.values.size() == map.x.size() * map.y.size());
  // 13 digits of both; the map's delta = 10^(i/8) is off by a few roundings.
  for (const Row& row : rows)
    BOOST_TEST(std::abs(at(row.delta, row.ratio) - (row.reduced - row.full)) < 3e-13);
}

// On the line of the map both models are 0.01 apart; it is found to 2e-5 in speed, and the
// difference changes by less than 1 over the whole range.
BOOST_AUTO_TEST_CASE(the_line_is_where_the_models_differ_by_a_hundredth) {
  const auto& points = the_paper().map.figure.series.at(0).points;
  BOOST_REQUIRE(points.size() > 10u);
  for (const figures::Point& point : points) {
    const double apart =
        reduced_friction(point.x, 0.9, point.y) - full_friction(point.x, 0.9, point.y);
    BOOST_TEST(std::abs(apart - 0.01) < 2e-5);
  }
  // Between two columns of the map, eight a decade, stands the delta from which it is needed.
  BOOST_TEST(the_paper().map.safe_delta < points.front().x);
  BOOST_TEST(the_paper().map.safe_delta > 0.7 * points.front().x);
}

// 1/sqrt(1 + delta^2) typed in, by mpmath.
BOOST_AUTO_TEST_CASE(amplitudes_without_separation) {
  const double expected[] = {0.7071067811865475244, 0.4472135954999579393, 0.0995037190209989137,
                             0.0099995000374968753};
  for (std::size_t i = 0; i < 4; ++i) {
    const AmplitudeLimit& row = the_paper().amplitudes.rows.at(i);
    for (const double found : {row.formula, row.by_admissibility, row.by_simulator})
      BOOST_TEST(std::abs(found / expected[i] - 1) < 8 * 0x1p-53);
  }
}

// Limits of the reduced model at a = 0.9: (47) with vbar = 0, integrated numerically by mpmath with
// 30 digits, the end of stick found as a root.
BOOST_AUTO_TEST_CASE(friction_at_rest) {
  const double reduced[] = {0.320131751563731555, 0.483118106137127999, 0.667325042877622984,
                            0.709007004785741876};
  for (std::size_t i = 0; i < 4; ++i) {
    const StaticRow& row = the_paper().slow.rows.at(i);
    BOOST_TEST(std::abs(row.limit - 0.1) < 1e-16);
    BOOST_TEST(std::abs(row.reduced_limit - reduced[i]) < 1e-15);
    BOOST_TEST((row.full[0] > row.full[1] && row.full[1] > row.full[2] && row.full[2] > 0.1));
    // The power 2/3 is come to from below: the rise in stick takes v^(1/3) of it away.
    BOOST_TEST(row.slopes.back() > row.slopes.front());
    BOOST_TEST(row.slopes.back() < 2 / 3.0);
  }
}

// The planted fault: what the reduced model says, in place of each method's value.
BOOST_AUTO_TEST_CASE(the_reduced_model_does_not_pass_for_the_full_motion) {
  for (const Witness& honest : the_paper().evidence.rows) {
    BOOST_TEST(failures(compare_witness(honest)) == 0u);
    Witness witness = honest;
    witness.exact = witness.reduced;
    BOOST_TEST(failures(compare_witness(witness)) == 1u);
    witness = honest;
    witness.adaptive = witness.reduced;
    BOOST_TEST(failures(compare_witness(witness)) == 1u);
    if (honest.ratio > 0.9) continue;  // near v* they differ by less than a fixed step sees
    witness = honest;
    witness.moreau.back() = witness.reduced;
    BOOST_TEST(failures(compare_witness(witness)) == 1u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
