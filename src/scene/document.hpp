// The TOML file as the scene reader sees it: tables whose every key is known, with the place of
// all.
#pragma once

#include <toml++/toml.h>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/complaints.hpp"
#include "base/errors.hpp"

namespace vcrit::document {

/// Bytes of a scene file (64 MiB): a million elements with a value each take less.
constexpr std::size_t longest_scene = 1U << 26U;

/// Complains, with line and column, where the text is no TOML; where complaints are collected it
/// goes on without the lines that are wrong. Throws InputError where it cannot go on, and for a
/// text that is longer than `longest_scene` or has too many dotted keys (key_limits.hpp).
toml::table parse(const std::string& text, const std::string& file, Complaints& complaints);

/// What stands there, for messages: `"8 N/um"`, `12`, "an array".
std::string describe_node(const toml::node& node);

/// One table of the file. A table that is not there has no keys.
class Section {
 public:
  /// `name` as in the file ("contact"; "" for the top level). Complains of keys that are not among
  /// `keys`, naming the nearest one. Throws InputError where the node is no table.
  Section(const toml::node* node, std::string name, std::string file,
          const std::vector<std::string>& keys, Complaints& complaints);

  bool exists() const { return table_ != nullptr; }
  const toml::node* find(std::string_view key) const;
  /// The string under that key; throws InputError if it is something else or not there.
  std::string text(std::string_view key) const;
  /// Of the value under that key, or of the section where there is none.
  Place place(std::string_view key) const;
  Place place(const toml::node& node) const;

 private:
  const toml::table* table_ = nullptr;
  std::string name_, file_;
};

/// The table of that name, whatever its keys. Throws InputError if it is no table.
const toml::table* table(const toml::table& document, const std::string& name,
                         const std::string& file);

Place place_of(const toml::node& node, const std::string& file);

}  // namespace vcrit::document
