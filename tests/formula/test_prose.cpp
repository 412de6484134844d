// Words with formulas, in each dialect.
#include <boost/test/unit_test.hpp>

#include <string>

#include "formula/dialect.hpp"
#include "formula/prose.hpp"
#include "formula/symbols.hpp"
#include "record/html_text.hpp"

BOOST_AUTO_TEST_SUITE(test_prose)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

const Prose velocity{"below ", stated(quantity("v*"), omega() / symbol({"k0"})), " & more"};

}  // namespace

BOOST_AUTO_TEST_CASE(formulas_in_words_are_mathematics) {
  BOOST_TEST(velocity.text() == "below v* = omega/k0 & more");
  BOOST_TEST(velocity.written(latex_within_words(), "$", "$", record::html_text) ==
             "below $v^{*} = \\omega/k_{0}$ &amp; more");
  const std::string page =
      velocity.written(mathml_within_words(), "<math>", "</math>", record::html_text);
  BOOST_TEST(page.starts_with(
      "below <math><msup><mi>v</mi><mo>*</mo></msup><mo>=</mo><mi>ω</mi><mo>/</mo>"));
  BOOST_TEST(page.ends_with("</msub></math> &amp; more"));
}

BOOST_AUTO_TEST_CASE(limits_are_said_with_an_arrow) {
  BOOST_TEST(Prose({tends(omega(), true)}).text() == "omega -> infinity");
  BOOST_TEST(Prose({tends(omega(), false)}).text() == "omega -> 0");
  BOOST_TEST(latex_dialect().written(tends(omega(), true)) == "\\omega \\to \\infty");
}

BOOST_AUTO_TEST_CASE(numbers_are_written_as_given) {
  BOOST_TEST(Prose({stated_number(quantity("nu"), 0.38)}).text() == "nu = 0.38");
  BOOST_TEST(Prose({stated_number(quantity("nu"), -0.5)}).text() == "nu = -0.5");
}

BOOST_AUTO_TEST_CASE(words_are_joined) {
  Prose words("Result");
  words += " (24)";
  words += {", with ", quantity("B")};
  BOOST_TEST(words.text() == "Result (24), with B");
  BOOST_TEST(Prose("").empty());
  BOOST_TEST(!words.empty());
}

BOOST_AUTO_TEST_SUITE_END()
