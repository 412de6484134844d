#include "support/patterns.hpp"

#include <regex>

namespace vcrit::test {

std::vector<std::vector<std::string>> matches(const std::string& text, const std::string& pattern) {
  const std::regex compiled(pattern);
  std::vector<std::vector<std::string>> all;
  for (std::sregex_iterator at(text.begin(), text.end(), compiled), end; at != end; ++at)
    all.emplace_back(at->begin(), at->end());
  return all;
}

bool has_match(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern));
}

std::string without_matches(const std::string& text, const std::string& pattern) {
  return std::regex_replace(text, std::regex(pattern), "");
}

}  // namespace vcrit::test
