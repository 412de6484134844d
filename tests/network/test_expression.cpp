// Expressions against networks built by hand; and what is wrong with the wrong ones, by column.
#include <boost/test/unit_test.hpp>
#include <string>

#include "network/catalogue.hpp"
#include "network/expression.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_expression)

using namespace vcrit;
using test::has;

namespace {

const Surroundings nothing{[](const std::string&, const Place&, int) { return std::nullopt; },
                           [](const std::string&) { return std::nullopt; }};

Network parsed(const std::string& text) {
  return parse_expression(text, {"s.toml", 1, 1}, nothing);
}

std::string message(const std::string& text) {
  return test::refusal([&] { parsed(text); });
}

Network k(const std::string& name) { return spring({name}); }
Network c(const std::string& name) { return damper({name}); }

}  // namespace

BOOST_AUTO_TEST_CASE(springs_dampers_series_parallel) {
  BOOST_CHECK(parsed("k0") == k("k0"));
  BOOST_CHECK(parsed(" kt|ct ") == parallel({k("kt"), c("ct")}));
  BOOST_CHECK(parsed("k0 | (k1 - c1)") == parallel({k("k0"), series({k("k1"), c("c1")})}));
  BOOST_CHECK(parsed("k1 - c1 - (k2 | c2)") ==
              series({k("k1"), c("c1"), parallel({k("k2"), c("c2")})}));
  BOOST_CHECK(parsed("((k0))") == k("k0"));
}

BOOST_AUTO_TEST_CASE(series_binds_tighter) {
  BOOST_CHECK(parsed("k0 | k1 - c1") == parsed("k0 | (k1 - c1)"));
}

BOOST_AUTO_TEST_CASE(nested_combinations_of_one_kind_are_one) {
  BOOST_CHECK(parsed("(k0 | k1) | k2") == parallel({k("k0"), k("k1"), k("k2")}));
}

BOOST_AUTO_TEST_CASE(named_rheologies_are_what_they_stand_for) {
  BOOST_CHECK(parsed("spring(a)") == k("a"));
  BOOST_CHECK(parsed("damper(eta)") == c("eta"));
  BOOST_CHECK(parsed("lossy(k, eta)") == (Network{Element{ElementKind::lossy, {"k"}, {"eta"}}}));
  BOOST_CHECK(parsed("kelvin(k, c)") == parsed("k | c"));
  BOOST_CHECK(parsed("maxwell(k, c)") == parsed("k - c"));
  BOOST_CHECK(parsed("zener(k0, k1, c1)") == parsed("k0 | (k1 - c1)"));
  BOOST_CHECK(parsed("sls(k0, k1, c1)") == parsed("k0 | (k1 - c1)"));
  BOOST_CHECK(parsed("poynting_thomson(k0, k1, c1)") == parsed("k0 - (k1 | c1)"));
  BOOST_CHECK(parsed("jeffreys(c0, k1, c1)") == parsed("c0 | (k1 - c1)"));
  BOOST_CHECK(parsed("burgers(k1, c1, k2, c2)") == parsed("k1 - c1 - (k2 | c2)"));
  BOOST_CHECK(parsed("prony(k0, k, tau, 2)") ==
              parallel({k("k0"), maxwell({"k", 1}, {"tau", 1}), maxwell({"k", 2}, {"tau", 2})}));
  BOOST_CHECK(parsed("generalized_maxwell(k0, k, tau, 2)") == parsed("prony(k0, k, tau, 2)"));
  const auto rung = [](int j) { return std::pair(spring({"k", j}), damper({"c", j})); };
  BOOST_CHECK(parsed("ladder(k, c, 1)") == series({rung(1).first, rung(1).second}));
  BOOST_CHECK(parsed("ladder(k, c, 3)") ==
              series({rung(1).first,
                      parallel({rung(1).second,
                                series({rung(2).first,
                                        parallel({rung(2).second,
                                                  series({rung(3).first, rung(3).second})})})})}));
}

BOOST_AUTO_TEST_CASE(a_ladder_is_as_deep_as_brackets) {
  BOOST_CHECK(size(parsed("ladder(k, c, 200)")) == 400U);
  BOOST_TEST(
      has(message("ladder(k, c, 201)"), "ladder(k, c) of 201 branches; expected at most 200"));
  BOOST_TEST(has(message("ladder(k, c, 100000)"), "expected at most 200"));
}

BOOST_AUTO_TEST_CASE(fractional_elements_lead_to_a_prony_series) {
  for (const char* text : {"k0 | springpot(k1, alpha)", "fractional_maxwell(k0, 0.5)", "springpot",
                           "scott_blair(k0, a, 0.3)"}) {
    BOOST_TEST(has(message(text), "a fractional element; expected springs and dampers"), text);
    BOOST_TEST(has(message(text), "vcrit fit"), text);
  }
}

BOOST_AUTO_TEST_CASE(arrays_give_the_number_of_branches) {
  const Surroundings arrays{[](const std::string&, const Place&, int) { return std::nullopt; },
                            [](const std::string& name) -> std::optional<int> {
                              if (name == "k") return 3;
                              if (name == "tau") return 3;
                              if (name == "t4") return 4;
                              return std::nullopt;
                            }};
  BOOST_CHECK(parse_expression("prony(k0, k, tau)", {}, arrays) == parsed("prony(k0, k, tau, 3)"));
  BOOST_CHECK_THROW(parse_expression("prony(k0, k, t4)", {}, arrays), InputError);
  BOOST_CHECK_THROW(parse_expression("prony(k0, k, tau, 4)", {}, arrays), InputError);
}

BOOST_AUTO_TEST_CASE(mistakes_are_named_with_their_column) {
  BOOST_TEST(has(message("k0 | (k1 - c1"), "s.toml:1:6"));
  BOOST_TEST(has(message("k0 | (k1 - c1"), "column 6"));
  BOOST_TEST(has(message("k0 | k1)"), "\")\" without an opening parenthesis at column 8"));
  BOOST_TEST(has(message("k0 | "), "the end of the network"));
  BOOST_TEST(has(message("k0 + k1"), "\"+\" at column 4"));
  for (const char* text : {"k0 + k1", "k0 // k1", "k0 * k1"})
    BOOST_TEST(has(message(text), "parallel is written \"|\", series \"-\": k0 | (k1 - c1)"), text);
  BOOST_TEST(has(message("k0 || k1"), "parallel is one \"|\""));
  BOOST_TEST(has(message("k0 - - k1"), "series is one \"-\""));
  BOOST_TEST(has(message("k0 \u2212 k1"), "found \"\u2212\" at column 4 of"));
  BOOST_TEST(has(message("k0 \u2212 k1"), "series is written with the \"-\" of the keyboard"));
  BOOST_TEST(!has(message("k0 | k1)"), "written"));
  BOOST_TEST(has(message("k0 | x1"), "s.toml:1:6: found element \"x1\" of unknown kind"));
  BOOST_TEST(
      has(message("E0 | (E1 - eta1)"), "write \"spring(E0) | (spring(E1) - damper(eta1))\""));
  BOOST_TEST(!has(message("E0 | x1"), "write"));
  BOOST_TEST(has(message("zenner(k0, k1, c1)"), "expected \"zener\""));
  BOOST_TEST(has(message("zener(k0, k1)"), "zener(k0, k1, c1)"));
  BOOST_TEST(has(message("sls(k0, k1)"), "found sls with 2 names; expected sls(k0, k1, c1)"));
  BOOST_TEST(has(message("prony(k0, k, tau)"), "number of branches"));
  BOOST_TEST(
      has(message("prony(k0, k, tau, 0)"), "found \"0\"; expected a number of branches from 1"));
  for (const char* number : {"100001", "999999", "-12", "123456789012345678901"})
    BOOST_TEST(has(message(std::string("prony(k0, k, tau, ") + number + ")"),
                   std::string("found \"") + number + "\"; expected a number of branches from 1"));
  BOOST_TEST(has(message("prony(k0, k, tau, )"), "found \")\"; expected"));
  BOOST_TEST(has(message("spring(const)"), "reserved word"));
  BOOST_TEST(has(message(""), "an element, a network"));
}

BOOST_AUTO_TEST_CASE(deep_nesting_is_refused_not_overflowed) {
  BOOST_TEST(has(message(std::string(100000, '(')),
                 "found 100000 levels of brackets; expected at most 200"));
}

BOOST_AUTO_TEST_CASE(signatures_say_the_arguments) {
  BOOST_TEST(catalogue().front().signature() == "spring(k)");
  BOOST_TEST(catalogue().back().signature() == "ladder(k, c)");
}

BOOST_AUTO_TEST_SUITE_END()
