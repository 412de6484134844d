// Jobs side by side: answers in order, errors as they were, a crash that names its job.
#include "run/workers.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "run/compiler.hpp"

BOOST_AUTO_TEST_SUITE(test_workers)

using namespace vcrit;
using namespace vcrit::validation;

namespace {

const std::vector<std::string> names{"first", "second", "third", "fourth", "fifth"};
const Watch nobody = [](const Standing&) {};

bool mentions(const std::exception& error, const std::string& part) {
  return std::string(error.what()).find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(answers_come_in_order_however_long_they_are) {
  // Longer than a pipe holds (64 KiB), the first the longest.
  const auto work = [](std::size_t i, const Progress&) {
    return std::string(300000 >> i, char('a' + i));
  };
  for (const unsigned at_once : {0u, 1u, 2u, 9u}) {
    const auto answers = in_processes(names, at_once, work, nobody);
    BOOST_REQUIRE(answers.size() == names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
      BOOST_TEST(answers[i] == std::string(300000 >> i, char('a' + i)));
  }
}

BOOST_AUTO_TEST_CASE(no_more_jobs_run_at_once_than_asked_for) {
  std::size_t most = 0, told = 0;
  in_processes(
      names, 2,
      [](std::size_t, const Progress& step) {
        step("working");
        return "done";
      },
      [&](const Standing& standing) {
        most = std::max(most, standing.running.size());
        told = standing.done;
        BOOST_TEST(standing.jobs == 5u);
      });
  BOOST_TEST(most <= 2u);
  BOOST_TEST(told == 5u);
}

// Two that wait for each other's file end only if both run.
BOOST_AUTO_TEST_CASE(jobs_do_run_at_once) {
  const PrivateFolder folder;
  const auto meet = [&](std::size_t i, const Progress&) -> std::string {
    write_file(folder.path() / std::to_string(i), "here");
    while (!std::filesystem::exists(folder.path() / std::to_string(1 - i))) usleep(1000);
    return "met";
  };
  const auto answers = in_processes({"one", "two"}, 2, meet, nobody);
  BOOST_TEST(answers[0] == "met");
  BOOST_TEST(answers[1] == "met");
}

BOOST_AUTO_TEST_CASE(errors_keep_their_kind_and_their_words) {
  const auto outside = [](std::size_t i, const Progress&) -> std::string {
    if (i == 3) throw ModelError("0/0");
    return "";
  };
  BOOST_CHECK_EXCEPTION(in_processes(names, 2, outside, nobody), ModelError,
                        [](const auto& error) { return error.what() == std::string("0/0"); });
  // As where there is no room for temporary files.
  const auto refused = [](std::size_t i, const Progress&) -> std::string {
    if (i == 0) throw InputError({"place"}, "no room", "room");
    throw std::system_error(ENOSPC, std::generic_category(), "mkdtemp");
  };
  for (const char* words : {"place: found no room; expected room", "mkdtemp: No space left"}) {
    const std::vector<std::string> one{words[0] == 'p' ? "input" : "system"};
    const auto job = [&](std::size_t, const Progress& step) {
      return refused(words[0] == 'p' ? 0 : 1, step);
    };
    BOOST_CHECK_EXCEPTION(in_processes(one, 1, job, nobody), JobRefused, [&](const auto& error) {
      return mentions(error, (one[0] + ": " + words).c_str());
    });
  }
  const auto broken = [](std::size_t, const Progress&) -> std::string {
    throw std::logic_error("a bug");
  };
  BOOST_CHECK_EXCEPTION(in_processes(names, 2, broken, nobody), std::runtime_error,
                        [](const auto& error) { return mentions(error, ": a bug"); });
}

BOOST_AUTO_TEST_CASE(a_crash_names_its_job) {
  const auto crash = [](std::size_t i, const Progress&) -> std::string {
    if (i == 2) raise(SIGKILL);
    return "fine";
  };
  BOOST_CHECK_EXCEPTION(in_processes(names, 1, crash, nobody), std::runtime_error,
                        [](const auto& error) {
                          return mentions(error, "third: its process was ended by signal 9");
                        });
}

BOOST_AUTO_TEST_CASE(what_fails_is_answered_for_and_the_others_are_finished) {
  const auto work = [](std::size_t i, const Progress&) -> std::string {
    if (i == 1) throw ModelError("0/0");
    if (i == 2) raise(SIGKILL);
    if (i == 3) throw std::logic_error("a bug");
    return "fine";
  };
  const auto in_place = [](std::size_t i, const std::string& why) { return names[i] + ": " + why; };
  const auto answers = in_processes(names, 2, work, nobody, in_place);
  const std::vector<std::string> expected{
      "fine", "second: 0/0", "third: its process was ended by signal 9", "fourth: a bug", "fine"};
  BOOST_TEST(answers == expected, boost::test_tools::per_element());
  // What the system refuses one job it refuses the others.
  const auto refused = [](std::size_t, const Progress&) -> std::string {
    throw std::system_error(ENOSPC, std::generic_category(), "mkdtemp");
  };
  BOOST_CHECK_THROW(in_processes(names, 2, refused, nobody, in_place), JobRefused);
}

BOOST_AUTO_TEST_SUITE_END()
