#include "record/template.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <deque>
#include <kainjow/mustache.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <vector>

#include "base/errors.hpp"
#include "base/trimmed.hpp"
#include "record/json_text.hpp"

namespace vcrit::record {

namespace mustache = kainjow::mustache;

using Json = nlohmann::ordered_json;

namespace {

/// The text before the first `mark`, and the text behind it.
std::pair<std::string, std::string> parted(const std::string& text, char mark) {
  const auto at = text.find(mark);
  if (at == text.npos) return {std::string(trimmed(text, " ")), ""};
  const std::string_view all = text;
  return {std::string(trimmed(all.substr(0, at), " ")),
          std::string(trimmed(all.substr(at + 1), " "))};
}

constexpr const char* line_break = "@line_break";

/// What a template has tags between: {{ }}, or what it begins with: {{=<< >>=}}.
struct Braces {
  explicit Braces(std::string_view text) {
    if (!text.starts_with("{{=")) return;
    const auto space = text.find(' '), end = text.find("=}}");
    ensure(space < end && end != text.npos, "a template says its braces in full");
    open = text.substr(3, space - 3);
    close = text.substr(space + 1, end - space - 1);
  }
  std::string open = "{{", close = "}}";
};

/// The begin or end of a section, or a comment, and nothing else: such a line is none of the text.
bool only_a_section(std::string_view line, const Braces& braces) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  if (!line.starts_with(braces.open)) return false;
  const std::string_view inside = line.substr(braces.open.size());
  return !inside.empty() && std::string_view("#^/!").find(inside.front()) != inside.npos &&
         inside.find(braces.close) + braces.close.size() == inside.size();
}

/// Line breaks as tags: the engine would drop some, and keep that of a section that is left out.
std::string prepared(std::string_view text) {
  const Braces braces(text);
  std::string result;
  while (!text.empty()) {
    const auto end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    const bool none = end != text.npos && only_a_section(line, braces);
    result += none ? line.substr(line.find_first_not_of(' ')) : line;
    if (end == text.npos) break;
    if (!none) result += braces.open + line_break + braces.close;
    text.remove_prefix(end + 1);
  }
  return result;
}

std::string before_last_dot(const std::string& tag) { return tag.substr(0, tag.rfind('.')); }

/// Records write what JSON has no number for as words.
double number_in(const Json& value, const std::string& tag) {
  if (value.is_number()) return value.get<double>();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  throw Bug("a template asks for a number that is none: " + tag);
}

std::string plain_number(const Json& value) {
  return value.is_number_float() ? fmt::format("{}", value.get<double>()) : json_text(value);
}

}  // namespace

/// What the engine is told of the record. It asks for one tag after the other and knows texts,
/// lists and truth; behind what it gets as list or object stand parts of the record.
class Lookup : public mustache::basic_context<std::string> {
 public:
  Lookup(const Templates& templates, std::string name, const Json& record)
      : templates_(templates), name_(std::move(name)), stack_{{&record, 0, 1}} {}

  void push(const mustache::data* data) override {
    const auto known = parts_.find(data);
    stack_.push_back(known == parts_.end() ? stack_.back() : known->second);
  }

  void pop() override { stack_.pop_back(); }

  const mustache::data* get(const std::string& tag) const override {
    if (tag == line_break) return keep(std::string("\n"));
    if (tag == "@number") return keep(std::to_string(stack_.back().number));
    if (tag == "@place") return keep(std::to_string(stack_.back().number + 1));
    if (tag == "@last") return keep(stack_.back().number + 1 == stack_.back().count);
    if (tag.ends_with(".@any")) return keep(!find(before_last_dot(tag)).empty());
    if (tag.ends_with(".@count")) return keep(std::to_string(find(before_last_dot(tag)).size()));
    const auto [key, format] = parted(tag, '|');
    const Json& value = find(key);
    return format.empty() ? shown(value) : keep(escaped(formatted(value, format, tag)));
  }

  const mustache::data* get_partial(const std::string& name) const override {
    const auto found = templates_.texts_.find(name);
    if (found == templates_.texts_.end()) throw Bug(name_ + ": no template " + name);
    return keep(found->second);
  }

 private:
  struct Part {
    const Json* value;
    std::size_t number, count;
  };

  template <class Value>
  mustache::data* keep(const Value& value) const {
    return &kept_.emplace_back(value);
  }

  std::string escaped(const std::string& text) const { return templates_.escape_(text); }

  /// By one key after the other: "drive.mass".
  const Json& find(const std::string& path) const {
    if (path == ".") return *stack_.back().value;
    const auto [key, rest] = parted(path, '.');
    for (auto part = stack_.rbegin(); part != stack_.rend(); ++part)
      if (part->value->is_object() && part->value->contains(key)) {
        const Json* value = &part->value->at(key);
        for (std::string left = rest; !left.empty();) {
          const auto [next, more] = parted(left, '.');
          if (!value->is_object() || !value->contains(next)) missing(path);
          value = &value->at(next);
          left = more;
        }
        return *value;
      }
    missing(path);
  }

  [[noreturn]] void missing(const std::string& key) const {
    throw Bug("the template " + name_ + " asks for " + key + ", which its record has not");
  }

  const mustache::data* shown(const Json& value) const {
    if (value.is_array()) return list(value);
    if (value.is_binary()) return markup(value.get_binary());
    if (value.is_number()) return keep(escaped(plain_number(value)));
    const std::string* text = value.get_ptr<const std::string*>();
    if (value.is_null() || value == false || (text != nullptr && text->empty())) return keep(false);
    const mustache::data* data = text != nullptr ? keep(escaped(*text))
                                 : value == true ? keep(true)
                                                 : keep(mustache::data::type::object);
    if (value.is_object()) parts_[data] = {&value, 0, 1};
    if (text != nullptr) parts_[data] = {&value, 0, 1};
    return data;
  }

  const mustache::data* markup(const Json::binary_t& bytes) const {
    return bytes.empty() ? keep(false) : keep(std::string(bytes.begin(), bytes.end()));
  }

  const mustache::data* list(const Json& values) const {
    const mustache::data* data = keep(mustache::list(values.size()));
    std::size_t number = 0;
    for (const Json& value : values) {
      parts_[&data->list_value()[number]] = {&value, number, values.size()};
      ++number;
    }
    return data;
  }

  std::string formatted(const Json& value, const std::string& format,
                        const std::string& tag) const {
    auto [name, argument] = parted(format, ' ');
    if (argument.starts_with('@')) argument = find(argument.substr(1)).get<std::string>();
    const auto known = templates_.formats_.find(name);
    if (known != templates_.formats_.end()) return known->second(number_in(value, tag), argument);
    return fmt::format(fmt::runtime("{:" + format + "}"), number_in(value, tag));
  }

  const Templates& templates_;
  std::string name_;
  std::vector<Part> stack_;
  mutable std::deque<mustache::data> kept_;  // addresses stay
  mutable std::unordered_map<const mustache::data*, Part> parts_;
};

Templates::Templates(std::string_view packed, std::string (*escape)(std::string_view),
                     std::map<std::string, NumberFormat> formats)
    : escape_(escape), formats_(std::move(formats)) {
  while (!packed.empty()) {
    const auto name_end = packed.find('\0'), end = packed.find('\0', name_end + 1);
    ensure(end != packed.npos, "templates come with their names");
    std::string_view text = packed.substr(name_end + 1, end - name_end - 1);
    if (text.ends_with('\n')) text.remove_suffix(1);
    const std::string name(packed.substr(0, name_end));
    if (text.find("{{{") != text.npos || text.find("{{&") != text.npos)
      throw Bug(name + ": a template cannot keep text from being escaped");
    texts_.emplace(name, prepared(text));
    packed.remove_prefix(end + 1);
  }
}

std::string Templates::render(const std::string& name, const Json& record) const {
  const auto found = texts_.find(name);
  if (found == texts_.end()) throw Bug("no template " + name);
  mustache::mustache page(found->second);
  page.set_custom_escape([](const std::string& text) { return text; });  // Lookup did
  Lookup lookup(*this, name, record);
  const std::string text = page.is_valid() ? page.render(lookup) : std::string();
  if (!page.is_valid()) throw Bug(name + ": " + page.error_message());
  return text;
}

}  // namespace vcrit::record
