// The scene that a fit writes: valid, with the fitted stiffness, and symbols for the rest.
#include "fit/scene_text.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>

#include "base/errors.hpp"
#include "scene/scene.hpp"
#include "stiffness/dynamic_stiffness.hpp"

BOOST_AUTO_TEST_SUITE(test_scene_text)

namespace {

using namespace vcrit;
using fit::Fit;

const StiffnessTable data{"folder/pad.csv", {{10, 1, 1, 0, 0}, {1000, 2, 1, 0, 0}}, false};

Fit series(std::optional<double> k0, std::optional<double> c0,
           const std::vector<std::pair<double, double>>& branches) {
  Fit fit;
  if (k0) fit.equilibrium = fit::Uncertain{*k0, 0};
  if (c0) fit.damper = fit::Uncertain{*c0, 0};
  for (const auto& [k, tau] : branches) fit.branches.push_back({{k, 0}, {tau, 0}});
  return fit;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

BOOST_AUTO_TEST_CASE(the_scene_has_the_fitted_stiffness) {
  const std::vector<std::pair<double, double>> branches{{1.23456789e6, 1e-5}, {3e6, 2.5e-3}};
  for (const bool damped : {false, true}) {
    const std::string text =
        scene_text(series(2e6, damped ? std::optional(30.0) : std::nullopt, branches), data, {});
    const Scene scene = parse_scene(text, "s.toml");
    BOOST_TEST(scene.warnings.empty());
    BOOST_TEST_REQUIRE(scene.fitted_range.has_value());
    BOOST_TEST(std::abs(scene.fitted_range->from / 10 - 1) < 1e-14);  // rad/s, by way of Hz
    BOOST_TEST(std::abs(scene.fitted_range->to / 1000 - 1) < 1e-14);
    Values values;
    for (const auto& [symbol, value] : scene.elements) values[symbol] = value.value();
    for (const double omega : {1.0, 400.0, 1e5, 1e8}) {
      const std::complex<double> x(0, omega);
      std::complex<double> expected = 2e6 + (damped ? 30.0 * x : 0.0);
      for (const auto& [k, tau] : branches) expected += k * x * tau / (1.0 + x * tau);
      // Ten digits are written.
      BOOST_TEST(std::abs(dynamic_stiffness(scene.normal, values, omega) / expected - 1.0) < 1e-9);
    }
    BOOST_TEST(has(text, "c0") == damped);
    BOOST_TEST(has(text, "N s/m") == damped);
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_there_is_in_no_line) {
  const std::string spring = scene_text(series(5, {}, {}), data, {});
  BOOST_TEST(has(spring, "normal  = \"k0\""));
  BOOST_TEST(!has(spring, "tau"));
  for (const char* word : {"[drive]", "[body]", "mass", "c0"}) BOOST_TEST(!has(spring, word));
  parse_scene(spring, "s.toml");
  const Scene fluid = parse_scene(scene_text(series({}, {}, {{1, 1}}), data, {}), "s.toml");
  BOOST_TEST(fluid.elements.size() == 2U);  // k[1], tau[1]
}

BOOST_AUTO_TEST_CASE(the_rest_is_symbols_until_it_is_given) {
  const Fit fit = series(1, {}, {{1, 1}});
  const Scene open = parse_scene(scene_text(fit, data, {}), "s.toml");
  for (const Quantity* quantity :
       {&open.coefficient, &open.angular_frequency, &open.amplitude, &open.indentation})
    BOOST_TEST(!quantity->value.has_value());
  BOOST_TEST(open.title == "Contact fitted to pad.csv");
  fit::Rest rest{"A \"pad\"", "0.4", "20 kHz", "0.1 um", "0.5 um", "0.3"};
  const Scene full = parse_scene(scene_text(fit, data, rest), "s.toml");
  BOOST_TEST(full.title == "A \"pad\"");
  BOOST_TEST(full.angular_frequency.value.value() == 2 * 3.141592653589793 * 20e3);
  BOOST_TEST(full.amplitude.value.value() == 1e-7);
  BOOST_TEST(full.coefficient.value.value() == 0.3);
  BOOST_TEST(std::abs(tangential_ratio(std::get<Isotropic>(full.tangential)) - 0.75) < 1e-15);
}

// What the scene's reader would refuse is refused before it is written, by the option's name.
BOOST_AUTO_TEST_CASE(wrong_values_are_those_of_an_option) {
  const Fit fit = series(1, {}, {{1, 1}});
  struct WrongValue {
    const char* key;
    std::string fit::Rest::*member;
    const char* text;
  };
  for (const auto& [key, member, text] :
       {WrongValue{"poisson", &fit::Rest::poisson, "0.6"},
        WrongValue{"frequency", &fit::Rest::frequency, "20 mm"},
        WrongValue{"frequency", &fit::Rest::frequency, "0 Hz"},
        WrongValue{"amplitude", &fit::Rest::amplitude, "-0.1 um"},
        WrongValue{"indentation", &fit::Rest::indentation, "-1"},
        WrongValue{"coefficient", &fit::Rest::coefficient, "-0.3"}}) {
    fit::Rest rest;
    rest.*member = text;
    const auto names_the_option = [key = key](const InputError& error) {
      return to_text(error.place()) == to_text(argument(key));
    };
    BOOST_CHECK_EXCEPTION(scene_text(fit, data, rest), InputError, names_the_option);
  }
}

// Names of files and titles have any bytes.
BOOST_AUTO_TEST_CASE(a_scene_is_utf_8_whatever_the_table_is_called) {
  const Fit fit = series(1, {}, {{1, 1}});
  for (const char* name : {"a\nb\".csv", "pad\xff.csv", "\xe2\x80\xa8.csv", "p\x7f\\d.csv"}) {
    const StiffnessTable odd{name, data.rows, false};
    parse_scene(scene_text(fit, odd, {}), "s.toml");
    fit::Rest rest;
    rest.title = name;
    parse_scene(scene_text(fit, data, rest), "s.toml");
  }
  fit::Rest rest;
  rest.title = "pad\xff \"\xc3\xbc\"";
  BOOST_TEST(parse_scene(scene_text(fit, data, rest), "s.toml").title == "pad\\xff \"\xc3\xbc\"");
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
