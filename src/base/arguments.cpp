#include "base/arguments.hpp"

namespace vcrit {

namespace {

bool is_letter_of_key(char c) { return (c >= 'a' && c <= 'z') || c == '_'; }

/// "velocity_ratio", "set NAME=VALUE"; no command and no text of another kind.
bool is_key(const std::string& quoted) {
  const std::string word = quoted.substr(0, quoted.find(' '));
  for (const char c : word)
    if (!is_letter_of_key(c)) return false;
  return !word.empty() && word != "vcrit";
}

}  // namespace

std::string spelled(const std::string& text, const ArgumentSpelling& spelling) {
  std::string result;
  std::size_t done = 0;
  while (true) {
    const std::size_t begin = text.find('`', done);
    const std::size_t end = begin == text.npos ? text.npos : text.find('`', begin + 1);
    if (end == text.npos) return result + text.substr(done);
    const std::string quoted = text.substr(begin + 1, end - begin - 1);
    const bool key = is_key(quoted);
    result += text.substr(done, begin - done) + (key ? spelling(quoted) : '`' + quoted + '`');
    done = end + 1;
  }
}

InputError spelled(const InputError& error, const ArgumentSpelling& spelling) {
  Place place = error.place();
  if (!place.argument.empty()) place.argument = spelling(place.argument);
  return {place, error.found(), spelled(error.expected(), spelling),
          spelled(error.advice(), spelling)};
}

ModelError spelled(const ModelError& error, const ArgumentSpelling& spelling) {
  std::string words = error.what();
  if (const std::string& advice = error.advice(); !advice.empty())
    words.resize(words.size() - advice.size() - std::string("; ").size());
  return ModelError(spelled(words, spelling), spelled(error.advice(), spelling));
}

}  // namespace vcrit
