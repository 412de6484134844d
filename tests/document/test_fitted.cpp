// Equations that fit a page: rows are narrow enough, and say the same.
#include <boost/test/unit_test.hpp>

#include <map>
#include <string>
#include <vector>

#include "document/fitted.hpp"
#include "formula/dialect.hpp"
#include "formula/symbols.hpp"
#include "formula/width.hpp"
#include "shortest/value_of.hpp"

BOOST_AUTO_TEST_SUITE(test_fitted)

using namespace vcrit;
using namespace vcrit::symbolic;
using GiNaC::ex;

namespace {

ex element(int number) { return symbol({"k" + std::to_string(number)}); }

ex long_sum(int from, int to) {
  ex sum = 0;
  for (int i = from; i <= to; ++i) sum += element(i) * element(i + 1) * (i % 3 == 0 ? -1 : 1);
  return sum;
}

std::map<std::string, double> values_of_elements() {
  std::map<std::string, double> values{{"omega", 0.7}};
  for (int i = 0; i <= 60; ++i) values["k" + std::to_string(i)] = 1 + 0.13 * i;
  return values;
}

/// The rows of the last equation put together, with what its names mean put in.
double value_of(const std::vector<FittedEquation>& equations) {
  std::map<std::string, double> values = values_of_elements();
  double value = 0;
  for (const FittedEquation& each : equations) {
    value = 0;
    for (const std::vector<Signed>& row : each.rows)
      for (const Signed& term : row)
        value += (term.minus ? -1 : 1) * test::value_of(term.form, values);
    values[each.left.form.text] = value;
  }
  return value;
}

double width_of_row(const FittedEquation& equation, const std::vector<Signed>& row) {
  double width = width_of(equation.left) + width_of_relation;
  for (const Signed& term : row) width += width_of(term.form) + width_of_sign;
  return width;
}

std::vector<FittedEquation> fit(Fitting& fitting, const ex& right) {
  return fitting.fitted(stated(quantity("v*"), right));
}

const std::vector<ex> wide{
    long_sum(1, 40), GiNaC::sqrt(long_sum(1, 20) / long_sum(21, 45)),
    omega() / GiNaC::sqrt(1 + GiNaC::pow(long_sum(1, 25), 2)) * GiNaC::abs(long_sum(3, 30)),
    1 / (1 / (long_sum(1, 20) + 1 / long_sum(30, 50)) + 1 / element(1)),
    GiNaC::pow(long_sum(1, 9) * (1 + element(3) * long_sum(2, 40)), 2)};

}  // namespace

// A sum of forty terms, in another order and with names in between, differs by some forty ulps;
// what is taken to a power or divided, by some times that.
BOOST_AUTO_TEST_CASE(rows_fit_and_say_the_same) {
  for (const ex& right : wide) {
    Fitting fitting(measure_of_page);
    const auto equations = fit(fitting, right);
    const double plain = test::value_of(form_of(right).form, values_of_elements());
    BOOST_TEST(value_of(equations) == plain, boost::test_tools::tolerance(1e-12));
    std::size_t rows = 0;
    for (const FittedEquation& each : equations)
      for (const auto& row : each.rows) {
        ++rows;
        BOOST_TEST(width_of_row(each, row) < text_width);
      }
    BOOST_TEST(rows > 1u);
  }
}

BOOST_AUTO_TEST_CASE(lines_of_a_terminal_are_narrow_as_well) {
  for (const ex& right : wide) {
    Fitting fitting(measure_of_terminal);
    const auto equations = fit(fitting, right);
    const double plain = test::value_of(form_of(right).form, values_of_elements());
    BOOST_TEST(value_of(equations) == plain, boost::test_tools::tolerance(1e-12));
    for (const FittedEquation& each : equations)
      for (const auto& row : each.rows) BOOST_TEST(text_dialect().terms(row, true).size() < 100u);
  }
}

BOOST_AUTO_TEST_CASE(what_fits_is_left_as_it_is) {
  Fitting fitting(measure_of_page);
  const auto equations = fit(fitting, long_sum(1, 5));
  BOOST_TEST_REQUIRE(equations.size() == 1u);
  BOOST_TEST(equations[0].rows.size() == 1u);
}

// The root is set beside the fraction, so that k_3/k_4 stands below one bar.
BOOST_AUTO_TEST_CASE(what_is_below_a_root_beside_a_fraction_is_not_small) {
  Fitting fitting(measure_of_page);
  const ex inside = (element(2) + element(3) / element(4)) / (1 + element(5));
  BOOST_TEST(fit(fitting, element(1) * GiNaC::sqrt(inside) / element(6)).size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_part_has_one_name_in_a_document) {
  Fitting fitting(measure_of_page);
  const ex part = long_sum(1, 40);
  BOOST_TEST(fit(fitting, GiNaC::sqrt(part)).size() == 2u);
  const auto again = fit(fitting, element(50) / GiNaC::sqrt(part));
  BOOST_TEST_REQUIRE(again.size() == 1u);
  BOOST_TEST(latex_dialect().terms(again[0].rows[0], false) == "\\frac{k_{50}}{\\sqrt{U_{1}}}");
}

BOOST_AUTO_TEST_CASE(what_is_zero_is_broken_behind_the_sign) {
  Fitting fitting(measure_of_page);
  const auto equations = fitting.fitted(stated(long_sum(1, 40), 0));
  BOOST_TEST_REQUIRE(equations.size() == 1u);
  BOOST_TEST(latex_dialect().print(equations[0].left) == "0");
  BOOST_TEST(equations[0].rows.size() > 1u);
  // Wider than half a page, which is all that is left of other signs.
  const ex fits = element(10) * long_sum(1, 6);
  BOOST_TEST(measure_of_page.of(form_of(fits).form) > 0.5 * measure_of_page.width);
  BOOST_TEST(fitting.fitted(stated(fits, 0)).size() == 1u);
}

// Letters of Computer Modern, from cmmi10.tfm and cmr10.tfm, by hand: k is 5.2 pt, its index 4.0.
BOOST_AUTO_TEST_CASE(widths_are_those_of_computer_modern) {
  const auto width = [](const ex& formula) { return width_of(form_of(formula)); };
  BOOST_TEST(width(element(1)) > 9.2);
  BOOST_TEST(width(element(1)) < 11);
  // Two of them and a plus, 7.8 pt in 2 x 2.2 pt.
  BOOST_TEST(width(element(1) + element(2)) > 30.6);
  BOOST_TEST(width(element(1) + element(2)) < 35);
  // A name in words is as wide as its letters, a fraction as the wider side.
  BOOST_TEST(width(symbol({"stiffness"})) > 35);
  BOOST_TEST(width(element(1) / (element(2) + element(3))) < width(element(2) + element(3)) + 6);
}

BOOST_AUTO_TEST_SUITE_END()
