// The network of springs and dampers whose stiffness is a rational function K(s), its Foster form:
// K(s) = k0 + c s + sum k_j s/(s + 1/tau_j). There is one exactly where all poles of K(s)/s but
// that at s = 0 are negative, real and simple, and its residues are positive (Foster, 1924).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/units.hpp"
#include "network/network.hpp"
#include "network/rational.hpp"

namespace vcrit {

/// Elements of a Foster form, each with its number, or with an expression of other numbers.
struct FosterForm {
  Network network;
  std::vector<std::pair<Symbol, TypedNumber>> values = {};
  std::vector<std::pair<Symbol, std::string>> expressions = {};
};

/// Why there is none: what was found, what was expected, and what to do.
struct NoFosterForm {
  std::string found, expected, advice = {};
};

/// The elements are called after `name`: k0_name, c_name, k_name[j] with tau_name[j], the fastest
/// branch last. Their numbers are those of K(s) to 60 digits; whether they exist is decided
/// exactly. `stiffness` may have common factors.
std::variant<FosterForm, NoFosterForm> foster_form(const RationalFunction& stiffness,
                                                   const std::string& name);

/// a/b to 60 digits, of integers above 0; nothing where no double can hold it.
std::optional<TypedNumber> quotient_value(const std::string& a, const std::string& b);

}  // namespace vcrit
