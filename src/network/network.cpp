#include "network/network.hpp"

#include <algorithm>
#include <set>

namespace vcrit {

namespace {

template <class Combination>
Network combine(std::vector<Network> parts) {
  Combination whole;
  const auto same_kind = [](const Network& part) {
    return std::holds_alternative<Combination>(part.form);
  };
  if (parts.size() > 1 && std::ranges::none_of(parts, same_kind)) {
    whole.parts = std::move(parts);
    return {std::move(whole)};
  }
  for (Network& part : parts) {
    if (auto* same = std::get_if<Combination>(&part.form))
      std::move(same->parts.begin(), same->parts.end(), std::back_inserter(whole.parts));
    else
      whole.parts.push_back(std::move(part));
  }
  if (whole.parts.size() == 1) return std::move(whole.parts.front());
  return {std::move(whole)};
}

}  // namespace

bool operator==(const Series& a, const Series& b) { return a.parts == b.parts; }
bool operator==(const Parallel& a, const Parallel& b) { return a.parts == b.parts; }
bool operator==(const Graph& a, const Graph& b) {
  return a.nodes == b.nodes && a.wires == b.wires && a.parts == b.parts;
}
bool operator==(const Network& a, const Network& b) { return a.form == b.form; }

Network spring(Amount k) { return {Element{ElementKind::spring, std::move(k), {}}}; }
Network damper(Amount c) { return {Element{ElementKind::damper, std::move(c), {}}}; }
Network maxwell(Amount k, Amount tau) {
  return {Element{ElementKind::maxwell, std::move(k), std::move(tau)}};
}

Network mass(Amount m) { return {Element{ElementKind::mass, std::move(m), {}}}; }

Network series(std::vector<Network> parts) { return combine<Series>(std::move(parts)); }
Network parallel(std::vector<Network> parts) { return combine<Parallel>(std::move(parts)); }

void for_each_element(const Network& network, const std::function<void(const Element&)>& visit) {
  if (const auto* element = std::get_if<Element>(&network.form)) return visit(*element);
  const auto visit_parts = [&](const std::vector<Network>& parts) {
    for (const Network& part : parts) for_each_element(part, visit);
  };
  if (const auto* s = std::get_if<Series>(&network.form)) visit_parts(s->parts);
  if (const auto* p = std::get_if<Parallel>(&network.form)) visit_parts(p->parts);
  if (const auto* g = std::get_if<Graph>(&network.form)) visit_parts(g->parts);
}

int depth(const Network& network) {
  const auto below = [](const std::vector<Network>& parts) {
    int deepest = 0;
    for (const Network& part : parts) deepest = std::max(deepest, depth(part));
    return deepest + 1;
  };
  if (const auto* s = std::get_if<Series>(&network.form)) return below(s->parts);
  if (const auto* p = std::get_if<Parallel>(&network.form)) return below(p->parts);
  if (const auto* g = std::get_if<Graph>(&network.form)) return below(g->parts);
  return 0;
}

std::size_t size(const Network& network) {
  std::size_t elements = 0;
  for_each_element(network, [&](const Element&) { ++elements; });
  return elements;
}

void rename(Network& network, const std::function<Amount(const Symbol&)>& name) {
  const auto rename_parts = [&](std::vector<Network>& parts) {
    for (Network& part : parts) rename(part, name);
  };
  if (auto* e = std::get_if<Element>(&network.form)) {
    e->coefficient = with_symbols(e->coefficient, name);
    if (e->second.exists()) e->second = with_symbols(e->second, name);
    if (e->rest.exists()) e->rest = with_symbols(e->rest, name);
  }
  if (auto* s = std::get_if<Series>(&network.form)) rename_parts(s->parts);
  if (auto* p = std::get_if<Parallel>(&network.form)) rename_parts(p->parts);
  if (auto* g = std::get_if<Graph>(&network.form)) rename_parts(g->parts);
}

std::vector<Symbol> symbols_of(const Network& network) {
  std::vector<Symbol> symbols;
  std::set<Symbol> seen;
  const auto add = [&](const Symbol& symbol, NumberRole) {
    if (seen.insert(symbol).second) symbols.push_back(symbol);
  };
  for_each_element(network, [&](const Element& element) {
    for (const Amount* amount : {&element.coefficient, &element.second, &element.rest})
      if (amount->exists()) for_each_symbol(*amount, NumberRole::factor, add);
  });
  return symbols;
}

}  // namespace vcrit
