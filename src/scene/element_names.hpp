// Names in the place of values in [elements]: k1 = "k0" calls the element k1 by the name k0, and
// elements of one name are one element.
#pragma once

#include <toml++/toml.h>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "network/law.hpp"
#include "network/network.hpp"

namespace vcrit {

/// How the networks use a name of [elements].
struct ElementUse {
  NumberRole role = NumberRole::stiffness;
  Dimension dimension = Dimension::stiffness;
  int length = 0;  ///< entries of an array, 0 for a scalar
  Place place;     ///< of the network that uses it
};

/// "a spring", "an array of dampers", "relaxation times", ...
const char* kind_name(const ElementUse& use);

/// Throws InputError for a name that the half-space and the drive below an indenter share: `what`
/// is it, in the place of its second use.
void refuse_other_unit(const ElementUse& use, const ElementUse& first, const std::string& what);

class ElementNames {
 public:
  using Uses = std::map<std::string, ElementUse>;

  /// `elements`: the table, null where there is none.
  ElementNames(const toml::table* elements, std::string file);

  /// What the element that the networks write so is called. Throws InputError for names that are
  /// taken from one another in a circle.
  Symbol of(const Symbol& symbol);
  /// The elements that the networks use, by these names. Throws InputError where one name would be
  /// that of elements of two kinds.
  Uses resolve(const Uses& uses);

  /// Whether this key, "k1" or "k[2]", leads to the name of an element of the networks.
  bool is_used(const std::string& key) const { return used_.contains(key); }
  /// What keys stand for that lead to another name: those that no other element shares, and those
  /// of elements that are one.
  std::map<std::string, Symbol> sole() const { return keys(true); }
  std::map<std::string, Symbol> shared() const { return keys(false); }

 private:
  struct Name {
    Symbol symbol;
    Place place;
  };

  std::optional<Name> name_under(const Symbol& key) const;
  void note(const Symbol& key, const ElementUse& use, Uses& uses);
  std::map<std::string, Symbol> keys(bool sole) const;

  const toml::table* elements_;
  std::string file_;
  bool any_ = false;  // whether there are such names
  std::set<std::string> used_;
  std::map<Symbol, std::vector<Symbol>>
      origins_;  // keys of the networks by the name of the element
};

}  // namespace vcrit
