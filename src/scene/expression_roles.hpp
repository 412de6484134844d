// What the numbers in expressions measure, from the units of those that are known.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "network/amount.hpp"

namespace vcrit {

/// An expression that has to measure what `role` says.
struct MeasuredExpression {
  std::string name, text;
  Place place;
  AmountTreePointer expression;
  NumberRole role = NumberRole::stiffness;
};

/// The roles of all names in the expressions; `known` are those of some of them. What the
/// expressions leave open is a stiffness or a damper by its first letter, k or c, else a plain
/// number. Throws InputError for an expression that does not measure what it has to, and for a sum
/// of what does not measure the same.
std::map<std::string, NumberRole> roles_of_names(const std::vector<MeasuredExpression>& expressions,
                                                 std::map<std::string, NumberRole> known,
                                                 bool of_half_space);

}  // namespace vcrit
