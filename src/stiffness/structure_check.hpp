// What relaxation forms and drives with masses must be that were not made of a network.
#pragma once

#include <cstddef>
#include <string_view>

#include "stiffness/drive_structure.hpp"

namespace vcrit {

/// Throws InputError with the member's name, `member` and `part` of it, unless `holds` and the
/// value is finite.
void check_number(bool holds, std::string_view member, double value, const char* expected,
                  const char* part = "");

/// Throws ModelError unless `holds`, of numbers that those of a scene came to.
void require_si_doubles(bool holds);

/// Throws InputError for numbers below 0, times that do not increase, and a network of nothing.
void check_relaxation(const Relaxation& form, std::string_view member);

/// Throws InputError unless there is one weight for each pole.
void check_weights(std::size_t poles, std::size_t weights);

/// Throws InputError unless sizes fit.
void check_sizes(const DriveStructure& structure);

/// Throws InputError unless sizes fit and masses, stiffnesses and times are above 0.
void check_structure(const DriveStructure& structure);

}  // namespace vcrit
