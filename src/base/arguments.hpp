// How the arguments of a call are called where people read of them. A library names each by a key,
// in what it advises in backquotes, `velocity_ratio`; who calls it spells the key as its users
// write it: --velocity-ratio for the program, velocity_ratio in Python.
#pragma once

#include <functional>
#include <string>

#include "base/errors.hpp"

namespace vcrit {

/// Of a key and what follows it: "velocity_ratio", "set k1", "set NAME=VALUE", "from, to".
using ArgumentSpelling = std::function<std::string(const std::string& argument)>;

/// `text` with its keys spelled. A whole command, `vcrit fit DATA.csv`, stays as it is, and so does
/// what no key begins like.
std::string spelled(const std::string& text, const ArgumentSpelling& spelling);

/// The error with its argument and the keys of what it expects and advises spelled; what was found
/// is the user's own text.
InputError spelled(const InputError& error, const ArgumentSpelling& spelling);
ModelError spelled(const ModelError& error, const ArgumentSpelling& spelling);

}  // namespace vcrit
