// Boost.Test's main function, for all test programs.
#define BOOST_TEST_MODULE vcrit
#include <boost/test/unit_test.hpp>
