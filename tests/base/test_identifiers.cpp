// Names that may and may not reach generated code, and guesses at what was meant.
#include <boost/test/unit_test.hpp>
#include <string>

#include "base/identifiers.hpp"

BOOST_AUTO_TEST_SUITE(test_identifiers)

using namespace vcrit;

BOOST_AUTO_TEST_CASE(names_of_elements_are_safe) {
  for (const char* name : {"k", "k0", "c_1", "kappa", "K1", "k_t", "nu"})
    BOOST_TEST(!unsafe_as_identifier(name));
}

BOOST_AUTO_TEST_CASE(what_breaks_code_is_not) {
  for (const char* name : {"", "0k", "k-1", "k 1", "k\"", "_k", "k__1", "const", "class", "lambda",
                           "NULL", "EOF", "M_PI", "INFINITY", "linux", "ünder", "../k"})
    BOOST_TEST_CONTEXT(name) { BOOST_TEST(unsafe_as_identifier(name).has_value()); }
  BOOST_TEST(unsafe_as_identifier(std::string(65, 'k')).has_value());
}

BOOST_AUTO_TEST_CASE(every_reserved_word_is_found) {
  // The table is searched by bisection: first, last and some between.
  for (const char* name :
       {"alignas", "yield", "char8_t", "bitor", "union", "unix", "xor_eq", "while"})
    BOOST_TEST_CONTEXT(name) { BOOST_TEST(unsafe_as_identifier(name).has_value()); }
}

BOOST_AUTO_TEST_CASE(the_nearest_name_is_the_one_meant) {
  BOOST_TEST(nearest("norml", {"normal", "poisson", "tangential"}).value() == "normal");
  BOOST_TEST(nearest("zenner", {"kelvin", "zener"}).value() == "zener");
  BOOST_TEST(!nearest("xyzzy", {"normal", "poisson"}).has_value());
  BOOST_TEST(nearest("K1", {"c1", "k1"}).value() == "k1");
}

BOOST_AUTO_TEST_CASE(a_beginning_is_enough_where_one_name_has_it) {
  BOOST_TEST(nearest("freq", {"angular_frequency", "frequency", "mass"}).value() == "frequency");
  BOOST_TEST(!nearest("vel", {"velocity", "velocity_ratio"}).has_value());
  BOOST_TEST(!nearest("fre", {"angular_frequency", "masses"}).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
