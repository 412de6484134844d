#include "scene/document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "base/identifiers.hpp"
#include "base/joined.hpp"
#include "scene/key_limits.hpp"
#include "scene/section_keys.hpp"
#include "scene/syntax.hpp"

namespace vcrit::document {

namespace {

const toml::table* as_table(const toml::node* node, const std::string& name,
                            const std::string& file) {
  if (node == nullptr) return nullptr;
  if (!node->is_table())
    throw InputError(place_of(*node, file), fmt::format("{} = {}", name, describe_node(*node)),
                     fmt::format("a table [{}]", name), advice_on_key(name, name));
  return node->as_table();
}

std::string expected_key(const std::optional<std::string>& meant,
                         const std::vector<std::string>& known) {
  if (meant) return fmt::format("\"{}\"", *meant);
  if (known.size() == 1) return fmt::format("\"{}\"", known.front());
  return fmt::format("one of {}", joined(known, ", "));
}

InputError unknown_key(const Place& place, const std::string& key, const std::string& section,
                       const std::vector<std::string>& known) {
  const std::string advice = advice_on_key(key, section);
  auto meant = advice.empty() ? nearest(key, known) : std::nullopt;
  for (const std::string& each : known)  // "poissons_ratio"
    if (!meant && advice.empty() && each.size() > 3 && key.find(each) != key.npos) meant = each;
  return {place,
          fmt::format("unknown key \"{}\"{}", key, section.empty() ? "" : " in [" + section + "]"),
          expected_key(meant, known), advice};
}

// More lines than these that are no TOML are no scene.
constexpr int most_wrong_lines = 100;

}  // namespace

Place place_of(const toml::node& node, const std::string& file) {
  const auto& begin = node.source().begin;
  return {file, static_cast<int>(begin.line), static_cast<int>(begin.column)};
}

toml::table parse(const std::string& text, const std::string& file, Complaints& complaints) {
  if (text.size() > longest_scene)
    throw InputError({file}, fmt::format("a scene of more than {} bytes", longest_scene),
                     "a shorter one");
  check_keys(text, file);
  std::string left = text;
  std::set<int> renamed;  // lines that have a name for a value
  for (int i = 0;; ++i) try {
      return toml::parse(left, file);
    } catch (const toml::parse_error& error) {
      const auto& begin = error.source().begin;
      const int line = static_cast<int>(begin.line);
      const InputError wrong = syntax_error(left, {file, line, static_cast<int>(begin.column)},
                                            std::string(error.description()));
      complaints.add(wrong);
      const auto without = without_line(left, line, !renamed.insert(line).second);
      if (!without || i == most_wrong_lines) throw wrong;
      complaints.ignore_line(line);
      left = *without;
    }
}

std::string describe_node(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  std::string text = out.str();
  if (node.is_string()) text = fmt::format("\"{}\"", node.ref<std::string>());
  return text;
}

Section::Section(const toml::node* node, std::string name, std::string file,
                 const std::vector<std::string>& keys, Complaints& complaints)
    : table_(as_table(node, name, file)), name_(std::move(name)), file_(std::move(file)) {
  if (table_ == nullptr) return;
  for (const auto& [key, value] : *table_) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    const auto& begin = key.source().begin;
    complaints.add(
        unknown_key({file_, static_cast<int>(begin.line), static_cast<int>(begin.column)},
                    std::string(key.str()), name_, keys));
  }
}

const toml::node* Section::find(std::string_view key) const {
  return table_ == nullptr ? nullptr : table_->get(key);
}

std::string Section::text(std::string_view key) const {
  const toml::node* node = find(key);
  if (node == nullptr)
    throw InputError(place(key), fmt::format("no \"{}\" in [{}]", key, name_),
                     fmt::format("{} = \"...\"", key));
  if (!node->is_string())
    throw InputError(place(key), fmt::format("{} = {}", key, describe_node(*node)),
                     "a text in quotes");
  return node->ref<std::string>();
}

Place Section::place(std::string_view key) const {
  if (const toml::node* node = find(key)) return place(*node);
  return table_ == nullptr ? Place{file_} : place(*table_);
}

Place Section::place(const toml::node& node) const { return place_of(node, file_); }

const toml::table* table(const toml::table& document, const std::string& name,
                         const std::string& file) {
  return as_table(document.get(name), name, file);
}

}  // namespace vcrit::document
