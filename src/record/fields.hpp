// What was found, as JSON: each type of record says its members once, a key and a value each.
//
//   namespace vcrit::record {
//   void fields(Fields& f, const Limit& limit) { f("name", limit.name)("value", limit.value); }
//   }
//
// json_of(limit) is the record as files have it: infinite and undefined numbers, which JSON lacks,
// are "inf", "-inf", "nan", and what is absent has no key. page_of(limit) is the record as
// templates read it (template.hpp): what is absent is there and empty, so that a key that is not
// there is a misspelt one, and there is more in it, for people.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace vcrit::record {

using Json = nlohmann::ordered_json;

/// Text that is markup already: MathML, the content of a script. Nothing else reaches a page
/// without being escaped. In a page's record it is binary, which no text can become.
struct Markup {
  std::string text;
};

/// None where there is no text, so that a template's section asks for it.
inline std::optional<Markup> present_markup(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(Markup{text});
}

enum class Reader { file, page };

class Fields {
 public:
  explicit Fields(Reader reader) : reader_(reader) {}

  template <class Value>
  Fields& operator()(const char* key, const Value& value) {
    object_[key] = written(value);
    return *this;
  }

  /// Only where the condition holds.
  template <class Value>
  Fields& when(bool holds, const char* key, const Value& value) {
    if (holds) return (*this)(key, value);
    return page(key, nullptr);
  }

  /// Only where there is a value, or a text or list that is not empty.
  template <class Value>
  Fields& some(const char* key, const Value& value) {
    return when(present(value), key, value);
  }

  /// An object within this one, of which no type tells: say(f) says its members.
  template <class Say>
  Fields& group(const char* key, const Say& say) {
    Fields inner(reader_);
    say(inner);
    object_[key] = inner.take();
    return *this;
  }

  /// For templates alone.
  template <class Value>
  Fields& page(const char* key, const Value& value) {
    if (reader_ == Reader::page) object_[key] = written(value);
    return *this;
  }

  bool for_page() const { return reader_ == Reader::page; }
  Json take() { return std::move(object_); }

  Json written(std::nullptr_t) const { return nullptr; }
  Json written(const char* text) const { return text; }
  Json written(const std::string& text) const { return text; }
  Json written(const std::filesystem::path& path) const { return path.string(); }
  Json written(const Json& json) const { return json; }
  Json written(const Markup& markup) const {
    return Json::binary({markup.text.begin(), markup.text.end()});
  }
  template <class A, class B>
  Json written(const std::pair<A, B>& pair) const {
    return Json::array({written(pair.first), written(pair.second)});
  }
  template <class Value>
  Json written(const std::optional<Value>& value) const {
    return value ? written(*value) : Json();
  }
  template <class Value>
  Json written(const std::vector<Value>& values) const {
    return list(values);
  }
  template <class Value, std::size_t size>
  Json written(const std::array<Value, size>& values) const {
    return list(values);
  }
  template <class Value>
  Json written(const Value& value) const {
    if constexpr (std::is_floating_point_v<Value>) {
      if (std::isnan(value)) return "nan";
      if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
      return value;
    } else if constexpr (std::is_arithmetic_v<Value>) {
      return value;
    } else if constexpr (std::is_enum_v<Value>) {
      return to_text(value);
    } else {
      Fields inner(reader_);
      fields(inner, value);
      return inner.take();
    }
  }

 private:
  template <class Values>
  Json list(const Values& values) const {
    Json array = Json::array();
    for (const auto& value : values) array.push_back(written(value));
    return array;
  }

  template <class Value>
  static bool present(const std::optional<Value>& value) {
    return value.has_value();
  }
  template <class Value>
  static bool present(const Value& value) {
    return !value.empty();
  }

  Reader reader_;
  Json object_ = Json::object();
};

/// As a file has it.
template <class Value>
Json json_of(const Value& value) {
  return Fields(Reader::file).written(value);
}

/// As templates read it.
template <class Value>
Json page_of(const Value& value) {
  return Fields(Reader::page).written(value);
}

}  // namespace vcrit::record
