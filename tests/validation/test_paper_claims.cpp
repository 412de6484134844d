// The 17 claims of the paper: each with the verdict and the numbers of tests/data/paper_claims.csv,
// which falls with the comparisons that show it; and viscosity against
// tests/data/paper_viscosity.csv and paper_crossings.csv. The claims' table: what was found out
// about each claim by hand and in many digits, by methods that share nothing with this program
// (last column).
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "paper/paper.hpp"
#include "paper/references.hpp"
#include "paper/verdicts.hpp"
#include "support/patterns.hpp"

BOOST_AUTO_TEST_SUITE(test_paper_claims)

using namespace vcrit::validation;
using namespace vcrit::validation::paper;

namespace {

using Verdict = Claim::Verdict;

const Paper& the_claims() {
  static const Paper paper = go_through([](const std::string&) {});
  return paper;
}

/// Fields of a line; quotes enclose commas, and are doubled within.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  return fields;
}

/// All lines of a file in tests/data but the first.
std::vector<std::vector<std::string>> table(const std::string& name) {
  std::ifstream file(VCRIT_TEST_DATA "/" + name);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) rows.push_back(fields_of(line));
  BOOST_REQUIRE(!rows.empty());
  return rows;
}

/// Numbers with seven decimals and more, and half a unit of their last.
std::vector<std::pair<double, double>> long_numbers(const std::string& text) {
  std::vector<std::pair<double, double>> numbers;
  for (const auto& number : vcrit::test::matches(text, "[0-9]+\\.([0-9]{7,})"))
    numbers.emplace_back(std::stod(number[0]), 0.5 * std::pow(10, -double(number[1].size())));
  return numbers;
}

std::map<int, Verdict> verdicts(const Paper& paper) {
  std::map<int, Verdict> result;
  for (const Claim& each : judge(paper)) result[each.number] = each.verdict;
  return result;
}

/// Of which claims the verdict changes if all comparisons of this key break.
std::vector<int> fallen(const std::string& key) {
  Paper planted = the_claims();
  for (auto* part :
       {&planted.proofs.comparisons, &planted.range.comparisons, &planted.figure4.comparisons,
        &planted.amplitudes.comparisons, &planted.slow.comparisons, &planted.viscosity.comparisons,
        &planted.punch.comparisons, &planted.shapes.comparisons, &planted.misprints.comparisons,
        &planted.evidence.comparisons})
    for (Comparison& each : *part)
      if (each.key == key) each.broken = true;
  std::vector<int> numbers;
  const auto before = verdicts(the_claims());
  for (const auto& [number, verdict] : verdicts(planted))
    if (verdict != before.at(number)) {
      BOOST_TEST((verdict == Verdict::not_shown));
      numbers.push_back(number);
    }
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(verdicts_are_those_of_the_table) {
  const auto rows = table("paper_claims.csv");
  const auto claims = judge(the_claims());
  BOOST_REQUIRE(rows.size() == 17u);
  BOOST_REQUIRE(claims.size() == 17u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    BOOST_TEST(claims[i].number == std::stoi(rows[i].at(0)));
    const std::string expected = rows[i].at(3) == "not decidable" ? "not legible" : rows[i].at(3);
    BOOST_TEST(to_text(claims[i].verdict) == expected, claims[i].words);
  }
}

// Each long number of the table is found by a comparison that decides the claim. 1e-15: what is
// found is a double, and some numbers of the table have 17 digits.
BOOST_AUTO_TEST_CASE(numbers_are_those_of_the_table) {
  const auto claims = judge(the_claims());
  std::size_t compared = 0;
  for (const auto& row : table("paper_claims.csv")) {
    const Claim& claim = claims.at(std::stoul(row.at(0)) - 1);
    std::vector<double> numbers;
    for (const std::string& key : claim.keys)
      for (const double number : found(the_claims(), key)) numbers.push_back(number);
    for (const auto& [expected, half_unit] : long_numbers(row.at(4))) {
      const double value = expected, near = half_unit + 1e-15;
      BOOST_TEST(std::any_of(numbers.begin(), numbers.end(),
                             [&](double each) { return std::abs(each - value) <= near; }),
                 "claim " << claim.number << ": " << value << " is not found");
      ++compared;
    }
  }
  BOOST_TEST(compared == 4u + 4u + 4u + 1u + 7u + 8u + 2u + 1u);
}

BOOST_AUTO_TEST_CASE(viscosity_is_that_of_the_tables) {
  const auto rows = table("paper_viscosity.csv");
  BOOST_REQUIRE(rows.size() == viscosity_references().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ViscosityReference& row = viscosity_references()[i];
    const double delta = std::stod(rows[i].at(0)), ratio = std::stod(rows[i].at(1));
    BOOST_TEST(row.delta == delta);
    BOOST_TEST(row.ratio == ratio);
    BOOST_TEST(row.per_a == std::stod(rows[i].at(3)));
    // The table's other columns follow: G, and the signs of both differences from elastic.
    BOOST_TEST(std::abs(row.per_a * std::hypot(1, delta) / std::stod(rows[i].at(2)) - 1) < 1e-13);
    if (delta > 0) BOOST_TEST(std::stod(rows[i].at(4)) > 0);  // equal D: always stronger
  }
  const auto crossings = table("paper_crossings.csv");
  BOOST_REQUIRE(crossings.size() == crossing_references().size());
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const CrossingReference& row = crossing_references()[i];
    BOOST_TEST(row.delta == std::stod(crossings[i].at(0)));
    BOOST_TEST(row.ratio == std::stod(crossings[i].at(1)));
    BOOST_TEST(row.weakening == std::stod(crossings[i].at(2)));
    BOOST_TEST(row.strengthening == std::stod(crossings[i].at(4)));
  }
}

// At equal a viscosity weakens the effect below v_c and strengthens it above, row by row of the
// table.
BOOST_AUTO_TEST_CASE(the_sign_changes_at_the_crossing) {
  std::map<double, double> crossing;
  for (const Crossing& row : the_claims().viscosity.crossings) crossing[row.delta] = row.ratio;
  for (const auto& row : table("paper_viscosity.csv")) {
    const double delta = std::stod(row.at(0)), ratio = std::stod(row.at(1));
    if (!crossing.contains(delta) || delta == 0) continue;
    BOOST_TEST((std::stod(row.at(5)) < 0) == (ratio < crossing[delta]), delta << ", " << ratio);
  }
}

BOOST_AUTO_TEST_CASE(claims_fall_with_what_shows_them) {
  const std::map<std::string, std::vector<int>> expected{{"rheologies", {1}},
                                                         {"free_swing", {1}},
                                                         {"threshold", {1, 3}},
                                                         {"equation", {2}},
                                                         {"no_rheology", {2}},
                                                         {"above", {3, 8}},
                                                         {"below", {3}},
                                                         {"force_before_height", {4}},
                                                         {"jump_printed", {5}},
                                                         {"moreau", {6}},
                                                         {"figure4_reduced", {6, 7}},
                                                         {"elastic", {7}},
                                                         {"concave", {8}},
                                                         {"initial", {9}},
                                                         {"static_rate", {9}},
                                                         {"crossing", {9, 10}},
                                                         {"most_weakening", {10}},
                                                         {"stronger", {11, 12}},
                                                         {"any_rheology", {11, 12}},
                                                         {"viscosity", {10, 12, 13}},
                                                         {"tiny_amplitude", {13}},
                                                         {"rim", {15}},
                                                         {"stick_begins", {16}},
                                                         {"stick_force", {17}}};
  for (const auto& [key, numbers] : expected)
    BOOST_TEST(fallen(key) == numbers, boost::test_tools::per_element());
}

// What is refuted has to be wrong by something that shows.
BOOST_AUTO_TEST_CASE(what_is_right_is_not_refuted) {
  Paper planted = the_claims();
  for (Witness& witness : planted.evidence.rows) witness.reduced = witness.exact;
  planted.misprints.velocity_as_printed = 0;
  const auto judged = verdicts(planted);
  for (const int number : {6, 16, 17}) BOOST_TEST((judged.at(number) == Verdict::not_shown));
}

BOOST_AUTO_TEST_SUITE_END()
