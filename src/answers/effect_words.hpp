// What vibration does to a scene, in words: the same on a terminal, on pages and in Python.
#pragma once

#include <cstddef>
#include <string>

#include "answers/effect.hpp"
#include "base/rounded.hpp"

namespace vcrit {

/// "Vibration lowers friction below 4.095 mm/s, by at most 25 %."
std::string sentence(const Effect& effect, int digits = few_digits);

/// "20 kHz, 0.1 µm amplitude, 0.5 µm indentation (4 N mean normal force)."
std::string conditions(const Effect& effect, int digits = few_digits);

/// The same, and "The contact stays closed up to 0.3968 µm."
std::string operating_point(const Effect& effect, int digits = few_digits);

/// "0.748 of the sliding value (at rest)"; empty where it is not known.
std::string lowest_friction(const Effect& effect, int digits = few_digits);

/// "up to 0.3968 µm (now 0.1 µm)"; empty where the contact opens at every amplitude.
std::string closed_range(const Effect& effect, int digits = few_digits);

/// "below 1.1e-16", or "about" of a simulated v*; empty where there is no v* that rounding changes.
std::string rounding_error(const Effect& effect);

/// v* with its unit: of a simulated one no more digits than its error leaves, at most so many.
std::string critical_velocity_in_words(const Effect& effect, int digits = few_digits);

/// What stands above a report of which checks failed.
std::string failed_checks(std::size_t failed, std::size_t made);

}  // namespace vcrit
