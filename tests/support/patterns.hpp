// Regular expressions. std::regex takes the compiler two seconds, here and nowhere else.
#pragma once

#include <string>
#include <vector>

namespace vcrit::test {

/// All that the pattern matches: the whole and its groups.
std::vector<std::vector<std::string>> matches(const std::string& text, const std::string& pattern);

bool has_match(const std::string& text, const std::string& pattern);

std::string without_matches(const std::string& text, const std::string& pattern);

}  // namespace vcrit::test
