#include "emit/words.hpp"

#include <algorithm>
#include <string_view>

#include "base/plain_text.hpp"

namespace vcrit::symbolic {

namespace {

// Nothing that ends a line in one of the languages (U+2028 does in JavaScript), goes on with it on
// the next (a backslash, or the trigraph that stands for it in C99), shows it in another order, or
// ends the script of a page.
std::string harmless(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t size = std::max<std::size_t>(steering(text), 1);
    const bool shown = steering(text) == 0 && text.front() != '\\';
    if (shown || size == 1) out += shown ? text.front() : ' ';
    text.remove_prefix(size);
    const bool trigraph = out.ends_with("??") && text.starts_with('/');
    const bool tag = out.ends_with('<') && (text.starts_with('/') || text.starts_with('!'));
    if (trigraph || tag) out += ' ';
  }
  return out;
}

}  // namespace

std::string comment(const std::string& text) {
  // Of a line of generated code, with its comment sign.
  constexpr std::size_t width = 116;
  std::string rest = harmless(text), out;
  std::string indent;
  while (rest.size() > width) {
    std::size_t end = rest.rfind(' ', width);
    if (end == std::string::npos || end < 8) end = rest.find(' ', width);
    if (end == std::string::npos) break;
    out += "// " + indent + rest.substr(0, end) + "\n";
    rest.erase(0, end + 1);
    if (text.starts_with("  ")) indent = "      ";
  }
  return out + "// " + indent + rest + "\n";
}

}  // namespace vcrit::symbolic
