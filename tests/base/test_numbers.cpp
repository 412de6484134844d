// Numbers as text: the whole of it, or as far as a number goes at its beginning.
#include "base/numbers.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_numbers)

using namespace vcrit;

BOOST_AUTO_TEST_CASE(a_number_goes_as_far_as_it_can) {
  const auto length = [](const char* text) { return leading_number(text).length; };
  BOOST_TEST(length("2eV") == 1u);
  BOOST_TEST(length("2e-3eV") == 4u);
  BOOST_TEST(length("+1.5N") == 4u);
  BOOST_TEST(length(".5") == 2u);
  BOOST_TEST(length("1e1e1") == 3u);
  for (const char* text : {"", "N", "+", "-", "+-5", "--5", "e5", "."})
    BOOST_TEST(length(text) == 0u);
}

// Once they were cut until the rest was a number: 1e40 of "1e401".
BOOST_AUTO_TEST_CASE(a_number_beyond_the_doubles_has_a_length_and_no_value) {
  for (const char* text : {"1e401", "-1e401", "1e-401", "1e99999999999999999999"}) {
    BOOST_TEST(leading_number(text).length == std::string_view(text).size());
    BOOST_TEST(!leading_number(text).value);
    BOOST_TEST(!to_double(text));
  }
}

BOOST_AUTO_TEST_CASE(the_ends_of_the_range_are_in_it) {
  for (const double value : {1.7976931348623157e308, 4.9406564584124654e-324, -5e-324})
    BOOST_TEST((to_double(to_text(value)) == value));
}

BOOST_AUTO_TEST_SUITE_END()
