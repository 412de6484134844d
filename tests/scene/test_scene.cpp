// Scenes: what is read, what is left out, and one clear message for what is wrong.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "network/expression.hpp"
#include "problem/problem.hpp"
#include "scene/scene.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_scene)

using namespace vcrit;
using test::has;

namespace {

const std::string oscillation =
    "[oscillation]\nfrequency = \"20 kHz\"\namplitude = \"0.1 um\"\nindentation = \"0.5 um\"\n";
const std::string friction = "[friction]\ncoefficient = 0.3\n";

Scene scene(const std::string& text, const Settings& settings = {}) {
  return parse_scene(text, "s.toml", settings);
}

std::string message(const std::string& text, const Settings& settings = {}) {
  return test::refusal([&] { resolve(scene(text, settings)).values(); });
}

bool warns(const Scene& s, const std::string& part) {
  for (const std::string& warning : s.warnings)
    if (warning.find(part) != std::string::npos) return true;
  return false;
}

Network k(const std::string& name) { return spring({name}); }
Network c(const std::string& name) { return damper({name}); }

/// A contact with one more line.
std::string contact(const std::string& normal, const std::string& line = "poisson = 0.3") {
  return "[contact]\nnormal = \"" + normal + "\"\n" + line + "\n";
}

const std::string kelvin = "[contact]\nnormal = \"kn | cn\"\ntangential = \"kt | ct\"\n";
const std::string kelvin_values = "[elements]\nkn = 4e6\ncn = 10\nkt = \"3 N/um\"\nct = 7\n";
const std::string bridge = contact("bridge") + "[networks.bridge]\nterminals = [\"a\", \"b\"]\n";

}  // namespace

BOOST_AUTO_TEST_CASE(a_full_scene) {
  const Scene s = scene(
      "title = \"Zener\"\n[contact]\nnormal = \"k0 | (k1 - c1)\"\npoisson = 0.3\n"
      "[drive]\nnetwork = \"kd\"\n[body]\nmass = \"5 g\"\n" +
      oscillation + friction +
      "[elements]\nk0 = \"8 N/um\"\nk1 = \"4 N/um\"\nc1 = \"30 N.s/m\"\nkd = \"2 N/um\"\n");
  BOOST_TEST(s.title == "Zener");
  BOOST_CHECK(s.normal == parallel({k("k0"), series({k("k1"), c("c1")})}));
  BOOST_CHECK(s.drive.value() == k("kd"));
  const Values values = resolve(s).values();
  // Conversions round twice at most: 4 units in the last place leave room.
  const auto near = [](double a, double b) { return std::abs(a - b) <= 4.5e-16 * b; };
  BOOST_TEST(near(values.at({"m"}), 5e-3));
  BOOST_TEST(near(values.at({"omega"}), 2 * std::numbers::pi * 2e4));
  BOOST_TEST(near(values.at({"k1"}), 4e6));
  BOOST_TEST(near(values.at({"u_z0"}), 5e-7));
  BOOST_TEST(values.at({"mu0"}) == 0.3);
  BOOST_TEST(near(tangential_ratio(std::get<Isotropic>(s.tangential)), 14.0 / 17));
  BOOST_TEST(s.warnings.empty());
}

// As decimals do, those that no double equals become the nearest.
BOOST_AUTO_TEST_CASE(whole_numbers_of_any_length) {
  for (const auto& [text, value] :
       {std::pair("9007199254740993", 9007199254740992.0), std::pair("9999999999999999", 1e16),
        std::pair("9223372036854775807", 9223372036854775808.0),
        std::pair("0x7fffffffffffffff", 9223372036854775808.0)}) {
    const Scene s = scene(kelvin + oscillation + friction + "[elements]\nkn = " + text +
                          "\ncn = 10\nkt = 3\nct = 7\n");
    BOOST_TEST(resolve(s).values().at({"kn"}) == value, text);
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_named_is_not_there) {
  const Scene s = scene(kelvin + oscillation + friction + kelvin_values);
  BOOST_TEST(!s.drive.has_value());
  BOOST_TEST(!s.mass.has_value());
  BOOST_TEST(!resolve(s).values().contains({"m"}));
}

BOOST_AUTO_TEST_CASE(a_mass_under_a_rigid_drive_is_left_out) {
  const Scene s = scene(kelvin + "[body]\nmass = 1\n" + oscillation + friction + kelvin_values);
  BOOST_TEST(!s.mass.has_value());
  BOOST_TEST(warns(s, "rigid drive"));
  BOOST_TEST(!scene(kelvin + "[drive]\nnetwork = \"kd\"\n[body]\nmass = 0\n").mass.has_value());
}

BOOST_AUTO_TEST_CASE(a_fitted_range_is_warned_of_beyond_it) {
  const auto with = [](const std::string& range, const std::string& frequency) {
    return parse_scene(contact("k") + "fitted_range = " + range +
                           "\n[oscillation]\nfrequency = \"" + frequency + "\"\n",
                       "s.toml");
  };
  const std::string range = "[\"10 Hz\", \"2e4\"]";
  BOOST_TEST(with(range, "10").warnings.empty());
  BOOST_TEST(with(range, "20 kHz").warnings.empty());
  BOOST_TEST_REQUIRE(with(range, "9.99").warnings.size() == 1U);
  BOOST_TEST(with(range, "20.1 kHz").warnings.front() ==
             "s.toml: the contact was fitted to data from 10 Hz to 20 kHz and is asked for at 20.1 "
             "kHz: beyond the data its stiffness is a guess");
  const Scene s = with("[10, 2e4]", "1 kHz");
  BOOST_TEST(!beyond_fitted_range(s, s.fitted_range->from, s.fitted_range->to).has_value());
  BOOST_TEST(beyond_fitted_range(s, 1, s.fitted_range->to).has_value());
  BOOST_TEST(!beyond_fitted_range(scene(kelvin), 1, 1e9).has_value());
  const auto wrong = [&](const std::string& value) {
    return message(contact("k") + "fitted_range = " + value + "\n");
  };
  for (const char* value : {"10", "[10]", "[10, 20, 30]", "[\"f\", 20]"})
    BOOST_TEST(has(wrong(value), "two frequencies, the lower one first"), value);
  BOOST_TEST(has(wrong("[20, 10]"), "found 20 Hz before 10 Hz"));
  BOOST_TEST(has(wrong("[-1, 10]"), "above 0"));
  BOOST_TEST(has(wrong("[\"1 mm\", 10]"), "frequency"));
}

BOOST_AUTO_TEST_CASE(equal_networks_are_isotropic) {
  const Scene s = scene(contact("k | c", "tangential = \"kelvin(k, c)\""));
  BOOST_TEST(tangential_ratio(std::get<Isotropic>(s.tangential)) == 1);
}

BOOST_AUTO_TEST_CASE(symbols_need_no_value_until_a_number_is_asked_for) {
  const Scene s = scene(kelvin + "[drive]\nnetwork = \"kd\"\n[body]\nmass = \"m\"\n");
  BOOST_TEST(s.elements.size() == 5);
  for (const auto& [symbol, value] : s.elements) BOOST_TEST(!value.has_value());
  const std::string text = message(kelvin + "[drive]\nnetwork = \"kd\"\n[body]\nmass = \"m\"\n");
  BOOST_TEST(has(text,
                 "kn, cn, kt, ct, kd, mu0 (coefficient), omega (frequency), du_z (amplitude), u_z0 "
                 "(indentation), "
                 "m (mass)"));
}

BOOST_AUTO_TEST_CASE(a_ratio_may_be_a_symbol) {
  const Scene s = scene(contact("kn", "poisson = \"nu\""));
  BOOST_TEST(std::get<Isotropic>(s.tangential).quantity.symbol.name == "nu");
  BOOST_TEST(resolve(scene(contact("kn", "poisson = \"nu\"") + oscillation + friction,
                           {{"nu", "0.25"}, {"kn", "1"}}))
                 .values()
                 .at({"nu"}) == 0.25);
}

BOOST_AUTO_TEST_CASE(set_replaces_and_completes) {
  const std::string text = kelvin + oscillation + friction + kelvin_values;
  BOOST_TEST(resolve(scene(text, {{"kn", "5 N/um"}})).values().at({"kn"}) == 5e6);
  BOOST_TEST(resolve(scene(text, {{"omega", "100"}})).values().at({"omega"}) == 100);
  BOOST_TEST(resolve(scene(text, {{"frequency", "10"}})).values().at({"omega"}) ==
             20 * std::numbers::pi);
  BOOST_TEST(resolve(scene(text, {{"amplitude", "1 mm"}})).values().at({"du_z"}) == 1e-3);
  BOOST_TEST(has(message(text, {{"kk", "1"}}), "set kk: found \"kk\""));
  BOOST_TEST(has(message(text, {{"kn", "1 s"}}), "a stiffness in N/m"));
  BOOST_TEST(has(message(text, {{"kn", "-1"}}), "at least 0"));
}

BOOST_AUTO_TEST_CASE(set_names_a_quantity_once) {
  const std::string text = kelvin + oscillation + friction + kelvin_values;
  BOOST_TEST(has(message(text, {{"amplitude", "1"}, {"du_z", "2"}}), "du_z as well as amplitude"));
  BOOST_TEST(
      has(message(text, {{"frequency", "1"}, {"omega", "2"}}), "omega as well as frequency"));
  // Whichever of the two the file has, the setting is what counts.
  const std::string angular =
      kelvin + friction + kelvin_values +
      "[oscillation]\nangular_frequency = 7\namplitude = 1\nindentation = 2\n";
  BOOST_TEST(resolve(scene(angular, {{"frequency", "10"}})).values().at({"omega"}) ==
             20 * std::numbers::pi);
  const auto settable = scene(text).settable;
  BOOST_TEST((settable.at("kn") == Dimension::stiffness));
  BOOST_TEST((settable.at("frequency") == Dimension::frequency));
  BOOST_TEST(!settable.contains("mass"));
}

BOOST_AUTO_TEST_CASE(arrays_of_a_prony_series) {
  const std::string text = contact("prony(k0, k, tau)", "tangential_ratio = 0.8") + oscillation +
                           friction +
                           "[elements]\nk0 = 1\nk = [2, \"3 N/mm\", 0]\ntau = [\"1 ms\", 2, 3]\n";
  const Scene s = scene(text);
  BOOST_TEST(s.arrays.at("k") == 3);
  BOOST_TEST(resolve(s).values().at({"k", 2}) == 3000);
  BOOST_TEST(!resolve(s).values().contains({"k", 3}));  // a branch of stiffness 0 is left out
  BOOST_TEST(resolve(scene(text, {{"k[1]", "7"}})).values().at({"k", 1}) == 7);
  BOOST_TEST(scene(contact("prony(k0, k, tau, 10)")).elements.size() == 21);
}

BOOST_AUTO_TEST_CASE(zeros_are_left_out) {
  const std::string zener = contact("k0 | (k1 - c1)");
  BOOST_CHECK(scene(zener + "[elements]\nc1 = 0\n").normal == k("k0"));
  BOOST_CHECK(scene(zener + "[elements]\nk0 = 0.0\n").normal == series({k("k1"), c("c1")}));
  const std::string lossy = contact("lossy(k0, eta)");
  BOOST_CHECK(scene(lossy + "[elements]\neta = 0\n").normal == k("k0"));
  BOOST_TEST(has(message(lossy + "[elements]\nk0 = 0\n"), "that elements of value 0 cut"));
  BOOST_TEST(has(message(zener + "[elements]\nk0 = 0\nk1 = 0\n"),
                 "a normal network that elements of value 0 cut"));
}

BOOST_AUTO_TEST_CASE(graphs_and_named_networks) {
  const Scene s =
      scene(bridge +
            "edges = [[\"k1\", \"a\", \"1\"], [\"c1\", \"a\", \"2\"], [\"k2\", \"1\", \"2\"], "
            "[\"c2\", \"1\", \"b\"], [\"k3\", \"2\", \"b\"]]\n");
  BOOST_TEST(std::get<Graph>(s.normal.form).wires.size() == 5);
  const Scene named =
      scene(contact("foot | k9") + "[networks]\nfoot = \"toe - c1\"\ntoe = \"k1 | k2\"\n");
  BOOST_CHECK(named.normal == parallel({series({parallel({k("k1"), k("k2")}), c("c1")}), k("k9")}));
}

BOOST_AUTO_TEST_CASE(a_dangling_branch_is_left_out_with_a_warning) {
  const Scene s = scene(bridge + "edges = [[\"k1\", \"a\", \"b\"],\n [\"c7\", \"a\", \"x\"]]\n");
  BOOST_TEST(warns(s, "s.toml:7:"));
  BOOST_TEST(warns(s, "carries no load"));
  BOOST_TEST(s.elements.size() == 1);
}

BOOST_AUTO_TEST_CASE(wrong_graphs) {
  BOOST_TEST(has(message(bridge + "edges = [[\"k1\", \"a\", \"1\"], [\"k2\", \"2\", \"b\"]]\n"),
                 "without a connection"));
  BOOST_TEST(
      has(message(bridge + "edges = [[\"k1\", \"a\"]]\n"), "[\"network\", \"node\", \"node\"]"));
  BOOST_TEST(has(message(bridge), "no edges"));
  BOOST_TEST(
      has(message(contact("x") + "[networks]\nx = \"y\"\ny = \"x | k\"\n"), "inside itself"));
}

BOOST_AUTO_TEST_CASE(a_network_that_doubles_at_each_name_is_refused_in_time) {
  std::string text = contact("n30") + "[networks]\nn0 = \"k | k\"\n";
  for (int i = 1; i <= 30; ++i)
    text += "n" + std::to_string(i) + " = \"n" + std::to_string(i - 1) + " | n" +
            std::to_string(i - 1) + "\"\n";
  BOOST_TEST(has(message(text), "more than 1000000 elements"));
}

BOOST_AUTO_TEST_CASE(unknown_keys_name_the_nearest) {
  BOOST_TEST(has(message("[contact]\nnorml = \"k\"\npoisson = 0.3\n"),
                 "s.toml:2:1: found unknown key \"norml\" in [contact]; expected \"normal\""));
  BOOST_TEST(has(message("[contakt]\nnormal = \"k\"\n"), "expected \"contact\""));
  BOOST_TEST(warns(scene(contact("k1") + "[elements]\nk2 = 1\n"), "\"k2\" is in no network"));
}

BOOST_AUTO_TEST_CASE(units_and_ranges) {
  const auto with_oscillation = [](const std::string& line) {
    return message(kelvin + friction + kelvin_values + "[oscillation]\n" + line +
                   "\namplitude = 1e-7\nindentation = 1e-6\n");
  };
  BOOST_TEST(has(with_oscillation("frequency = \"1.2e5 rad/s\""),
                 "an angular frequency, not cycles a second"));
  BOOST_TEST(has(with_oscillation("angular_frequency = \"20 kHz\""),
                 "a frequency, not an angle a second"));
  BOOST_TEST(has(with_oscillation("frequency = 1\nangular_frequency = 2"), "one of the two"));
  BOOST_TEST(has(with_oscillation("frequency = 0"), "above 0"));
  BOOST_TEST(has(with_oscillation("frequency = -5"), "above 0"));
  BOOST_TEST(has(message(kelvin + oscillation + friction + "[elements]\nkn = \"3 N.s/m\"\n"),
                 "s.toml:11:6: found \"3 N.s/m\""));
  BOOST_TEST(has(message(kelvin + "[elements]\nkn = -3\n"),
                 "kn = -3; expected a finite value of at least 0"));
  BOOST_TEST(has(message(kelvin + "[elements]\nkn = inf\n"), "expected a finite value"));
  BOOST_TEST(has(message(kelvin + "[elements]\nkn = nan\n"), "expected a finite value"));
  BOOST_TEST(has(message(kelvin + "[elements]\nkn = [1]\n"), "an array"));
  BOOST_TEST(has(message(contact("kn", "poisson = 0.7")), "Poisson"));
}

BOOST_AUTO_TEST_CASE(contacts_need_exactly_one_tangential_network) {
  BOOST_TEST(has(message("[contact]\nnormal = \"k\"\n"), "exactly one"));
  BOOST_TEST(has(message(contact("k") + "tangential = \"kt\"\n"), "exactly one"));
  BOOST_TEST(has(message("[contact]\npoisson = 0.3\n"), "no \"normal\""));
  BOOST_TEST(has(message("title = \"x\"\n"), "no [contact]"));
  BOOST_TEST(has(message("[contact\n"), "no TOML"));
}

BOOST_AUTO_TEST_CASE(one_name_is_one_kind_of_number) {
  BOOST_TEST(has(message(contact("spring(a)", "tangential = \"damper(a)\"")),
                 "s.toml:3:14: found \"a\" as a damper; expected a spring, as at s.toml:2:10"));
  BOOST_TEST(
      has(message(contact("k1 | prony(k0, k1, tau, 2)")), "\"k1\" as an array of stiffnesses"));
  BOOST_TEST(has(message(contact("spring(m)")), "a quantity of the scene"));
  BOOST_TEST(has(message(contact("kn") + "[networks]\nkn = \"k1\"\n[elements]\nkn = 1\n"),
                 "as a network and as an element"));
}

// --set amplitude=... and the like would mean two numbers.
BOOST_AUTO_TEST_CASE(names_of_quantities_are_free_for_nothing_else) {
  const std::string body = "[body]\nmass = \"m\"\n";
  for (const char* name : {"mu0", "omega", "du_z", "u_z0", "m", "amplitude", "angular_frequency",
                           "coefficient", "frequency", "indentation", "mass", "poisson",
                           "tangential_ratio", "velocity", "velocity_ratio"}) {
    const std::string quoted(name);
    BOOST_TEST(
        has(message("[contact]\nnormal = \"spring(" + quoted + ")\"\ntangential = \"kt\"\n" + body),
            "found \"" + quoted + "\" as an element; expected another name"),
        name);
    for (const char* key : {"poisson", "tangential_ratio"})
      if (quoted != key) {
        const std::string given = std::string(key) + " = \"" + quoted + "\"";
        const std::string refusal = message("[contact]\nnormal = \"k\"\n" + given + "\n" + body);
        BOOST_TEST((has(refusal, "found \"" + quoted + "\" as a symbol; expected another name") ||
                    has(refusal, "found " + given + "; expected another name")),
                   name);
      }
  }
}

// What the program calls a quantity is free where the scene calls it otherwise.
BOOST_AUTO_TEST_CASE(symbols_are_known_by_themselves_and_called_by_the_scene) {
  const Scene s = scene(
      contact("spring(mu0) | k1", "poisson = \"m\"") +
      "[drive]\nnetwork = \"kd\"\n"
      "[body]\nmass = \"M\"\n[friction]\ncoefficient = \"mu\"\n[oscillation]\nfrequency = \"f\"\n"
      "[elements]\nk1 = \"E\"\nE = 5\nmu0 = 7\n");
  BOOST_TEST(name_in(s, *s.mass) == "M");
  BOOST_TEST(s.mass->symbol.name == "m");
  BOOST_TEST(name_in(s, s.coefficient) == "mu");
  BOOST_TEST(name_in(s, std::get<Isotropic>(s.tangential).quantity) == "m");
  BOOST_TEST(std::get<Isotropic>(s.tangential).quantity.symbol.name != "m");
  BOOST_TEST_REQUIRE(s.elements.size() == 3U);
  BOOST_TEST(to_text(as_called(s, s.elements[0].first)) == "mu0");
  BOOST_TEST((s.elements[0].first != s.coefficient.symbol));
  BOOST_TEST(to_text(s.elements[1].first) == "E");
  BOOST_TEST(s.elements[1].second.value() == 5);
  BOOST_TEST((s.named.at("f") == frequency_symbol));
  BOOST_TEST((s.named.at("k1") == s.named.at("E")));
  BOOST_TEST((s.named.at("mass") == s.named.at("M")));
  BOOST_TEST(s.warnings.empty());
}

BOOST_AUTO_TEST_CASE(a_setting_by_another_name_than_the_scenes_is_told_that) {
  const std::string text = contact("k1") +
                           "[drive]\nnetwork = \"kd\"\n[body]\nmass = \"M\"\n"
                           "[friction]\ncoefficient = \"mu\"\n";
  BOOST_TEST(has(message(text, {{"m", "1"}}), "expected \"M\""));
  BOOST_TEST(has(message(text, {{"mu0", "1"}}), "expected \"mu\""));
}

BOOST_AUTO_TEST_SUITE_END()
