// One line of mathematics.
#pragma once

#include <ginac/ginac.h>

#include "formula/algebra_lock.hpp"
#include "formula/prose.hpp"

namespace vcrit::symbolic {

/// left = right, with the words that lead to it.
struct Line {
  Prose words;
  Expression left, right;
};

}  // namespace vcrit::symbolic
