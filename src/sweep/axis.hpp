// An axis of a sweep: the values that one quantity takes in turn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit {

struct Axis {
  std::string name;            ///< as for --set, or "velocity", "velocity_ratio"
  std::vector<double> values;  ///< SI
  Dimension dimension = Dimension::none;
};

/// "velocity_ratio=lin:0.1:1:10" or "frequency=log:1 kHz:1 MHz:31": NAME=lin|log:FROM:TO:N, both
/// ends included exactly, N >= 1 (1: FROM alone), FROM and TO numbers in SI or with a unit; or
/// "k1=list:FILE", one value a line, # begins a comment. Throws InputError, also for names that
/// `problem` does not have.
Axis parse_axis(const std::string& text, const Problem& problem);

/// FILE of such an axis; nothing for others.
std::optional<std::string> list_file(const std::string& axis);

/// An axis of these values (SI). Throws InputError where there are none, and for names as above.
Axis axis_of(const std::string& name, std::vector<double> values, const Problem& problem);

/// The scene with a value of whatever the axes vary: any that leaves its networks as they are,
/// where it has none.
Problem completed(Problem problem, const std::vector<Axis>& axes);

/// The values of a list: the text of the file named `file`. Throws InputError with file and line.
std::vector<double> parse_list(const std::string& text, const std::string& file,
                               Dimension dimension);

}  // namespace vcrit
