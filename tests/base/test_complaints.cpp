// Complaints: thrown at once, or all collected, each once.
#include "base/complaints.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_complaints)

using namespace vcrit;

namespace {

InputError at(int line, int column, const char* found = "this") {
  return {{"s.toml", line, column}, found, "that"};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_first_one_is_thrown) {
  Complaints complaints;
  BOOST_CHECK_THROW(complaints.add(at(1, 1)), InputError);
  BOOST_CHECK_THROW(complaints.attempt([] { throw at(1, 1); }), InputError);
  BOOST_TEST(complaints.attempt([] {}));
  BOOST_TEST(!complaints.any());
}

BOOST_AUTO_TEST_CASE(all_are_collected_by_line) {
  Complaints complaints(Complaints::Mode::all);
  BOOST_TEST(!complaints.attempt([] { throw at(7, 2); }));
  complaints.add(at(7, 1));
  complaints.add(at(3, 9));
  complaints.add(at(3, 9));           // once
  complaints.add(at(3, 9, "other"));  // another one
  BOOST_TEST(complaints.attempt([] {}));
  const std::vector<InputError> all = complaints.sorted();
  BOOST_REQUIRE_EQUAL(all.size(), 4U);
  BOOST_TEST(all[0].found() == "this");
  BOOST_TEST(all[1].found() == "other");
  BOOST_TEST(all[2].place().column == 1);
  BOOST_TEST(all[3].place().column == 2);
}

BOOST_AUTO_TEST_CASE(other_failures_are_not_complaints) {
  Complaints complaints(Complaints::Mode::all);
  BOOST_CHECK_THROW(complaints.attempt([] { throw ModelError("outside"); }), ModelError);
}

BOOST_AUTO_TEST_CASE(an_ignored_line_has_no_more) {
  Complaints complaints(Complaints::Mode::all);
  complaints.add(at(4, 1));
  complaints.ignore_line(4);
  complaints.add(at(4, 8));
  BOOST_TEST(complaints.sorted().size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_warning_begins_with_its_place) {
  BOOST_TEST(to_text(Warning{{"s.toml", 3, 4}, "odd"}) == "s.toml:3:4: odd");
  BOOST_TEST(to_text(Warning{{}, "odd"}) == "odd");
}

BOOST_AUTO_TEST_SUITE_END()
