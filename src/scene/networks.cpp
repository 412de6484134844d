#include "scene/networks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "base/joined.hpp"
#include "network/expression.hpp"
#include "network/graph.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"
#include "scene/arithmetic.hpp"
#include "scene/document.hpp"
#include "scene/quantities.hpp"
#include "scene/rational_stiffness.hpp"

namespace vcrit {

namespace {

// Of all networks of a scene, where each use of a name is a copy of its network.
constexpr std::size_t most_elements_together = 4 * most_elements;

// Combinations in one another; a level of brackets makes two of them.
constexpr int deepest_network = 2 * deepest_nesting;

using document::describe_node;
using document::place_of;

constexpr const char* ground = "ground";

/// Gives a variable another value until the end of the block, however that is left.
template <class T>
class Restored {
 public:
  Restored(T& variable, T value) : variable_(variable), before_(std::move(variable)) {
    variable_ = std::move(value);
  }
  ~Restored() { variable_ = std::move(before_); }
  Restored(const Restored&) = delete;
  Restored& operator=(const Restored&) = delete;

 private:
  T& variable_;
  T before_;
};

bool carries_mass(const Graph& graph) {
  return std::any_of(graph.parts.begin(), graph.parts.end(), has_masses);
}

}  // namespace

Networks::Networks(const toml::table& document, std::string file, Complaints& complaints)
    : file_(std::move(file)),
      of_half_space_(document.contains("indenter")),
      named_(document::table(document, "networks", file_)),
      elements_(document::table(document, "elements", file_)),
      names_(elements_, file_),
      complaints_(complaints) {
  if (named_ == nullptr) return;
  for (const auto& [key, value] : *named_) {
    const std::string name(key.str());
    const Place place = place_of(value, file_);
    complaints_.attempt([&] { check_name("network", name, place); });
    if (elements_ != nullptr && elements_->contains(name))
      complaints_.add(
          {place, fmt::format("\"{}\" as a network and as an element", name), "one of the two"});
  }
}

Network Networks::read(const std::string& text, const Place& place, int level) {
  Surroundings around{
      [this](const std::string& name, const Place& at, int depth) {
        return named(name, at, depth + 1);
      },
      [this](const std::string& name) -> std::optional<int> { return array_length(name); },
      level,
      [this](const std::string& name) { return has_arguments(name); },
      [this](const std::string& name, const std::vector<std::string>& given, const Place& at,
             int depth) { return called(name, given, at, depth + 1); },
      arguments_};
  if (complaints_.collects())
    around.complain = [this](const InputError& complaint) { complaints_.add(complaint); };
  // The place is that of the opening quote.
  Network network = parse_expression(text, {place.file, place.line, place.column + 1}, around);
  check_size(network, place);
  note_uses(network, place);
  return network;
}

// An array that is called by another's name is as long.
std::optional<int> Networks::array_length(const std::string& name) {
  const std::string other = names_.of({name}).name;
  const toml::node* node = elements_ == nullptr ? nullptr : elements_->get(other);
  if (node == nullptr || !node->is_array()) return std::nullopt;
  return static_cast<int>(node->as_array()->size());
}

void Networks::read_unused() {
  if (named_ == nullptr) return;
  for (const bool with_arguments : {false, true})
    for (const auto& [key, value] : *named_) {
      const std::string name(key.str());
      if (has_arguments(name) != with_arguments || known_.contains(name) || called_.contains(name))
        continue;
      complaints_.attempt([&, &value = value] { read_unused(name, place_of(value, file_)); });
    }
}

// The arguments of one that nobody calls are no elements of the scene.
void Networks::read_unused(const std::string& name, const Place& place) {
  const bool is_plain = !has_arguments(name);
  const Restored notes(notes_uses_, is_plain);
  if (is_plain)
    named(name, place, 0);
  else
    called(name, arguments_of(name), place, 0);
  warnings_.push_back({place, fmt::format("network \"{}\" is not used by this scene", name)});
}

std::optional<Network> Networks::named(const std::string& name, const Place& place, int level) {
  if (named_ == nullptr || !named_->contains(name)) return std::nullopt;
  if (has_arguments(name))
    throw InputError(place, fmt::format("network \"{}\" without its arguments", name),
                     fmt::format("{}({})", name, joined(arguments_of(name), ", ")));
  auto known = known_.find(name);
  if (known == known_.end())
    known = known_.emplace(name, read_definition(name, {}, place, level)).first;
  return known->second;
}

bool Networks::has_arguments(const std::string& name) const {
  const toml::node* node = named_ == nullptr ? nullptr : named_->get(name);
  return node != nullptr && node->is_table() && node->as_table()->contains("arguments");
}

Network Networks::called(const std::string& name, const std::vector<std::string>& given,
                         const Place& place, int level) {
  const std::vector<std::string> arguments = arguments_of(name);
  if (given.size() != arguments.size())
    throw InputError(place, fmt::format("{} with {} names", name, given.size()),
                     fmt::format("{}({})", name, joined(arguments, ", ")));
  called_.insert(name);
  std::map<std::string, std::string> meant;
  for (std::size_t i = 0; i < given.size(); ++i) meant.emplace(arguments[i], given[i]);
  return read_definition(name, std::move(meant), place, level);
}

// A network knows its own arguments alone, wherever it stands.
Network Networks::read_definition(const std::string& name, std::map<std::string, std::string> meant,
                                  const Place& place, int level) {
  if (!being_read_.insert(name).second)
    throw InputError(place, fmt::format("network \"{}\" inside itself", name),
                     "networks that do not contain themselves");
  if (level > deepest_nesting)
    throw InputError(place, fmt::format("network \"{}\" at level {}", name, level),
                     fmt::format("at most {} levels of brackets and named networks in one another",
                                 deepest_nesting));
  // Also where it cannot be read, and the rest is.
  const struct Leaving {
    std::set<std::string>& networks;
    const std::string& name;
    ~Leaving() { networks.erase(name); }
  } leaving{being_read_, name};
  const Restored around(arguments_, std::move(meant));
  return read_named(name, *named_->get(name), level);
}

std::vector<std::string> Networks::arguments_of(const std::string& name) const {
  const toml::node& node = *named_->get(name)->as_table()->get("arguments");
  const std::string expected = "arguments = [\"k0\", \"k1\", \"c1\"], different names of elements";
  const toml::array* names = node.as_array();
  if (names == nullptr || names->empty())
    throw InputError(place_of(node, file_), fmt::format("arguments = {}", describe_node(node)),
                     expected);
  std::vector<std::string> arguments;
  for (const toml::node& each : *names) {
    const Place place = place_of(each, file_);
    if (!each.is_string())
      throw InputError(place, fmt::format("argument {}", describe_node(each)), expected);
    const auto& argument = each.ref<std::string>();
    check_name("argument", argument, place);
    if (named_->contains(argument))
      throw InputError(place, fmt::format("\"{}\" as a network and as an argument", argument),
                       "one of the two");
    if (std::find(arguments.begin(), arguments.end(), argument) != arguments.end())
      throw InputError(place, fmt::format("argument \"{}\" twice", argument), expected);
    arguments.push_back(argument);
  }
  return arguments;
}

Network Networks::read_named(const std::string& name, const toml::node& node, int level) {
  if (node.is_string()) return read(node.ref<std::string>(), place_of(node, file_), level);
  const toml::table* table = node.as_table();
  if (table == nullptr)
    throw InputError(place_of(node, file_),
                     fmt::format("network \"{}\" = {}", name, describe_node(node)),
                     "a network in quotes, or a table with terminals and edges, or a stiffness");
  if (table->contains("stiffness")) return read_rational(name, *table);
  if (!table->contains("network")) return read_graph(name, *table, level);
  const document::Section section(table, "networks." + name, file_, {"arguments", "network"},
                                  complaints_);
  return read(section.text("network"), section.place("network"), level);
}

Network Networks::read_rational(const std::string& name, const toml::table& table) {
  const document::Section section(&table, "networks." + name, file_, {"stiffness"}, complaints_);
  const Place quote = section.place("stiffness");
  const StiffnessNames names{
      [this](const Symbol& symbol) { return names_.of(symbol); },
      [this](const Symbol& symbol) -> AmountTreePointer {
        const toml::node* node = element_node(elements_, symbol);
        const auto text = node == nullptr ? std::nullopt : expression_in(*node);
        if (!text) return nullptr;
        const Place place = place_of(*node, file_);
        return parse_arithmetic(*text, {place.file, place.line, place.column + 1});
      }};
  TypedStiffness typed = read_stiffness(section.text("stiffness"), name,
                                        {quote.file, quote.line, quote.column + 1}, names);
  for (const auto& [symbol, number] : typed.form.values) {
    refuse_typed_element(symbol, name);
    numbers_[symbol] = number;
  }
  for (const auto& [symbol, expression] : typed.form.expressions) {
    refuse_typed_element(symbol, name);
    if (notes_uses_) expressions_.texts[symbol] = {expression, quote};
  }
  expressions_.keys.merge(typed.keys);
  note_uses(typed.form.network, quote);
  return std::move(typed.form.network);
}

void Networks::refuse_typed_element(const Symbol& element, const std::string& network) const {
  if (elements_ != nullptr && elements_->contains(element.name))
    throw InputError(place_of(*elements_->get(element.name), file_),
                     fmt::format("\"{}\", an element of network \"{}\" that its stiffness gives",
                                 element.name, network),
                     "another name of the element or of the network");
}

Network Networks::given(Network network, const std::map<Symbol, TypedNumber>& numbers,
                        const std::set<std::string>& tabulated, const Place& place) {
  for (const Symbol& symbol : symbols_of(network)) {
    if (elements_ != nullptr && elements_->contains(symbol.name))
      throw InputError(place_of(*elements_->get(symbol.name), file_),
                       fmt::format("\"{}\", a number of the measured contact", symbol.name),
                       "another name of the element");
    if (uses_.contains(symbol.name)) refuse_reserved(symbol.name, uses_.at(symbol.name).place);
  }
  note_uses(network, place);
  for (const Symbol& symbol : symbols_of(network)) reserved_.insert(symbol.name);
  numbers_.insert(numbers.begin(), numbers.end());
  tabulated_.insert(tabulated.begin(), tabulated.end());
  return network;
}

void Networks::refuse_reserved(const std::string& name, const Place& place) {
  throw InputError(place, fmt::format("\"{}\", a number of the measured contact", name),
                   "another name of the element");
}

const TypedNumber* Networks::number_of(const Symbol& symbol) const {
  const auto found = numbers_.find(symbol);
  return found == numbers_.end() ? nullptr : &found->second;
}

Network Networks::read_graph(const std::string& name, const toml::table& table, int level) {
  const document::Section section(&table, "networks." + name, file_,
                                  {"arguments", "terminals", "edges"}, complaints_);
  const toml::node* terminals = section.find("terminals");
  const toml::node* edges = section.find("edges");
  const std::string expected_terminals = "terminals = [\"a\", \"b\"], two different nodes";
  if (terminals == nullptr || !terminals->is_array() || terminals->as_array()->size() != 2)
    throw InputError(section.place("terminals"), "no two terminals", expected_terminals);
  if (edges == nullptr || !edges->is_array() || edges->as_array()->empty())
    throw InputError(section.place("edges"), "no edges", "edges = [[\"k1\", \"a\", \"b\"], ...]");

  Graph graph;
  NamedNodes nodes;
  for (const toml::node& terminal : *terminals->as_array()) read_node(terminal, "terminals", nodes);
  if (nodes.names.size() != 2)
    throw InputError(section.place("terminals"), "one node twice", expected_terminals);
  for (const toml::node& edge : *edges->as_array()) read_edge(edge, graph, nodes, level);
  graph.nodes = std::move(nodes.names);
  if (graph.nodes[0] == ground && carries_mass(graph))
    throw InputError(section.place("terminals"), "\"ground\" as the first terminal",
                     "the body's end first; \"ground\" is inertial ground, where masses end");
  merge_ground(graph, *edges->as_array());

  auto loaded = load_carrying({graph.nodes, std::move(graph.parts), graph.wires});
  if (!loaded)
    throw InputError(
        section.place("edges"),
        fmt::format("terminals \"{}\" and \"{}\" of network \"{}\" without a connection",
                    graph.nodes[0], graph.nodes[1], name),
        "a path of edges between them");
  for (const std::size_t i : loaded->left_out)
    warnings_.push_back(
        {section.place(*edges->as_array()->get(i)),
         fmt::format("edge {} of network \"{}\" (\"{}\" to \"{}\") carries no load and is left out",
                     i + 1, name, graph.nodes[static_cast<std::size_t>(graph.wires[i].from)],
                     graph.nodes[static_cast<std::size_t>(graph.wires[i].to)])});
  Network network{std::move(loaded->graph)};
  check_size(network, section.place("edges"));
  return network;
}

void Networks::read_edge(const toml::node& node, Graph& graph, NamedNodes& nodes, int level) {
  const toml::array* edge = node.as_array();
  const Place place = place_of(node, file_);
  const std::string expected = "[\"network\", \"node\", \"node\"]";
  if (edge == nullptr || edge->size() != 3 || !edge->get(0)->is_string())
    throw InputError(
        place, fmt::format("edge {}", edge == nullptr ? describe_node(node) : "of another form"),
        expected);
  const int from = read_node(*edge->get(1), expected, nodes);
  graph.wires.push_back({from, read_node(*edge->get(2), expected, nodes)});
  const toml::node& network = *edge->get(0);
  graph.parts.push_back(read(network.ref<std::string>(), place_of(network, file_), level));
}

// To an oscillation inertial ground and the second terminal, which moves uniformly, are one node.
void Networks::merge_ground(Graph& graph, const toml::array& edges) const {
  const auto found = std::find(graph.nodes.begin() + 2, graph.nodes.end(), ground);
  if (found == graph.nodes.end()) return;
  const auto node = static_cast<int>(found - graph.nodes.begin());
  for (std::size_t i = 0; i < graph.wires.size(); ++i) {
    Wire& wire = graph.wires[i];
    if (wire.from != node && wire.to != node) continue;
    if (without_masses(graph.parts[i]))
      throw InputError(place_of(*edges.get(i), file_),
                       fmt::format("an edge to \"ground\" other than a mass ({})",
                                   describe_node(*edges.get(i)->as_array()->get(0))),
                       "mass(...): springs and dampers have no end at inertial ground");
    for (int* end : {&wire.from, &wire.to})
      if (*end == node) *end = 1;
  }
}

int Networks::read_node(const toml::node& node, const std::string& expected,
                        NamedNodes& nodes) const {
  if (!node.is_string())
    throw InputError(place_of(node, file_), describe_node(node),
                     "the name of a node in quotes: " + expected);
  const auto& name = node.ref<std::string>();
  const auto [known, is_new] = nodes.places.emplace(name, static_cast<int>(nodes.names.size()));
  if (is_new) nodes.names.push_back(name);
  return known->second;
}

void Networks::check_size(const Network& network, const Place& place) {
  if (const int levels = depth(network); levels > deepest_network)
    throw InputError(place, fmt::format("{} combinations in one another", levels),
                     fmt::format("at most {}", deepest_network));
  const std::size_t elements = size(network);
  elements_read_ += elements;
  if (elements > most_elements)
    throw InputError(place, fmt::format("{} elements", elements),
                     fmt::format("at most {} in a network", most_elements));
  if (elements_read_ > most_elements_together)
    throw InputError(place, fmt::format("more than {} elements", most_elements_together),
                     "at most so many in all networks of a scene, each use of a name counted");
}

Dimension Networks::dimension_of(NumberRole role) const {
  return of_half_space_ ? number_row(role).in_half_space : number_row(role).dimension;
}

void Networks::note_uses(const Network& network, const Place& place) {
  if (!notes_uses_) return;
  for_each_element(network, [&](const Element& element) {
    for_each_number(element,
                    [&](const Symbol& symbol, NumberRole role) { note_use(symbol, role, place); });
  });
}

void Networks::note_use(const Symbol& symbol, NumberRole role, const Place& place) {
  if (reserved_.contains(symbol.name)) refuse_reserved(symbol.name, place);
  const ElementUse use{role, dimension_of(role), symbol.entry, place};
  const auto [known, is_new] = uses_.try_emplace(symbol.name, use);
  ElementUse& first = known->second;
  if (is_new) return;
  if (first.role != role || (first.length > 0) != (symbol.entry > 0))
    throw InputError(place, fmt::format("\"{}\" as {}", symbol.name, kind_name(use)),
                     fmt::format("{}, as at {}", kind_name(first), to_text(first.place)));
  refuse_other_unit(use, first, fmt::format("\"{}\"", symbol.name));
  first.length = std::max(first.length, symbol.entry);
}

}  // namespace vcrit
