// The tables of the paper's page.
#pragma once

#include <string>

#include "paper/contents.hpp"

namespace vcrit::validation::report {

std::string jump_table(const paper::JumpLimits& limits);
std::string static_table(const paper::StaticLimit& limit);
std::string crossing_table(const paper::Viscosity& viscosity);
std::string punch_table(const paper::FlatPunch& punch);
std::string witness_table(const paper::Evidence& evidence);

}  // namespace vcrit::validation::report
