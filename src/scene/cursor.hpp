// A place in one line of text of a scene, for the parsers of src/scene.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "base/errors.hpp"

namespace vcrit {

constexpr int most_entries_named = 1'000'000;  ///< the largest entry that an array's name may have

inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

class Cursor {
 public:
  /// `text` by reference; `place` is that of its first character.
  Cursor(const std::string& text, Place place) : text_(text), place_(std::move(place)) {}

 protected:
  /// The next character behind blanks, '\0' at the end.
  char peek() {
    while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\t'))
      ++position_;
    return position_ < text_.size() ? text_[position_] : '\0';
  }
  bool at_end() {
    peek();
    return position_ == text_.size();
  }
  bool accept(char c) {
    if (peek() != c || at_end()) return false;
    ++position_;
    return true;
  }
  Place here() {
    peek();
    return {place_.file, place_.line, place_.column + static_cast<int>(position_)};
  }
  /// A whole number from 1 to `most` and goes behind it; nothing, and stays, where there is none.
  std::optional<int> whole_number_up_to(int most) {
    peek();
    int value = 0;
    const char* const begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc{} || value < 1 || value > most) return std::nullopt;
    position_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  const std::string& text_;
  Place place_;
  std::size_t position_ = 0;
};

}  // namespace vcrit
