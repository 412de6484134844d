#include "report/document.hpp"

#include <fmt/core.h>
#include <nettle/base64.h>
#include <nettle/sha2.h>

#include <array>
#include <cctype>
#include <cmath>

#include "base/errors.hpp"
#include "base/numbers.hpp"
#include "formula/text.hpp"
#include "record/html_text.hpp"
#include "record/template.hpp"
#include "report/assets.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

std::vector<std::string_view> scripts_of(const Document& content) {
  std::vector<std::string_view> result;
  if (content.charts)
    for (const std::string_view script : scripts()) result.push_back(script);
  result.insert(result.end(), content.scripts.begin(), content.scripts.end());
  return result;
}

/// HTML reads a script's text for these alone, in whatever case.
bool ends_early(std::string_view script) {
  for (std::size_t at = script.find('<'); at != script.npos; at = script.find('<', at + 1)) {
    std::string next(script.substr(at, 8));
    for (char& c : next) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (next == "</script" || next.starts_with("<!--")) return true;
  }
  return false;
}

std::string policy(const std::vector<std::string_view>& scripts, bool simulates) {
  std::string allowed = "default-src 'none'; ";
  if (!scripts.empty()) {
    allowed += "script-src";
    for (const std::string_view script : scripts) allowed += " '" + script_hash(script) + "'";
    if (simulates) allowed += " 'wasm-unsafe-eval'";
    allowed += "; img-src data: blob:; ";
  }
  return allowed + "style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";
}

std::string style_of(const Document& content) {
  std::string all(style());
  all += symbolic::mathml_style();
  if (content.simulates) all += explorer_style();
  return all;
}

// Formats that templates name.

std::string exact(double value, const std::string&) { return vcrit::to_text(value); }

std::string in_magnitude(double value, const std::string&) { return magnitude(value); }

std::string in_nanoseconds(double nanoseconds, const std::string&) {
  return rounded(1e-9 * nanoseconds, "s", 3);
}

std::string microseconds(double seconds, const std::string&) {
  return fmt::format("{:.3g}", 1e6 * seconds);
}

/// Without a power of ten as programs write it: "4.58 × 10¹¹".
std::string in_digits(double value, const std::string& digits) {
  return rounded(value, "", std::stoi(digits));
}

/// What a number is off, as "−1.4 × 10⁻⁸".
std::string off(double difference, const std::string&) {
  return (difference < 0 ? "−" : "") + magnitude(std::abs(difference));
}

/// With a minus sign as people write it, and so many digits behind the point.
std::string with_sign(double value, const std::string& digits) {
  return fmt::format("{}{:.{}f}", value < 0 ? "−" : "", std::abs(value), std::stoi(digits));
}

/// `argument`: the unit, and how many digits if it says so: "m/s 5".
std::string in_unit(double value, const std::string& argument) {
  const auto space = argument.rfind(' ');
  if (space == argument.npos || std::isdigit(static_cast<unsigned char>(argument.back())) == 0)
    return quantity(value, argument);
  return quantity(value, argument.substr(0, space), std::stoi(argument.substr(space + 1)));
}

}  // namespace

std::string script_hash(std::string_view text) {
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, text.size(), reinterpret_cast<const unsigned char*>(text.data()));
  std::array<unsigned char, SHA256_DIGEST_SIZE> hash{};
  sha256_digest(&context, hash.size(), hash.data());
  std::array<char, BASE64_ENCODE_RAW_LENGTH(SHA256_DIGEST_SIZE)> base64{};
  base64_encode_raw(base64.data(), hash.size(), hash.data());
  return "sha256-" + std::string(base64.begin(), base64.end());
}

std::string rendered(const char* name, const record::Json& record) {
  static const record::Templates all(templates(), record::html_text,
                                     {{"exact", exact},
                                      {"magnitude", in_magnitude},
                                      {"microseconds", microseconds},
                                      {"digits", in_digits},
                                      {"nanoseconds", in_nanoseconds},
                                      {"off", off},
                                      {"quantity", in_unit},
                                      {"signed", with_sign}});
  return all.render(name, record);
}

std::string document(const char* name, record::Json record, const Document& about) {
  const record::Fields page(record::Reader::page);
  const auto all = scripts_of(about);
  std::vector<record::Markup> scripts;
  for (const std::string_view script : all) {
    ensure(!ends_early(script), "a script is whole");
    scripts.push_back({std::string(script)});
  }
  record["page"] = {{"title", about.title},
                    {"policy", page.written(record::Markup{policy(all, about.simulates)})},
                    {"style", page.written(record::Markup{style_of(about)})},
                    {"scripts", page.written(scripts)}};
  return rendered(name, record) + "\n";
}

}  // namespace vcrit::validation::report
