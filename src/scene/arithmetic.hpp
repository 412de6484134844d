// Expressions in the place of values in [elements]: "2*k0", "k1*tau", "c0/(1 + r)^2". Sums,
// products, quotients and whole powers of names and numbers; no differences, so that what is made
// of positive numbers is positive.
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <optional>
#include <string>

#include "base/errors.hpp"
#include "network/amount.hpp"

namespace vcrit {

constexpr std::size_t most_operations_of_one =
    1000;  ///< of an expression, with those that it is made of

/// The text where it is an expression, and neither a name, nor a number, nor a quantity.
std::optional<std::string> expression_in(const toml::node& value);

/// `place` is where its first character stands. Names are as they are written, of no role yet.
/// Throws InputError with the column.
AmountTreePointer parse_arithmetic(const std::string& text, const Place& place);

}  // namespace vcrit
