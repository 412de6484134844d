// The elastic flat punch under a rigid drive, which has a closed form.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

FlatPunch press_flat_punch();

}  // namespace vcrit::validation::paper
