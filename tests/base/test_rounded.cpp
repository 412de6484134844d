// Numbers for people. What is expected is the number with its point moved by hand.
#include "base/rounded.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_rounded)

using namespace vcrit;

namespace {
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double endless = std::numeric_limits<double>::infinity();
}  // namespace

BOOST_AUTO_TEST_CASE(four_digits_and_the_prefix_that_reads_well) {
  BOOST_TEST(rounded(0.004094841503754417, Dimension::velocity) == "4.095 mm/s");
  BOOST_TEST(rounded(20000, Dimension::frequency) == "20 kHz");
  BOOST_TEST(rounded(0.0023149, "W") == "2.315 mW");
  BOOST_TEST(rounded(0.00098764, "s") == "987.6 µs");
  BOOST_TEST(rounded(-2e-3, "N") == "-2 mN");
  BOOST_TEST(rounded(0.748, "") == "0.748");
  BOOST_TEST(rounded(3, Dimension::none) == "3");
}

BOOST_AUTO_TEST_CASE(lengths_and_stiffnesses_as_people_write_them) {
  BOOST_TEST(rounded(1e-7, "m") == "0.1 µm");
  BOOST_TEST(rounded(3.968253968e-7, "m") == "0.3968 µm");
  BOOST_TEST(rounded(5e-8, "m") == "50 nm");
  BOOST_TEST(rounded(1.2e-3, "m") == "1.2 mm");
  BOOST_TEST(rounded(41671, "m/s") == "41670 m/s");
  BOOST_TEST(rounded(8e6, Dimension::stiffness) == "8 N/µm");
  BOOST_TEST(rounded(2.5e3, Dimension::stiffness) == "2.5 kN/m");
  BOOST_TEST(rounded(1e30, "N/m") == "1 × 10³⁰ N/m");
}

BOOST_AUTO_TEST_CASE(grams_not_kilograms_take_prefixes) {
  BOOST_TEST(rounded(0.005, Dimension::mass) == "5 g");
  BOOST_TEST(rounded(3e-7, Dimension::mass) == "300 µg");
  BOOST_TEST(rounded(2000, Dimension::mass) == "2000 kg");
}

BOOST_AUTO_TEST_CASE(what_is_rounded_up_takes_the_next_prefix) {
  BOOST_TEST(rounded(999.96, "Hz") == "1 kHz");
  BOOST_TEST(rounded(999.94, "Hz") == "999.9 Hz");
}

BOOST_AUTO_TEST_CASE(no_prefix_where_none_is_used) {
  BOOST_TEST(rounded(125664, "rad/s") == "125700 rad/s");
  BOOST_TEST(rounded(0, "m") == "0 m");
  BOOST_TEST(rounded(0, "kg") == "0 kg");
  BOOST_TEST(rounded(0.02, "Hz") == "0.02 Hz");
  BOOST_TEST(rounded(-0.7, "N/m") == "-0.7 N/m");
  BOOST_TEST(rounded(1.5e-9, "") == "1.5 × 10⁻⁹");
}

BOOST_AUTO_TEST_CASE(beyond_the_prefixes_the_number_has_its_power) {
  BOOST_TEST(rounded(1e-30, "m") == "1 × 10⁻³⁰ m");
  BOOST_TEST(rounded(4.1671e17, "m/s") == "4.167 × 10¹⁷ m/s");
}

BOOST_AUTO_TEST_CASE(what_is_no_number_says_so) {
  BOOST_TEST(rounded(endless, "m/s") == "∞");
  BOOST_TEST(rounded(-endless, "m/s") == "-∞");
  BOOST_TEST(rounded(no_number, "m/s") == "not a number");
}

// The prefix moves the point of the decimal, so that it is the same number: 1e-7 has no other
// digits in µm.
BOOST_AUTO_TEST_CASE(all_digits_read_back) {
  BOOST_TEST(rounded(0.004094841503754417, "m/s", all_digits) == "4.094841503754417 mm/s");
  BOOST_TEST(rounded(1e-7, "m", all_digits) == "0.1 µm");
  BOOST_TEST(rounded(2.0 / 3, "", all_digits) == "0.6666666666666666");
  BOOST_TEST(rounded(2.0 / 3, "", 2) == "0.67");
  BOOST_TEST(rounded(0.0123, "N", 1) == "10 mN");
}

BOOST_AUTO_TEST_CASE(an_angular_frequency_is_told_in_hertz) {
  BOOST_TEST(rounded_frequency(125663.706) == "20 kHz");
}

BOOST_AUTO_TEST_CASE(a_bound_is_rounded_to_its_side) {
  BOOST_TEST(rounded_down(3.9689e-7, "m") == "0.3968 µm");
  BOOST_TEST(rounded_up(3.9681e-7, "m") == "0.3969 µm");
  BOOST_TEST(rounded_up(9.9991e-3, "m/s") == "10 mm/s");
  BOOST_TEST(rounded_down(1.00009e-3, "m/s") == "1 mm/s");
  BOOST_TEST(rounded_down(-2.0001, "N") == "-2.001 N");
  BOOST_TEST(rounded_up(-2.0009, "N") == "-2 N");
  BOOST_TEST(rounded_up(0, "m") == "0 m");
  BOOST_TEST(rounded_down(endless, "m/s") == "∞");
}

BOOST_AUTO_TEST_CASE(a_bound_of_four_digits_stays_itself) {
  for (const double value : {499.99999999999994e-9, 5e-7, 500.00000000000006e-9}) {
    BOOST_TEST(rounded_down(value, "m") == "0.5 µm");
    BOOST_TEST(rounded_up(value, "m") == "0.5 µm");
  }
}

BOOST_AUTO_TEST_CASE(numbers_that_differ_are_told_apart) {
  using Both = std::pair<std::string, std::string>;
  BOOST_TEST((rounded_apart(4, 3, "N") == Both("4 N", "3 N")));
  BOOST_TEST((rounded_apart(5.00003e-3, 5e-3, "m/s") == Both("5.00003 mm/s", "5 mm/s")));
  BOOST_TEST((rounded_apart(0.5, 0.5, "N") == Both("500 mN", "500 mN")));
}

BOOST_AUTO_TEST_CASE(per_cent_are_whole_and_rounded_down) {
  BOOST_TEST(whole_percent(0.252) == "25 %");
  BOOST_TEST(whole_percent(0.2599) == "25 %");
  BOOST_TEST(whole_percent(0.29) == "29 %");  // 0.29 is no double, and 100 times it below 29
  BOOST_TEST(whole_percent(1) == "100 %");
  BOOST_TEST(whole_percent(0.01) == "1 %");
  BOOST_TEST(whole_percent(0.0099) == "0.9 %");
  BOOST_TEST(whole_percent(0.00037) == "0.03 %");
  BOOST_TEST(whole_percent(0) == "0 %");
}

BOOST_AUTO_TEST_CASE(many_numbers_share_the_scale_of_the_largest) {
  const UnitScale speed = scale_for(0.0045, "m/s");
  BOOST_TEST(speed.unit == "mm/s");
  BOOST_TEST(std::abs(speed.factor / 1000 - 1) < 1e-15);
  BOOST_TEST(scale_for(8e6, "N/m").unit == "N/µm");
  BOOST_TEST(scale_for(endless, "m").factor == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()
