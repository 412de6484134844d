#include "fit/scene_text.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "base/constants.hpp"
#include "base/messages.hpp"
#include "base/numbers.hpp"
#include "base/plain_text.hpp"
#include "base/rounded.hpp"
#include "base/units.hpp"
#include "scene/range.hpp"

namespace vcrit::fit {

namespace {

// Ten digits: rounding far below what the search settles to.
std::string digits(double value) { return fmt::format("{:.10g}", value); }

std::string list(const std::vector<FittedBranch>& branches, Uncertain FittedBranch::*number) {
  std::string text;
  for (const FittedBranch& branch : branches)
    text += (text.empty() ? "" : ", ") + digits((branch.*number).value);
  return "[" + text + "]";
}

// Titles and names of files have any bytes; a scene is UTF-8, and this one line of it.
std::string on_a_line(const std::string& text) { return printable(one_line(text)); }

// A basic string of TOML.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : on_a_line(text)) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string name_of(const StiffnessTable& data) {
  return std::filesystem::path(data.file).filename().string();
}

struct Line {
  const char* key;
  const std::string& value;
  Dimension dimension;
  const Range& range;
  const char* example;  ///< with what it means
};

// As the scene's own reader takes it, which knows nothing of options.
void refuse_wrong(const Line& line) {
  const Place place = argument(line.key);
  checked(parse_typed(line.value, line.dimension, place), line.range, line.key, place);
}

// A bare number stays one; anything else is a text with a unit.
std::string given(const Line& line) {
  if (line.value.empty()) return fmt::format("# {} = {}\n", line.key, line.example);
  refuse_wrong(line);
  return fmt::format("{} = {}\n", line.key, quoted(line.value));
}

std::string network(const Fit& fit) {
  std::string text = fit.branches.empty() ? "k0" : "prony(k0, k, tau)";
  if (fit.damper) text += " | c0";
  return text;
}

std::string contact(const Fit& fit, const StiffnessTable& data, const Rest& rest) {
  std::string text = fmt::format("[contact]\nnormal  = \"{}\"\n", network(fit));
  text += fmt::format(
      "fitted_range = [\"{} Hz\", \"{} Hz\"]  # the data; vcrit warns of frequencies beyond\n",
      to_text(data.rows.front().omega / two_pi), to_text(data.rows.back().omega / two_pi));
  if (rest.poisson.empty())
    return text +
           "poisson = \"nu\"  # a symbol: put Poisson's ratio here, or a tangential network\n";
  return text + given({"poisson", rest.poisson, Dimension::none, poisson_range, ""});
}

std::string elements(const Fit& fit) {
  std::string text = "[elements]  # N/m";
  if (!fit.branches.empty()) text += ", s";
  if (fit.damper) text += ", N s/m";
  text += "\n";
  text += fit.equilibrium
              ? fmt::format("k0  = {}\n", digits(fit.equilibrium->value))
              : "k0  = 0  # the data need no equilibrium spring: without one this contact carries "
                "no static load\n";
  if (fit.damper) text += fmt::format("c0  = {}\n", digits(fit.damper->value));
  if (fit.branches.empty()) return text;
  return text + fmt::format("k   = {}\ntau = {}\n", list(fit.branches, &FittedBranch::stiffness),
                            list(fit.branches, &FittedBranch::time));
}

std::string origin(const Fit& fit, const StiffnessTable& data) {
  constexpr double hertz = two_pi;  // rad/s
  return fmt::format(
      "# Prony series with {} branch{}, fitted by `vcrit fit` to {} frequencies of {}, {} to {},\n"
      "# with a root mean square misfit of {:.2g} %.\n",
      fit.branches.size(), fit.branches.size() == 1 ? "" : "es", data.rows.size(),
      on_a_line(name_of(data)), rounded(data.rows.front().omega / hertz, "Hz"),
      rounded(data.rows.back().omega / hertz, "Hz"), 100 * fit.rms_relative);
}

}  // namespace

std::string scene_text(const Fit& fit, const StiffnessTable& data, const Rest& rest) {
  const std::string title = rest.title.empty() ? "Contact fitted to " + name_of(data) : rest.title;
  return origin(fit, data) + "title = " + quoted(title) + "\n\n" + contact(fit, data, rest) +
         "\n[oscillation]\n" +
         given({"frequency", rest.frequency, Dimension::frequency, frequency_range, "\"20 kHz\""}) +
         given({"amplitude", rest.amplitude, Dimension::length, nonnegative, "\"0.1 um\""}) +
         given({"indentation", rest.indentation, Dimension::length, nonnegative,
                "\"0.5 um\"  # the mean; the contact stays closed for smaller amplitudes only"}) +
         "\n[friction]\n" +
         given({"coefficient", rest.coefficient, Dimension::none, nonnegative, "0.3"}) + "\n" +
         elements(fit);
}

}  // namespace vcrit::fit
