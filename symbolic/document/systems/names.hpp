// Names in another system. Symbols are told apart by what they are within the program, never by how
// they read: each has a name that the system has no meaning for and that no other symbol has.
#pragma once

#include <map>
#include <string>

#include "document/systems/taken.hpp"

namespace vcrit::symbolic {

struct AlgebraSystem;

class SystemNames {
 public:
  /// What the system can call as the scene and our own formulas do stays so; the others get names
  /// after these.
  SystemNames(const AlgebraSystem& system, const TakenFormula& formula);
  const std::string& of(const std::string& symbol) const { return names_.at(symbol); }

 private:
  std::map<std::string, std::string> names_;
};

}  // namespace vcrit::symbolic
