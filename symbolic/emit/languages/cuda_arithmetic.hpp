// The fixed parts of a CUDA header; @CALL stands for what precedes a function of host and device.
#pragma once

namespace vcrit::symbolic::cuda {

extern const char* const includes;
extern const char* const structs;
extern const char* const numbers;
extern const char* const operations;
/// Operations that few programs use.
extern const char* const less_inertia;
extern const char* const power_unit;
extern const char* const nonzero;
extern const char* const ties;
extern const char* const magnitude;
extern const char* const unless_moderate;
/// The error bound; @ROOT and @SQRT are the root in each grade, or nothing.
extern const char* const finished;
extern const char* const result;
/// The functions that users call; @T is the grade's type of number.
extern const char* const calls;

}  // namespace vcrit::symbolic::cuda
