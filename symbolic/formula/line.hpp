// One line of mathematics.
#pragma once

#include <ginac/ginac.h>

#include <string>

#include "formula/algebra_lock.hpp"

namespace vcrit::symbolic {

/// left = right, with the words that lead to it.
struct Line {
  std::string words;
  Expression left, right;
};

}  // namespace vcrit::symbolic
