// The fixed parts of a JavaScript module.
#pragma once

namespace vcrit::symbolic::javascript {

extern const char* const numbers;
/// Operations that not every program uses.
extern const char* const root;
extern const char* const less_inertia;
extern const char* const power_unit;
extern const char* const nonzero;
extern const char* const ties;
extern const char* const magnitude;
extern const char* const unless_moderate;
/// The error bound; @ROOT and @SQRT are the root in each grade, or nothing.
extern const char* const finished;
/// The functions that users call.
extern const char* const calls;

}  // namespace vcrit::symbolic::javascript
