// Networks as one writes them: "k0 | (k1 - c1)" with | parallel, - series (which binds tighter),
// parentheses, names of springs (k...) and dampers (c...), named networks, and as calls the
// catalogue's rheologies, "kelvin(k, c)", and networks with arguments of their own.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/errors.hpp"
#include "network/network.hpp"

namespace vcrit {

constexpr int deepest_nesting = 200;  ///< brackets in one another, named networks counted as such
constexpr std::size_t most_elements = 1'000'000;  ///< of one network

/// What an expression's names may refer to besides elements.
struct Surroundings {
  /// The network of that name, if there is one; may throw InputError (cycles). `level`: how deep in
  /// brackets the name stands.
  std::function<std::optional<Network>(const std::string& name, const Place&, int level)>
      named_network;
  /// The length of the array of that name, if there is one.
  std::function<std::optional<int>(const std::string& name)> array_length;
  /// How deep in brackets the text itself stands.
  int level = 0;
  /// Whether there is a network of that name with arguments; where this is absent there is none.
  std::function<bool(const std::string& name)> has_arguments = {};
  /// That network with elements of these names for its arguments; may throw InputError.
  std::function<Network(const std::string& name, const std::vector<std::string>& arguments,
                        const Place&, int level)>
      called_network = {};
  /// What the text's own arguments stand for; other names stand for themselves.
  std::map<std::string, std::string> arguments = {};
  /// Takes the complaint of an element of unknown kind, so that the rest is read for its own; where
  /// this is absent the complaint is thrown.
  std::function<void(const InputError&)> complain = {};
};

/// `place` is where the first character of `text` stands. Throws InputError with the column,
/// also beyond the two limits above.
Network parse_expression(std::string_view text, const Place& place, const Surroundings& around);

}  // namespace vcrit
