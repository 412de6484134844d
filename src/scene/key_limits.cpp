#include "scene/key_limits.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace vcrit::document {

namespace {

/// Reads TOML only as far as to know what is a string, what a comment and what may be a key. In a
/// text that is no TOML it may lose its way, but not before the place where toml++ gives up.
class Keys {
 public:
  Keys(std::string_view text, const std::string& file) : text_(text), place_{file, 1} {}

  void check() {
    while (position_ < text_.size()) {
      const char c = text_[position_];
      if (c == '"' || c == '\'')
        skip_string(c);
      else if (c == '#')
        move_to(text_.find('\n', position_));
      else
        read(c);
    }
  }

 private:
  void read(char c) {
    if (c == '.' && ++dots_ >= most_key_parts)
      throw InputError(place_, fmt::format("a key of more than {} parts", most_key_parts),
                       "sections and keys of a scene");
    if (dots_ > 0 && (c == '=' || (c == ']' && in_header_))) count_key();
    if (c == '[' && at_line_begin_) in_header_ = true;
    if (c == '\n') in_header_ = false;
    if (std::string_view("=[]{},\n").find(c) != std::string_view::npos) dots_ = 0;
    at_line_begin_ = c == '\n' || (at_line_begin_ && (c == ' ' || c == '\t' || c == '['));
    move_to(position_ + 1);
  }

  void count_key() {
    if (++dotted_ > most_dotted_keys)
      throw InputError(place_, fmt::format("more than {} dotted keys", most_dotted_keys),
                       "keys in sections, as name = value below [section]");
  }

  void skip_string(char quote) {
    const std::string_view three = quote == '"' ? R"(""")" : "'''";
    const bool multiline = text_.substr(position_, 3) == three;
    const std::string_view end = multiline ? three : three.substr(0, 1);
    std::size_t at = position_ + end.size();
    while (at < text_.size() && text_.substr(at, end.size()) != end) {
      if (!multiline && text_[at] == '\n') break;
      at += quote == '"' && text_[at] == '\\' ? 2 : 1;
    }
    at += end.size();
    // One or two quotes right before the end belong to the string.
    const std::size_t last = multiline ? std::min(at + 2, text_.size()) : 0;
    while (at < last && text_[at] == quote) ++at;
    move_to(at);
  }

  void move_to(std::size_t position) {
    position = std::min(position, text_.size());
    place_.line +=
        static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(position_),
                                    text_.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
    position_ = position;
  }

  std::string_view text_;
  Place place_;
  std::size_t position_ = 0;
  int dots_ = 0;  // since the last character that is in no key; also those of numbers
  int dotted_ = 0;
  bool at_line_begin_ = true, in_header_ = false;
};

}  // namespace

void check_keys(const std::string& text, const std::string& file) { Keys(text, file).check(); }

}  // namespace vcrit::document
