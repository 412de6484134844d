// What is refused, and with which words.
#pragma once

#include <boost/test/unit_test.hpp>
#include <string>

#include "base/errors.hpp"

namespace vcrit::test {

/// The message that work() ends with; "accepted" where it has none.
template <class Error = InputError, class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

/// Whether a text has a part; where it does not, the text is shown.
inline bool has(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return true;
  BOOST_TEST_MESSAGE("not in: " << text);
  return false;
}

/// Whether work() ends with a message of these words.
template <class Error = InputError, class Work>
bool refused(const Work& work, const std::string& words) {
  return has(refusal<Error>(work), words);
}

}  // namespace vcrit::test
