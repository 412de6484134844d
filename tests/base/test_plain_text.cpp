// What steers a terminal or turns the direction of writing becomes visible; other text stays.
#include <boost/test/unit_test.hpp>
#include <string>

#include "base/plain_text.hpp"

BOOST_AUTO_TEST_SUITE(test_plain_text)

using namespace vcrit;

BOOST_AUTO_TEST_CASE(ordinary_text_stays) {
  for (const char* text :
       {"", "k0 = 8 N/um", "\u00b5m, \u2026 \u2192 \u4e2d \U0001F600 \u00a0", "a\tb\nc"})
    BOOST_TEST(without_steering(text) == text);
  BOOST_TEST(one_line("a\tb\nc") == "a b c");
}

BOOST_AUTO_TEST_CASE(what_steers_is_shown) {
  BOOST_TEST(without_steering("\x1b[2J\r\x7f") == "\\u{1b}[2J\\u{d}\\u{7f}");
  BOOST_TEST(without_steering(std::string("\0", 1)) == "\\u{0}");
  // C1, and all marks of direction and ends of line that Unicode has.
  BOOST_TEST(without_steering("\xC2\x80\xC2\x9F") == "\\u{80}\\u{9f}");
  BOOST_TEST(without_steering("\u061c\u200e\u200f") == "\\u{61c}\\u{200e}\\u{200f}");
  BOOST_TEST(without_steering("\u2028\u2029\u202a\u202e") ==
             "\\u{2028}\\u{2029}\\u{202a}\\u{202e}");
  BOOST_TEST(without_steering("\u2066\u2069") == "\\u{2066}\\u{2069}");
}

BOOST_AUTO_TEST_CASE(neighbours_of_what_steers_stay) {
  for (const char* text :
       {"\u00a0", "\u061b", "\u061d", "\u200d", "\u2010", "\u2027", "\u202f", "\u2065", "\u206a"})
    BOOST_TEST(without_steering(text) == text);
}

// Text that ends within a character, or is no UTF-8.
BOOST_AUTO_TEST_CASE(broken_text_stays_as_it_is) {
  for (const char* text : {"\xE2", "\xE2\x80", "\xC2", "\xFF\xFE"})
    BOOST_TEST(without_steering(text) == text);
}

BOOST_AUTO_TEST_SUITE_END()
