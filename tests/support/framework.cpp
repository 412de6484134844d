#include "support/framework.hpp"

#include <string>

namespace vcrit::test {

using boost::unit_test::const_string;
using boost::unit_test::lazy_ostream;

void reach(const char* file, std::size_t line) {
  boost::unit_test::unit_test_log.set_checkpoint(file, line);
}

void reach(const char* file, std::size_t line, const char* name, const char* stage) {
  boost::unit_test::unit_test_log.set_checkpoint(file, line,
                                                 '"' + std::string(name) + "\" " + stage);
}

boost::unit_test::test_case* new_case(void (*run)(), const char* name, const char* file,
                                      std::size_t line) {
  return boost::unit_test::make_test_case(run, name, file, line);
}

void report(const boost::test_tools::assertion_result& result, const char* words, const char* file,
            std::size_t line, boost::test_tools::tt_detail::tool_level level) {
  const const_string text = words;
  boost::test_tools::tt_detail::report_assertion(
      result, lazy_ostream::instance() << text, file, line, level,
      boost::test_tools::tt_detail::CHECK_BUILT_ASSERTION, 0);
}

}  // namespace vcrit::test
