// Arithmetic of polynomials, on identities known by hand.
#include <boost/test/unit_test.hpp>

#include "base/errors.hpp"
#include "network/polynomial.hpp"

BOOST_AUTO_TEST_SUITE(test_polynomial)

using namespace vcrit;

struct Fixture {
  Ring ring{{"s", "a", "b"}};
  Polynomial s = Polynomial::variable(ring, "s"), a = Polynomial::variable(ring, "a"),
             b = Polynomial::variable(ring, "b"), one{ring, 1};
};

BOOST_FIXTURE_TEST_CASE(products_and_sums, Fixture) {
  BOOST_TEST(((a + b) * (a - b) == a * a - b * b));
  BOOST_TEST(!((a + b) * (a + b) == a * a + b * b));
  BOOST_TEST(((a + b) * (a + b)).terms() == 3U);
  BOOST_TEST((a - a).is_zero());
  BOOST_TEST(one.is_one());
}

BOOST_FIXTURE_TEST_CASE(terms_are_read_in_lexical_order, Fixture) {
  const Polynomial f = b * b - Polynomial(ring, 12) * s * a + one;
  BOOST_TEST(f.terms() == 3U);
  BOOST_TEST(f.coefficient(0) == "-12");
  BOOST_TEST((f.exponents(0) == std::vector<unsigned long>{1, 1, 0}));
  BOOST_TEST((f.exponents(2) == std::vector<unsigned long>{0, 0, 0}));
}

BOOST_FIXTURE_TEST_CASE(coefficients_may_be_long, Fixture) {
  Polynomial f(ring, 1);
  f.add_term("123456789012345678901234567890", {1, 0, 0});
  f.add_term("-123456789012345678901234567889", {1, 0, 0});
  BOOST_TEST((f == s + one));
  BOOST_CHECK_THROW(f.add_term("1/2", {0, 0, 0}), vcrit::Bug);
}

BOOST_FIXTURE_TEST_CASE(powers_of_one_variable, Fixture) {
  const Polynomial f = s * s * a + s * s * s * b;
  BOOST_TEST(f.degree("s") == 3U);
  BOOST_TEST(f.lowest_degree("s") == 2U);
  BOOST_TEST((f.without_power("s", 2) == a + s * b));
  BOOST_TEST((f.derivative("s") == Polynomial(ring, 2) * s * a + Polynomial(ring, 3) * s * s * b));
}

BOOST_FIXTURE_TEST_CASE(common_factors_go, Fixture) {
  const PolynomialQuotient q = cancelled({(a + b) * (a - b), (a + b) * (s + one)});
  BOOST_TEST((q.over == a - b));
  BOOST_TEST((q.under == s + one));
  const PolynomialQuotient sum = cancelled(PolynomialQuotient{one, a} + PolynomialQuotient{one, b});
  BOOST_TEST((sum.over == a + b));
  BOOST_TEST((sum.under == a * b));
  const PolynomialQuotient turned = cancelled({one, Polynomial(ring, -1) * a});
  BOOST_TEST((turned.under == a));
}

BOOST_FIXTURE_TEST_CASE(primitive_parts, Fixture) {
  const Polynomial six(ring, -6), nine(ring, 9);
  BOOST_TEST(((six * a * s + nine * a * b).primitive("s") ==
              Polynomial(ring, 2) * s - Polynomial(ring, 3) * b));
}

BOOST_AUTO_TEST_SUITE_END()
