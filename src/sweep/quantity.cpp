#include "sweep/quantity.hpp"

#include <fmt/core.h>

#include <string_view>

#include "base/identifiers.hpp"
#include "base/joined.hpp"
#include "base/trimmed.hpp"
#include "problem/variation.hpp"
#include "rules/kinds.hpp"
#include "scene/settings.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit {

namespace {

using Kind = SweptQuantity::Kind;
using simulation::Regime;
using Words = std::vector<std::string>;

constexpr std::string_view sensitivity_prefix = "sensitivity:";

/// What is said of a quantity, and how its words are numbered.
struct QuantityRow {
  Kind kind;
  std::string name;
  const char *unit, *description;  ///< {}: the parameter
  bool needs_motion;
  Words words = {}, words_separating = {};
  int first_flag = 0;
};

const std::vector<QuantityRow>& quantity_rows() {
  static const Words answers{"no", "yes"},
      closed{to_text(Regime::sliding), to_text(Regime::stick_slip),
             to_text(Regime::stick_slip_backslip), to_text(Regime::stick)},
      separating{to_text(Regime::sliding),
                 to_text(Regime::stick_slip),
                 to_text(Regime::stick_slip_backslip),
                 to_text(Regime::stick),
                 to_text(Regime::sliding_separated),
                 to_text(Regime::stick_slip_separated),
                 to_text(Regime::stick_slip_backslip_separated)};
  static const std::vector<QuantityRow> all{
      {Kind::critical_velocity, "critical_velocity", "m/s", "critical velocity v* (Eq. 24)", false},
      {Kind::friction_ratio, "friction_ratio", "1",
       "macroscopic over microscopic coefficient of friction, simulated", true},
      {Kind::friction_ratio_error, "friction_ratio_error", "1",
       "estimated absolute error of the friction ratio", true},
      {Kind::regime, "regime", "1", "regime of the steady motion, simulated", true, closed,
       separating, 1},
      {Kind::admissible, "admissible", "1", "whether Eq. 24 applies: closed contact", false,
       answers, answers},
      {Kind::indentation, "indentation", "m", "mean indentation", false},
      {Kind::mean_normal_force, "mean_normal_force", "N", "mean normal force", false},
      {Kind::contact_amplitude, "contact_amplitude", "m", "amplitude at the contact", false},
      {Kind::sensitivity, std::string(sensitivity_prefix) + "NAME", "1",
       "relative change of v* per relative change of {}", false}};
  return all;
}

const QuantityRow& row_of_quantity(const SweptQuantity& quantity) {
  for (const QuantityRow& row : quantity_rows())
    if (row.kind == quantity.kind) return row;
  throw Bug("a quantity without a row");
}

}  // namespace

const std::vector<std::string>& swept_quantity_names() {
  static const Words names = [] {
    Words list;
    for (const QuantityRow& row : quantity_rows()) list.push_back(row.name);
    return list;
  }();
  return names;
}

SweptQuantity parse_swept_quantity(const std::string& text, const Problem& problem) {
  const Place place = argument("quantity");
  if (const std::size_t comma = text.find(','); comma != std::string::npos)
    throw InputError(place, fmt::format("\"{}\"", text), "one name a word",
                     fmt::format("several stand apart, without commas: {} {}",
                                 text.substr(0, comma), trimmed(text.substr(comma + 1), " ")));
  const bool separates = rules::may_open(problem);
  if (text.starts_with(sensitivity_prefix)) {
    const std::string name = text.substr(sensitivity_prefix.size());
    refuse_expression(*problem->source, name, place);
    known_dimension(name, problem->source->settable, place, problem->source->named);
    const Symbol parameter = target_of(problem, name).symbol;
    return {Kind::sensitivity, parameter, separates, to_text(as_called(problem, parameter))};
  }
  for (const QuantityRow& row : quantity_rows())
    if (row.name == text && row.kind != Kind::sensitivity) return {row.kind, {}, separates, {}};
  const auto& names = swept_quantity_names();
  auto meant = nearest(text, names);
  if (text.starts_with('v')) meant = "critical_velocity";  // v*, vstar, v_crit
  if (text == "friction" || text == "mu") meant = "friction_ratio";
  throw InputError(
      place, fmt::format("\"{}\"", text),
      meant ? fmt::format("\"{}\"", *meant) : fmt::format("one of {}", joined(names, ", ")));
}

std::string column_name(const SweptQuantity& quantity) {
  if (quantity.kind == Kind::sensitivity) return "sensitivity_" + quantity.name;
  return row_of_quantity(quantity).name;
}

std::string unit(const SweptQuantity& quantity) { return row_of_quantity(quantity).unit; }

std::string description(const SweptQuantity& quantity) {
  if (quantity.kind == Kind::critical_velocity && quantity.separates)
    return "critical velocity v* (Eq. 24, or simulated where the contact opens)";
  return fmt::format(fmt::runtime(row_of_quantity(quantity).description), quantity.name);
}

const std::vector<std::string>& words(const SweptQuantity& quantity) {
  const QuantityRow& row = row_of_quantity(quantity);
  return quantity.separates ? row.words_separating : row.words;
}

int first_flag(const SweptQuantity& quantity) { return row_of_quantity(quantity).first_flag; }

std::string word_of(const SweptQuantity& quantity, double flag) {
  const int place = static_cast<int>(flag) - first_flag(quantity);
  return place < 0 ? "" : words(quantity).at(static_cast<std::size_t>(place));
}

bool needs_motion(const SweptQuantity& quantity) { return row_of_quantity(quantity).needs_motion; }

}  // namespace vcrit
