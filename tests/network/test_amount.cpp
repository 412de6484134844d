// Numbers that are made of others: their values, texts, and what is left where some are 0.
#include <boost/test/unit_test.hpp>

#include "network/amount.hpp"
#include "network/expression.hpp"
#include "network/law.hpp"
#include "network/network.hpp"

BOOST_AUTO_TEST_SUITE(test_amount)

using namespace vcrit;

namespace {

using Kind = AmountTree::Kind;

AmountTreePointer k(const std::string& name) {
  return make_expression(Symbol{name}, NumberRole::stiffness);
}
AmountTreePointer sum(AmountTreePointer a, AmountTreePointer b) {
  return make_expression(Kind::sum, std::move(a), std::move(b));
}
AmountTreePointer product(AmountTreePointer a, AmountTreePointer b) {
  return make_expression(Kind::product, std::move(a), std::move(b));
}
AmountTreePointer quotient(AmountTreePointer a, AmountTreePointer b) {
  return make_expression(Kind::quotient, std::move(a), std::move(b));
}
const AmountTreePointer quarter = make_expression(TypedNumber{0.25, "0.25"});

/// (a + b)*0.25/c
const Amount whole({"x"}, quotient(product(sum(k("a"), k("b")), quarter), k("c")));

std::optional<Amount> left_where(const Amount& amount, const std::string& zero) {
  return without_zeros(amount, [&](const Symbol& symbol) { return symbol.name == zero; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_are_those_of_the_arithmetic) {
  BOOST_TEST(amount_value(whole, {{{"a"}, 3}, {{"b"}, 5}, {{"c"}, 4}}).value() == 0.5);
  BOOST_TEST(!amount_value(whole, {{{"a"}, 3}, {{"b"}, 5}}).has_value());
  BOOST_TEST(amount_value(Amount("a"), {{{"a"}, 3}}).value() == 3);
  BOOST_TEST(amount_operations(whole) == 4U);
  BOOST_TEST(amount_operations(Amount("a")) == 0U);
}

BOOST_AUTO_TEST_CASE(texts_read_as_they_are_meant) {
  BOOST_TEST(to_text(whole) == "(a + b)*0.25/c");
  BOOST_TEST(to_text(Amount({}, quotient(k("a"), product(k("b"), k("c"))))) == "a/(b*c)");
  BOOST_TEST(to_text(Amount({}, quotient(k("a"), quotient(k("b"), k("c"))))) == "a/(b/c)");
  BOOST_TEST(to_text(Amount({}, product(k("a"), quotient(k("b"), k("c"))))) == "a*(b/c)");
  BOOST_TEST(to_text(whole, [](const Symbol& s) { return s.name + s.name; }) ==
             "(aa + bb)*0.25/cc");
}

BOOST_AUTO_TEST_CASE(what_is_0_leaves_sums_and_takes_products_along) {
  BOOST_TEST(to_text(left_where(whole, "a").value()) == "b*0.25/c");
  BOOST_TEST(!left_where(Amount({}, product(k("a"), k("b"))), "b").has_value());
  BOOST_TEST(!left_where(Amount({}, quotient(k("a"), k("b"))), "a").has_value());
  BOOST_CHECK_THROW(left_where(whole, "c"), Bug);
  const auto zero = [](const Symbol& symbol) { return symbol.name == "c"; };
  BOOST_TEST(divides_by_zero(whole, zero));
  BOOST_TEST(!divides_by_zero(Amount({}, sum(k("a"), k("c"))), zero));
}

BOOST_AUTO_TEST_CASE(equal_are_those_of_one_text) {
  const Amount same({"x"}, quotient(product(sum(k("a"), k("b")), quarter), k("c")));
  BOOST_CHECK(whole == same);
  BOOST_CHECK(!(whole == Amount(Symbol{"y"}, whole.expression())));
  BOOST_CHECK(!(whole == Amount("x")));
  BOOST_CHECK_THROW(whole.symbol(), Bug);
  BOOST_CHECK(Amount("x").symbol() == (Symbol{"x"}));
}

BOOST_AUTO_TEST_CASE(a_network_has_the_symbols_of_its_amounts) {
  const Network network = parallel({spring(whole), damper({Symbol{}, product(k("a"), k("t"))})});
  BOOST_CHECK((symbols_of(network) == std::vector<Symbol>{{"a"}, {"b"}, {"c"}, {"t"}}));
  BOOST_TEST(!is_plain(network));
  Network renamed = network;
  rename(renamed, [](const Symbol& symbol) {
    return symbol.name == "a" ? Amount({"a"}, sum(k("p"), k("q"))) : Amount(symbol);
  });
  BOOST_CHECK((symbols_of(renamed) == std::vector<Symbol>{{"p"}, {"q"}, {"b"}, {"c"}, {"t"}}));
}

// Each is spring k beside damper k tau.
BOOST_AUTO_TEST_CASE(a_generalized_kelvin_has_retardation_times) {
  const Surroundings nothing{[](const std::string&, const Place&, int) { return std::nullopt; },
                             [](const std::string&) { return std::nullopt; }};
  const Network network = parse_expression("generalized_kelvin(k, tau, 2)", Place{}, nothing);
  const auto* elements = std::get_if<Series>(&network.form);
  BOOST_REQUIRE(elements != nullptr && elements->parts.size() == 2U);
  for (int j = 1; j <= 2; ++j) {
    const auto& pair = std::get<Parallel>(elements->parts[static_cast<std::size_t>(j - 1)].form);
    BOOST_CHECK(pair.parts[0] == spring({"k", j}));
    const auto& dashpot = std::get<Element>(pair.parts[1].form);
    BOOST_CHECK(dashpot.kind == ElementKind::damper);
    BOOST_TEST(amount_value(dashpot.coefficient, {{{"k", j}, 3}, {{"tau", j}, 7}}).value() == 21);
  }
}

BOOST_AUTO_TEST_SUITE_END()
