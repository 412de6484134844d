// Axes as a user writes them.
#include "sweep/axis.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "scene/scene.hpp"
#include "support/program.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_axis)

namespace {

using namespace vcrit;
using test::has;

Scene kelvin() { return read_scene(VCRIT_SCENES "/kelvin.toml"); }

std::vector<double> values(const std::string& text) { return parse_axis(text, kelvin()).values; }

std::string message(const std::string& text) {
  return test::refusal([&] { parse_axis(text, kelvin()); });
}

BOOST_AUTO_TEST_CASE(even_steps_with_both_ends) {
  BOOST_TEST((values("velocity_ratio=lin:0.1:1.1:11") ==
              std::vector{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1}));
  BOOST_TEST((values("velocity=lin:3:1:3") == std::vector{3.0, 2.0, 1.0}));
  BOOST_TEST((values("velocity=lin:3:1:1") == std::vector{3.0}));
}

BOOST_AUTO_TEST_CASE(even_ratios_with_units) {
  const Axis axis = parse_axis("frequency=log:1 kHz:1MHz:4", kelvin());
  BOOST_TEST(axis.name == "frequency");
  BOOST_TEST((axis.values == std::vector{1e3, 1e4, 1e5, 1e6}));
  const std::vector<double> uneven = values("amplitude=log:3e-9:7e-6:50");
  BOOST_TEST(uneven.front() == 3e-9);
  BOOST_TEST(uneven.back() == 7e-6);
  // 15 digits of each value: 5e-15 of each at most.
  for (std::size_t i = 1; i < 50; ++i)
    BOOST_TEST(std::abs(uneven[i] / uneven[i - 1] / std::pow(7e-6 / 3e-9, 1 / 49.0) - 1) < 1e-14);
}

// 15 digits of the largest double are beyond it.
BOOST_AUTO_TEST_CASE(values_up_to_the_largest_double) {
  const std::string largest = "1.7976931348623157e308";
  BOOST_TEST((values("velocity=lin:" + largest + ":" + largest + ":3") ==
              std::vector<double>(3, 1.7976931348623157e308)));
  const std::vector<double> narrow = values("velocity=lin:0.1:0.10000000000000003:3");
  BOOST_TEST(narrow[1] >= narrow[0]);
  BOOST_TEST(narrow[1] <= narrow[2]);
}

BOOST_AUTO_TEST_CASE(values_from_a_file) {
  const test::PrivateFolder folder;
  const auto file = folder.path() / "values.txt";
  std::ofstream(file) << "# measured\n1 kHz  # first\n\n  20e3\r\n0.5 MHz";
  const Axis axis = parse_axis("frequency=list:" + file.string(), kelvin());
  BOOST_TEST((axis.values == std::vector{1e3, 20e3, 5e5}));
  std::ofstream(file) << "1\n2 m\n";
  BOOST_TEST(has(message("frequency=list:" + file.string()), "values.txt:2: found"));
  std::ofstream(file) << "# none\n";
  BOOST_TEST(has(message("frequency=list:" + file.string()), "no values"));
  BOOST_TEST(has(message("frequency=list:/nowhere/list"), "no such file"));
  // As Windows saves it.
  std::ofstream(file) << "\xEF\xBB\xBF"
                      << "1 kHz\r\n2 kHz\r\n";
  BOOST_TEST((parse_axis("frequency=list:" + file.string(), kelvin()).values ==
              std::vector<double>{1000, 2000}));
  std::ofstream(file) << "\xFF\xFE"
                      << "1";
  BOOST_TEST(has(message("frequency=list:" + file.string()), "a table in UTF-16"));
}

BOOST_AUTO_TEST_CASE(mistakes_are_named) {
  for (const char* text :
       {"velocity", "velocity=1:2:3", "velocity=lin:1:2:3:4", "velocity=sin:1:2:3"})
    BOOST_TEST(has(message(text), "expected NAME=lin|log:FROM:TO:N"), text);
  BOOST_TEST(has(message("velocty=lin:1:2:3"), "expected \"velocity\""));
  BOOST_TEST(has(message("velocity=lin:1 N:2:3"), "a velocity in m/s"));
  BOOST_TEST(has(message("velocity=log:0:2:3"), "both ends above 0"));
  for (const char* text : {"velocity=lin:1:2:0", "velocity=lin:1:2:", "velocity=lin:1:2:3.5",
                           "velocity=lin:1:2:-3", "velocity=lin:1:2:9999999999"})
    BOOST_TEST(has(message(text), "a whole number from 1 to"), text);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
