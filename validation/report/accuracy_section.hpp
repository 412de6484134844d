// The part of a scene's page about accuracy, cost and stability.
#pragma once

#include <string>

#include "accuracy/data.hpp"

namespace vcrit::validation::report {

std::string accuracy_section(const accuracy::Accuracy& accuracy);

}  // namespace vcrit::validation::report
