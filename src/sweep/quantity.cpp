#include "sweep/quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/identifiers.hpp"
#include "problem/variation.hpp"
#include "scene/settings.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit {

namespace {

const std::string sensitivity_prefix = "sensitivity:";

}  // namespace

const std::vector<std::string>& swept_quantity_names() {
  static const std::vector<std::string> names{"critical_velocity",    "friction_ratio",
                                              "friction_ratio_error", "regime",
                                              "admissible",           sensitivity_prefix + "NAME"};
  return names;
}

SweptQuantity parse_swept_quantity(const std::string& text, const Problem& problem) {
  const Place place = argument("quantity");
  if (text.starts_with(sensitivity_prefix)) {
    const std::string name = text.substr(sensitivity_prefix.size());
    known_dimension(name, problem->source->settable, place, problem->source->named);
    const Symbol parameter = target_of(problem, name).symbol;
    return {SweptQuantity::Kind::sensitivity, parameter, problem->separation || problem->indenter,
            to_text(as_called(problem, parameter))};
  }
  const auto& names = swept_quantity_names();
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    if (names[i] == text)
      return {
          static_cast<SweptQuantity::Kind>(i), {}, problem->separation || problem->indenter, {}};
  const auto meant = nearest(text, names);
  throw InputError(
      place, fmt::format("\"{}\"", text),
      meant ? fmt::format("\"{}\"", *meant) : fmt::format("one of {}", fmt::join(names, ", ")));
}

std::string column_name(const SweptQuantity& quantity) {
  if (quantity.kind == SweptQuantity::Kind::sensitivity) return "sensitivity_" + quantity.name;
  return swept_quantity_names()[static_cast<std::size_t>(quantity.kind)];
}

std::string unit(const SweptQuantity& quantity) {
  return quantity.kind == SweptQuantity::Kind::critical_velocity ? "m/s" : "1";
}

std::string description(const SweptQuantity& quantity) {
  switch (quantity.kind) {
    case SweptQuantity::Kind::critical_velocity:
      return quantity.parting ? "critical velocity v* (Eq. 24, or simulated where surfaces part)"
                              : "critical velocity v* (Eq. 24)";
    case SweptQuantity::Kind::friction_ratio:
      return "macroscopic over microscopic coefficient of friction, simulated";
    case SweptQuantity::Kind::friction_ratio_error:
      return "estimated absolute error of the friction ratio";
    case SweptQuantity::Kind::regime:
      return "regime of the steady motion, simulated";
    case SweptQuantity::Kind::admissible:
      return "whether Eq. 24 applies: no jumping, closed contact";
    case SweptQuantity::Kind::sensitivity:
      return fmt::format("relative change of v* per relative change of {}", quantity.name);
  }
  throw Bug("a quantity without a description");
}

const std::vector<std::string>& words(const SweptQuantity& quantity) {
  using simulation::Regime;
  static const std::vector<std::string> none, answers{"no", "yes"},
      touching{to_text(Regime::sliding), to_text(Regime::stick_slip),
               to_text(Regime::stick_slip_backslip), to_text(Regime::stick)},
      parting{to_text(Regime::sliding),
              to_text(Regime::stick_slip),
              to_text(Regime::stick_slip_backslip),
              to_text(Regime::stick),
              to_text(Regime::sliding_apart),
              to_text(Regime::stick_slip_apart),
              to_text(Regime::stick_slip_backslip_apart)};
  if (quantity.kind == SweptQuantity::Kind::regime) return quantity.parting ? parting : touching;
  return quantity.kind == SweptQuantity::Kind::admissible ? answers : none;
}

int first_flag(const SweptQuantity& quantity) {
  return quantity.kind == SweptQuantity::Kind::regime ? 1 : 0;
}

std::string word_of(const SweptQuantity& quantity, double flag) {
  const int place = static_cast<int>(flag) - first_flag(quantity);
  return place < 0 ? "" : words(quantity).at(static_cast<std::size_t>(place));
}

bool needs_motion(const SweptQuantity& quantity) {
  return quantity.kind == SweptQuantity::Kind::friction_ratio ||
         quantity.kind == SweptQuantity::Kind::friction_ratio_error ||
         quantity.kind == SweptQuantity::Kind::regime;
}

}  // namespace vcrit
