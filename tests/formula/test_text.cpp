// Numbers beside expressions: a double is written with its own digits whether formula/text.hpp is
// included or not. As an expression 17/14 would be 1.2142857142857141906.
#include "formula/text.hpp"

#include <boost/test/unit_test.hpp>

#include "emit/languages/cpp/dialect.hpp"
#include "formula/dialect.hpp"
#include "support/scene_text.hpp"

namespace vcrit::symbolic {

BOOST_AUTO_TEST_SUITE(test_text)

namespace {

constexpr double value = 17.0 / 14;
const std::string shortest = "1.2142857142857142";  // the neighbours are 2.2e-16 away

}  // namespace

BOOST_AUTO_TEST_CASE(a_double_is_no_expression) {
  BOOST_TEST(to_text(value) == shortest);
  BOOST_TEST(to_text(GiNaC::ex(17) / 14) == "17/14");
  BOOST_TEST(to_text(Symbol{"k", 3}) == "k[3]");
}

BOOST_AUTO_TEST_CASE(generated_code_holds_the_digits_of_the_double) {
  BOOST_TEST(literal(value) == shortest);
  Node node;
  node.constant = GiNaC::numeric(17, 14);
  const ParameterList none(test::scene_of(test::SceneText{}), std::vector<Symbol>{}, {});
  BOOST_TEST(CppDialect(none).constant(node).text == shortest);
}

// 17/14^2 and x/17/14 would read as other numbers.
BOOST_AUTO_TEST_CASE(a_fraction_holds_together) {
  const Form g{Form::Kind::number, "17/14", {}, {}, {}, 1}, x{Form::Kind::name, "x", {}, {}, {}, 1};
  const auto text = [](const Form& form) { return text_dialect().print({false, form}); };
  BOOST_TEST(text({Form::Kind::power, "", {g}, {}, {}, 2}) == "(17/14)^2");
  BOOST_TEST(text({Form::Kind::product, "", {x}, {g}, {}, 1}) == "x/(17/14)");
  BOOST_TEST(text({Form::Kind::product, "", {g, x}, {}, {}, 1}) == "17/14*x");
}

// a - (b - c) and -(b - c).
BOOST_AUTO_TEST_CASE(a_sum_that_is_taken_away_stands_in_parentheses) {
  const auto name = [](const char* text) { return Form{Form::Kind::name, text, {}, {}, {}, 1}; };
  const Form inner{Form::Kind::sum, "", {}, {}, {{false, name("b")}, {true, name("c")}}, 1};
  const Form behind{Form::Kind::sum, "", {}, {}, {{false, name("a")}, {true, inner}}, 1};
  const Form lone{Form::Kind::sum, "", {}, {}, {{true, inner}}, 1};
  const auto text = [](const Signed& form) { return text_dialect().print(form); };
  BOOST_TEST(text({false, behind}) == "a - (b - c)");
  BOOST_TEST(text({false, lone}) == "-(b - c)");
  BOOST_TEST(text({true, inner}) == "-(b - c)");
  BOOST_TEST(text_dialect().terms(behind.terms, true) == " + a - (b - c)");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace vcrit::symbolic
