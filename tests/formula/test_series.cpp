// Sums over an index: what is folded, and that it stays the same number.
#include <boost/test/unit_test.hpp>

#include <map>
#include <string>

#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/prose.hpp"
#include "formula/series.hpp"
#include "formula/symbols.hpp"
#include "shortest/value_of.hpp"

BOOST_AUTO_TEST_SUITE(test_series)

using namespace vcrit;
using namespace vcrit::symbolic;
using GiNaC::ex;

namespace {

ex entry(const char* name, int number) { return symbol({name, number}); }

std::string folded(const ex& sum) {
  return text_dialect().print({false, with_series(form_of(sum).form)});
}

ex branches(int from, int to) {
  ex sum = symbol({"k0"});
  for (int j = from; j <= to; ++j) sum += entry("k", j) / (1 + entry("tau", j) * omega());
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(four_terms_that_differ_by_a_number_are_a_sum) {
  BOOST_TEST(folded(branches(1, 4)) == "k0 + sum(k[j]/(1 + omega*tau[j]), j = 1..4)");
  BOOST_TEST(folded(branches(3, 12)) == "k0 + sum(k[j]/(1 + omega*tau[j]), j = 3..12)");
  BOOST_TEST(folded(branches(1, 3)).find("sum(") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(other_terms_stay_apart) {
  // A gap, a sign, a coefficient, and elements that are no array.
  const ex gap = branches(1, 2) + branches(4, 5);
  BOOST_TEST(folded(gap).find("sum(") == std::string::npos);
  ex signs = 0, numbers = 0, scalars = 0;
  for (int j = 1; j <= 4; ++j) {
    signs += (j == 2 ? -1 : 1) * entry("k", j);
    numbers += j * entry("k", j);
    scalars += symbol({"k" + std::to_string(j)});
  }
  for (const ex& sum : {signs, numbers, scalars})
    BOOST_TEST(folded(sum).find("sum(") == std::string::npos, folded(sum));
}

BOOST_AUTO_TEST_CASE(letters_of_the_program_run_with_the_entries) {
  ex sum = 0;
  for (int j = 1; j <= 5; ++j) sum += quantity("T" + std::to_string(j + 7)) * entry("k", j);
  BOOST_TEST(folded(sum) == "sum(k[j]*T[j+7], j = 1..5)");
}

// Products, roots and powers around the sum; each number once, at random places. Sums of ten terms
// in two orders differ by some ten ulps.
BOOST_AUTO_TEST_CASE(a_folded_formula_has_the_same_value) {
  const ex sum = branches(1, 10);
  const ex formula = GiNaC::sqrt(1 + sum * sum) / sum;
  std::map<std::string, double> values{{"k0", 1.7}, {"omega", 0.3}};
  for (int j = 1; j <= 10; ++j) {
    values["k[" + std::to_string(j) + "]"] = 1 + 0.37 * j * j;
    values["tau[" + std::to_string(j) + "]"] = 2.0 / (j + 1);
  }
  const Form plain = form_of(formula).form, short_form = with_series(plain);
  BOOST_TEST(text_dialect().print({false, short_form}).size() <
             text_dialect().print({false, plain}).size() / 3);
  BOOST_TEST(test::value_of(short_form, values) == test::value_of(plain, values),
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(dialects_write_sums) {
  const Form sum = with_series(form_of(branches(1, 4)).form);
  BOOST_TEST(latex_dialect()
                 .print({false, sum})
                 .find("\\sum_{j=1}^{4} \\frac{k_{j}}{1 + \\omega \\tau_{j}}") !=
             std::string::npos);
  BOOST_TEST(mathml_dialect().print({false, sum}).find("<munderover><mo>∑</mo>") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
