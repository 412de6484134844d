// Programs without a shell, with a time limit, in folders that go away.
#include "run/compiler.hpp"

#include <sys/stat.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <filesystem>
#include <system_error>

#include "base/files.hpp"

BOOST_AUTO_TEST_SUITE(test_compiler)

using namespace vcrit::validation;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(arguments_reach_the_program_as_they_are) {
  const PrivateFolder folder;
  const std::string hostile = "a b $(touch intruder) `id` ; \"'|&>x * \\";
  const ProgramResult result = run_program({"/usr/bin/printf", "%s", hostile}, folder.path(), 10s);
  BOOST_TEST(result.succeeded());
  BOOST_TEST(result.output == hostile);
  BOOST_TEST(!fs::exists("intruder"));
}

BOOST_AUTO_TEST_CASE(a_program_runs_in_its_folder) {
  const PrivateFolder folder;
  BOOST_TEST(run_program({"/bin/pwd"}, folder.path(), 10s).output == folder.path().string() + "\n");
}

BOOST_AUTO_TEST_CASE(the_exit_status_and_both_outputs_come_back) {
  const PrivateFolder folder;
  const ProgramResult result =
      run_program({"/bin/sh", "-c", "echo out; echo err >&2; exit 7"}, folder.path(), 10s);
  BOOST_TEST(result.status == 7);
  BOOST_TEST(!result.succeeded());
  BOOST_TEST(result.output == "out\nerr\n");
}

BOOST_AUTO_TEST_CASE(a_signal_is_told_from_an_exit) {
  const PrivateFolder folder;
  const ProgramResult result = run_program({"/bin/sh", "-c", "kill -9 $$"}, folder.path(), 10s);
  BOOST_TEST(result.status == 128 + 9);
}

BOOST_AUTO_TEST_CASE(the_time_limit_stops_the_program_and_its_children) {
  const PrivateFolder folder;
  // The child would write a file a second after the limit.
  const std::string child = "(sleep 1; touch " + (folder.path() / "late").string() + ") & wait";
  const ProgramResult result = run_program({"/bin/sh", "-c", child}, folder.path(), 20ms);
  BOOST_TEST(result.timed_out);
  BOOST_TEST(!result.succeeded());
  run_program({"/bin/sleep", "1.3"}, folder.path(), 10s);
  BOOST_TEST(!fs::exists(folder.path() / "late"));
}

BOOST_AUTO_TEST_CASE(the_time_limit_is_of_processor_time) {
  const PrivateFolder folder;
  // As on a machine that is busy with others.
  BOOST_TEST(run_program({"/bin/sleep", "0.3"}, folder.path(), 100ms).succeeded());
  const std::string busy = "while :; do :; done";
  BOOST_TEST(run_program({"/bin/sh", "-c", busy}, folder.path(), 1s).timed_out);
  BOOST_TEST(
      run_program({"/bin/sh", "-c", "sh -c '" + busy + "'; exit 1"}, folder.path(), 1s).timed_out);
}

BOOST_AUTO_TEST_CASE(what_a_program_leaves_running_is_stopped_with_it) {
  const PrivateFolder folder;
  const std::string child = "(sleep 1; touch " + (folder.path() / "late").string() + ") & exit 0";
  BOOST_TEST(run_program({"/bin/sh", "-c", child}, folder.path(), 10s).succeeded());
  run_program({"/bin/sleep", "1.3"}, folder.path(), 10s);
  BOOST_TEST(!fs::exists(folder.path() / "late"));
}

BOOST_AUTO_TEST_CASE(temporary_files_of_a_program_are_in_its_folder) {
  const PrivateFolder folder;
  const ProgramResult result = run_program({"/bin/sh", "-c", "echo $TMPDIR"}, folder.path(), 10s);
  BOOST_TEST(result.output == folder.path().string() + "\n");
}

BOOST_AUTO_TEST_CASE(a_program_has_limits_and_no_files_of_ours) {
  const PrivateFolder folder;
  // In units of 1024 bytes.
  const ProgramResult limits = run_program(
      {"/bin/bash", "-c", "ulimit -v; ulimit -f; ulimit -c; ulimit -t"}, folder.path(), 10s);
  BOOST_TEST(limits.output == "4194304\n1048576\n0\n10\n");
  BOOST_TEST(run_program({"/bin/bash", "-c", "ulimit -v"}, folder.path(), 10s, 1 << 30).output ==
             "1048576\n");
  // Its three streams, and the folder that ls itself has open.
  const ProgramResult open = run_program({"/bin/ls", "/proc/self/fd"}, folder.path(), 10s);
  BOOST_TEST(open.output == "0\n1\n2\n3\n");
}

BOOST_AUTO_TEST_CASE(what_is_no_program_is_an_error) {
  const PrivateFolder folder;
  BOOST_CHECK_THROW(run_program({folder.path() / "absent"}, folder.path(), 10s), std::system_error);
}

BOOST_AUTO_TEST_CASE(output_without_end_does_not_fill_the_memory) {
  const PrivateFolder folder;
  const ProgramResult result =
      run_program({"/usr/bin/head", "-c", "3000000", "/dev/zero"}, folder.path(), 10s);
  BOOST_TEST(result.output.size() == 1u << 20);
}

BOOST_AUTO_TEST_CASE(private_folders_are_private_and_removed) {
  fs::path path;
  {
    const PrivateFolder folder, other;
    path = folder.path();
    BOOST_TEST(path != other.path());
    struct stat status {};
    BOOST_TEST(stat(path.c_str(), &status) == 0);
    BOOST_TEST((status.st_mode & 0777) == 0700u);
    vcrit::write_file(path / "deep" / "file", "text");
  }
  BOOST_TEST(!fs::exists(path));
}

BOOST_AUTO_TEST_CASE(without_a_compiler_there_is_none) {
  const PrivateFolder folder;
  BOOST_TEST(!find_compiler("").has_value());
  BOOST_TEST(!find_compiler(folder.path().string()).has_value());
  BOOST_TEST(!find_compiler(".:relative").has_value());
}

BOOST_AUTO_TEST_CASE(the_first_folder_with_an_executable_compiler_counts) {
  const PrivateFolder folder;
  const fs::path first = folder.path() / "first", second = folder.path() / "second";
  vcrit::write_file(first / "g++", "not executable");
  fs::permissions(first / "g++", fs::perms::owner_read);
  vcrit::write_file(second / "g++", "#!/bin/sh\n");
  fs::permissions(second / "g++", fs::perms::owner_all);
  const auto found = find_compiler(first.string() + ":" + second.string());
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(*found == second / "g++");
}

BOOST_AUTO_TEST_CASE(a_program_is_compiled_and_runs) {
  const auto compiler = find_compiler();
  BOOST_REQUIRE(compiler.has_value());
  const PrivateFolder folder;
  vcrit::write_file(folder.path() / "a.cpp",
                    "#include <cstdio>\nint main() { std::puts(\"42\"); }\n");
  BOOST_TEST(compile(*compiler, folder.path(), "a.cpp", "a", {"-O2"}).succeeded());
  BOOST_TEST(run_program({folder.path() / "a"}, folder.path(), 10s).output == "42\n");
  BOOST_TEST(!describe_compiler(*compiler, folder.path()).empty());
}

BOOST_AUTO_TEST_CASE(what_a_compiler_complains_about_comes_back) {
  const auto compiler = find_compiler();
  BOOST_REQUIRE(compiler.has_value());
  const PrivateFolder folder;
  vcrit::write_file(folder.path() / "b.cpp", "int main() { return nonsense; }\n");
  const ProgramResult result = compile(*compiler, folder.path(), "b.cpp", "b", {});
  BOOST_TEST(!result.succeeded());
  BOOST_TEST(result.output.find("nonsense") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
