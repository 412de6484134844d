// Lines of a table: blanks, line ends and places.
#include "base/csv.hpp"

#include <boost/test/unit_test.hpp>
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_csv)

using namespace vcrit;

namespace {

std::string message(const std::string& line, std::size_t count) {
  CsvLines lines(line, "t.csv");
  lines.next();
  return test::refusal([&] { lines.numbers(count, "two numbers"); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(lines_know_their_places_and_empty_ones_are_passed) {
  CsvLines lines("\xEF\xBB\xBFname, b c ,\"d\"\r\n\r\n \t\n 1 ,-2e3\t,+3", "t.csv");
  BOOST_TEST_REQUIRE(lines.next());
  BOOST_TEST((lines.cells() == std::vector<std::string>{"name", "b c", "d"}));
  BOOST_TEST(lines.place().line == 1);
  BOOST_TEST_REQUIRE(lines.next());
  BOOST_TEST(lines.place().line == 4);
  BOOST_TEST((lines.numbers(3, "three") == std::vector<double>{1, -2000, 3}));
  BOOST_TEST(!lines.next());
}

// As some instruments write all cells.
BOOST_AUTO_TEST_CASE(quotes_around_numbers_do_no_harm) {
  CsvLines lines("\"1\", \"-2e3\" ,3", "t.csv");
  BOOST_TEST_REQUIRE(lines.next());
  BOOST_TEST((lines.numbers(3, "three") == std::vector<double>{1, -2000, 3}));
  BOOST_TEST(message("\"\",\"", 2) == "t.csv:1: found \"\"; expected a finite number");
}

BOOST_AUTO_TEST_CASE(another_encoding_is_told) {
  for (const char* text : {"\xFF\xFEx", "\xFE\xFF"}) {
    const std::string found = test::refusal([&] { CsvLines(text, "t.csv"); });
    BOOST_TEST(found.starts_with("t.csv: found a table in UTF-16; expected one in UTF-8"), found);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_number_is_named) {
  BOOST_TEST(message("1,2", 2) == "accepted");
  BOOST_TEST(message("1,", 2) == "t.csv:1: found \"\"; expected a finite number");
  BOOST_TEST(message("1,2 3", 2) == "t.csv:1: found \"2 3\"; expected a finite number");
  BOOST_TEST(message("1,inf", 2) == "t.csv:1: found \"inf\"; expected a finite number");
  const std::string advice = "; commas separate numbers, which have decimal points: 2.5";
  for (const char* text : {"1,5,2,5,3,5", "1,2,5,3,5", "1;2;3"})
    BOOST_TEST(message(text, 3).ends_with(advice), text);
  BOOST_TEST(!message("1,2,3,4", 3).ends_with(advice));
  BOOST_TEST(message("1,2,3", 2) == "t.csv:1: found \"1,2,3\"; expected two numbers");
}

BOOST_AUTO_TEST_SUITE_END()
