// What a scene says of a contact that opens and of the shape of an indenter, and one clear message
// for what is wrong.
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <numbers>

#include "problem/variation.hpp"
#include "scene/scene.hpp"
#include "support/program.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_indenter_section)

using namespace vcrit;
using test::has;

namespace {

std::string scene_of(const std::string& contact, const std::string& rest) {
  return "[contact]\nnormal = \"k | c\"\n" + contact +
         "\n[oscillation]\nangular_frequency = 2.0\n" +
         "amplitude = 0.1\nindentation = 0.5\n[friction]\ncoefficient = 0.25\n[elements]\n" + rest;
}

const std::string elements = "k = \"5 GPa\"\nc = \"3 Pa.s\"\n";

Scene with_indenter(const std::string& indenter, const Settings& settings = {}) {
  return parse_scene(scene_of("poisson = 0.3", elements + "[indenter]\n" + indenter), "s.toml",
                     settings);
}

std::string message(const std::string& text) {
  return test::refusal([&] { parse_scene(text, "s.toml"); });
}

std::string indenter_message(const std::string& indenter) {
  return message(scene_of("poisson = 0.3", elements + "[indenter]\n" + indenter));
}

}  // namespace

BOOST_AUTO_TEST_CASE(contacts_open_only_where_the_scene_says_so) {
  const auto separation = [](const std::string& line) {
    return parse_scene(scene_of("poisson = 0.3\n" + line, "k = 1.0\nc = 1.0\n"), "s.toml")
        .separation;
  };
  BOOST_TEST(!separation(""));
  BOOST_TEST(!separation("separation = false"));
  BOOST_TEST(separation("separation = true"));
  BOOST_TEST(message(scene_of("poisson = 0.3\nseparation = \"yes\"", "")) ==
             "s.toml:4:14: found separation = \"yes\"; expected true or false");
}

BOOST_AUTO_TEST_CASE(shapes_have_their_sizes) {
  using Shape = Indenter::Shape;
  const Scene parabola = with_indenter("shape = \"parabola\"\nradius = \"10 mm\"\n");
  BOOST_REQUIRE(parabola.indenter.has_value());
  BOOST_TEST((parabola.indenter->shape == Shape::parabola));
  BOOST_TEST(parabola.indenter->sizes.front().value.value() == 0.01);
  const Scene cone = with_indenter("shape = \"cone\"\nangle = \"45 deg\"\n");
  BOOST_TEST((cone.indenter->shape == Shape::cone));
  // One rounding of udunits' degree.
  BOOST_TEST(std::abs(cone.indenter->sizes.front().value.value() - std::numbers::pi / 4) <=
             1.2e-16);
  const Scene power = with_indenter("shape = \"power\"\nprefactor = 3\nexponent = 2.5\n");
  BOOST_TEST((power.indenter->shape == Shape::power));
  BOOST_TEST(power.indenter->sizes[0].value.value() == 3);
  BOOST_TEST(power.indenter->sizes[1].value.value() == 2.5);
  BOOST_TEST((with_indenter("shape = \"flat\"\nradius = 1\n").indenter->shape == Shape::flat));
}

// The half-space is given by its moduli, in Pa and Pa s.
BOOST_AUTO_TEST_CASE(networks_are_moduli) {
  const Scene scene = with_indenter("shape = \"parabola\"\nradius = \"10 mm\"\n");
  const Values values = resolve(scene).values();
  BOOST_TEST(values.at({"k"}) == 5e9);
  BOOST_TEST(values.at({"c"}) == 3);
  BOOST_TEST(values.at({"radius"}) == 0.01);
  BOOST_TEST(
      has(message(scene_of("poisson = 0.3",
                           "k = \"8 N/um\"\n[indenter]\nshape = \"flat\"\nradius = 1\n")),
          "s.toml:11:5: found \"8 N/um\" (a unit of another dimension); expected a modulus in Pa"));
  BOOST_TEST(has(
      message(scene_of("poisson = 0.3", "k = \"5 GPa\"\n")),
      "s.toml:11:5: found \"5 GPa\" (a unit of another dimension); expected a stiffness in N/m"));
}

BOOST_AUTO_TEST_CASE(sizes_can_be_set_and_swept) {
  const std::string shape = "shape = \"parabola\"\nradius = \"10 mm\"\n";
  BOOST_TEST(with_indenter(shape, {{"radius", "2 cm"}}).indenter->sizes.front().value.value() ==
             0.02);
  const Variation varied(with_indenter(shape), {"radius"});
  const double radius = 0.5;
  BOOST_TEST(varied.at({&radius, 1})->indenter->sizes.front().value.value() == 0.5);
  const Scene open = with_indenter("shape = \"cone\"\n");
  BOOST_CHECK_THROW(resolve(open).values(), InputError);
}

BOOST_AUTO_TEST_CASE(a_table_is_read) {
  const test::PrivateFolder folder;
  const auto read = [&](const std::string& table) {
    std::ofstream(folder.path() / "tip.csv") << table;
    const std::string file = (folder.path() / "s.toml").string();
    std::ofstream(file) << scene_of("poisson = 0.3",
                                    elements + "[indenter]\nshape = \"tip.csv\"\n");
    try {
      const Scene scene = read_scene(file);
      return std::to_string(scene.indenter.value().profile.value().rows.size());
    } catch (const InputError& error) {
      const std::string what = error.what(), path = folder.path().string() + "/";
      return what.starts_with(path) ? what.substr(path.size()) : what;
    }
  };
  BOOST_TEST(read("r, f\r\n0,0\n1e-3,2e-6\n2e-3,5e-6\n") == "3");
  BOOST_TEST(
      read("r,f\n0,0\n") ==
      "tip.csv:2: found one row of numbers; expected at least two rows: the tip and the outer "
      "radius");
  std::string long_table = "r,f\n";
  for (int i = 0; i <= 2000; ++i) long_table += std::to_string(i) + ",0\n";
  BOOST_TEST(
      read(long_table) ==
      "tip.csv:2002: found more than 2000 rows; expected at most so many: each is a place where "
      "the contact changes");
  BOOST_TEST(read("r,h\n0,0\n") == "tip.csv:1: found \"r,h\"; expected the header r,f");
  BOOST_TEST(read("r,f\n1,0\n2,1\n") ==
             "tip.csv:2: found r = 1, f = 0 first; expected 0,0: the tip of the indenter");
  BOOST_TEST(read("r,f\n0,0\n2,1\n2,2\n") ==
             "tip.csv:4: found r = 2 after 2; expected r increasing from row to row");
  BOOST_TEST(read("r,f\n0,0\n2,1\n3,0.5\n") ==
             "tip.csv:4: found f = 0.5 after 1; expected f that never decreases: one contact area "
             "without holes");
}

BOOST_AUTO_TEST_CASE(wrong_indenters) {
  const std::string expected =
      ", which is no file; expected flat, cone, parabola, power, or a table "
      "in CSV with the header r,f";
  BOOST_TEST(indenter_message("shape = \"sphere\"\nradius = 1\n")
                 .ends_with("sphere\"" + expected +
                            "; close to the contact a sphere is a parabola of its radius: shape = "
                            "\"parabola\""));
  BOOST_TEST(indenter_message("shape = \"parabla\"\nradius = 1\n")
                 .ends_with("parabla\"" + expected + "; did you mean \"parabola\"?"));
  BOOST_TEST(indenter_message("shape = \"tip.csv\"\n").ends_with("tip.csv\"" + expected));
  BOOST_TEST(
      indenter_message("shape = \"cone\"\nradius = 1\n") ==
      "s.toml:15:10: found radius beside shape = \"cone\"; expected for cone no keys but shape, "
      "angle");
  BOOST_TEST(indenter_message("shape = \"cone\"\nangle = \"95 deg\"\n")
                 .find("expected an angle between 0 and 90 deg") != std::string::npos);
  BOOST_TEST(indenter_message("shape = \"parabola\"\nradius = 0\n") ==
             "s.toml:15:10: found radius = 0; expected a finite value above 0");
  const std::string flat = "[indenter]\nshape = \"flat\"\nradius = 1\n";
  BOOST_TEST(
      message(scene_of("tangential_ratio = 0.8", elements + flat)) ==
      "s.toml:13:1: found [indenter] without poisson; expected poisson = ... in [contact], of the "
      "half-space whose Young's modulus normal = \"...\" is");
  // Below an indenter k is a modulus, and in the drive a spring.
  const std::string drive = "[drive]\nnetwork = \"kd\"\n";
  BOOST_TEST(message(scene_of("poisson = 0.3", "kd = \"2 N/mm\"\n" + elements + flat + drive)) ==
             "accepted");
  BOOST_TEST(message(scene_of("poisson = 0.3", "kd = \"2 GPa\"\n" + elements + flat + drive))
                 .find("found \"2 GPa\"") != std::string::npos);
  std::string clash = scene_of("poisson = 0.3", "radius = 5.0\n" + flat);
  clash.replace(clash.find("k | c"), 5, "spring(radius)");
  BOOST_TEST(message(clash).find("it is a quantity of the scene") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
