// Names of symbols. Those of the program (K_n, s, v*, ...) carry a mark of which no name of a scene
// can hold the character, so that both are told apart wherever symbols are known by name; in print
// the mark goes, and where a scene has an element that would read the same, the program's own
// symbol is printed with another name.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>

#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// The marked name of a symbol of the program.
std::string own_name(const std::string& base);
bool is_own(const std::string& name);
/// Without the mark.
std::string base_name(const std::string& name);

/// How a name, marked or not, reads: a scene's symbol as the scene calls it.
std::string printed_name(const std::string& name);

/// While it lives, formulas of this scene are printed in this thread: its names are not given to
/// symbols of the program, and two of them that would be set alike (k1 and k_1) are set apart.
/// What the scene calls otherwise than the program (mass = "M") is printed so.
class NamesOfScene {
 public:
  explicit NamesOfScene(const Problem& problem);
  ~NamesOfScene();
  NamesOfScene(const NamesOfScene&) = delete;
  NamesOfScene& operator=(const NamesOfScene&) = delete;

 private:
  friend std::string printed_name(const std::string& name);
  friend bool is_set_apart(const std::string& name);
  friend bool is_taken(const std::string& name);
  friend bool has_bare_entry(const std::string& name);
  bool taken(const std::string& name) const;
  std::string printed(const std::string& name) const;
  std::string written(const std::string& name) const;
  std::string with_entry(const std::string& name) const;

  std::map<std::string, std::string> by_setting_;  ///< the first name of each setting in LaTeX
  std::set<std::string> entries_;                  ///< settings of entries of arrays
  std::map<std::string, std::string> groups_by_setting_;  ///< likewise of what is named after them
  std::set<std::string> ambiguous_;           ///< arrays with an entry that is set as an element is
  std::map<std::string, std::string> names_;  ///< that the scene gives its symbols
  mutable std::unordered_map<std::string, std::string> printed_;  ///< as far as asked for
  const NamesOfScene* before_;
};

/// Whether an earlier name of the scene is set alike, so that this one is set letter by letter.
bool is_set_apart(const std::string& name);

/// Whether an entry of an array, k[1], may be set as k with index 1: of none is there an element
/// that is set so, as k1 is.
bool has_bare_entry(const std::string& name);

/// Whether the scene that is printed has a name that would read the same.
bool is_taken(const std::string& name);

}  // namespace vcrit::symbolic
