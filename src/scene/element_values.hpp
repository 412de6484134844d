// [elements]: the values of what the networks name, with what --set gives in their place.
#pragma once

#include <toml++/toml.h>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/complaints.hpp"
#include "base/units.hpp"
#include "network/network.hpp"
#include "scene/element_expressions.hpp"
#include "scene/networks.hpp"
#include "scene/quantities.hpp"
#include "scene/scene.hpp"

namespace vcrit {

class ElementValues {
 public:
  /// All by reference; `scene` gets its names, arrays, expressions and typed values.
  ElementValues(const toml::table& document, const std::string& file, Networks& networks,
                Quantities& quantities, Scene& scene, Complaints& complaints);

  /// Once networks and quantities have been read.
  void read();
  /// Puts the elements' own names and their expressions into the networks.
  void rename_elements();
  /// Of elements that no network uses.
  std::vector<Warning> warnings() const;

  /// By what an element is known in the program, which may have a quantity that is called otherwise
  /// in this scene, but so there.
  Symbol own(const Symbol& element) const;
  bool is_zero(const Symbol& symbol) const;
  std::optional<double> value(const Symbol& symbol) const;

 private:
  using Uses = ElementNames::Uses;

  bool has_body() const { return document_.contains("body"); }
  OverridingValues& settings() { return quantities_.settings(); }
  void read(const std::string& name, const ElementUse& use, const std::set<std::string>& taken);
  void refuse_clash(const std::string& name, const ElementUse& use,
                    const std::set<std::string>& taken) const;
  void read_other_keys(const Uses& uses);
  void refuse_to_set(const std::string& key, const Symbol& element) const;
  void read_scalar(const std::string& name, const ElementUse& use, const toml::node* node);
  void read_array(const std::string& name, const ElementUse& use, const toml::node* node);
  void read_entry(const Symbol& entry, const ElementUse& use, const toml::node* node);
  void read_unused();
  void refuse_names_beyond_ascii();
  std::vector<std::string> without_value() const;
  void put(const Symbol& symbol, const TypedNumber& number, const Place& place);

  const toml::table& document_;
  const toml::table* elements_;
  std::string file_;
  Networks& networks_;
  Quantities& quantities_;
  Scene& scene_;
  Complaints& complaints_;
  std::optional<ElementExpressions> expressions_;
  Uses uses_;
  std::map<Symbol, double> values_;
};

}  // namespace vcrit
