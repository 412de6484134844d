// Templates: no text gets past being escaped, and no misspelt key vanishes.
#include "record/template.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "base/errors.hpp"
#include "record/fields.hpp"

BOOST_AUTO_TEST_SUITE(test_template)

using namespace vcrit;
using namespace vcrit::record;

namespace {

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '<' ? "&lt;" : std::string(1, c);
  return result;
}

std::string meters(double value, const std::string& unit) {
  return fmt::format("{} {}", value, unit);
}

/// By templates as they are written in the program: "name:text".
std::string rendered(const std::vector<std::string>& templates, const Json& record) {
  std::string packed;
  for (std::string each : templates) {
    *std::find(each.begin(), each.end(), ':') = '\0';
    packed += each + '\0';
  }
  const Templates all(packed, escape, {{"meters", meters}});
  return all.render(templates.front().substr(0, templates.front().find(':')), record);
}

std::string page(const std::string& text, const Json& record) {
  return rendered({"page:" + text}, record);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_text_is_escaped) {
  const Json record{{"name", "<script>"}, {"names", {"<a", "<b"}}};
  BOOST_TEST(page("<p>{{name}}</p>", record) == "<p>&lt;script></p>");
  BOOST_TEST(page("{{#names}}{{.}};{{/names}}", record) == "&lt;a;&lt;b;");
  BOOST_TEST(page("{{#name}}{{.}}{{/name}}", record) == "&lt;script>");
}

BOOST_AUTO_TEST_CASE(only_markup_stands_as_it_is) {
  const Json record{{"sign", Fields(Reader::page).written(Markup{"<b>{{name}}"})}};
  BOOST_TEST(page("{{sign}}", record) == "<b>{{name}}");
}

BOOST_AUTO_TEST_CASE(no_template_can_keep_text_from_being_escaped) {
  BOOST_CHECK_THROW(page("{{{name}}}", {{"name", "x"}}), Bug);
  BOOST_CHECK_THROW(page("{{&name}}", {{"name", "x"}}), Bug);
}

BOOST_AUTO_TEST_CASE(a_misspelt_key_is_an_error) {
  const Json record{{"name", "x"}, {"none", nullptr}, {"drive", {{"mass", 1}}}};
  const auto names_it = [](const std::string& key) {
    return [key](const Bug& bug) { return std::string(bug.what()).find(key) != std::string::npos; };
  };
  for (const char* text :
       {"{{nome}}", "{{#nome}}x{{/nome}}", "{{^nome}}x{{/nome}}", "{{nome | .3f}}"})
    BOOST_CHECK_EXCEPTION(page(text, record), Bug, names_it("nome"));
  BOOST_CHECK_EXCEPTION(page("{{drive.moss}}", record), Bug, names_it("drive.moss"));
  BOOST_CHECK_EXCEPTION(page("{{> nome}}", record), Bug, names_it("nome"));
  BOOST_TEST(page("{{#none}}x{{/none}}{{^none}}y{{/none}}", record) == "y");
}

BOOST_AUTO_TEST_CASE(what_is_no_mustache_is_an_error) {
  for (const char* text : {"{{#a}}", "{{/a}}", "{{a", "{{#a}}{{/b}}"})
    BOOST_CHECK_THROW(page(text, {{"a", 1}, {"b", 1}}), Bug);
  BOOST_CHECK_THROW(rendered({"page:{{> part}}", "part:{{#a}}"}, {{"a", 1}}), Bug);
}

BOOST_AUTO_TEST_CASE(numbers_by_their_formats) {
  const Json record{{"x", 0.25}, {"n", 3}, {"far", "inf"}, {"word", "w"}, {"unit", "<m"}};
  BOOST_TEST(page("{{x}} {{n}} {{x | .3f}} {{x | +.1e}}", record) == "0.25 3 0.250 +2.5e-01");
  BOOST_TEST(page("{{x | meters km}} {{x | meters @unit}}", record) == "0.25 km 0.25 &lt;m");
  BOOST_TEST(page("{{far}} {{far | .3f}}", record) == "inf inf");
  BOOST_CHECK_THROW(page("{{word | .3f}}", record), Bug);
}

BOOST_AUTO_TEST_CASE(lists_know_their_places) {
  const Json record{{"rows", {{{"x", 1}}, {{"x", 2}}, {{"x", 3}}}}, {"y", 9}};
  BOOST_TEST(page("{{#rows}}{{@number}}:{{x}}{{y}}{{^@last}}, {{/@last}}{{/rows}}", record) ==
             "0:19, 1:29, 2:39");
  BOOST_TEST(page("{{#rows}}{{@place}}{{/rows}}", record) == "123");
  BOOST_TEST(page("{{#rows}}{{#y}}{{@number}}{{/y}}{{/rows}}", record) == "012");
  BOOST_TEST(page("{{#grid}}{{#.}}{{.}}{{/.}};{{/grid}}", {{"grid", {{1, 2}, {3}}}}) == "12;3;");
}

BOOST_AUTO_TEST_CASE(lists_are_counted) {
  const Json record{{"none", Json::array()}, {"part", {{"rows", {1, 2}}}}};
  BOOST_TEST(page("{{part.rows.@count}} of {{#part.rows.@any}}any{{/part.rows.@any}}", record) ==
             "2 of any");
  BOOST_TEST(page("{{none.@count}}{{^none.@any}}, none{{/none.@any}}", record) == "0, none");
  BOOST_CHECK_THROW(page("{{nome.@count}}", record), Bug);
}

BOOST_AUTO_TEST_CASE(what_is_empty_is_not_there) {
  const Json record{{"text", ""}, {"list", Json::array()}, {"no", false}, {"zero", 0}};
  for (const char* key : {"text", "list", "no"})
    BOOST_TEST(page(fmt::format("{{{{#{0}}}}}x{{{{/{0}}}}}{{{{^{0}}}}}y{{{{/{0}}}}}", key),
                    record) == "y");
  BOOST_TEST(page("{{#zero}}{{zero}}{{/zero}}", record) == "0");
}

BOOST_AUTO_TEST_CASE(a_template_stands_within_a_line) {
  BOOST_TEST(rendered({"page:<p>{{> part}}</p>\n", "part:<b>{{x}}</b>\n"}, {{"x", 1}}) ==
             "<p><b>1</b></p>");
  BOOST_TEST(rendered({"page:{{#rows}}\n{{> part}}\n{{/rows}}\n", "part:<i>{{x}}</i>\n"},
                      {{"rows", {{{"x", 1}}, {{"x", 2}}}}}) == "<i>1</i>\n<i>2</i>\n");
}

BOOST_AUTO_TEST_CASE(lines_of_sections_alone_are_none) {
  const std::string text =
      "a\n{{#x}}\n\n  {{y}}\n{{/x}}\n{{^x}}\n  {{! no }}\nno\n{{/x}}\nb\n\nc\n";
  BOOST_TEST(page(text, {{"x", true}, {"y", "Y"}}) == "a\n\n  Y\nb\n\nc");
  BOOST_TEST(page(text, {{"x", false}, {"y", "Y"}}) == "a\nno\nb\n\nc");
  BOOST_TEST(page("{{#x}}\n{{.}}\n{{/x}}\nend\n", {{"x", {" ", "1"}}}) == " \n1\nend");
}

BOOST_AUTO_TEST_CASE(other_braces) {
  const std::string text = "{{=<< >>=}}{<<x>>}\n<<#y>>\n{{<<.>>}}\n<</y>>\nend\n";
  BOOST_TEST(page(text, {{"x", 1}, {"y", {2, 3}}}) == "{1}\n{{2}}\n{{3}}\nend");
}

BOOST_AUTO_TEST_SUITE_END()
