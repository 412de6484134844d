// One line of mathematics.
#pragma once

#include <ginac/ginac.h>

#include <string>

namespace vcrit::symbolic {

/// left = right, with the words that lead to it.
struct Line {
  std::string words;
  GiNaC::ex left, right;
};

}  // namespace vcrit::symbolic
