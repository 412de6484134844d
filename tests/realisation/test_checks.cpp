// Tables with a fault planted in them: the rows at fault are named.
#include "realisation/checks.hpp"

#include <boost/test/unit_test.hpp>

#include "chains.hpp"
#include "realisation/realisation.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_checks)

namespace {

using namespace vcrit::realisation;
using vcrit::Receptance;
using vcrit::test::chain;
using vcrit::test::has;
using vcrit::test::refused;
using vcrit::test::table_of;

// C-two-01, whose body end is a spring and a damper: |Im R| is well above noise everywhere.
Receptance clean(double noise = 0) { return table_of(chain("C-two-01"), 8, noise); }

std::string warnings_of(const Receptance& table) {
  std::string all;
  const Realisation found(table);
  for (const std::string& each : found.warnings()) all += each + "\n";
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_good_table_has_no_fault) {
  BOOST_TEST(warnings_of(clean()) == "");
  BOOST_TEST(warnings_of(clean(0.01)) == "");
}

BOOST_AUTO_TEST_CASE(the_other_sign_convention_is_refused) {
  Receptance table = clean();
  for (auto& row : table.rows) row.im = -row.im;
  BOOST_TEST(refused([&] { Realisation{table}; }, "rows where it is not 0"));
  BOOST_TEST(refused([&] { Realisation{table}; }, "change the sign of the column Im"));
}

BOOST_AUTO_TEST_CASE(a_row_that_gives_energy_is_named) {
  Receptance table = clean();
  table.rows[100].im = std::abs(table.rows[100].re);
  const std::string words = warnings_of(table);
  BOOST_TEST(has(words, "C-two-01:102: Im R > 0 at 0.6557 Hz: a drive cannot give energy"));
}

// Five standard deviations of 0.8 % are 4 %.
BOOST_AUTO_TEST_CASE(energy_beyond_the_noise_is_named) {
  Receptance table = clean(0.008);
  table.rows[100].im = 0.03 * std::abs(table.rows[100].re);
  BOOST_TEST(!has(warnings_of(table), "a drive cannot give energy"));
  table.rows[100].im = 0.1 * std::abs(table.rows[100].re);
  BOOST_TEST(has(warnings_of(table), "Im R > 0 at 0.6557 Hz: a drive cannot give energy"));
}

// |left| beyond x times the noise has the chance exp(-x^2/2): in one of 100 rows in a thousand
// cases from 4.80 on. Five rows in a run beyond twice the noise, to one side, are no noise either.
BOOST_AUTO_TEST_CASE(rows_are_not_causal_by_their_size_or_in_a_run) {
  const double noise = 0.01;
  const auto found = [noise](int rows, Complex size, double turn = 1) {
    CausalFit fit;
    fit.left = Eigen::VectorXcd::Zero(100);
    for (int i = 0; i < rows; ++i) fit.left[20 + i] = noise * size * (i == 2 ? turn : 1);
    return not_causal(fit, noise);
  };
  BOOST_TEST(found(1, {0, 4.75}).empty());
  BOOST_TEST_REQUIRE(found(1, {4.85, 0}).size() == 1U);
  for (const Complex size : {Complex{2.1, 0}, Complex{0, -2.1}}) {
    BOOST_TEST_REQUIRE(found(5, size).size() == 1U);
    BOOST_TEST(found(5, size).front().first == 20);
    BOOST_TEST(found(5, size).front().last == 24);
    BOOST_TEST(found(4, size).empty());
    BOOST_TEST(found(5, size, -1).empty());
  }
  BOOST_TEST(found(9, {1.9, 0}).empty());
}

BOOST_AUTO_TEST_CASE(rows_that_no_causal_response_has_are_named) {
  Receptance table = clean(0.008);
  for (std::size_t i = 150; i < 154; ++i) {
    table.rows[i].re *= 1.06;
    table.rows[i].im *= 1.06;
  }
  const std::string words = warnings_of(table);
  BOOST_TEST(has(words, "from any causal response, noise"));
  BOOST_TEST(has(words, "C-two-01:152: R from 0.9676 Hz to 0.9863 Hz (4 rows) differs by"));
}

BOOST_AUTO_TEST_CASE(rows_at_fault_do_not_spoil_the_fit) {
  Receptance table = clean();
  table.rows[60].re *= 1.1;
  const Realisation found(table);
  for (const int n : {1, 2, 3})
    // Five digits: 7e-5 of |R| at most.
    BOOST_TEST(std::abs(found.response(n) / chain("C-two-01").receptance(n) - 1.0) < 7.1e-5);
}

BOOST_AUTO_TEST_CASE(a_resonance_between_the_rows_is_named) {
  // w = 2, half-power width 0.002, rows every 0.039.
  const vcrit::test::Chain sharp{"sharp", "chain", {4, 4, 0}, {0.02, 0.002, 0}, {1, 0}};
  BOOST_TEST(has(warnings_of(table_of(sharp, 8, 0)),
                 "sharp: the resonance at 0.3183 Hz is narrower than the rows' distance"));
}

// Half-power width 0.08: two rows in it.
BOOST_AUTO_TEST_CASE(a_resonance_of_two_rows_is_named) {
  const vcrit::test::Chain narrow{"narrow", "chain", {4, 4, 0}, {0.02, 0.08, 0}, {1, 0}};
  const std::string words = warnings_of(table_of(narrow, 8, 0));
  BOOST_TEST(has(words, "has 2 rows within its width: its height rests on the fit"), words);
}

BOOST_AUTO_TEST_SUITE_END()
