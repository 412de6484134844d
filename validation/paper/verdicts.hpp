// What the comparisons of some keys show, and the numbers that they found.
#pragma once

#include <string>
#include <vector>

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

/// Each of these keys has comparisons, and all of them passed.
bool shown(const Paper& paper, const std::vector<std::string>& keys);

/// What the comparisons of this key found, in their order.
std::vector<double> found(const Paper& paper, const std::string& key);

/// The same as text: "0.7071, 0.8660".
std::string found_words(const Paper& paper, const std::string& key, int digits);

/// With a minus sign as people write it: "−0.3660".
std::string signed_words(double number, int digits);

}  // namespace vcrit::validation::paper
