// A contact that was measured: its keys, its table, and the numbers that follow omega.
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <string>

#include "base/errors.hpp"
#include "problem/problem.hpp"
#include "problem/variation.hpp"
#include "support/program.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_measured_contact)

using namespace vcrit;

namespace {

const std::string pad = "omega,storage,loss\n1,8,1\n3,16,2\n5,16,4\n";
const std::string table = "dynamic_stiffness = \"pad.csv\"\nstatic_stiffness = \"6 N/m\"\n";

}  // namespace

struct Contact {
  test::PrivateFolder folder;

  Contact() { write(pad); }
  void write(const std::string& text, const std::string& name = "pad.csv") const {
    std::ofstream(folder.path() / name) << text;
  }
  Problem read(const std::string& contact, const std::string& rest = "",
               const Settings& settings = {}) const {
    return parse_problem(
        "[contact]\n" + contact +
            "[oscillation]\nangular_frequency = \"2 rad/s\"\namplitude = \"1 um\"\n"
            "indentation = \"9 um\"\n[friction]\ncoefficient = 0.3\n" +
            rest,
        folder.path() / "s.toml", settings);
  }
  /// The message without the folder.
  std::string message(const std::string& contact, const std::string& rest = "",
                      const Settings& settings = {}) const {
    const std::string what = test::refusal([&] { read(contact, rest, settings).values(); }),
                      path = folder.path().string() + "/";
    return what.starts_with(path) ? what.substr(path.size()) : what;
  }
};

// At 2 rad/s K = 12 + 1.5 i, at a row that row's.
BOOST_FIXTURE_TEST_CASE(storage_and_loss_are_linear_between_rows, Contact) {
  const Problem problem = read(table + "poisson = 0.3\n");
  BOOST_TEST(problem.values().at({"k_n"}) == 12);
  BOOST_TEST(problem.values().at({"eta_n"}) == 0.125);
  BOOST_TEST(problem.values().at({"k_n0"}) == 6);
  const Problem other = problem.with({{{"omega"}, 5}});
  BOOST_TEST(other.values().at({"k_n"}) == 16);
  BOOST_TEST(other.values().at({"eta_n"}) == 0.25);
  BOOST_TEST(Variation(problem, {"omega"}).at(std::vector{3.0}).values().at({"eta_n"}) == 0.125);
}

BOOST_FIXTURE_TEST_CASE(outside_the_table_nothing_is_known, Contact) {
  const Problem problem = read(table + "poisson = 0.3\n");
  for (const double omega : {0.999, 5.001})
    BOOST_CHECK_THROW(problem.with({{{"omega"}, omega}}).values(), ModelError);
  const Problem beyond = problem.with({{{"omega"}, 6}});
  BOOST_CHECK_EXCEPTION(beyond.values(), ModelError, [](const ModelError& error) {
    return std::string(error.what()).starts_with("0.9549 Hz is outside the measured stiffness in ");
  });
}

BOOST_FIXTURE_TEST_CASE(tangentially_too_and_in_the_units_of_its_header, Contact) {
  write("frequency [Hz],storage [N/um],tan_delta\n0.1,2,0\n1,2,0.5\n10,2,0.5\n", "t.csv");
  const Problem problem = read(table + "tangential_dynamic_stiffness = \"t.csv\"\n", "",
                               {{"frequency", "1"}, {"k_n0", "7"}});
  BOOST_TEST(problem.known_values().at({"k_t"}) == 2e6);
  BOOST_TEST(problem.known_values().at({"eta_t"}) == 0.5);
  BOOST_TEST(problem.known_values().at({"k_n0"}) == 7);
  const Problem below =
      read("normal = \"k\"\ntangential_dynamic_stiffness = \"t.csv\"\n", "[elements]\nk = 5\n");
  BOOST_TEST(!below.known_values().contains({"k_n0"}));
}

BOOST_FIXTURE_TEST_CASE(without_its_stiffness_at_rest_that_is_missing, Contact) {
  BOOST_TEST(message("dynamic_stiffness = \"pad.csv\"\npoisson = 0.3\n") ==
             "s.toml: found no value for k_n0; expected a number for each, in the scene or by `set "
             "NAME=VALUE`; k_n0 is static_stiffness in [contact]");
}

BOOST_FIXTURE_TEST_CASE(wrong_keys, Contact) {
  BOOST_TEST(
      message("normal = \"k\"\n" + table + "poisson = 0.3\n") ==
      "s.toml:3:21: found normal and dynamic_stiffness; expected one of the two in [contact]");
  BOOST_TEST(message("normal = \"k\"\nstatic_stiffness = 5\npoisson = 0.3\n") ==
             "s.toml:3:20: found static_stiffness without dynamic_stiffness; expected "
             "dynamic_stiffness = \"TABLE.csv\", which it is of; a network has its own");
  BOOST_TEST(message("dynamic_stiffness = \"pad.csv\"\nstatic_stiffness = 0\npoisson = 0.3\n") ==
             "s.toml:3:20: found static_stiffness = 0; expected a finite value above 0");
  BOOST_TEST(
      message("dynamic_stiffness = \"none.csv\"\npoisson = 0.3\n").find("which is no file") !=
      std::string::npos);
  BOOST_TEST(
      message(table + "poisson = 0.3\n", "[elements]\nk_n = 5\n") ==
      "s.toml:12:7: found \"k_n\", a number of the measured contact; expected another name of "
      "the element");
  BOOST_TEST(message(table + "poisson = 0.3\n", "[drive]\nnetwork = \"k_n\"\n") ==
             "s.toml:12:11: found \"k_n\", a number of the measured contact; expected another name "
             "of the element");
  BOOST_TEST(
      message(table + "poisson = 0.3\n", "", {{"k_n", "5"}}) ==
      "set k_n: found k_n, which is in the table pad.csv; expected another table, or normal = "
      "\"...\", a network of elements to set");
  BOOST_TEST(message(table + "poisson = 0.3\n", "[indenter]\nshape = \"flat\"\nradius = 1\n") ==
             "s.toml:11:1: found [indenter] with a measured stiffness; expected a network of the "
             "half-space's modulus in [contact]");
}

BOOST_FIXTURE_TEST_CASE(wrong_rows, Contact) {
  write("omega,storage,loss\n1,8,1\n2,8,-0.1\n3,8,1\n");
  BOOST_TEST(message(table + "poisson = 0.3\n") ==
             "pad.csv:3: found a loss stiffness of -0.1 N/m; expected at least 0 in each row: a "
             "contact below that gives energy; leave out the row, or fit a network: vcrit fit");
  write("omega,storage,loss\n1,8,1\n2,0,1\n3,8,1\n");
  BOOST_TEST(
      message(table + "poisson = 0.3\n") ==
      "pad.csv:3: found a storage stiffness of 0 N/m; expected one above 0 in each row; leave "
      "out the row, or fit a network: vcrit fit");
  write("omega [Hz],storage,loss\n1,8,1\n2,8,1\n3,8,1\n");
  BOOST_TEST(message(table + "poisson = 0.3\n").find("pad.csv:1: ") == 0U);
}

BOOST_AUTO_TEST_SUITE_END()
