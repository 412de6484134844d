// An option that takes one of some names.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <utility>
#include <vector>

namespace vcrit::app {

/// Names and what they stand for; the first one is the default.
template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

/// An option that takes one of the names.
template <class T>
CLI::Option* add_choice(CLI::App& command, const std::string& option, T& target,
                        const Choices<T>& choices, const std::string& words) {
  std::vector<std::string> names;
  for (const auto& choice : choices) names.push_back(choice.first);
  const auto choose = [&target, choices](const std::string& name) {
    for (const auto& [choice, value] : choices)
      if (name == choice) target = value;
  };
  return command.add_option_function<std::string>(option, choose, words)
      ->check(CLI::IsMember(names))
      ->default_str(names.front());
}

}  // namespace vcrit::app
