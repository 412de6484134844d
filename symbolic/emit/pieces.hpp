// Parts of generated files that are the same in several languages.
#pragma once

#include <cstddef>
#include <string>

#include "derivation/derivation.hpp"
#include "emit/options.hpp"
#include "emit/parameters.hpp"
#include "problem/problem.hpp"
#include "program/velocity.hpp"

namespace vcrit::symbolic {

/// What the file is, the formula it evaluates, and the command that makes it again, as // comments.
std::string banner(const Derivation& derivation, const std::string& command,
                   const FixedValues& fixed);

/// What a file says of the table of a measured drive, as // comments; nothing without one.
std::string table_words(const Program& program);

/// The macro around a generated C++ header. Not #pragma once, which compilers complain about when
/// they are given the header itself.
std::string guard_of(const std::string& name);

std::string replaced(std::string text, const std::string& what, const std::string& with);

/// Of generated code.
constexpr std::size_t line_width = 120;

/// A statement on as many lines as it takes.
std::string statement(const std::string& text);

/// "(p.nu > -1.0) & (p.nu <= 0.5)"
std::string poisson_check(const ParameterList& parameters, const VelocityProgram& velocity);
/// The body of a function of p, in C and C++: whether all parameters are finite and of a sign that
/// a scene may have. Of other ones the error bounds say nothing.
std::string allowed_body(const ParameterList& parameters, const VelocityProgram& velocity);

/// "SI units: friction coefficient mu0; ...; spring k0, k1; damper c1".
std::string meanings(const ParameterList& parameters);

}  // namespace vcrit::symbolic
