// What the numbers in expressions measure, from the units of those that are known.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "network/amount.hpp"

namespace vcrit {

/// What a number is and measures. A spring of a half-space measures a modulus, one of the drive
/// that holds its indenter a stiffness.
struct NumberMeasure {
  NumberRole role = NumberRole::stiffness;
  Dimension dimension = Dimension::stiffness;

  friend bool operator==(const NumberMeasure&, const NumberMeasure&) = default;
};

/// An expression that has to measure this.
struct MeasuredExpression {
  std::string name, text;
  Place place;
  AmountTreePointer expression;
  NumberMeasure measure;
};

/// Which parts of a scene the expressions are of, and so what a number without a unit may measure.
enum class MeasuredParts { networks, half_space, both };

/// What numbers measure in such expressions, each once.
std::vector<NumberMeasure> measures_in(MeasuredParts parts);

/// What all names in the expressions measure; `known` is that of some of them. What the
/// expressions leave open is a stiffness (of a half-space a modulus) or a damper by its first
/// letter, k or c, else a plain number. Throws InputError for an expression that does not measure
/// what it has to, and for a sum of what does not measure the same.
std::map<std::string, NumberMeasure> measures_of_names(
    const std::vector<MeasuredExpression>& expressions, std::map<std::string, NumberMeasure> known,
    MeasuredParts parts);

}  // namespace vcrit
