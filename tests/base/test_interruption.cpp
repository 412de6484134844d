// What may be interrupted is so in its own scope and thread, and nowhere else.
#include "base/interruption.hpp"

#include <boost/test/unit_test.hpp>
#include <thread>

BOOST_AUTO_TEST_SUITE(test_interruption)

namespace {

struct Ended {};
void end() { throw Ended{}; }

}  // namespace

BOOST_AUTO_TEST_CASE(ends_work_within_a_scope) {
  vcrit::hear_interruption();
  {
    const vcrit::Interruptible scope(&end);
    BOOST_CHECK_THROW(vcrit::hear_interruption(), Ended);
    {
      const vcrit::Interruptible spared(nullptr);
      vcrit::hear_interruption();
    }
    BOOST_CHECK_THROW(vcrit::hear_interruption(), Ended);
    std::thread(vcrit::hear_interruption).join();
  }
  vcrit::hear_interruption();
}

BOOST_AUTO_TEST_SUITE_END()
