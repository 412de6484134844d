// The values of --set, taken by name while the scene is read; what nobody took is an error.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/units.hpp"
#include "scene/quantity.hpp"

namespace vcrit {

/// What the quantity `name` measures. Throws InputError at `place` for others, with the name that
/// the scene gives the symbol of that name ("M" for "m" where mass = "M"), else the nearest one.
Dimension known_dimension(const std::string& name, const std::map<std::string, Dimension>& known,
                          const Place& place, const std::map<std::string, Symbol>& named = {});

/// Throws InputError at `place` where the scene has an expression in the place of this number, or
/// takes it from a table.
void refuse_expression(const Source& source, const std::string& name, const Place& place);

/// "NAME=VALUE" of --set. Throws InputError if it has another form.
std::pair<std::string, std::string> parse_setting(const std::string& text);

class OverridingValues {
 public:
  explicit OverridingValues(const Settings& settings);

  /// The value set for `name`, which stands for `symbol`, in SI. Throws InputError if it is no
  /// quantity of that dimension.
  std::optional<TypedNumber> take(const std::string& name, Dimension dimension,
                                  const Symbol& symbol);
  /// Whether there is a value for `name`.
  bool has(const std::string& name) const { return settings_.contains(name); }
  /// The names that could be taken so far, and what they measure.
  const std::map<std::string, Dimension>& known() const { return known_; }
  /// What each of them stands for.
  const std::map<std::string, Symbol>& named() const { return named_; }
  /// Where the setting of `name` stands, for messages.
  static Place place(const std::string& name);
  /// Throws InputError for names that the scene does not have.
  void refuse_untaken() const;

 private:
  std::map<std::string, std::string> settings_;
  std::map<std::string, Dimension> known_;
  std::map<std::string, Symbol> named_;
};

}  // namespace vcrit
