// Complex numbers in doubles.
#pragma once

#include <complex>

namespace vcrit {

using ComplexDouble = std::complex<double>;

}  // namespace vcrit
