// What a number of an element is, in words.
#pragma once

#include "network/law.hpp"

namespace vcrit {

/// "relaxation time": by its role, which does not tell the stiffnesses of what is measured apart.
inline const char* number_words(const Element& e, const Symbol& symbol, NumberRole role) {
  if (!follows_table(e) || role != NumberRole::stiffness) return number_row(role).words;
  const bool at_rest = e.rest.exists() && e.rest.is_symbol() && e.rest.symbol() == symbol;
  return at_rest ? "stiffness at rest" : "storage stiffness";
}

}  // namespace vcrit
