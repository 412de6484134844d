#include "emit/parameters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "emit/pieces.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

ParameterList::ParameterList(const Problem& problem, const std::vector<Symbol>& symbols,
                             const FixedValues& fixed, Spelled spelled)
    : names_(problem->names), spelled_(spelled) {
  const std::set<Symbol> always{{"mu0"}, {"omega"}, {"du_z"}};
  const std::map<Symbol, Meaning> meanings = meanings_of(problem);
  for (const char* name : {"mu0", "omega", "du_z"}) add({name}, meanings.at({name}), problem);
  for (const Symbol& symbol : symbols) {
    if (const auto number = fixed.find(symbol); number != fixed.end())
      fixed_.insert(*number);
    else if (!always.contains(symbol))
      add(symbol, meanings.at(symbol), problem);
  }
}

void ParameterList::add(const Symbol& symbol, const Meaning& meaning, const Problem& problem) {
  known_.insert(symbol);
  const std::string name = in_language(as_called(problem, symbol).name);
  if (symbol.entry == 0)
    return members_.push_back({name, meaning.words, meaning.dimension, 0, symbol.name});
  const bool is_there = std::any_of(members_.begin(), members_.end(), [&](const Member& member) {
    return member.symbol == symbol.name;
  });
  if (!is_there)
    members_.push_back({name, meaning.words, meaning.dimension,
                        problem->source->arrays.at(symbol.name), symbol.name});
}

std::string ParameterList::named(std::string text) const {
  for (const auto& [mark, name] :
       {std::pair("THE_MU0", "mu0"), {"THE_OMEGA", "omega"}, {"THE_DU_Z", "du_z"}})
    text = replaced(std::move(text), mark, name_of(name));
  return text;
}

std::string ParameterList::name_of(const std::string& symbol) const {
  const auto found = names_.find(symbol);
  return in_language(found == names_.end() ? symbol : found->second);
}

std::string ParameterList::in_language(const std::string& name) const {
  return spelled_ == nullptr ? name : spelled_(name);
}

NodeId ParameterList::value(Program& program, const Symbol& symbol) const {
  if (contains(symbol)) return program.parameter(symbol);
  const auto number = fixed_.find(symbol);
  return program.constant(number == fixed_.end() ? GiNaC::numeric(1)
                                                 : exact_binary(number->second));
}

std::vector<std::string> ParameterList::references(const Program& program) const {
  std::vector<std::string> all;
  for (const Node& node : program.nodes())
    if (node.operation == Node::Operation::parameter) all.push_back(reference(node.parameter));
  return all;
}

std::string ParameterList::reference(const Symbol& symbol) const {
  if (symbol.entry == 0) return "p." + name_of(symbol.name);
  return fmt::format("p.{}[{}]", name_of(symbol.name), symbol.entry - 1);
}

}  // namespace vcrit::symbolic
