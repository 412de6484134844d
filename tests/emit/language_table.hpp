// The rows of tests/languages/languages.toml, and the programs that call evaluators of a language.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "derivation/derivation.hpp"
#include "emit/asked.hpp"
#include "emit/parameters.hpp"
#include "scene/scene.hpp"

namespace vcrit::test {

/// Words, where FOLDER/ stands for the folder of the files.
using Command = std::vector<std::string>;

/// What compiles and runs evaluators of a language.
struct Tool {
  std::string label, language;
  Command present, compile, run;
  bool wide = false;         ///< knows numbers out of range
  bool is_optional = false;  ///< `./dev test` does not install it
};

struct LanguageRow {
  std::string name, driver;
  Command arithmetic, quick, elements, libraries;
  std::vector<Tool> tools;
};

inline std::vector<LanguageRow> read_language_rows() {
  const toml::table table = toml::parse_file(VCRIT_LANGUAGE_TESTS "/languages.toml");
  const auto strings = [](const toml::node* list) {
    Command words;
    if (list != nullptr)
      for (const toml::node& word : *list->as_array()) words.push_back(*word.value<std::string>());
    return words;
  };
  const auto command = [&](const toml::node* list) {
    Command words;
    for (const std::string& word : strings(list)) {
      const Command expanded = word == "STRICT" ? strings(table.get("STRICT")) : Command{word};
      words.insert(words.end(), expanded.begin(), expanded.end());
    }
    return words;
  };
  std::vector<LanguageRow> rows;
  for (const auto& [name, node] : table) {
    if (!node.is_table()) continue;
    const toml::table& language = *node.as_table();
    LanguageRow row{std::string(name.str()),
                    *language["driver"].value<std::string>(),
                    command(language.get("arithmetic")),
                    strings(language.get("quick")),
                    strings(language.get("elements")),
                    strings(language.get("libraries")),
                    {}};
    for (const toml::node& each : *language.get("tools")->as_array()) {
      const toml::table& tool = *each.as_table();
      Tool read{*tool["label"].value<std::string>(),
                row.name,
                strings(tool.get("present")),
                command(tool.get("compile")),
                strings(tool.get("run")),
                language["wide"].value_or(false),
                tool["optional"].value_or(false)};
      if (read.present.empty())
        read.present = {(read.compile.empty() ? read.run : read.compile).front(), "--version"};
      row.tools.push_back(std::move(read));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

inline const std::vector<LanguageRow>& language_rows() {
  static const std::vector<LanguageRow> rows = read_language_rows();
  return rows;
}

/// Without C++, whose tests have more to ask.
inline std::vector<LanguageRow> other_languages() {
  std::vector<LanguageRow> rows = language_rows();
  std::erase_if(rows, [](const LanguageRow& row) { return row.name == "c++"; });
  return rows;
}

inline std::string library(std::size_t i) { return "scene_" + std::to_string(i); }

inline std::string replaced_all(std::string text, const std::string& mark, const std::string& by) {
  for (std::size_t at = text.find(mark); at != std::string::npos;
       at = text.find(mark, at + by.size()))
    text.replace(at, mark.size(), by);
  return text;
}

/// [["mu0", 0], ["k", 10]], as Python and JavaScript read it.
inline std::string layout(const symbolic::ParameterList& parameters) {
  std::vector<std::string> members;
  for (const symbolic::Member& member : parameters.members())
    members.push_back(fmt::format("[\"{}\", {}]", member.name, member.length));
  return fmt::format("[{}]", fmt::join(members, ", "));
}

/// The lines between "//: each" and "//: end" for every scene's library.
inline std::string driver_of(const LanguageRow& row,
                             const std::vector<symbolic::ParameterList>& libraries, Asked asked) {
  std::istringstream lines(read_file(std::filesystem::path(VCRIT_LANGUAGE_TESTS) / row.driver));
  std::string out, each;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(": each")) {
      inside = true;
    } else if (line.ends_with(": end")) {
      for (std::size_t i = 0; i < libraries.size(); ++i) {
        std::string own = replaced_all(each, "LIBRARY", library(i));
        own = replaced_all(own, "NUMBER", std::to_string(i));
        own = replaced_all(own, "MEMBERS", layout(libraries[i]));
        out += replaced_all(own, "OMEGA", libraries[i].named("THE_OMEGA"));
      }
      each.clear();
      inside = false;
    } else {
      (inside ? each : out) += line + "\n";
    }
  }
  return replaced_all(out, "WITH_GRADIENTS", asked == Asked::values ? "0" : "1");
}

}  // namespace vcrit::test
