// Fig. 4 a to d: friction against speed for delta = 1, 2, 10, 100, each with six amplitudes, by the
// reduced model and by the full motion, with independent values on one more curve.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

Figure4 draw_figure4();

}  // namespace vcrit::validation::paper
