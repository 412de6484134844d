// Indenters of other shapes, and what the method of dimensionality reduction takes for granted.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

PaperPart press_shapes();

}  // namespace vcrit::validation::paper
