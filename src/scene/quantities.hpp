// Numbers of a scene file: bare ones in SI, texts with a unit, and names, which have no value.
#pragma once

#include <toml++/toml.h>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>

#include "base/units.hpp"
#include "scene/document.hpp"
#include "scene/scene.hpp"
#include "scene/settings.hpp"

namespace vcrit {

/// What a quantity's value must satisfy.
struct Range {
  bool (*holds)(double);
  const char* expected;
};
extern const Range nonnegative, positive, poisson_range, slope_range;

/// The value. Throws InputError, with `name`, where it is out of range.
double checked(double value, const Range& range, const std::string& name, const Place& place);

/// In SI; nothing for a bare name. Throws InputError for anything else.
std::optional<TypedNumber> number(const toml::node& node, Dimension dimension,
                                  const std::string& name, const Place& place);

/// Of a bare name that stands for no value: throws InputError unless it is one of `own`, the names
/// that the quantity or element has.
void refuse_other_name(const toml::node& node, std::initializer_list<std::string> own,
                       const std::string& name, const Place& place, const std::string& expected);

/// The quantities of one scene file, with what --set gives in their place.
class Quantities {
 public:
  /// `typed`: where they are kept as they were typed.
  Quantities(const Settings& settings, std::map<Symbol, TypedNumber>& typed)
      : settings_(settings), typed_(typed) {}

  /// The value under `key`, unless --set gives one for the key or for the symbol.
  Quantity read(const document::Section& section, const char* key, const std::string& symbol,
                Dimension dimension, const Range& range);
  /// Two names of one quantity, of which --set may give one.
  void refuse_both(const std::string& name, const std::string& other) const;

  OverridingValues& settings() { return settings_; }

 private:
  OverridingValues settings_;
  std::map<Symbol, TypedNumber>& typed_;
};

}  // namespace vcrit
