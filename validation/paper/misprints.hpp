// Phases in (41) and (43) that do not fit the equations around them.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

Misprints try_misprints();

}  // namespace vcrit::validation::paper
