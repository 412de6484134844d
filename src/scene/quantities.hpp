// Numbers of a scene file: bare ones in SI, texts with a unit, and names, which have no value.
#pragma once

#include <toml++/toml.h>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/complaints.hpp"
#include "base/units.hpp"
#include "scene/bare_numbers.hpp"
#include "scene/document.hpp"
#include "scene/quantity.hpp"
#include "scene/range.hpp"
#include "scene/settings.hpp"

namespace vcrit {

/// In SI; nothing for a bare name. Throws InputError for anything else.
std::optional<TypedNumber> number(const toml::node& node, Dimension dimension,
                                  const std::string& name, const Place& place);

/// The bare name that stands for a value, if one does.
std::optional<std::string> bare_name(const toml::node& node);

/// Throws InputError for a name that is none in generated code. `what`: "network".
void check_name(const char* what, const std::string& name, const Place& place);

/// Throws InputError for a name that no symbol may have: one that could not stand in generated
/// code, or is among `taken` or the keys by which commands speak of quantities. `what`: "an
/// element".
void check_symbol_name(const std::string& name, const char* what, const Place& place,
                       const std::set<std::string>& taken = {});

/// The symbols of quantities that not every scene has, by the section that has them. There before
/// anything runs, as scenes may be read before main.
struct SymbolOfSection {
  const char *section, *symbol;
};
inline constexpr std::array<SymbolOfSection, 3> symbols_of_sections{
    {{"body", "m"}, {"load", "W"}, {"mount", "m_n"}}};

/// What a symbol is called within the program that the scene calls `name`: the same, unless a
/// quantity is called so here, whatever the scene calls that. `others`: of symbols_of_sections
/// those of this scene.
std::string own_name_of(const std::string& name, const std::set<std::string>& others);

/// The quantities of one scene file, with what --set gives in their place.
class Quantities {
 public:
  /// `typed`: where they are kept as they were typed.
  Quantities(const Settings& settings, std::map<Symbol, TypedNumber>& typed, Complaints& complaints)
      : settings_(settings), typed_(typed), complaints_(complaints) {}

  /// The value under `key`, unless --set gives one for the key or for the symbol's name. That is
  /// `symbol`, unless a bare name stands for the value. Complains of what is no such value.
  Quantity read(const document::Section& section, const char* key, const std::string& symbol,
                Dimension dimension, const Range& range);

  /// What a quantity is called where it is not called as is usual.
  struct Called {
    std::string setting = {};  ///< by --set, in place of the key
    std::string name = {};     ///< in place of the symbol, while no bare name stands for the value
  };
  Quantity read(const document::Section& section, const char* key, const std::string& symbol,
                Dimension dimension, const Range& range, const Called& called);
  /// Throws InputError where two of the quantities read would have one name.
  void refuse_equal_names() const;
  /// Those that are not called by their symbol, by it.
  std::map<std::string, std::string> names() const;
  /// Two names of one quantity, of which --set may give one.
  void refuse_both(const std::string& name, const std::string& other) const;

  /// Notes that --set gives `name` a bare number where the scene's `node` has a unit, if it is
  /// probably meant to be of that. Throws InputError where the node is no such quantity.
  void compare(const std::string& name, const TypedNumber& set, const toml::node* node,
               Dimension dimension);
  /// What to warn of where a number has no unit and others of them have one.
  std::vector<Warning> warnings() const;

  OverridingValues& settings() { return settings_; }
  const OverridingValues& settings() const { return settings_; }

 private:
  struct Named {
    std::string key, symbol, name;
    Place place;
  };

  void read_value(Quantity& quantity, const document::Section& section, const char* key,
                  Dimension dimension, const Range& range, const Called& called);
  void note(const Symbol& symbol, const char* key, const TypedNumber& number, const Place& place);

  OverridingValues settings_;
  std::vector<Named> read_;
  std::map<Symbol, TypedNumber>& typed_;
  Complaints& complaints_;
  std::vector<BareNumber> bare_;
  bool gives_units_ = false;
};

}  // namespace vcrit
