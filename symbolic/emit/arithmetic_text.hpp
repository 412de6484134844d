// The fixed parts of a generated header: its licence, the arithmetic it needs, and its calls.
#pragma once

namespace vcrit::symbolic::text {

/// The MIT-0 licence as comment lines.
extern const char* const licence;
/// Twofold numbers: struct Twofold with + - * / and sqrt.
extern const char* const twofold;
/// less(): subtracting the inertia without losing digits at (anti)resonance.
extern const char* const inertia;
/// within(): neither huge nor tiny.
extern const char* const within;
/// length(): the absolute value of a complex number.
extern const char* const length;
/// Edge<T> for networks with star-mesh elimination.
extern const char* const edge;
/// What evaluate<T>() returns.
extern const char* const estimate;
/// The error bound, and the loop over omega.
extern const char* const certified;
/// The functions that users call.
extern const char* const calls;

}  // namespace vcrit::symbolic::text
