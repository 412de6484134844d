// Numbers for people.
#include "report/units.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_report_units)

using namespace vcrit::validation::report;

BOOST_AUTO_TEST_CASE(quantities_take_the_prefix_that_reads_well) {
  BOOST_TEST(quantity(0.0045779, "m/s") == "4.5779 mm/s");
  BOOST_TEST(quantity(8e6, "N/m") == "8 N/µm");
  BOOST_TEST(quantity(1e-7, "m") == "0.1 µm");
  BOOST_TEST(quantity(1000, "N/m") == "1 kN/m");
  BOOST_TEST(quantity(999.9, "N/m") == "999.9 N/m");
  BOOST_TEST(quantity(-2e-3, "N") == "-2 mN");
}

BOOST_AUTO_TEST_CASE(grams_not_kilograms_take_prefixes) {
  BOOST_TEST(quantity(0.005, "kg") == "5 g");
  BOOST_TEST(quantity(3e-7, "kg") == "300 µg");
}

BOOST_AUTO_TEST_CASE(no_prefix_where_none_is_used) {
  BOOST_TEST(quantity(125664, "rad/s") == "125664 rad/s");
  BOOST_TEST(quantity(0.3, "") == "0.3");
  BOOST_TEST(quantity(0, "m") == "0 m");
}

BOOST_AUTO_TEST_CASE(beyond_the_prefixes_the_number_gives_way) {
  BOOST_TEST(quantity(1e-30, "m") == "1 × 10⁻³⁰ m");
  BOOST_TEST(quantity(1e30, "N/m") == "1 × 10³⁰ N/m");
  BOOST_TEST(quantity(std::numeric_limits<double>::infinity(), "m/s") == "∞");
}

BOOST_AUTO_TEST_CASE(no_line_ends_between_a_number_and_its_unit) {
  BOOST_TEST(unbroken("below 4.1 mm/s, by 40 % at 0.1 \u00b5m, k1 at most") ==
             "below 4.1\u00a0mm/s, by 40\u00a0% at 0.1\u00a0\u00b5m, k1\u00a0at most");
  BOOST_TEST(unbroken(" 4") == " 4");
}

BOOST_AUTO_TEST_CASE(differences_show_their_power_of_ten) {
  BOOST_TEST(magnitude(3.21e-16) == "3.2 × 10⁻¹⁶");
  BOOST_TEST(magnitude(0.5) == "5.0 × 10⁻¹");
  BOOST_TEST(magnitude(0) == "0");
  BOOST_TEST(magnitude(std::numeric_limits<double>::infinity()) == "∞");
}

BOOST_AUTO_TEST_SUITE_END()
