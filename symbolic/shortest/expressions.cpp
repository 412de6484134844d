#include "shortest/expressions.hpp"

#include <algorithm>

#include "base/errors.hpp"

namespace vcrit::symbolic::shortest {

namespace {

std::size_t hash_with(std::size_t hash, std::size_t value) {
  hash = (hash ^ value) * 0x9e3779b97f4a7c15;
  return hash ^ (hash >> 29);
}

std::size_t node_hash(const NodeData& data) {
  std::size_t hash = hash_with(static_cast<std::size_t>(data.kind) + 1, data.name);
  for (const Item& item : data.items) {
    hash = hash_with(hash, item.node);
    hash = hash_with(hash, static_cast<std::size_t>(item.exponent));
    hash = hash_with(hash, static_cast<std::size_t>(item.factor.over));
    hash = hash_with(hash, static_cast<std::size_t>(item.factor.under));
  }
  return hash;
}

bool by_node(const Item& a, const Item& b) { return a.node < b.node; }

SmallFraction power(SmallFraction base, int exponent) {
  if (base.is_one()) return base;  // nearly always
  if (exponent < 0) return power(reciprocal(base), -exponent);
  SmallFraction result;
  for (int i = 0; i < exponent; ++i) result = result * base;
  return result;
}

/// Factors of one node joined; those that cancel go.
void join_factors(std::vector<Item>& items) {
  std::sort(items.begin(), items.end(), by_node);
  std::size_t kept = 0;
  for (const Item& item : items) {
    if (kept > 0 && items[kept - 1].node == item.node)
      items[kept - 1].exponent += item.exponent;
    else
      items[kept++] = item;
    if (items[kept - 1].exponent == 0) --kept;
  }
  items.resize(kept);
}

void join_terms(std::vector<Item>& items) {
  std::sort(items.begin(), items.end(), by_node);
  std::size_t kept = 0;
  for (const Item& item : items) {
    if (kept > 0 && items[kept - 1].node == item.node)
      items[kept - 1].factor = items[kept - 1].factor + item.factor;
    else
      items[kept++] = item;
    if (items[kept - 1].factor.is_zero()) --kept;
  }
  items.resize(kept);
}

/// n = square^2 * rest.
std::int64_t square_part(std::int64_t& n) {
  std::int64_t square = 1;
  for (std::int64_t i = 2; i < 1000 && i * i <= n; ++i)
    while (n % (i * i) == 0) n /= i * i, square *= i;
  return square;
}

}  // namespace

Expressions::Expressions() : known_(1024, Hash{this}, Same{this}) { make(ExpressionKind::one, {}); }

bool Expressions::Same::operator()(ExNode a, ExNode b) const {
  const NodeData &x = all->nodes_[a], &y = all->nodes_[b];
  return x.kind == y.kind && x.name == y.name && x.items == y.items;
}

bool Expressions::is_positive(ExpressionKind kind, const std::vector<Item>& items) const {
  const auto all = [&](const auto& holds) {
    return std::all_of(items.begin(), items.end(), holds);
  };
  if (kind == ExpressionKind::sum)
    return all([&](const Item& i) { return !i.factor.negative() && nodes_[i.node].positive; });
  if (kind == ExpressionKind::product)
    return all([&](const Item& i) { return i.exponent % 2 == 0 || nodes_[i.node].positive; });
  return true;
}

ExNode Expressions::make(ExpressionKind kind, std::vector<Item> items) {
  NodeData data{kind, is_positive(kind, items), 0, std::move(items), 0};
  data.hash = node_hash(data);
  spend(8 + 2 * data.items.size());
  nodes_.push_back(std::move(data));
  const auto [known, is_new] = known_.insert(static_cast<ExNode>(nodes_.size() - 1));
  if (!is_new) nodes_.pop_back();
  return *known;
}

Ex Expressions::symbol(std::string name, int operations, bool leads) {
  nodes_.push_back(
      {ExpressionKind::symbol, true, static_cast<std::uint32_t>(names_.size()), {}, 0});
  nodes_.back().hash = node_hash(nodes_.back());
  const ExNode node = static_cast<ExNode>(nodes_.size() - 1);
  known_.insert(node);
  names_.push_back({std::move(name), operations, leads, number(0), node});
  return {{}, node};
}

Ex Expressions::signed_symbol(std::string name) {
  const Ex ex = symbol(std::move(name));
  nodes_[ex.node].positive = false;
  return ex;
}

Ex Expressions::named(std::string letter, const Ex& meaning, int operations, bool positive) {
  const bool is_name = meaning.factor.is_one() &&
                       nodes_[meaning.node].kind == ExpressionKind::symbol &&
                       this->operations(meaning.node) == 0;
  if (is_name || meaning.is_number()) return meaning;
  for (const Name& name : names_)
    if (!name.meaning.is_zero() && name.meaning == meaning) return {{}, name.symbol};
  const Ex ex = symbol(std::move(letter), operations);
  nodes_[ex.node].positive = positive;
  names_.back().meaning = meaning;
  return ex;
}

Ex Expressions::sum(std::vector<Ex> terms) {
  std::vector<Item> items;
  items.reserve(terms.size());
  for (const Ex& term : terms)
    if (!term.is_zero()) items.push_back({term.node, 1, term.factor});
  join_terms(items);
  // A sum of sums is one sum, unless a number stands before one of them.
  const auto is_part = [this](const Item& item) {
    return item.factor.is_unit() && nodes_[item.node].kind == ExpressionKind::sum;
  };
  while (std::any_of(items.begin(), items.end(), is_part)) {
    std::vector<Item> flat;
    flat.reserve(2 * items.size());
    for (const Item& item : items) {
      if (!is_part(item))
        flat.push_back(item);
      else
        for (const Item& part : nodes_[item.node].items)
          flat.push_back({part.node, 1, part.factor * item.factor});
    }
    join_terms(flat);
    items = std::move(flat);
  }
  if (items.empty()) return number(0);
  if (items.size() == 1) return {items[0].factor, items[0].node};
  SmallFraction common = absolute(items[0].factor);
  for (const Item& item : items)
    if (!(absolute(item.factor) == common)) common = {};
  if (items[0].factor.negative()) common = -common;
  for (Item& item : items) item.factor = item.factor / common;
  return {common, make(ExpressionKind::sum, std::move(items))};
}

void Expressions::multiply_into(std::vector<Item>& items, SmallFraction& factor,
                                std::vector<Item>& under_root, SmallFraction& root_factor,
                                const Ex& base, int exponent) {
  factor = factor * shortest::power(base.factor, exponent);
  const NodeData& data = nodes_[base.node];
  switch (data.kind) {
    case ExpressionKind::one:
      return;
    case ExpressionKind::product:
      for (const Item& item : data.items)
        multiply_into(items, factor, under_root, root_factor, {{}, item.node},
                      item.exponent * exponent);
      return;
    case ExpressionKind::root: {
      const Ex argument{data.items[0].factor, data.items[0].node};
      const int left = exponent % 2;
      multiply_into(items, factor, under_root, root_factor, argument, (exponent - left) / 2);
      if (left == 0) return;
      root_factor = root_factor * shortest::power(argument.factor, left);
      under_root.push_back({argument.node, left, {}});
      return;
    }
    case ExpressionKind::magnitude:
      if (exponent % 2 == 0)
        return multiply_into(items, factor, under_root, root_factor, {{}, data.items[0].node},
                             exponent);
      [[fallthrough]];
    default:
      items.push_back({base.node, exponent, {}});
  }
}

Ex Expressions::product(const std::vector<std::pair<Ex, int>>& factors) {
  std::vector<Item> items, under_root;
  items.reserve(factors.size() + 4);  // some are products themselves
  SmallFraction factor, root_factor;
  for (const auto& [base, exponent] : factors) {
    if (base.is_zero()) return number(0);
    multiply_into(items, factor, under_root, root_factor, base, exponent);
  }
  if (!under_root.empty()) {
    std::vector<std::pair<Ex, int>> arguments{{{root_factor, 0}, 1}};
    for (const Item& item : under_root) arguments.push_back({{{}, item.node}, item.exponent});
    const Ex whole = root(product(arguments));
    factor = factor * whole.factor;
    const NodeData& data = nodes_[whole.node];
    if (data.kind == ExpressionKind::product)
      items.insert(items.end(), data.items.begin(), data.items.end());
    else if (data.kind != ExpressionKind::one)
      items.push_back({whole.node, 1, {}});
  }
  join_factors(items);
  // x^2 |x| is |x|^3.
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (nodes_[items[i].node].kind != ExpressionKind::magnitude) continue;
    for (Item& other : items)
      if (other.node == nodes_[items[i].node].items[0].node && other.exponent % 2 == 0)
        items[i].exponent += std::exchange(other.exponent, 0);
  }
  std::erase_if(items, [](const Item& item) { return item.exponent == 0; });
  if (items.empty()) return {factor, 0};
  if (items.size() == 1 && items[0].exponent == 1) return {factor, items[0].node};
  return {factor, make(ExpressionKind::product, std::move(items))};
}

Ex Expressions::root(const Ex& argument) {
  ensure(!argument.factor.negative(), "roots are real");
  if (argument.is_zero()) return argument;
  SmallFraction inside = argument.factor, outside;
  outside.over = square_part(inside.over), outside.under = square_part(inside.under);
  std::vector<std::pair<Ex, int>> before{{{outside, 0}, 1}}, left;
  const NodeData& data = nodes_[argument.node];
  if (data.kind == ExpressionKind::product) {
    for (const Item& item : data.items) {
      const int odd = item.exponent % 2;
      if (item.exponent != odd)
        before.emplace_back(magnitude({{}, item.node}), (item.exponent - odd) / 2);
      if (odd != 0) left.push_back({{{}, item.node}, odd});
    }
  } else {
    left.push_back({{{}, argument.node}, 1});
  }
  const Ex rest = product(left);
  if (rest.is_one() && inside.is_one()) return product(before);
  before.push_back({{{}, make(ExpressionKind::root, {{rest.node, 1, inside}})}, 1});
  // Not by product(), which would take the root apart again.
  std::vector<Item> items;
  SmallFraction factor = outside;
  for (std::size_t i = 1; i < before.size(); ++i) {
    const ExNode node = before[i].first.node;
    if (nodes_[node].kind == ExpressionKind::product)
      for (const Item& item : nodes_[node].items)
        items.push_back({item.node, item.exponent * before[i].second, {}});
    else
      items.push_back({node, before[i].second, {}});
  }
  join_factors(items);
  if (items.size() == 1 && items[0].exponent == 1) return {factor, items[0].node};
  return {factor, make(ExpressionKind::product, std::move(items))};
}

Ex Expressions::magnitude(const Ex& argument) {
  const SmallFraction size = absolute(argument.factor);
  const NodeData& data = nodes_[argument.node];
  if (data.positive) return {size, argument.node};
  if (data.kind != ExpressionKind::product)
    return {size, make(ExpressionKind::magnitude, {{argument.node, 1, {}}})};
  std::vector<std::pair<Ex, int>> factors{{{size, 0}, 1}};
  for (const Item& item : std::vector<Item>(data.items)) {
    const bool even = item.exponent % 2 == 0;
    factors.emplace_back(even ? Ex{{}, item.node} : magnitude({{}, item.node}), item.exponent);
  }
  return product(factors);
}

}  // namespace vcrit::symbolic::shortest
