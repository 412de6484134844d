// Whole files: written or not written, never half.
#include <sys/stat.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/numbers.hpp"
#include "base/output_places.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_files)

using namespace vcrit;
namespace fs = std::filesystem;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("vcrit_files_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

BOOST_FIXTURE_TEST_CASE(what_is_written_is_read, Folder) {
  write_file(path / "new" / "file.txt", "one\ntwo\0three");
  BOOST_TEST(read_file(path / "new" / "file.txt") == "one\ntwo");
  write_file(path / "new" / "file.txt", "again");
  BOOST_TEST(read_file(path / "new" / "file.txt") == "again");
  BOOST_TEST(std::distance(fs::directory_iterator(path / "new"), {}) == 1);
}

BOOST_FIXTURE_TEST_CASE(a_missing_file_meets_the_nearest_one, Folder) {
  const auto message = [this](const char* name) {
    return test::refusal([&] { read_file(path / name); });
  };
  write_file(path / "zener.toml", "");
  write_file(path / "zener.csv", "");
  const std::string meant = "did you mean " + (path / "zener.toml").string() + "?";
  BOOST_TEST(test::has(message("zenner.toml"), "zenner.toml: found no such file; expected a file"));
  BOOST_TEST(test::has(message("zenner.toml"), meant));
  BOOST_TEST(test::has(message("zener"), "did you mean"));
  BOOST_TEST(!test::has(message("burgers.toml"), "did you mean"));
  BOOST_TEST(!test::has(message("zener.txt"), "did you mean"));
  fs::create_directories(path / "folder.toml");
  BOOST_TEST(test::has(message("folder.toml"), "found a folder; expected a file"));
  BOOST_TEST(
      test::has(test::refusal([&] { read_file(path / "none" / "a.toml"); }), "no such file"));
}

BOOST_FIXTURE_TEST_CASE(a_place_that_cannot_be_written_is_named_and_left_clean, Folder) {
  fs::create_directories(path / "taken" / "inside");
  BOOST_CHECK_THROW(write_file(path / "taken", "text"), InputError);
  BOOST_TEST(std::distance(fs::directory_iterator(path), {}) == 1);
  write_file(path / "file", "text");
  BOOST_CHECK_THROW(write_file(path / "file" / "below", "text"), InputError);
}

BOOST_FIXTURE_TEST_CASE(folders_made_for_what_cannot_be_written_are_gone, Folder) {
  fs::create_directories(path / "taken" / "inside");
  BOOST_CHECK_THROW(write_files({{path / "new" / "deep" / "one", "1"},
                                 {path / "new" / "other" / "two", "2"},
                                 {path / "taken", "3"}}),
                    InputError);
  BOOST_TEST(std::distance(fs::directory_iterator(path), {}) == 1);
  // One that was there before stays, and one that somebody else has put something into.
  BOOST_CHECK_THROW(write_files({{path / "taken" / "one", "1"}, {path / "taken", "3"}}),
                    InputError);
  BOOST_TEST(fs::exists(path / "taken" / "inside"));
  write_file(path / "new" / "." / "deep" / ".." / "deep" / "one", "1");
  BOOST_TEST(read_file(path / "new" / "deep" / "one") == "1");
  BOOST_TEST(test::has(test::refusal([&] { write_file(path / "new" / "deep" / "one" / "x", "1"); }),
                       "found Not a directory"));
}

BOOST_FIXTURE_TEST_CASE(either_all_files_of_a_set_are_new_or_none, Folder) {
  write_file(path / "a", "old");
  // The last one cannot be written: a file is where its folder should be, or a folder where it
  // should be.
  BOOST_CHECK_THROW(write_files({{path / "a", "new"}, {path / "a" / "below", "new"}}), InputError);
  fs::create_directories(path / "taken");
  BOOST_CHECK_THROW(write_files({{path / "a", "new"}, {path / "taken", "new"}}), InputError);
  BOOST_TEST(read_file(path / "a") == "old");
  BOOST_TEST(std::distance(fs::directory_iterator(path), {}) == 2);
  write_files({{path / "a", "new"}, {path / "b" / "c", "new"}});
  BOOST_TEST(read_file(path / "a") + read_file(path / "b" / "c") == "newnew");
}

BOOST_FIXTURE_TEST_CASE(neither_a_link_nor_what_stands_beside_the_place_is_written_over, Folder) {
  write_file(path / "outside", "theirs");
  const std::string part = "file.part" + std::to_string(::getpid());
  fs::create_symlink(path / "outside", path / part);
  fs::create_symlink(path / "outside", path / "file");
  write_file(path / "file", "ours");
  BOOST_TEST(read_file(path / "outside") == "theirs");
  BOOST_TEST(!fs::is_symlink(path / "file"));
  BOOST_TEST(read_file(path / "file") == "ours");
  BOOST_TEST(fs::is_symlink(path / part));
}

// --out /dev/null of root put a file in place of the device. Pipes stand for devices here, which no
// test should risk.
BOOST_FIXTURE_TEST_CASE(what_is_no_file_is_not_replaced, Folder) {
  const fs::path pipe = path / "pipe", link = path / "link", stream = path / "stream";
  BOOST_REQUIRE(::mkfifo(pipe.c_str(), 0666) == 0);
  fs::create_symlink(pipe, link);
  fs::create_symlink("/proc/self/fd/1", stream);
  for (const fs::path& place : {pipe, link, stream})
    BOOST_TEST(test::has(test::refusal([&] { write_file(place, "text"); }),
                         "found a device, a pipe or a socket; expected the name of a file"));
  BOOST_TEST(fs::is_fifo(pipe));
  BOOST_TEST(fs::is_symlink(link));
  BOOST_TEST(fs::is_symlink(stream));
  BOOST_TEST(std::distance(fs::directory_iterator(path), {}) == 3);
}

BOOST_FIXTURE_TEST_CASE(what_a_result_is_made_from_stays, Folder) {
  write_file(path / "data", "theirs");
  fs::create_symlink(path / "data", path / "link");
  for (const char* const place : {"data", "link"})
    BOOST_TEST(
        test::has(test::refusal([&] { refuse_input_as_output(path / place, {path / "data"}); }),
                  "found a file that this result is made from; expected another name"));
  refuse_input_as_output(path / "other", {path / "data", path / "none"});
}

BOOST_FIXTURE_TEST_CASE(a_missing_file_is_wrong_input, Folder) {
  BOOST_CHECK_THROW(read_file(path / "none"), InputError);
  BOOST_CHECK_THROW(read_file(path), InputError);
}

BOOST_FIXTURE_TEST_CASE(a_file_larger_than_asked_for_is_wrong_input, Folder) {
  write_file(path / "file", std::string(100000, 'x'));
  BOOST_TEST(read_file(path / "file", 100000).size() == 100000u);
  BOOST_CHECK_THROW(read_file(path / "file", 99999), InputError);
  BOOST_CHECK_THROW(read_file("/dev/zero", 100000), InputError);
}

BOOST_AUTO_TEST_CASE(numbers_read_back_to_the_same_double) {
  for (const double value : {0.1, 1e-310, 5e-324, 1.7976931348623157e308, 1.0 / 3, 2e6})
    BOOST_TEST(to_double(to_text(value)).value() == value);
  BOOST_TEST(!to_double("1,5").has_value());
  BOOST_TEST(!to_double("1.5x").has_value());
  BOOST_TEST(!to_double("").has_value());
}

BOOST_AUTO_TEST_SUITE_END()
