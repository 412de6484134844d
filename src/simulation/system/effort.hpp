// What simulations may cost (base/effort.hpp).
#pragma once

#include "base/effort.hpp"

namespace vcrit::simulation {

using vcrit::Effort;
using vcrit::SharedEffort;

/// For one steady state, a few seconds; for all that an answer asks for together; and for all of
/// all cells below an indenter, a minute of one core.
inline constexpr std::size_t effort_of_state = 200'000'000, effort_of_answer = 400'000'000,
                             effort_of_cells = 4'000'000'000;

/// For one steady state by another method, half a minute, and what is said beyond.
inline constexpr std::size_t effort_of_method = 2'000'000'000;
inline constexpr const char* beyond_effort_of_method =
    "has not settled within the bound on the work for one steady state, of which networks of many "
    "branches take the most";

}  // namespace vcrit::simulation
