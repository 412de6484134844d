// Equations and tables of limits as the pages show them.
#pragma once

#include <string>
#include <vector>

#include "scene_report.hpp"

namespace vcrit::validation::report {

/// v* in MathML.
extern const char* const velocity_sign;

/// The two sides of an equation, in MathML, as one line that scrolls if it must.
std::string equation(const std::string& left, const std::string& right, const char* relation = "=");
std::string equation(const Equation& line);

/// The number in the paper; empty for none.
std::string numbered(const std::string& number);

/// "with s = i omega and" the names' equations; empty for none.
std::string definitions(const std::vector<Equation>& lines);

/// The table of limits under its heading; empty for none.
std::string limits_table(const std::vector<LimitLine>& lines);

/// What v* tends to at low and high frequency; empty for none.
std::string asymptotes_table(const std::vector<AsymptoteLine>& lines);

}  // namespace vcrit::validation::report
