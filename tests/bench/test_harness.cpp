// What is measured does not depend on what was measured before: neither the first run in a process
// nor memory fetched from the system counts.
#include <sys/resource.h>

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <memory>
#include <vector>

#include "harness/child.hpp"
#include "harness/timing.hpp"

BOOST_AUTO_TEST_SUITE(test_harness)

using namespace vcrit::bench;

namespace {

constexpr Limits no_limits{.time = std::chrono::seconds(100)};

void work_for(double seconds) {
  const double begin = processor_time();
  while (processor_time() < begin + seconds) {
  }
}

double page_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_minflt);
}

/// Two megabytes at the end of the heap, in small pieces, and given back.
void use_memory() {
  std::vector<std::unique_ptr<char[]>> pieces;
  for (int i = 0; i < 16'384; ++i) pieces.push_back(std::make_unique<char[]>(112));
}

}  // namespace

// Later runs only read the clock twice. A tenth of the first run is ten thousand times that, and
// ten times what separates the smallest figure that the system may have counted in ticks of 100 us.
BOOST_AUTO_TEST_CASE(the_first_run_is_not_counted) {
  const Report report = in_child(no_limits, [runs = 0]() mutable {
    const auto run = [&runs] { work_for(runs++ == 0 ? 5e-3 : 0); };
    return ChildNumbers{settled_time(run, 0.01), static_cast<double>(runs)};
  });
  BOOST_REQUIRE((report.ending == Ending::answered));
  BOOST_TEST(report.numbers[0] < 0.5e-3);
  BOOST_TEST(report.numbers[1] > 6);
}

BOOST_AUTO_TEST_CASE(a_long_run_is_not_repeated) {
  int runs = 0;
  const auto run = [&runs] {
    ++runs;
    work_for(15e-3);
  };
  BOOST_TEST(settled_time(run, 0.01) >= 15e-3);
  BOOST_TEST(runs == 1);
}

// 512 pages a run. The last one or two may be fetched anew: in a process where the heap's end comes
// and goes, all are, in each of at least six runs.
BOOST_AUTO_TEST_CASE(repeated_runs_fetch_no_memory) {
  const Report report = in_child(no_limits, [] {
    use_memory();
    const double before = page_faults();
    settled_time(use_memory, 1e-3, 0.01);
    return ChildNumbers{page_faults() - before};
  });
  BOOST_REQUIRE((report.ending == Ending::answered));
  BOOST_TEST(report.numbers[0] < 512);
}

BOOST_AUTO_TEST_CASE(time_counts_until_the_limit_is_lifted) {
  const Limits limits{.time = std::chrono::milliseconds(50)};
  const auto forever = [] {
    work_for(1e9);
    return ChildNumbers{};
  };
  BOOST_TEST((in_child(limits, forever).ending == Ending::out_of_time));
  const auto lifted = [] {
    lift_time_limit();
    work_for(0.2);
    return ChildNumbers{1, 2, 3};
  };
  BOOST_TEST(in_child(limits, lifted).numbers[2] == 3);
}

BOOST_AUTO_TEST_CASE(programs_that_are_started_are_limited_too) {
  const auto starts = [] {
    return ChildNumbers{static_cast<double>(std::system("while :; do :; done"))};
  };
  const Limits limits{.time = std::chrono::seconds(1), .of_programs = true};
  const Report report = in_child(limits, starts);
  BOOST_TEST((report.ending == Ending::answered));
  BOOST_TEST(report.numbers[0] != 0);
}

BOOST_AUTO_TEST_SUITE_END()
