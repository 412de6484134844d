// Logarithmic axes with powers of ten on them.
#pragma once

#include "figures/figure.hpp"

namespace vcrit::validation::accuracy {

/// "10⁻³", "1", "10", "10¹²".
std::string power_of_ten(int exponent);

/// From `least` to `greatest`, both positive, with at most eight ticks.
figures::Axis decades(std::string title, double least, double greatest);

/// Puts decades on both axes, as the series need them; without any the axes stay.
void set_decades(figures::Figure& figure);

}  // namespace vcrit::validation::accuracy
