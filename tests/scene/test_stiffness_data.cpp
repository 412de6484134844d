// Tables of measured stiffness: headers with units, and one clear message for what is wrong.
#include "scene/stiffness_data.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "scene/written_digits.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_stiffness_data)

using namespace vcrit;

namespace {

std::string message(const std::string& text) {
  return test::refusal([&] { parse_stiffness_table(text, "d.csv"); });
}

// A few roundings of the unit's factor and of 2 pi.
bool close(double a, double b) { return std::abs(a / b - 1) < 1e-15 * 4; }

constexpr const char* header = "frequency,storage,loss\n";
constexpr const char* columns =
    "; expected the columns frequency (or angular_frequency), storage, loss (or tan_delta), and if "
    "known storage_error, loss_error, separated by commas: \"frequency [Hz],storage [N/um],loss "
    "[N/um]\"";

}  // namespace

BOOST_AUTO_TEST_CASE(units_stand_in_the_header) {
  const StiffnessTable data = parse_stiffness_table(
      "Loss [N/mm], \"Frequency (kHz)\" ,storage (MN/m),Loss Error [N/mm],storage_error\n"
      "2,1,3,0.5,7\n4,2,5,0.25,8\n8,3,5,0.25,8\n",
      "d.csv");
  BOOST_TEST_REQUIRE(data.rows.size() == 3U);
  BOOST_TEST(data.notes.front() ==
             "the header gives no units, so numbers count as storage_error in N/m; other units "
             "stand behind "
             "a name, as in \"storage [N/um]\"");
  BOOST_TEST(data.has_errors);
  BOOST_TEST(close(data.rows[0].omega, 2000 * std::numbers::pi));
  BOOST_TEST(close(data.rows[0].loss, 2000));
  BOOST_TEST(close(data.rows[0].storage, 3e6));
  BOOST_TEST(close(data.rows[1].loss_error, 250));
  BOOST_TEST(data.rows[1].storage_error == 8);
}

BOOST_AUTO_TEST_CASE(bare_numbers_are_si_and_frequencies_may_fall) {
  const StiffnessTable data =
      parse_stiffness_table("angular_frequency,storage,loss\n30,3,0\n20,2,1\n10,0,2\n", "d.csv");
  BOOST_TEST(!data.has_errors);
  BOOST_TEST(data.rows[0].omega == 10);
  BOOST_TEST(data.rows[0].storage == 0);
  BOOST_TEST(data.rows[2].omega == 30);
  BOOST_TEST(data.rows[2].loss == 0);
  BOOST_TEST(
      parse_stiffness_table("angular_frequency (rad/s),storage,loss\n1,1,1\n2,2,2\n3,2,2\n", "d")
          .rows[1]
          .omega == 2);
  BOOST_TEST(
      data.notes.front().starts_with("the header gives no units, so numbers count as "
                                     "angular_frequency in rad/s, storage in N/m, loss in "
                                     "N/m;"));
  BOOST_TEST(data.notes.front().ends_with("and those of moduli, \"storage [MPa]\""));
  BOOST_TEST(
      parse_stiffness_table("frequency [Hz],storage [N/m],loss [N/m]\n1,1,1\n2,2,2\n3,2,2\n", "d")
          .notes.empty());
}

BOOST_AUTO_TEST_CASE(noise_below_zero_is_noted) {
  const StiffnessTable data = parse_stiffness_table(
      "frequency [Hz],storage [N/m],loss [N/m]\n1,6,0.1\n2,6,-0.0004\n3,6,0.2\n", "d.csv");
  BOOST_TEST(data.rows[1].loss == -0.0004);
  BOOST_TEST_REQUIRE(data.notes.size() == 1U);
  BOOST_TEST(
      data.notes[0] ==
      "d.csv:3: loss = -0.0004 N/m is below 0 (0.0067 % of |K|): taken for noise, and fitted "
      "as it is");
  // Half of |K| is none; nor is what lies five given errors below.
  BOOST_TEST(message("frequency,storage,loss\n1,6,-3\n") ==
             "d.csv:2: found loss = -3 N/m; expected a loss stiffness of at least 0");
  // 12 % of it may be, where the fit finds as much noise.
  BOOST_TEST(
      parse_stiffness_table("frequency,storage,loss\n1,6,-0.7\n2,6,1\n3,6,1\n", "d").rows.size() ==
      3U);
  const std::string errors = "frequency,storage,loss,storage_error,loss_error\n";
  BOOST_TEST(message(errors + "1,6,-0.5,1,0.1\n") ==
             "d.csv:2: found loss = -0.5 N/m; expected a loss stiffness of at least 0");
  BOOST_TEST(
      parse_stiffness_table(errors + "1,6,-0.3,1,0.1\n2,6,1,1,1\n3,6,1,1,1\n", "d").rows.size() ==
      3U);
}

// A flat punch: k = 2 a E/(1 - nu^2), with a = 0.5 mm and nu = 0.4 E of 1 MPa is 1e3/0.84 N/m.
BOOST_AUTO_TEST_CASE(moduli_are_taken_below_a_punch) {
  const Punch punch{5e-4, 0.4};
  const StiffnessTable data = parse_stiffness_table(
      "f [Hz],E' [MPa],Tan Delta\n1,84,0.5\n2,168,0.25\n3,170,0.1\n", "d.csv", punch);
  BOOST_TEST(close(data.rows[0].storage, 1e5));
  BOOST_TEST(close(data.rows[0].loss, 5e4));
  BOOST_TEST(close(data.rows[1].loss, 5e4));
  // A unit of the last digit: 1 MPa; of 0.01 in tan delta (the table has it so), and that of the
  // storage times tan delta.
  BOOST_TEST(close(data.rows[0].storage_step, 1e3 / 0.84));
  BOOST_TEST(close(data.rows[1].loss_step, std::hypot(2e5 * 0.01, 0.25e3 / 0.84)));
  BOOST_TEST(data.notes.front() ==
             "moduli, times 1.19 mm: below a flat punch of radius 500 µm with nu = 0.4 the "
             "stiffness is 2 a E/(1 - nu^2)");
  const auto refused = [&](const std::string& text) {
    return test::refusal([&] { parse_stiffness_table(text, "d.csv", punch); });
  };
  BOOST_TEST(refused("f [Hz],storage [MPa],loss [N/um]\n") ==
             "d.csv:1: found loss as a stiffness beside a modulus; expected moduli or stiffnesses "
             "throughout");
  BOOST_TEST(refused("f [Hz],storage [MPa],loss\n") ==
             "d.csv:1: found no unit of loss; expected one, as the other moduli have");
  BOOST_TEST(
      refused("f [Hz],storage [N/um],loss [N/um]\n") ==
      "d.csv:1: found no modulus, but a flat punch; expected storage and loss with a unit of "
      "a modulus, \"storage [MPa]\", or no `punch_radius`");
}

BOOST_AUTO_TEST_CASE(wrong_headers) {
  BOOST_TEST(message("") == std::string("d.csv: found an empty table") + columns);
  BOOST_TEST(message("frequency,storage\n1,2\n") ==
             std::string("d.csv:1: found no column loss or tan_delta") + columns);
  BOOST_TEST(message("storage,loss\n1,2\n") ==
             std::string("d.csv:1: found no column frequency or angular_frequency") + columns);
  BOOST_TEST(message("1,2,3\n4,5,6\n") ==
             std::string("d.csv:1: found a column \"1\"") + columns +
                 "; the first line names the columns, and numbers follow it");
  BOOST_TEST(message("# 2026\nfrequency,storage,loss\n")
                 .ends_with("; leave out lines of comments: the first line names the columns"));
  BOOST_TEST(message("f,G',G''\n").ends_with("E = 2 (1 + nu) G"));
  BOOST_TEST(
      message("f,storage,loss,temperature\n").ends_with("; rename the column, or leave it out"));
  BOOST_TEST(
      message("f [rad/s],storage,loss\n").ends_with("; name the column angular_frequency [rad/s]"));
  BOOST_TEST(message("f,storage,tan_delta [deg]\n")
                 .starts_with("d.csv:1: found \"tan_delta [deg]\" (an angle)"));
  BOOST_TEST(message("frequency,angular_frequency,storage,loss\n") ==
             "d.csv:1: found frequency and angular_frequency; expected one of the two");
  BOOST_TEST(message("frequency,loss,storage,loss\n") ==
             "d.csv:1: found two columns loss; expected one of each");
  BOOST_TEST(message("frequency,storage,loss,loss_error\n") ==
             "d.csv:1: found one of storage_error and loss_error; expected both or none");
  BOOST_TEST(message("frequency (rad/s),storage,loss\n")
                 .starts_with("d.csv:1: found \"frequency (rad/s)\""));
  BOOST_TEST(message("frequency,storage [s],loss\n").starts_with("d.csv:1: found \"storage [s]\""));
  BOOST_TEST(message("f [Hz],E' [MPa],E'' [foo]\n")
                 .starts_with("d.csv:1: found E' in MPa, a modulus; expected a stiffness"));
  BOOST_TEST(message("f [Hz],K',K'' [foo]\n")
                 .starts_with("d.csv:1: found \"K'' [foo]\" (unknown unit \"foo\")"));
  BOOST_TEST(message("frequency,storage [MPa],loss\n") ==
             "d.csv:1: found storage in MPa, a modulus; expected a stiffness, as N/um; or "
             "`punch_radius` and `poisson` of a flat punch, whose stiffness is 2 a E/(1 - nu^2)");
  BOOST_TEST(message("frequency [Hz];storage [N/um];loss [N/um]\n1;2,5;0,1\n") ==
             "d.csv:1: found a column \"frequency [Hz];storage [N/um];loss [N/um]\"; expected "
             "columns separated by commas, and decimal points: 2.5, not 2,5");
  BOOST_TEST(message("frequency,storage,loss,tan_delta\n") ==
             "d.csv:1: found loss and tan_delta; expected one of the two; tan_delta is loss over "
             "storage: leave its column out");
  BOOST_TEST(
      message("freq_hz,storage,loss\n").ends_with("; a unit stands in brackets: \"freq [Hz]\""));
  BOOST_TEST(message("frequency [Hz]\tstorage [N/um]\tloss [N/um]\n") ==
             "d.csv:1: found columns separated by tabs; expected columns separated by commas, and "
             "decimal points: 2.5, not 2,5");
  BOOST_TEST(message("frequency,storage,tan_delta,storage_error,loss_error\n") ==
             "d.csv:1: found loss_error beside tan_delta; expected the errors of storage and loss");
  BOOST_TEST(message("frequency,storage [N/m,loss\n") ==
             "d.csv:1: found \"storage [N/m\"; expected a name and its unit: \"storage [N/um]\"");
}

BOOST_AUTO_TEST_CASE(wrong_rows) {
  const auto with = [](const std::string& rows) { return message(header + rows); };
  const std::string at_least =
      "; expected at least 3 rows, one frequency each: any two are met exactly, so that nothing "
      "would tell noise from material";
  BOOST_TEST(with("") == "d.csv:1: found no row of numbers" + at_least);
  BOOST_TEST(with("1,2,3\n") == "d.csv:2: found one row of numbers" + at_least);
  BOOST_TEST(with("1,2,3\n2,2,3\n") == "d.csv:3: found 2 rows of numbers" + at_least);
  BOOST_TEST(with("1,2,3\n2,nan,3\n") == "d.csv:3: found \"nan\"; expected a finite number");
  BOOST_TEST(with("1,2,3\n2,,3\n") == "d.csv:3: found \"\"; expected a finite number");
  BOOST_TEST(with("1,2,3\n2,3\n") ==
             "d.csv:3: found \"2,3\"; expected 3 numbers, as the header has");
  BOOST_TEST(message("frequency,storage,loss\n1e308,2,3\n") ==
             "d.csv:2: found a number that is infinite in SI units; expected the range of doubles");
  BOOST_TEST(with("0,2,3\n2,2,3\n") ==
             "d.csv:2: found a frequency of 0 Hz; expected a frequency above 0");
  BOOST_TEST(with("1,-2,3\n2,2,3\n") ==
             "d.csv:2: found storage = -2 N/m; expected a storage stiffness of at least 0");
  BOOST_TEST(with("1,2,3\n2,2,-3\n") ==
             "d.csv:3: found loss = -3 N/m; expected a loss stiffness of at least 0");
  BOOST_TEST(with("1,0,0\n2,2,3\n") ==
             "d.csv:2: found storage = loss = 0 N/m; expected one of them above 0");
  const auto order = [](const std::string& rows) {
    return message("angular_frequency,storage,loss\n" + rows);
  };
  BOOST_TEST(order("1,2,3\n2,2,3\n2,2,3\n") ==
             "d.csv:4: found 0.3183 Hz once more; expected each frequency once");
  BOOST_TEST(order("1,2,3\n1,2,3\n") ==
             "d.csv:3: found 0.1592 Hz once more; expected each frequency once");
  BOOST_TEST(order("1,2,3\n2,2,5,0,3\n")
                 .ends_with("; commas separate numbers, which have decimal points: 2.5"));
  BOOST_TEST(order("3,2,3\n2,2,3\n\n4,2,3\n") ==
             "d.csv:5: found 0.6366 Hz after 0.3183 Hz; expected frequencies that go on falling");
  BOOST_TEST(message("frequency,storage,loss,storage_error,loss_error\n1,2,3,0,1\n") ==
             "d.csv:2: found storage_error = 0 N/m; expected an error above 0");
}

// A unit of the last digit: fixed decimals, fixed digits with zeros dropped at the end, exponents.
BOOST_AUTO_TEST_CASE(the_last_digit_is_read_from_the_text) {
  const auto same = [](const std::vector<double>& found, const std::vector<double>& expected) {
    BOOST_TEST_REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      BOOST_TEST(std::abs(found[i] / expected[i] - 1) < 1e-14);
  };
  same(rounding_steps({"12.34", "0.05", "-7.80"}), {0.01, 0.01, 0.01});
  same(rounding_steps({"1.23", "1.2", "12.3", "0.0123"}), {0.01, 0.01, 0.1, 1e-4});
  same(rounding_steps({"1.20e+06", "3.1E5", "250e3"}), {1e4, 1e3, 1e3});
  same(rounding_steps({"0", "0.5", "1.25"}), {0.01, 0.01, 0.01});
  const StiffnessTable data = parse_stiffness_table(
      "frequency,storage [N/um],loss\n3,1.25,7\n2,1.5,12\n1,1.75,8\n", "d.csv");
  for (const StiffnessRow& row : data.rows) {
    BOOST_TEST(std::abs(row.storage_step / 1e4 - 1) < 1e-14);
    BOOST_TEST(row.loss_step == 1);
  }
}

BOOST_AUTO_TEST_SUITE_END()
