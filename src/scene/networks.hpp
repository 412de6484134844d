// The networks of one scene file: expressions, named networks and graphs, resolved into trees, and
// what kind of number each of their elements is.
#pragma once

#include <toml++/toml.h>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/complaints.hpp"
#include "base/units.hpp"
#include "network/law.hpp"
#include "network/network.hpp"
#include "scene/element_expressions.hpp"
#include "scene/element_names.hpp"

namespace vcrit {

class Networks {
 public:
  Networks(const toml::table& document, std::string file, Complaints& complaints);

  /// The network written as `text` at `place` (of the opening quote), as deep in brackets as
  /// `level` says. Throws InputError, also for networks that are too deep or too large.
  Network read(const std::string& text, const Place& place, int level = 0);
  /// Reads the named networks that nothing has used yet, for their errors.
  void read_unused();

  /// A network of elements whose numbers are given with it, or follow a table: `tabulated`. Throws
  /// InputError where [elements] or another network has one of their names.
  Network given(Network network, const std::map<Symbol, TypedNumber>& numbers,
                const std::set<std::string>& tabulated, const Place& place);
  /// Whether the number of that element follows a table.
  bool is_tabulated(const std::string& name) const { return tabulated_.contains(name); }

  /// By the names in the networks.
  const std::map<std::string, ElementUse>& uses() const { return uses_; }
  /// Numbers of elements that stand for a stiffness typed in, by the names in the networks.
  const TypedNumber* number_of(const Symbol& symbol) const;
  /// Expressions of such elements.
  const GivenExpressions& given_expressions() const { return expressions_; }
  /// What [elements] calls them.
  ElementNames& names() { return names_; }
  const std::vector<Warning>& warnings() const { return warnings_; }
  /// What is read from now on is of the drive: springs and dampers, also below an indenter.
  void read_drive_now() { of_half_space_ = false; }

 private:
  /// The nodes of a graph that is being read, and the place of each among them.
  struct NamedNodes {
    std::vector<std::string> names;
    std::map<std::string, int> places;
  };

  std::optional<int> array_length(const std::string& name);
  std::optional<Network> named(const std::string& name, const Place& place, int level);
  bool has_arguments(const std::string& name) const;
  /// Its network with elements of these names in the place of its arguments.
  Network called(const std::string& name, const std::vector<std::string>& given, const Place& place,
                 int level);
  /// Reads what stands under a name in [networks], which must not contain itself; `meant`: what its
  /// arguments stand for.
  Network read_definition(const std::string& name, std::map<std::string, std::string> meant,
                          const Place& place, int level);
  Network read_named(const std::string& name, const toml::node& node, int level);
  Network read_rational(const std::string& name, const toml::table& table);
  void refuse_typed_element(const Symbol& element, const std::string& network) const;
  Network read_graph(const std::string& name, const toml::table& table, int level);
  std::vector<std::string> arguments_of(const std::string& name) const;
  void read_unused(const std::string& name, const Place& place);
  void merge_ground(Graph& graph, const toml::array& edges) const;
  int read_node(const toml::node& node, const std::string& expected, NamedNodes& nodes) const;
  void read_edge(const toml::node& node, Graph& graph, NamedNodes& nodes, int level);
  Dimension dimension_of(NumberRole role) const;
  void note_uses(const Network& network, const Place& place);
  void note_use(const Symbol& symbol, NumberRole role, const Place& place);
  [[noreturn]] static void refuse_reserved(const std::string& name, const Place& place);
  void check_size(const Network& network, const Place& place);

  std::string file_;
  bool of_half_space_;           // elements are moduli and viscosities
  const toml::table* named_;     // [networks]
  const toml::table* elements_;  // [elements], for the length of its arrays
  ElementNames names_;
  std::map<std::string, Network> known_;
  std::map<Symbol, TypedNumber> numbers_;
  GivenExpressions expressions_;
  std::set<std::string> tabulated_, reserved_;
  std::set<std::string> being_read_;
  std::set<std::string> called_;                  // with arguments
  std::map<std::string, std::string> arguments_;  // of the network that is being read
  bool notes_uses_ = true;
  std::map<std::string, ElementUse> uses_;
  std::vector<Warning> warnings_;
  Complaints& complaints_;
  std::size_t elements_read_ = 0;
};

}  // namespace vcrit
