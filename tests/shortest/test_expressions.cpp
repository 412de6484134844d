// Expressions have one form; moves change how they are written, never what they are.
#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

#include "shortest/expressions.hpp"
#include "shortest/moves.hpp"
#include "shortest/search.hpp"
#include "shortest/steps.hpp"
#include "shortest/value_of.hpp"

BOOST_AUTO_TEST_SUITE(test_expressions)

using namespace vcrit;
using namespace vcrit::symbolic::shortest;
using vcrit::test::value_of;

struct Names {
  Expressions all;
  Ex a = all.symbol("a"), b = all.symbol("b"), c = all.symbol("c"), d = all.symbol("d");
  Ex sum(const Ex& x, const Ex& y) { return all.add(x, y); }
  Ex times(const Ex& x, const Ex& y) { return all.multiply(x, y); }
  Ex square(const Ex& x) { return all.power(x, 2); }
  double value(const Ex& ex) const {
    std::map<ExNode, double> known{{a.node, 1.7}, {b.node, 0.6}, {c.node, 2.3}, {d.node, 0.9}};
    return value_of(ex.factor) * value_of(all, ex.node, known);
  }
  int operations(const Ex& ex) const { return symbolic::shortest::operations(all, ex); }
};

BOOST_FIXTURE_TEST_CASE(equal_expressions_are_one_node, Names) {
  BOOST_TEST((sum(a, b) == sum(b, a)));
  BOOST_TEST((times(times(a, b), c) == times(c, times(b, a))));
  BOOST_TEST((sum(sum(a, b), all.negative(b)) == a));
  BOOST_TEST((all.divide(times(a, b), b) == a));
  BOOST_TEST((square(all.subtract(a, b)) == square(all.subtract(b, a))));
  BOOST_TEST(all.subtract(a, a).is_zero());
}

BOOST_FIXTURE_TEST_CASE(roots_and_magnitudes_are_taken_where_they_can_be, Names) {
  const Ex difference = all.subtract(a, b);
  BOOST_TEST((all.root(square(a)) == a));
  BOOST_TEST((all.root(square(difference)) == all.magnitude(difference)));
  BOOST_TEST((all.magnitude(sum(a, b)) == sum(a, b)));
  BOOST_TEST((square(all.magnitude(difference)) == square(difference)));
  BOOST_TEST((square(all.root(sum(a, b))) == sum(a, b)));
  BOOST_TEST(
      (all.root(all.multiply(all.number(9, 4), square(a))) == all.multiply(all.number(3, 2), a)));
  const Ex roots = times(all.root(sum(a, b)), all.root(sum(c, d)));
  BOOST_TEST(operations(roots) == 4);
}

BOOST_FIXTURE_TEST_CASE(what_is_written_twice_counts_once, Names) {
  BOOST_TEST(operations(all.divide(times(a, b), c)) == 2);
  BOOST_TEST(operations(all.power(times(a, b), -1)) == 2);
  BOOST_TEST(operations(square(times(a, b))) == 2);
  BOOST_TEST(operations(sum(square(times(a, b)), times(a, b))) == 3);
  BOOST_TEST(operations(all.divide(sum(sum(a, b), c), sum(sum(a, b), d))) == 4);
  BOOST_TEST(operations(all.multiply(all.number(17, 14), a)) == 2);
}

// (x0 + x64 + a) (x0 + x64 + b) x0 ... x65: by hand, x0 + x64 is one operation, each sum another,
// and 68 factors are 67.
BOOST_FIXTURE_TEST_CASE(terms_in_common_are_found_among_many, Names) {
  std::vector<Ex> symbols;
  for (int i = 0; i < 66; ++i) symbols.push_back(all.symbol("x" + std::to_string(i)));
  const Ex both = sum(symbols[0], symbols[64]);
  Ex whole = times(sum(both, a), sum(both, b));
  for (const Ex& symbol : symbols) whole = times(whole, symbol);
  BOOST_TEST(operations(whole) == 70);
}

BOOST_FIXTURE_TEST_CASE(moves_keep_the_value, Names) {
  const Ex inner = all.divide(sum(a, times(b, sum(c, d))), sum(square(a), square(times(b, d))));
  const Ex whole = times(a, all.root(all.divide(sum(square(inner), square(all.subtract(c, b))),
                                                sum(all.number(1), square(c)))));
  const double value = this->value(whole);
  int moves = 0;
  Moves(all).for_each(whole, [&](const Ex& moved) {
    ++moves;
    BOOST_TEST(this->value(moved) == value, boost::test_tools::tolerance(1e-12));
    return true;
  });
  BOOST_TEST(moves > 20);
}

BOOST_FIXTURE_TEST_CASE(the_search_finds_factors, Names) {
  const Ex expanded = sum(sum(times(a, c), times(a, d)), sum(times(b, c), times(b, d)));
  const Ex best = shortest_of(all, {expanded}, {50, 1'000'000});
  BOOST_TEST(operations(best) == 3);
  BOOST_TEST(value(best) == value(expanded), boost::test_tools::tolerance(1e-12));
  // k T/(1 + T^2) = k/(T + 1/T)
  const Ex loss = all.divide(times(a, b), sum(all.number(1), square(b)));
  BOOST_TEST(operations(shortest_of(all, {loss}, {50, 1'000'000})) == 3);
}

BOOST_AUTO_TEST_CASE(fractions_that_leave_64_bits_are_refused) {
  const SmallFraction large{std::int64_t{1} << 40, 1};
  BOOST_CHECK_THROW(large * large, TooLarge);
}

BOOST_AUTO_TEST_SUITE_END()
