// Text of the user's own in messages: what is printable stays, the rest is escaped, much is cut.
#include "base/messages.hpp"

#include <boost/test/unit_test.hpp>

#include "base/errors.hpp"

BOOST_AUTO_TEST_SUITE(test_messages)

using namespace vcrit;

// Boundaries of the Unicode standard's table 3-7 (well-formed UTF-8).
BOOST_AUTO_TEST_CASE(characters_stay) {
  for (const char* text : {"k0 | c0", "N/µm", "\xC2\xA0", "\xDF\xBF", "\xE0\xA0\x80",
                           "\xED\x9F\xBF", "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    BOOST_TEST(printable(text) == text);
}

BOOST_AUTO_TEST_CASE(the_rest_is_escaped) {
  BOOST_TEST(printable("a\nb\x1b[31m\x7f") == "a\\nb\\x1b[31m\\x7f");
  BOOST_TEST(printable("\xC2\x9B") == "\\xc2\\x9b");
  BOOST_TEST(printable("\xC0\x80") == "\\xc0\\x80");
  BOOST_TEST(printable("\xE0\x9F\xBF") == "\\xe0\\x9f\\xbf");
  BOOST_TEST(printable("\xED\xA0\x80") == "\\xed\\xa0\\x80");
  BOOST_TEST(printable("\xF0\x8F\xBF\xBF") == "\\xf0\\x8f\\xbf\\xbf");
  BOOST_TEST(printable("\xF4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
  BOOST_TEST(printable("\xF5") == "\\xf5");
  BOOST_TEST(printable("\xE2\x82") == "\\xe2\\x82");
}

BOOST_AUTO_TEST_CASE(long_texts_lose_their_middle) {
  const std::string end(2000, 'b');
  BOOST_TEST(printable(std::string(4000, 'a')) == std::string(4000, 'a'));
  BOOST_TEST(printable(std::string(2500, 'a') + end) ==
             std::string(2000, 'a') + " ... (500 more bytes) ... " + end);
  // A character of two bytes at the cut stays whole.
  BOOST_TEST(printable(std::string(1999, 'a') + "\xC2\xB5" + std::string(499, 'x') + end) ==
             std::string(1999, 'a') + "\xC2\xB5 ... (499 more bytes) ... " + end);
}

BOOST_AUTO_TEST_CASE(errors_are_printable) {
  const InputError error({"a\nb", 1, 2}, "\x1b", "\xff");
  BOOST_TEST(error.what() == std::string("a\\nb:1:2: found \\x1b; expected \\xff"));
}

// A comment more above a place where something is ensured leaves the program as it is.
BOOST_AUTO_TEST_CASE(bugs_say_their_function_and_no_line) {
  const auto broken = [](const auto& promise) {
    try {
      promise();
    } catch (const Bug& bug) {
      return std::string(bug.what());
    }
    return std::string();
  };
  BOOST_TEST(broken([] { ensure(false, "a is b"); }) == "bug in vcrit (operator()): a is b");
  BOOST_TEST(broken([] { throw Bug("a is b"); }) == "bug in vcrit (operator()): a is b");
}

BOOST_AUTO_TEST_SUITE_END()
