// Tables of a measured drive: what is read, where an angular frequency lies, and one clear message
// with file and line for what is wrong.
#include <boost/test/unit_test.hpp>
#include <fstream>

#include "scene/receptance.hpp"
#include "scene/scene.hpp"
#include "support/program.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_receptance)

using namespace vcrit;

struct Table {
  test::PrivateFolder folder;

  Receptance read(const std::string& text) const {
    std::ofstream(folder.path() / "r.csv") << text;
    return read_receptance(folder.path() / "r.csv", {"s.toml", 5, 14});
  }
  /// The message without the folder.
  std::string message(const std::string& text) const {
    const std::string what = test::refusal([&] { read(text); }),
                      path = folder.path().string() + "/";
    return what.starts_with(path) ? what.substr(path.size()) : what;
  }
};

BOOST_FIXTURE_TEST_CASE(a_table_is_read, Table) {
  const Receptance r = read("omega, Re, Im\r\n0,1e-6,-2e-7\r\n\r\n10.5 , 2e-6, -0\n");
  BOOST_REQUIRE(r.rows.size() == 2);
  BOOST_TEST(r.rows[0].re == 1e-6);
  BOOST_TEST(r.rows[0].im == -2e-7);
  BOOST_TEST(r.rows[1].omega == 10.5);
}

BOOST_FIXTURE_TEST_CASE(an_angular_frequency_lies_on_a_row_or_between_two, Table) {
  const Receptance r = read("omega,Re,Im\n1,10,0\n2,20,0\n4,40,0\n");
  const auto between = [&](double omega) {
    const Bracket found = bracket(r, omega);
    return std::pair(found.below.omega, found.above.omega);
  };
  BOOST_TEST((between(1) == std::pair(1.0, 1.0)));
  BOOST_TEST((between(1.5) == std::pair(1.0, 2.0)));
  BOOST_TEST((between(2) == std::pair(2.0, 2.0)));
  BOOST_TEST((between(3.9) == std::pair(2.0, 4.0)));
  BOOST_TEST((between(4) == std::pair(4.0, 4.0)));
  BOOST_CHECK_THROW(bracket(r, 0.999), ModelError);
  BOOST_CHECK_THROW(bracket(r, 4.001), ModelError);
}

BOOST_FIXTURE_TEST_CASE(wrong_tables, Table) {
  const std::string units =
      "omega in rad/s, and Re and Im of displacement over force in m/N; of an amplitude A and a "
      "phase p they are A cos p and A sin p";
  BOOST_TEST(message("w,Re,Im\n1,2,3\n") ==
             "r.csv:1: found \"w,Re,Im\"; expected the header omega,Re,Im; " + units);
  BOOST_TEST(message("") ==
             "r.csv: found an empty table; expected the header omega,Re,Im; " + units);
  BOOST_TEST(
      message("omega,Re,Im\n") ==
      "r.csv:1: found no row of numbers; expected at least two rows, to interpolate between them");
  BOOST_TEST(
      message("omega,Re,Im\n1,2,3\n") ==
      "r.csv:2: found one row of numbers; expected at least two rows, to interpolate between them");
  BOOST_TEST(message("omega,Re,Im\n1,2,3\n\n2,x,3\n") ==
             "r.csv:4: found \"x\"; expected a finite number");
  BOOST_TEST(message("omega,Re,Im\n1,nan,3\n2,1,3\n") ==
             "r.csv:2: found \"nan\"; expected a finite number");
  BOOST_TEST(message("omega,Re,Im\n1,inf,3\n2,1,3\n") ==
             "r.csv:2: found \"inf\"; expected a finite number");
  BOOST_TEST(message("omega,Re,Im\n1,2\n") ==
             "r.csv:2: found \"1,2\"; expected three numbers: omega, Re, Im");
  BOOST_TEST(message("omega,Re,Im\n1,2,3,4\n") ==
             "r.csv:2: found \"1,2,3,4\"; expected three numbers: omega, Re, Im");
  BOOST_TEST(message("omega,Re,Im\n1,2,3,\n") ==
             "r.csv:2: found \"1,2,3,\"; expected three numbers: omega, Re, Im");
  BOOST_TEST(message("omega,Re,Im\n1,2,3\n1,2,3\n") ==
             "r.csv:3: found omega = 1 after 1; expected omega increasing from row to row");
  BOOST_TEST(message("omega,Re,Im\n-1,2,3\n1,2,3\n") ==
             "r.csv:2: found omega = -1; expected an omega of at least 0");
}

BOOST_FIXTURE_TEST_CASE(a_scene_names_its_table_relative_to_itself, Table) {
  std::ofstream(folder.path() / "r.csv") << "omega,Re,Im\n1,2,-3\n2,2,-3\n";
  const std::string file = (folder.path() / "s.toml").string();
  const std::string contact = "[contact]\nnormal = \"kn\"\npoisson = 0.3\n[drive]\n";
  const Scene scene = parse_scene(contact + "receptance = \"r.csv\"\n[body]\nmass = 1\n", file);
  BOOST_TEST(scene.receptance.value().rows.size() == 2);
  BOOST_TEST(!scene.drive.has_value());
  BOOST_TEST(scene.mass.has_value());
  const auto message = [&](const std::string& drive) {
    return test::refusal([&] { parse_scene(contact + drive, file); });
  };
  using test::has;
  BOOST_TEST(has(message("receptance = \"none.csv\"\n"), "s.toml:5:14: found receptance = "));
  BOOST_TEST(has(message("receptance = \"none.csv\"\n"), "which is no file"));
  BOOST_TEST(has(message("receptance = 3\n"),
                 "s.toml:5:14: found receptance = 3; expected a text in quotes"));
  BOOST_TEST(has(message("network = \"kd\"\nreceptance = \"r.csv\"\n"),
                 "s.toml:6:14: found network and receptance; expected one of the two"));
}

BOOST_AUTO_TEST_SUITE_END()
