// The fixed parts of a generated header: the arithmetic it needs, and its calls.
#pragma once

namespace vcrit::symbolic::text {

extern const char* const includes;
/// What calls return and take, and each() for all members at once.
extern const char* const structs;
extern const char* const each;
/// Twofold numbers, and Wide ones, which are Twofold with an exponent of their own.
extern const char* const numbers;
/// times, plus, mad, head, size: the operations that programs are written in.
extern const char* const operations;
/// Operations that few programs use.
extern const char* const less_inertia;
extern const char* const power_unit;
extern const char* const nonzero;
extern const char* const ties;
extern const char* const magnitude;
extern const char* const unless_moderate;
/// Whether a positive number is of ordinary size, without comparing.
extern const char* const steps;
/// The error bound, and one result with what it falls back to.
extern const char* const result;
/// Batches over omega, and over any columns, in blocks.
extern const char* const sweep;
extern const char* const batch;
/// Sweeps in plain double with polynomials in i omega.
extern const char* const polynomials;
extern const char* const polynomials_end;
extern const char* const polynomial_sweep;
/// Large programs need to be told, lest their loops stay scalar.
extern const char* const inline_all;
extern const char* const inline_no_more;
extern const char* const calls_comment;
/// The functions that users call; @T@ is the grade's type of number.
extern const char* const calls;
extern const char* const batch_comment;
extern const char* const batch_calls;

}  // namespace vcrit::symbolic::text
