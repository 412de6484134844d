// Common factors and splits of GiNaC's polynomials by FLINT, against products made by hand.
#include <boost/test/unit_test.hpp>

#include "formula/symbols.hpp"
#include "polynomial/symbol_ring.hpp"

BOOST_AUTO_TEST_SUITE(test_symbol_ring)

using namespace vcrit;
using namespace vcrit::symbolic;
using GiNaC::ex;

namespace {

const ex k = symbol({"k"}), m = symbol({"m"}), w = omega(), s = laplace(),
         nu = poisson_ratio({"nu"});

bool same(const ex& a, const ex& b) { return (a - b).expand().is_zero(); }

}  // namespace

BOOST_AUTO_TEST_CASE(a_polynomial_comes_back_as_it_was) {
  const GiNaC::numeric large("-123456789012345678901234567890");
  for (const ex& each : {ex(0), ex(7), k, (large * pow(k, 3) * nu + 2 * s - 1).expand(),
                         pow(k - m * w * w + s * nu, 4).expand()}) {
    const SymbolRing ring({each});
    BOOST_TEST(ring.sum(ring.polynomial(each)).is_equal(each));
  }
}

BOOST_AUTO_TEST_CASE(two_polynomials_share_a_factor) {
  const ex shared = k - m * w * w, a = k + s, b = 1 - nu;
  const CommonFactor found = common_factor((shared * a).expand(), (shared * b).expand());
  BOOST_TEST((same(found.common, shared) || same(found.common, -shared)));
  BOOST_TEST(same(found.common * found.a_left, shared * a));
  BOOST_TEST(same(found.common * found.b_left, shared * b));
  BOOST_TEST(common_factor(a, b).common.is_equal(1));
}

BOOST_AUTO_TEST_CASE(fractions_stay_with_what_is_left) {
  const ex a = ((k + s) * (k - m) / 6).expand(), b = (GiNaC::numeric(5, 4) * (k + s)).expand();
  const CommonFactor found = common_factor(a, b);
  BOOST_TEST((same(found.common, k + s) || same(found.common, -k - s)));
  BOOST_TEST(same(found.common * found.a_left, a));
  BOOST_TEST(same(found.common * found.b_left, b));
}

BOOST_AUTO_TEST_CASE(a_rational_function_is_one_fraction_in_lowest_terms) {
  // k/(k + s) + s/(k + s) - 2 s/(k + s) = (k - s)/(k + s), times (k + s)/(3 m (k - s)^2).
  const ex sum = k / (k + s) + s / (k + s) - 2 * s / (k + s);
  const LowestTerms found = lowest_terms(sum * (k + s) / (3 * m * pow(k - s, 2)));
  BOOST_TEST(same(found.over * (3 * m * (k - s)), found.under));
  BOOST_TEST(found.over.info(GiNaC::info_flags::integer));
  BOOST_TEST(found.under.nops() == 2U);
  const LowestTerms none = lowest_terms((k - s) * (k + s) - k * k + s * s);
  BOOST_TEST(none.over.is_zero());
  BOOST_TEST(none.under.is_equal(1));
}

BOOST_AUTO_TEST_CASE(a_polynomial_splits_by_the_symbols_that_its_factors_lack) {
  const ex whole = ((2 - nu) * (k - m * w * w) * (s + w) / 3).expand();
  const std::vector<ex> found = split_by(whole, {k, m});
  // Without k: (2 - nu)(s + w). Of the other factor nothing lacks m.
  BOOST_TEST(found.size() == 2U);
  BOOST_TEST(!found[0].has(k));
  BOOST_TEST(found[0].has(nu));
  BOOST_TEST(found[0].has(s));
  BOOST_TEST(found[1].nops() == 2U);
  BOOST_TEST(same(found[0] * found[1], whole));
  // What lacks the first symbol altogether is one factor.
  const std::vector<ex> all = split_by(whole, {symbol({"c"}), k});
  BOOST_TEST(all.size() == 2U);
  BOOST_TEST((same(all[0], 3 * whole) || same(all[0], -3 * whole)));
  BOOST_TEST(same(all[0] * all[1], whole));
}

BOOST_AUTO_TEST_SUITE_END()
