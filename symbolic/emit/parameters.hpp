// The members of a generated struct Parameters: the symbols that v* depends on, but for those that
// are fixed.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "derivation/derivation.hpp"
#include "derivation/meanings.hpp"
#include "emit/options.hpp"
#include "problem/problem.hpp"
#include "program/ratio.hpp"

namespace vcrit::symbolic {

struct Member {
  std::string name;  ///< that the scene gives it, as the language spells it
  std::string comment;
  Dimension dimension = Dimension::none;
  int length = 0;      ///< of an array, 0 for a number
  std::string symbol;  ///< what it is called in the program: Symbol::name
};

/// How a language writes a name of the scene that it has another meaning for.
using Spelled = std::string (*)(const std::string& name);

class ParameterList {
 public:
  /// mu0, omega and du_z are always there, as the calls need them.
  ParameterList(const Problem& problem, const Derivation& derivation, const FixedValues& fixed = {},
                Spelled spelled = nullptr)
      : ParameterList(problem, derivation.parameters, fixed, spelled) {}
  ParameterList(const Problem& problem, const std::vector<Symbol>& symbols,
                const FixedValues& fixed, Spelled spelled = nullptr);

  const std::vector<Member>& members() const { return members_; }
  /// The text with the names of those three for THE_MU0, THE_OMEGA and THE_DU_Z.
  std::string named(std::string text) const;
  /// "p.k0", "p.k[2]".
  std::string reference(const Symbol& symbol) const;
  /// Those that the program is of, as references.
  std::vector<std::string> references(const Program& program) const;
  bool contains(const Symbol& symbol) const { return known_.contains(symbol); }
  /// What a program computes with: the parameter, its fixed number as the double that it is, or 1
  /// for an element whose value does not matter.
  NodeId value(Program& program, const Symbol& symbol) const;
  /// The same, for as long as this list lives.
  SymbolValue values() const {
    return [this](Program& program, const Symbol& symbol) { return value(program, symbol); };
  }

 private:
  void add(const Symbol& symbol, const Meaning& meaning, const Problem& problem);
  std::string name_of(const std::string& symbol) const;
  std::string in_language(const std::string& name) const;

  std::set<Symbol> known_;
  std::map<std::string, std::string> names_;
  FixedValues fixed_;
  Spelled spelled_;
  std::vector<Member> members_;
};

}  // namespace vcrit::symbolic
