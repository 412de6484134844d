// How finely the numbers of a column are rounded, as their text shows.
#pragma once

#include <string>
#include <vector>

namespace vcrit {

/// For each number the value of a unit in its last digit. Programs drop zeros at the end ("1.2"
/// among "1.23"), so that the whole column is asked: for its finest place, as numbers with a fixed
/// count of decimals have it, and for its most digits; the coarser of the two is taken.
std::vector<double> rounding_steps(const std::vector<std::string>& numbers);

}  // namespace vcrit
