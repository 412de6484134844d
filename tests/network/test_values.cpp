// Numbers by symbols: what is found, by a place or by a search, and in which order they stand.
#include "network/values.hpp"

#include <boost/test/unit_test.hpp>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "network/amount.hpp"
#include "network/wiring.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_values)

namespace {

using namespace vcrit;

const Symbol a{"a"}, b{"b"}, c{"c"};

std::vector<std::pair<std::string, double>> in_order(const Values& values) {
  std::vector<std::pair<std::string, double>> all;
  for (const auto& [symbol, value] : values) all.emplace_back(to_text(symbol), value);
  return all;
}

BOOST_AUTO_TEST_CASE(each_symbol_has_its_number) {
  Values values{{b, 2.0}, {a, 1.0}, {b, 7.0}};
  BOOST_TEST(values.at(a) == 1);
  BOOST_TEST(values.at(b) == 2);  // the first that is given
  BOOST_TEST(values.find(c) == nullptr);
  values[c] = 3;
  values[a] = 4;
  values.emplace(a, 5);
  BOOST_TEST(values.at(c) == 3);
  BOOST_TEST(values.at(a) == 4);
  BOOST_TEST((Values{{a, 4.0}, {b, 2.0}, {c, 3.0}} == values));
  BOOST_TEST(!(Values{{a, 4.0}, {b, 2.0}, {c, 5.0}} == values));
}

// By name, then by entry as a number, whatever the order in which they came.
BOOST_AUTO_TEST_CASE(they_stand_in_the_order_of_symbols) {
  Values values;
  for (const int entry : {10, 2, 1}) values[{"k", entry}] = entry;
  values[{"k"}] = 0;
  values[{"eta"}] = 5;
  values[{"k0"}] = 6;
  using Order = std::vector<std::pair<std::string, double>>;
  BOOST_TEST((in_order(values) ==
              Order{{"eta", 5}, {"k", 0}, {"k[1]", 1}, {"k[2]", 2}, {"k[10]", 10}, {"k0", 6}}));
}

BOOST_AUTO_TEST_CASE(a_missing_number_has_a_place_and_is_not_there) {
  Values values{SymbolList({c, a, b, a})};
  BOOST_TEST(values.empty());
  BOOST_TEST((values.begin() == values.end()));
  values[b] = 2;
  BOOST_TEST(values.size() == 1U);
  BOOST_TEST((in_order(values) == in_order({{b, 2.0}})));
  BOOST_TEST((values == Values{{b, 2.0}}));
  BOOST_TEST(!values.contains(a));
  BOOST_TEST(!amount_value(values.placed(a), values).has_value());
  BOOST_CHECK_THROW(values.at(a), Bug);
  BOOST_TEST(test::refused([&] { value_of(values, values.placed(a)); }, "none for a"));
  values.erase(b);
  BOOST_TEST(!values.contains(b));
  BOOST_TEST(Values().find(values.placed(b)) == nullptr);
}

// What is at that place in the other list is another symbol, or none.
BOOST_AUTO_TEST_CASE(a_place_of_one_list_is_no_answer_of_another) {
  const Values one{{a, 1.0}, {b, 2.0}, {c, 3.0}}, other{{b, 20.0}, {c, 30.0}};
  BOOST_TEST(one.placed(b).place == 1);
  BOOST_TEST(other.placed(b).place == 0);
  BOOST_TEST(other.at(one.placed(b)) == 20);
  BOOST_TEST(other.at(one.placed(c)) == 30);
  BOOST_TEST(other.find(one.placed(a)) == nullptr);
  BOOST_TEST(one.at(other.placed(b)) == 2);
  BOOST_TEST(one.at(other.placed(c)) == 3);
  BOOST_TEST((one.placed(b) == other.placed(b)));
  Symbol beyond = a;
  beyond.place = 1000;
  BOOST_TEST(one.at(beyond) == 1);
  BOOST_TEST(one.placed({"d"}).place == -1);
}

// A copy shares the list until it gets a symbol of its own.
BOOST_AUTO_TEST_CASE(copies_are_apart) {
  const Values first{{a, 1.0}, {c, 3.0}};
  const Symbol placed = first.placed(c);
  Values copy = first;
  copy[placed] = 4;
  copy[b] = 2;  // c is behind it now
  BOOST_TEST(first.at(placed) == 3);
  BOOST_TEST(first.size() == 2U);
  BOOST_TEST(copy.at(placed) == 4);
  BOOST_TEST(copy.placed(c).place == 2);
  const auto words = BySymbol<std::string>::beside(first);
  BOOST_TEST(words.empty());
  BOOST_TEST(words.placed(c).place == 1);
}

// The same questions to a tree of the standard library.
BOOST_AUTO_TEST_CASE(it_answers_as_a_map_does) {
  std::mt19937 random(3);
  std::map<Symbol, double> expected;
  Values values;
  std::vector<Symbol> symbols;
  for (int i = 0; i < 40; ++i)
    symbols.push_back({std::string(1, static_cast<char>('a' + i % 7)), i / 7});
  for (int step = 0; step < 2000; ++step) {
    Symbol symbol = symbols[random() % symbols.size()];
    symbol.place = static_cast<int>(random() % 50) - 1;  // mostly a wrong one
    if (random() % 3 == 0) {
      values.erase(symbol);
      expected.erase(symbol);
    } else {
      values[symbol] = expected[symbol] = step;
    }
    const Symbol& asked = symbols[random() % symbols.size()];
    const auto found = expected.find(asked);
    const double* const number = values.find(asked);
    BOOST_TEST_REQUIRE((number == nullptr) == (found == expected.end()));
    if (number != nullptr) BOOST_TEST(*number == found->second);
    BOOST_TEST_REQUIRE(values.size() == expected.size());
  }
  BOOST_TEST(std::equal(
      expected.begin(), expected.end(), values.begin(), values.end(),
      [](const auto& x, const auto& y) { return x.first == y.first && x.second == y.second; }));
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
