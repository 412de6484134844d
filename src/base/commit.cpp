#include "base/commit.hpp"

#include <string_view>

// Its label, the commit and blanks up to a fixed length, in a file that cmake/commit.cmake writes.
extern const char vcrit_commit_text[];

namespace vcrit {

std::string commit() {
  const std::string_view text = vcrit_commit_text;
  const auto begin = text.find(": ") + 2;
  return std::string(text.substr(begin, text.find(' ', begin) - begin));
}

}  // namespace vcrit
