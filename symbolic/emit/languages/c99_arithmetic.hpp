// The fixed parts of a C99 header; @ stands for the prefix of its names.
#pragma once

namespace vcrit::symbolic::c99 {

extern const char* const includes;
extern const char* const numbers;
extern const char* const wide;
/// Operations that few programs use.
extern const char* const less_inertia;
extern const char* const power_unit;
extern const char* const nonzero;
extern const char* const ties;
extern const char* const magnitude;
extern const char* const unless_moderate;
/// The error bound; @ROOT and @SQRT are the root in each grade, or nothing.
extern const char* const finished;
/// One grade's evaluation with what it falls back to; @GRADE is dd or plain.
extern const char* const result;
/// The functions that users call; @FAST is empty or "fast_".
extern const char* const calls;

}  // namespace vcrit::symbolic::c99
