// What one may ask of the generator: parameters that become numbers of the code, and which files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit::symbolic {

struct GenerateOptions {
  std::vector<std::string> fixed = {};  ///< names of parameters; "all": every one that has a number
  bool quantities = false;              ///< NAME_quantities.hpp, too; C++ only
  std::string language = "c++";         ///< or one of language_names()
};

/// The numbers of fixed parameters, as the scene gives them.
using FixedValues = std::map<Symbol, double>;

/// An array's name stands for all its entries. Throws InputError for names that the scene does not
/// have, that have no number in it, or that every call needs as a parameter.
FixedValues fixed_values(const Problem& problem, const std::vector<std::string>& names);

/// "vcrit generate SCENE --out DIR --name NAME", with the options.
std::string command_line(const Problem& problem, const std::string& name,
                         const GenerateOptions& options);

/// "Fixed: k0 = 8e6, c1 = 30.", or nothing.
std::string fixed_text(const Problem& problem, const FixedValues& fixed);

}  // namespace vcrit::symbolic
