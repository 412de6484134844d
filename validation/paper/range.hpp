// Where (24) and the law of friction below it hold: (24) for any linear rheology, against
// simulation; free swings of the drive at harmonics; no reduction above v*; friction that rises
// with speed and ever more slowly; and which of the conditions (3) and (4) is the stricter.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

PaperPart explore_range();

}  // namespace vcrit::validation::paper
