// The members of a generated struct Parameters: the symbols that v* depends on.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "derivation/derivation.hpp"
#include "scene/scene.hpp"

namespace vcrit::symbolic {

struct Member {
  std::string name, comment;
  int length = 0;  ///< of an array, 0 for a number
};

class ParameterList {
 public:
  /// mu0, omega and du_z are always there, as the calls need them.
  ParameterList(const Scene& scene, const Derivation& derivation);

  const std::vector<Member>& members() const { return members_; }
  /// "p.k0", "p.k[2]"; or "1.0" for an element whose value v* does not depend on.
  std::string reference(const Symbol& symbol) const;
  bool contains(const Symbol& symbol) const { return known_.contains(symbol); }

 private:
  void add(const Symbol& symbol, const std::string& comment, const Scene& scene);

  std::set<Symbol> known_;
  std::vector<Member> members_;
};

}  // namespace vcrit::symbolic
