// Quantities with units against conversions done by hand.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "base/units.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_units)

using namespace vcrit;
using test::has;

namespace {

const Place place{"scene.toml", 3, 8};

std::string message(const std::string& text, Dimension dimension) {
  return test::refusal([&] { parse_quantity(text, dimension, place); });
}

// A conversion is one multiplication by a factor that is itself rounded: two units in the last
// place.
bool near(double value, double expected) {
  return std::abs(value - expected) <= 4.5e-16 * expected;
}

}  // namespace

// What is typed is a decimal number, and is converted as one: rounded once.
BOOST_AUTO_TEST_CASE(decimals_are_converted_exactly) {
  const auto typed = [](const char* text, Dimension dimension) {
    return parse_typed(text, dimension, place);
  };
  for (const char* text : {"0.1 um", "100 nm", "1e-4 mm", "0.00010 mm", "+.1 um"}) {
    BOOST_TEST(typed(text, Dimension::length).value == 1e-7, text);
    BOOST_TEST(typed(text, Dimension::length).decimal == "1e-7", text);
  }
  for (int i = 1; i < 1000; ++i) {
    const std::string digits = std::to_string(i);
    BOOST_TEST(typed((digits + " um").c_str(), Dimension::length).value ==
               std::stod(digits + "e-6"));
    BOOST_TEST(typed(("0." + digits + " N/um").c_str(), Dimension::stiffness).value ==
               std::stod("0." + digits + "e6"));
  }
  BOOST_TEST(typed("3183.09886184109 Hz", Dimension::frequency).decimal == "318309886184109e-11");
  BOOST_TEST(typed("2 inch", Dimension::length).decimal == "508e-4");
  BOOST_TEST(typed("-2.50 mm", Dimension::length).decimal == "-25e-4");
  BOOST_TEST(typed("1e-7", Dimension::length).decimal.empty());
  BOOST_TEST(typed("0 um", Dimension::length).value == 0);
  // pi/30 is no decimal number.
  BOOST_TEST(typed("30 rpm", Dimension::angular_frequency).decimal.empty());
  BOOST_TEST(near(typed("30 rpm", Dimension::angular_frequency).value, 3.14159265358979312));
}

BOOST_AUTO_TEST_CASE(units_convert_to_si) {
  BOOST_TEST(near(parse_quantity("8 N/um", Dimension::stiffness, place), 8e6));
  BOOST_TEST(near(parse_quantity("30 N.s/m", Dimension::damping, place), 30));
  BOOST_TEST(near(parse_quantity("30 N s/m", Dimension::damping, place), 30));
  BOOST_TEST(near(parse_quantity("0.5 kN/mm", Dimension::stiffness, place), 5e5));
  BOOST_TEST(near(parse_quantity("5 g", Dimension::mass, place), 5e-3));
  BOOST_TEST(near(parse_quantity("0.1 um", Dimension::length, place), 1e-7));
  BOOST_TEST(near(parse_quantity("0.1 µm", Dimension::length, place), 1e-7));
  BOOST_TEST(near(parse_quantity("20 kHz", Dimension::frequency, place), 2e4));
  BOOST_TEST(near(parse_quantity("1.2e5 rad/s", Dimension::angular_frequency, place), 1.2e5));
  BOOST_TEST(near(parse_quantity("20 mm/s", Dimension::velocity, place), 0.02));
  BOOST_TEST(near(parse_quantity("3 ms", Dimension::time, place), 3e-3));
  BOOST_TEST(near(parse_quantity("2e3N/m", Dimension::stiffness, place), 2e3));
  for (const char* space : {"\u00a0", "\u2009", "\u202f"})
    BOOST_TEST(
        near(parse_quantity(std::string("8") + space + "N/um", Dimension::stiffness, place), 8e6));
}

BOOST_AUTO_TEST_CASE(bare_numbers_are_si) {
  BOOST_TEST(parse_quantity(" 1.5e6 ", Dimension::stiffness, place) == 1.5e6);
  BOOST_TEST(parse_quantity("-2", Dimension::none, place) == -2);
}

BOOST_AUTO_TEST_CASE(a_reciprocal_unit_is_refused) {
  BOOST_TEST(has(message("5 ms", Dimension::frequency), "a unit of another dimension"));
  BOOST_TEST(has(message("20 kHz", Dimension::time), "a unit of another dimension"));
  BOOST_TEST(has(message("2 um/N", Dimension::stiffness), "a unit of another dimension"));
  BOOST_TEST(has(message("1 ln(re 1 N/m)", Dimension::stiffness), "a unit of another dimension"));
}

// Numbers are units to udunits: "10 000 N/m" would be nothing, and "0.3-50" fifteen below it.
BOOST_AUTO_TEST_CASE(a_second_number_is_refused) {
  for (const char* text : {"0.3 5", "0.3-50", "0.3 -50", "0.3 .5", "0.3 1e-3", "3 10^-1", "1 10"})
    BOOST_TEST(has(message(text, Dimension::none), "a second number"));
  for (const char* text : {"10 000 N/m", "1 -50 N/m", "8+3 N/m", "1 1 N/m"})
    BOOST_TEST(has(message(text, Dimension::stiffness), "a second number"));
  for (const char* text : {"0.1 um 5", "0.1 um 10 %", "0.1 um 10%", "0.1 um +0.2", "0.1 um -0.2",
                           "0.1 um.5", "0.1 (um) 2", "0.1 um from 5", "0.1 um 1"})
    BOOST_TEST(has(message(text, Dimension::length), "a second number"));
  BOOST_TEST(has(message("8 N/um 10 %", Dimension::stiffness), "(\"10 %\" is a second number"));
  for (const char* text : {"8 N.m-1", "8 N m^-1", "8 N/m^1", "8 kg/s2", "8 kg s-2", "8 N 1/m",
                           "8 kg.m^+2/(s^2 m2)", "8 N m**-1"})
    BOOST_TEST(near(parse_quantity(text, Dimension::stiffness, place), 8));
  for (const char* text : {"80 N/(10 m)", "16 N/m/2", "4 N*2/m"})
    BOOST_TEST(near(parse_quantity(text, Dimension::stiffness, place), 8));
  BOOST_TEST(near(parse_quantity("20 1/s", Dimension::frequency, place), 20));
  BOOST_TEST(parse_quantity("0.3 1", Dimension::none, place) == 0.3);
  BOOST_TEST(near(parse_quantity("20 1 /s", Dimension::frequency, place), 20));
  BOOST_TEST(near(-parse_quantity("0.3 (-5)", Dimension::none, place), 1.5));
}

// udunits would count from 20 on: 28 N/um.
BOOST_AUTO_TEST_CASE(units_count_from_zero) {
  for (const char* text : {"8 N/um @ 20", "8 N/um@20"})
    BOOST_TEST(has(message(text, Dimension::stiffness), "a unit with a zero of its own"));
}

BOOST_AUTO_TEST_CASE(a_number_beyond_the_doubles_is_refused) {
  BOOST_TEST(has(message("1e401", Dimension::none), "beyond the range of doubles"));
  BOOST_TEST(has(message("1e-401 N/m", Dimension::stiffness), "beyond the range of doubles"));
}

BOOST_AUTO_TEST_CASE(a_long_unit_is_refused) {
  const std::string unit = message("1 " + std::string(65, 'm'), Dimension::length);
  BOOST_TEST(has(unit, "a unit of 65 characters, more than 64"));
}

BOOST_AUTO_TEST_CASE(a_unit_of_another_dimension_is_refused) {
  const std::string text = message("8 N.s/m", Dimension::stiffness);
  BOOST_TEST(has(text, "scene.toml:3:8"));
  BOOST_TEST(has(text, "8 N.s/m"));
  BOOST_TEST(has(text, "a stiffness in N/m"));
}

BOOST_AUTO_TEST_CASE(frequency_and_angular_frequency_are_kept_apart) {
  BOOST_TEST(has(message("1.2e5 rad/s", Dimension::frequency), "angular frequency"));
  BOOST_TEST(has(message("3000 rpm", Dimension::frequency), "angular frequency"));
  BOOST_TEST(has(message("20 kHz", Dimension::angular_frequency),
                 "a frequency, not an angle a second); expected an angular frequency in rad/s; "
                 "write it as frequency = \"20 kHz\""));
  BOOST_TEST(has(message("20 1/s", Dimension::angular_frequency), "a frequency"));
}

BOOST_AUTO_TEST_CASE(an_unknown_unit_meets_the_nearest_one) {
  using enum Dimension;
  BOOST_TEST(has(message("28 khz", frequency),
                 "found \"28 khz\" (unknown unit \"khz\"); expected a frequency in Hz; did you "
                 "mean \"28 kHz\"?"));
  BOOST_TEST(has(message("28 mhz", frequency), "did you mean \"28 mHz\" or \"28 MHz\"?"));
  BOOST_TEST(has(message("0.1 uM", length), "did you mean \"0.1 um\"?"));
  BOOST_TEST(has(message("6 Ns/m", damping), "did you mean \"6 N.s/m\"?"));
  BOOST_TEST(has(message("8 N/umm", stiffness), "did you mean \"8 N/um\""));
  BOOST_TEST(!has(message("8 fathoms7", stiffness), "did you mean"));
  BOOST_TEST(!has(message("8 x", length), "did you mean"));
}

BOOST_AUTO_TEST_CASE(a_decimal_comma_is_named) {
  BOOST_TEST(has(message("0,2 um", Dimension::length), "write a decimal point: \"0.2 um\""));
  BOOST_TEST(has(message("0,2", Dimension::length), "write a decimal point: \"0.2\""));
  BOOST_TEST(has(message("1,500 N/m", Dimension::stiffness),
                 "\"1.500 N/m\", and nothing between thousands, \"1500 N/m\""));
  BOOST_TEST(has(message("1,5000 N/m", Dimension::stiffness), "point: \"1.5000 N/m\""));
}

// Minutes of arc to udunits: 8'000 N/mm would be 8 N/mm.
BOOST_AUTO_TEST_CASE(nothing_stands_between_thousands) {
  using enum Dimension;
  for (const char* text : {"8'000 N/mm", "8 000 N/mm"})
    BOOST_TEST(has(message(text, stiffness), "write nothing between thousands: \"8000 N/mm\""));
  BOOST_TEST(has(message("1'234'567.5 N/m", stiffness), "\"1234567.5 N/m\""));
  BOOST_TEST(has(message("1.000,5 um", length), "nothing between thousands: \"1000.5 um\""));
  for (const char* text : {"8'00 N/mm", "8' N/mm", "8 0000 N/mm", "0.3 500 N/mm"}) {
    BOOST_TEST(!has(message(text, stiffness), "thousands"));
    BOOST_TEST(has(message(text, stiffness), "found"));
  }
}

BOOST_AUTO_TEST_CASE(an_angle_is_no_plain_number) {
  for (const char* text : {"17 deg", "0.3 rad", "17\u00b0"})
    BOOST_TEST(has(message(text, Dimension::none),
                   "(an angle); expected a plain number; write the "
                   "tangent of the angle, if that is meant"));
  BOOST_TEST(near(parse_quantity("30 %", Dimension::none, place), 0.3));
  BOOST_TEST(near(parse_quantity("180 deg", Dimension::angle, place), std::numbers::pi));
}

BOOST_AUTO_TEST_CASE(an_amplitude_is_a_peak_value) {
  for (const char* text : {"6 um peak", "6 um (peak)", "6 um 0-pk"})
    BOOST_TEST(has(message(text, Dimension::length), "an amplitude is one: \"6 um\""));
}

BOOST_AUTO_TEST_CASE(peak_to_peak_is_halved) {
  for (const char* text : {"12 um pp", "12 um p-p", "12 um peak-to-peak", "12 um peak to peak",
                           "12 um_pp", "12 umpp", "12 um (pp", "12 um (pp)", "12 um pk-pk"})
    BOOST_TEST(
        has(message(text, Dimension::length), "an amplitude is half of peak to peak: \"6 um\""));
  BOOST_TEST(!has(message("12 N pp", Dimension::length), "half"));
  BOOST_TEST(!has(message("12 um pp", Dimension::mass), "half"));
}

BOOST_AUTO_TEST_CASE(a_root_mean_square_becomes_an_amplitude) {
  for (const char* text : {"100 nm rms", "100 nm RMS", "100 nm (rms"})
    BOOST_TEST(has(message(text, Dimension::length), "is sqrt(2) times that: \"141.4 nm\""));
  BOOST_TEST(!has(message("100 N rms", Dimension::length), "sqrt"));
}

// To udunits "gr" is the grain, 65 mg.
BOOST_AUTO_TEST_CASE(a_grain_is_no_gram) {
  BOOST_TEST(has(message("5 gr", Dimension::mass), "unknown unit \"gr\""));
  BOOST_TEST(has(message("5 gr", Dimension::mass), "did you mean \"5 g\""));
  BOOST_TEST(parse_quantity("1 grain", Dimension::mass, {"m"}) == 6.479891e-5);
}

BOOST_AUTO_TEST_CASE(a_space_within_a_unit_is_seen) {
  BOOST_TEST(has(message("0.5 \u00b5 m", Dimension::length), "did you mean \"0.5 um\"?"));
}

BOOST_AUTO_TEST_CASE(a_modulus_needs_a_length) {
  using enum Dimension;
  BOOST_TEST(has(message("0.5 MPa", stiffness), "k = 2 a E/(1 - nu^2)"));
  BOOST_TEST(has(message("6 Pa.s", damping), "c = 2 a eta/(1 - nu^2)"));
  BOOST_TEST(has(message("8 N/um", modulus), "springs are moduli"));
  BOOST_TEST(has(message("6 N.s/m", viscosity), "dampers are viscosities"));
  BOOST_TEST(!has(message("6 m", stiffness), "radius"));
}

BOOST_AUTO_TEST_CASE(a_typeset_minus_is_named) {
  for (const char* text : {"\u22125 um", "1e\u22127 m", "\u20135 um"})
    BOOST_TEST(has(message(text, Dimension::length), "write the minus sign of the keyboard"));
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  BOOST_TEST(has(message("8 N/fathomless", Dimension::stiffness), "unknown unit \"N/fathomless\""));
  BOOST_TEST(has(message("eight N/m", Dimension::stiffness), "a number and a unit"));
  BOOST_TEST(has(message("", Dimension::stiffness), "a number and a unit"));
  BOOST_TEST(has(message("1e308 N/um", Dimension::stiffness), "not finite"));
}

BOOST_AUTO_TEST_SUITE_END()
