#include "base/units.hpp"

#include <fmt/core.h>
#include <udunits2.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "base/messages.hpp"
#include "base/numbers.hpp"
#include "base/trimmed.hpp"
#include "base/unit_advice.hpp"
#include "base/usual_units.hpp"

namespace vcrit {

namespace {

// "kg.m2.s-2" has nine characters; udunits' parser needs the more stack the longer a unit is.
constexpr std::size_t longest_unit = 64;

struct UnitDeleter {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;

struct DimensionText {
  const char* name;
  const char* unit;
};

constexpr std::array<DimensionText, 14> dimensions{{{"a plain number", "1"},
                                                    {"a stiffness", "N/m"},
                                                    {"a damping coefficient", "N.s/m"},
                                                    {"a modulus", "Pa"},
                                                    {"a viscosity", "Pa.s"},
                                                    {"a time", "s"},
                                                    {"a mass", "kg"},
                                                    {"a length", "m"},
                                                    {"an angle", "rad"},
                                                    {"a velocity", "m/s"},
                                                    {"a force", "N"},
                                                    {"a frequency", "Hz"},
                                                    {"an angular frequency", "rad/s"},
                                                    {"a compliance", "m/N"}}};

const DimensionText& text_of(Dimension dimension) {
  return dimensions.at(static_cast<std::size_t>(dimension));
}

// udunits keeps global state for messages and is not thread-safe.
std::mutex& units_mutex() {
  static std::mutex mutex;
  return mutex;
}

// The database says "degree" only.
void add_short_names(ut_system* system) {
  const Unit degree(ut_parse(system, "degree", UT_ASCII));
  if (degree) ut_map_name_to_unit("deg", UT_ASCII, degree.get());
}

constexpr const char* database_variable = "UDUNITS2_XML_PATH";

ut_system* units() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    ut_system* const all = ut_read_xml(nullptr);
    if (all != nullptr) add_short_names(all);
    return all;
  }();
  if (system == nullptr) {
    const char* const file = std::getenv(database_variable);
    throw InputError({database_variable}, file == nullptr ? "nothing" : fmt::format("\"{}\"", file),
                     "the database of units, udunits2.xml: unset the variable, or set it to that "
                     "file of the package libudunits2-data");
  }
  return system;
}

// udunits prints a line's end, which it does not know, on standard output.
Unit parse_unit(const std::string& text) {
  if (text.find('\n') != std::string::npos) return {};
  return Unit(ut_parse(units(), text.c_str(), UT_UTF8));
}

// udunits takes the radian for a pure number, so that Hz and rad/s (or rpm) would convert into one
// another; only the unit's definition tells them apart.
bool angular(const ut_unit* unit) {
  std::array<char, 256> definition{};
  const int length =
      ut_format(unit, definition.data(), definition.size() - 1, UT_ASCII | UT_DEFINITION);
  return length > 0 && std::string_view(definition.data()).find("rad") != std::string_view::npos;
}

/// digits 10^exponent, without point, and without zeros at either end.
struct Decimal {
  bool minus = false;
  std::string digits;
  int exponent = 0;

  std::string text() const { return fmt::format("{}{}e{}", minus ? "-" : "", digits, exponent); }
};

Decimal decimal_of(std::string_view text) {
  Decimal decimal;
  decimal.minus = text.starts_with('-');
  const std::size_t e = text.find_first_of("eE");
  if (e != text.npos) {
    const std::size_t sign = text[e + 1] == '+' ? 1 : 0;
    std::from_chars(text.data() + e + 1 + sign, text.data() + text.size(), decimal.exponent);
  }
  bool behind_point = false;
  for (const char c : text.substr(0, e)) {
    if (c == '.') behind_point = true;
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) continue;
    decimal.digits += c;
    decimal.exponent -= behind_point ? 1 : 0;
  }
  const std::size_t first = decimal.digits.find_first_not_of('0');
  decimal.digits.erase(0, std::min(first, decimal.digits.size()));
  while (decimal.digits.ends_with('0')) decimal.digits.pop_back(), ++decimal.exponent;
  return decimal;
}

// A factor of a unit is taken for a decimal number where it needs no more digits than this: the
// double of another one (pi/30 of rpm) needs 17, and of a thousand of them one ends in so many
// zeros by chance. What is typed may be longer by far, as numbers on paper are.
constexpr std::size_t most_factor_digits = 12, most_typed_digits = 60;

std::optional<Decimal> short_decimal(double factor) {
  Decimal decimal = decimal_of(fmt::format("{:.14e}", factor));
  if (decimal.digits.empty() || decimal.digits.size() > most_factor_digits) return std::nullopt;
  return decimal;
}

std::string multiplied(const std::string& digits, std::uint64_t factor) {
  std::string reversed;
  std::uint64_t carry = 0;  // below 10^13, and 9 times the factor beside it
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    carry += factor * static_cast<std::uint64_t>(*digit - '0');
    reversed += static_cast<char>('0' + carry % 10);
    carry /= 10;
  }
  for (; carry > 0; carry /= 10) reversed += static_cast<char>('0' + carry % 10);
  return {reversed.rbegin(), reversed.rend()};
}

/// Nothing for 0, for more digits than are typed, and beyond the range of doubles.
std::optional<TypedNumber> times(const Decimal& typed, const Decimal& factor) {
  if (typed.digits.empty() || typed.digits.size() > most_typed_digits) return std::nullopt;
  const Decimal result{typed.minus != factor.minus,
                       multiplied(typed.digits, std::stoull(factor.digits)),
                       typed.exponent + factor.exponent};
  const std::optional<double> value = to_double(result.text());
  if (!value) return std::nullopt;
  return TypedNumber{*value, result.text()};
}

bool has_any(std::string_view characters, char c) { return characters.find(c) != characters.npos; }

/// Behind these a number belongs to the unit: an origin, too, which is told as one.
constexpr std::string_view signs = "/*^(@";

/// Whether the number from `begin` to `end` is a part of the unit to people as well: an exponent,
/// what a sign divides or multiplies by, and "1/s".
bool belongs_to_unit(std::string_view unit, std::size_t begin, std::size_t end) {
  const std::size_t next = unit.find_first_not_of(" \t", end);
  if (unit.substr(begin, end - begin) == "1" && next != unit.npos && unit[next] == '/') return true;
  if (begin == 0) return unit == "1";
  const char before = unit[begin - 1];
  if (!has_any(" \t", before)) return unit[begin] != '.' || has_any(signs, before);
  const std::size_t last = unit.find_last_not_of(" \t", begin - 1);
  return last == unit.npos || has_any(signs, unit[last]);
}

/// Where a number begins that is a second one: to udunits "5" of "0.3 5", "-50" of "0.3-50" and
/// "10 %" of "8 N/um 10 %" are units, by which it multiplies. Else npos.
std::size_t second_number(std::string_view unit) {
  constexpr std::string_view digits = "0123456789";
  for (std::size_t digit = 0; (digit = unit.find_first_of(digits, digit)) != unit.npos;) {
    std::size_t begin = digit;
    if (begin > 0 && unit[begin - 1] == '.') --begin;
    if (begin > 0 && has_any("+-", unit[begin - 1])) --begin;
    const std::size_t end = std::min(unit.find_first_not_of("0123456789.", digit), unit.size());
    if (!belongs_to_unit(unit, begin, end)) return begin;
    digit = end;
  }
  return unit.npos;
}

/// Whether a number of the one is one of the other, converted. To udunits a unit and its reciprocal
/// are convertible: "5 ms" would be a frequency, 200 Hz.
bool measures_the_same(const ut_unit* one, const ut_unit* other) {
  const Unit ratio(ut_divide(one, other));
  return ratio && ut_is_dimensionless(ratio.get()) != 0;
}

bool measures(const ut_unit* unit, Dimension dimension) {
  return measures_the_same(unit, parse_unit(text_of(dimension).unit).get());
}

// Data sheets and tables have moduli where a contact needs a stiffness.
const char* advice_on_dimension(const ut_unit* from, Dimension dimension) {
  if (dimension == Dimension::stiffness && measures(from, Dimension::modulus))
    return "a modulus needs a length: below a flat punch of radius a, k = 2 a E/(1 - nu^2); or add "
           "an [indenter], whose elements are moduli";
  if (dimension == Dimension::damping && measures(from, Dimension::viscosity))
    return "a viscosity needs a length: below a flat punch of radius a, c = 2 a eta/(1 - nu^2); or "
           "add an [indenter], whose elements are viscosities";
  if (dimension == Dimension::modulus && measures(from, Dimension::stiffness))
    return "below an [indenter] springs are moduli; without it they are stiffnesses";
  if (dimension == Dimension::viscosity && measures(from, Dimension::damping))
    return "below an [indenter] dampers are viscosities; without it they are damping coefficients";
  return "";
}

struct Explanation {
  std::string why, advice;
};

// What is no unit: a decimal comma, a value from peak to peak, a slip of the pen.
Explanation of_unknown_unit(double value, std::string_view unit, Dimension dimension,
                            std::string_view whole) {
  const std::string_view number = trimmed(whole.substr(0, whole.size() - unit.size()), " \t");
  if (std::string advice = advice_on_comma(number, unit); !advice.empty())
    return {"a comma in a number", std::move(advice)};
  const auto is_length = [&](const std::string& text) {
    const Unit length = text.empty() ? Unit() : parse_unit(text);
    return length && dimension == Dimension::length && measures(length.get(), dimension);
  };
  if (const std::string rest(before_peak_to_peak(unit)); is_length(rest))
    return {"from peak to peak", fmt::format("an amplitude is half of peak to peak: \"{} {}\"",
                                             to_text(value / 2), rest)};
  if (const std::string rest(before_root_mean_square(unit)); is_length(rest))
    return {"a root mean square",
            fmt::format("the amplitude of a sine is sqrt(2) times that: \"{:.4g} {}\"",
                        value * std::sqrt(2.0), rest)};
  if (const std::string rest(before_peak(unit)); is_length(rest))
    return {"a peak value", fmt::format("an amplitude is one: \"{} {}\"", number, rest)};
  return {fmt::format("unknown unit \"{}\"", unit),
          advice_on_unknown_unit(number, unit, dimension)};
}

/// Without udunits, whose database takes longer to read than most scenes; nothing for what it has
/// to be asked about. A database of the user's may have a meaning of its own for any unit.
std::optional<TypedNumber> by_usual_unit(const Decimal& number, std::string_view unit,
                                         Dimension dimension) {
  const std::optional<int> power = usual_power(unit, dimension);
  if (!power || std::getenv(database_variable) != nullptr) return std::nullopt;
  return times(number, {false, "1", *power});
}

TypedNumber convert(double value, const Decimal& number, std::string_view unit, Dimension dimension,
                    const Place& place, std::string_view whole) {
  if (const auto converted = by_usual_unit(number, unit, dimension)) return *converted;
  const auto refuse = [&](const std::string& why, const std::string& advice = "") {
    throw InputError(place, fmt::format("\"{}\" ({})", whole, why), describe(dimension), advice);
  };
  if (unit.size() > longest_unit)
    refuse(fmt::format("a unit of {} characters, more than {}", unit.size(), longest_unit));
  const std::string_view typed = trimmed(whole.substr(0, whole.size() - unit.size()), " \t");
  const std::size_t second = second_number(unit);
  const auto refuse_number = [&](const std::string& advice) {
    refuse(fmt::format("\"{}\" is a second number, no unit", unit.substr(second)), advice);
  };
  if (second == 0) refuse_number(advice_on_thousands(typed, unit));
  // To udunits minutes and seconds of arc.
  if (unit.find_first_of("'\"") != unit.npos)
    refuse(fmt::format("unknown unit \"{}\"", unit), advice_on_thousands(typed, unit));
  const std::scoped_lock lock(units_mutex());
  const Unit from = parse_unit(std::string(unit));
  // To udunits the byte 0xFF is the end of a unit.
  if (!from || printable(unit) != unit || is_mistaken_unit(unit)) {
    const Explanation found = of_unknown_unit(value, unit, dimension, whole);
    refuse(found.why, found.advice);
  }
  const Unit to = parse_unit(text_of(dimension).unit);
  if (!measures_the_same(from.get(), to.get())) {
    if (dimension == Dimension::length && !before_peak_to_peak(unit).empty()) {
      const Explanation found = of_unknown_unit(value, unit, dimension, whole);
      refuse(found.why, found.advice);
    }
    refuse("a unit of another dimension", advice_on_dimension(from.get(), dimension));
  }
  if (dimension == Dimension::none && angular(from.get()))
    refuse("an angle", "write the tangent of the angle, if that is meant");
  if (dimension == Dimension::frequency && angular(from.get()))
    refuse("an angular frequency, not cycles a second",
           fmt::format("write it as angular_frequency = \"{}\"", whole));
  if (dimension == Dimension::angular_frequency && !angular(from.get()))
    refuse("a frequency, not an angle a second",
           fmt::format("write it as frequency = \"{}\"", whole));
  const std::unique_ptr<cv_converter, void (*)(cv_converter*)> converter(
      ut_get_converter(from.get(), to.get()), cv_free);
  if (!converter) refuse("a unit that cannot be converted");
  if (second != unit.npos) refuse_number("write the value and its unit alone");
  // "8 N/um @ 20" is 28 N/um to udunits, to people a stiffness at some frequency.
  if (cv_convert_double(converter.get(), 0) != 0)
    refuse("a unit with a zero of its own", "write the value and its unit alone");
  if (const auto factor = short_decimal(cv_convert_double(converter.get(), 1)))
    if (const auto product = times(number, *factor)) return *product;
  return {cv_convert_double(converter.get(), value), {}};
}

/// No-break and thin spaces, as texts copied from pages have them before a unit, like any other.
std::string with_plain_spaces(std::string_view text) {
  std::string plain(text);
  for (const std::string_view space : {"\u00a0", "\u2009", "\u202f"})
    for (auto at = plain.find(space); at != plain.npos; at = plain.find(space, at))
      plain.replace(at, space.size(), " ");
  return plain;
}

}  // namespace

const char* si_unit(Dimension dimension) { return text_of(dimension).unit; }

std::string describe(Dimension dimension) {
  const DimensionText& text = text_of(dimension);
  if (dimension == Dimension::none) return text.name;
  return fmt::format("{} in {}", text.name, text.unit);
}

double parse_quantity(std::string_view text, Dimension dimension, const Place& place) {
  return parse_typed(text, dimension, place).value;
}

TypedNumber parse_typed(std::string_view text, Dimension dimension, const Place& place) {
  const std::string plain = with_plain_spaces(text);
  const std::string_view whole = trimmed(plain, " \t");
  if (has_typeset_minus(whole))
    throw InputError(place, fmt::format("\"{}\" (a typeset minus sign or dash)", text),
                     describe(dimension), "write the minus sign of the keyboard, \"-\"");
  // No inf or nan; and of "2eV" it is the 2 that is the number.
  const auto end = std::min(whole.find_first_not_of("0123456789.+-eE"), whole.size());
  const LeadingNumber number = leading_number(whole.substr(0, end));
  if (number.length == 0)
    throw InputError(place, fmt::format("\"{}\"", text),
                     "a number and a unit: " + describe(dimension));
  if (!number.value)
    throw InputError(place, fmt::format("\"{}\", beyond the range of doubles", text),
                     describe(dimension));
  const std::string_view unit = trimmed(whole.substr(number.length), " \t");
  TypedNumber typed{*number.value, {}, unit.empty()};
  if (!unit.empty()) {
    typed = convert(*number.value, decimal_of(whole.substr(0, number.length)), unit, dimension,
                    place, whole);
    typed.text = whole;
  }
  if (!std::isfinite(typed.value))
    throw InputError(place, fmt::format("\"{}\", which is not finite", text), describe(dimension));
  return typed;
}

}  // namespace vcrit
