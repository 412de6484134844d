// Boost.Test for all tests, read once. Where its macros give each case and each check some code of
// its own, for messages that are hardly ever asked for, these call functions, which do and say the
// same: a tenth of what tests take to compile.
#pragma once

#include <boost/test/unit_test.hpp>
#include <cstddef>

namespace vcrit::test {

/// Tells the log where the test is: of an unexpected exception, it shows what was reached last.
void reach(const char* file, std::size_t line);

/// The same for a stage of a case.
void reach(const char* file, std::size_t line, const char* name, const char* stage);

boost::unit_test::test_case* new_case(void (*run)(), const char* name, const char* file,
                                      std::size_t line);

/// Logs how a check of these words ended. At level REQUIRE, a failure ends the case.
void report(const boost::test_tools::assertion_result& result, const char* words, const char* file,
            std::size_t line, boost::test_tools::tt_detail::tool_level level);

}  // namespace vcrit::test

#undef BOOST_TEST_PASSPOINT
#define BOOST_TEST_PASSPOINT() ::vcrit::test::reach(__FILE__, __LINE__)

#undef BOOST_TEST_TOOL_ET_IMPL
#define BOOST_TEST_TOOL_ET_IMPL(P, level)                                                         \
  do {                                                                                            \
    BOOST_TEST_PASSPOINT();                                                                       \
    ::vcrit::test::report(BOOST_TEST_BUILD_ASSERTION(P).evaluate(), BOOST_STRINGIZE(P), __FILE__, \
                          __LINE__, ::boost::test_tools::tt_detail::level);                       \
  } while (::boost::test_tools::tt_detail::dummy_cond())

#undef BOOST_FIXTURE_TEST_CASE_WITH_DECOR
#define BOOST_FIXTURE_TEST_CASE_WITH_DECOR(test_name, F, decorators)                           \
  struct test_name : public F {                                                                \
    void test_method();                                                                        \
  };                                                                                           \
  static void BOOST_AUTO_TC_INVOKER(test_name)() {                                             \
    ::vcrit::test::reach(__FILE__, __LINE__, #test_name, "fixture ctor");                      \
    test_name t;                                                                               \
    ::vcrit::test::reach(__FILE__, __LINE__, #test_name, "fixture setup");                     \
    ::boost::unit_test::setup_conditional(t);                                                  \
    ::vcrit::test::reach(__FILE__, __LINE__, #test_name, "test entry");                        \
    t.test_method();                                                                           \
    ::vcrit::test::reach(__FILE__, __LINE__, #test_name, "fixture teardown");                  \
    ::boost::unit_test::teardown_conditional(t);                                               \
    ::vcrit::test::reach(__FILE__, __LINE__, #test_name, "fixture dtor");                      \
  }                                                                                            \
  BOOST_AUTO_TU_REGISTRAR(test_name)                                                           \
  (::vcrit::test::new_case(&BOOST_AUTO_TC_INVOKER(test_name), #test_name, __FILE__, __LINE__), \
   decorators);                                                                                \
  void test_name::test_method()
