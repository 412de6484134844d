// Dotted keys are counted where TOML has keys, and nowhere else.
#include "scene/key_limits.hpp"

#include <boost/test/unit_test.hpp>
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_key_limits)

using namespace vcrit;

namespace {

std::string message(const std::string& text) {
  return test::refusal([&] { document::check_keys(text, "s.toml"); });
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

const std::string deep = "a" + repeated(".a", 20);
const std::string too_deep =
    "s.toml:2: found a key of more than 20 parts; expected sections and "
    "keys of a scene";

}  // namespace

BOOST_AUTO_TEST_CASE(a_deep_key_is_refused_wherever_it_stands) {
  BOOST_TEST(message("\n" + deep + " = 1") == too_deep);
  BOOST_TEST(message("\n[" + deep + "]") == too_deep);
  BOOST_TEST(message("\n[[" + deep + "]]") == too_deep);
  BOOST_TEST(message("x = 1\ny = {b = 1, " + deep + " = 1}") == too_deep);
  BOOST_TEST(message("\n\"a\" . 'b'" + repeated(" . \"a\\\"b\"", 19) + " = 1") == too_deep);
  BOOST_TEST(message("\nx = {a = \"\"\"b\"\"\"\"\", " + deep + " = 1}") == too_deep);
  BOOST_TEST(message("x = '''\n'''\n" + deep).starts_with("s.toml:3:"));
  BOOST_TEST(message(deep.substr(2) + " = 1") == "accepted");
}

BOOST_AUTO_TEST_CASE(dots_elsewhere_are_free) {
  const std::string dots = repeated(".", 50);
  for (const std::string& text :
       {"# " + dots + "\n", "x = \"" + dots + "\"", "x = '" + dots + "'",
        "x = \"\\\"" + dots + "\"", "x = \"\"\"\n\"" + dots + "\n\"\"\"",
        "x = '''\n'" + dots + "'''", "x = [" + repeated("1.5, ", 50) + "]",
        "x = [\n" + repeated("1.5,\n", 50) + "]"})
    BOOST_TEST(message(text) == "accepted");
}

BOOST_AUTO_TEST_CASE(many_dotted_keys_are_refused) {
  const std::string refused =
      "s.toml:10001: found more than 10000 dotted keys; expected keys in "
      "sections, as name = value below [section]";
  BOOST_TEST(message(repeated("a.b = 1\n", 10001)) == refused);
  BOOST_TEST(message(repeated("1.b = 1\n", 10001)) == refused);
  BOOST_TEST(message(repeated("[a.b]\n", 10001)) == refused);
  BOOST_TEST(message(repeated(" [[a.b]]\n", 10001)) == refused);
  BOOST_TEST(message("x = {" + repeated("a.b = 1, ", 10001) + "}").starts_with("s.toml:1: found"));
  BOOST_TEST(message(repeated("a.b = 1\n", 10000)) == "accepted");
  BOOST_TEST(message(repeated("a = 1.5\n", 10001)) == "accepted");
  BOOST_TEST(message("x = [" + repeated("1.5, ", 10001) + "1.5]\n") == "accepted");
}

BOOST_AUTO_TEST_SUITE_END()
