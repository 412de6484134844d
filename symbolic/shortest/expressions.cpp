#include "shortest/expressions.hpp"

#include <algorithm>
#include <array>

#include "base/errors.hpp"

namespace vcrit::symbolic::shortest {

namespace {

std::uint64_t hash_with(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9e3779b97f4a7c15;
  return hash ^ (hash >> 29);
}

std::uint64_t node_hash(ExpressionKind kind, std::span<const Item> items) {
  std::uint64_t hash = static_cast<std::uint64_t>(kind) + 1;
  for (const Item& item : items) {
    const auto exponent = static_cast<std::uint32_t>(item.exponent);
    hash = hash_with(hash, item.node | std::uint64_t{exponent} << 32);
    if (item.factor.is_one()) continue;  // nearly always
    hash = hash_with(hash, static_cast<std::uint64_t>(item.factor.over));
    hash = hash_with(hash, static_cast<std::uint64_t>(item.factor.under));
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
void join_factors(ItemList& items) {
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

void join_terms(ItemList& items) {
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

void NodeStore::push_back(NodeData node) {
  if (size_ == chunks_.size() * chunk) chunks_.push_back(std::make_unique<NodeData[]>(chunk));
  const std::size_t count = node.items.size();
  if (left_.size() < count) {
    const std::size_t more = std::max(4 * chunk, count);
    item_chunks_.push_back(std::make_unique_for_overwrite<Item[]>(more));
    left_ = {item_chunks_.back().get(), more};
  }
  std::copy(node.items.begin(), node.items.end(), left_.begin());
  node.items = left_.first(count);
  left_ = left_.subspan(count);
  (*this)[size_++] = node;
}

void KnownNodes::grow() {
  std::vector<Slot> before(2 * slots_.size());
  before.swap(slots_);
  for (const Slot& slot : before) {
    if (slot.node == none) continue;
    std::size_t at = slot.mark & (slots_.size() - 1);
    while (slots_[at].node != none) at = (at + 1) & (slots_.size() - 1);
    slots_[at] = slot;
  }
}

Expressions::Expressions() { make(ExpressionKind::one, {}); }

bool Expressions::is_positive(ExpressionKind kind, std::span<const Item> items) const {
  const auto all = [&](const auto& holds) {
    return std::all_of(items.begin(), items.end(), holds);
  };
  if (kind == ExpressionKind::sum)
    return all([&](const Item& i) { return !i.factor.negative() && nodes_[i.node].positive; });
  if (kind == ExpressionKind::product)
    return all([&](const Item& i) { return i.exponent % 2 == 0 || nodes_[i.node].positive; });
  return true;
}

ExNode Expressions::make(ExpressionKind kind, std::span<const Item> items) {
  spend(8 + 2 * items.size());
  const auto next = static_cast<ExNode>(nodes_.size());
  const auto same = [&](ExNode node) {
    return nodes_[node].kind == kind && std::ranges::equal(nodes_[node].items, items);
  };
  const ExNode node = known_.find_or_add(node_hash(kind, items), next, same);
  if (node == next) nodes_.push_back({kind, is_positive(kind, items), 0, items});
  return node;
}

Ex Expressions::symbol(std::string name, int operations, bool leads) {
  const auto node = static_cast<ExNode>(nodes_.size());
  nodes_.push_back({ExpressionKind::symbol, true, static_cast<std::uint32_t>(names_.size()), {}});
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

Ex Expressions::sum(std::span<const Ex> terms) {
  ItemList items;
  items.reserve(terms.size());
  for (const Ex& term : terms)
    if (!term.is_zero()) items.push_back({term.node, 1, term.factor});
  join_terms(items);
  // A sum of sums is one sum, unless a number stands before one of them.
  const auto is_part = [this](const Item& item) {
    return item.factor.is_unit() && nodes_[item.node].kind == ExpressionKind::sum;
  };
  while (std::any_of(items.begin(), items.end(), is_part)) {
    ItemList flat;
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
  return {common, make(ExpressionKind::sum, {items.data(), items.size()})};
}

void Expressions::multiply_into(ItemList& items, SmallFraction& factor, ItemList& under_root,
                                SmallFraction& root_factor, const Ex& base, int exponent) {
  if (!base.factor.is_one()) factor = factor * shortest::power(base.factor, exponent);
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

Ex Expressions::product(std::span<const ExPower> factors) {
  ItemList items, under_root;
  SmallFraction factor, root_factor;
  for (const auto& [base, exponent] : factors) {
    if (base.is_zero()) return number(0);
    multiply_into(items, factor, under_root, root_factor, base, exponent);
  }
  if (!under_root.empty()) {
    std::vector<ExPower> arguments{{{root_factor, 0}, 1}};
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
  const auto cancels = [](const Item& item) { return item.exponent == 0; };
  items.erase(std::remove_if(items.begin(), items.end(), cancels), items.end());
  if (items.empty()) return {factor, 0};
  if (items.size() == 1 && items[0].exponent == 1) return {factor, items[0].node};
  return {factor, make(ExpressionKind::product, {items.data(), items.size()})};
}

Ex Expressions::root(const Ex& argument) {
  ensure(!argument.factor.negative(), "roots are real");
  if (argument.is_zero()) return argument;
  SmallFraction inside = argument.factor, outside;
  outside.over = square_part(inside.over), outside.under = square_part(inside.under);
  boost::container::small_vector<ExPower, 12> before, left;
  before.emplace_back(Ex{outside, 0}, 1);
  const NodeData& data = nodes_[argument.node];
  if (data.kind == ExpressionKind::product) {
    for (const Item& item : data.items) {
      const int odd = item.exponent % 2;
      if (item.exponent != odd)
        before.emplace_back(magnitude({{}, item.node}), (item.exponent - odd) / 2);
      if (odd != 0) left.emplace_back(Ex{{}, item.node}, odd);
    }
  } else {
    left.emplace_back(Ex{{}, argument.node}, 1);
  }
  const Ex rest = product({left.data(), left.size()});
  if (rest.is_one() && inside.is_one()) return product({before.data(), before.size()});
  const ExNode root = make(ExpressionKind::root, std::array{Item{rest.node, 1, inside}});
  before.emplace_back(Ex{{}, root}, 1);
  // Not by product(), which would take the root apart again.
  ItemList items;
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
  return {factor, make(ExpressionKind::product, {items.data(), items.size()})};
}

Ex Expressions::magnitude(const Ex& argument) {
  const SmallFraction size = absolute(argument.factor);
  const NodeData& data = nodes_[argument.node];
  if (data.positive) return {size, argument.node};
  if (data.kind != ExpressionKind::product)
    return {size, make(ExpressionKind::magnitude, std::array{Item{argument.node, 1, {}}})};
  std::vector<ExPower> factors{{{size, 0}, 1}};
  for (const Item& item : data.items) {
    const bool even = item.exponent % 2 == 0;
    factors.emplace_back(even ? Ex{{}, item.node} : magnitude({{}, item.node}), item.exponent);
  }
  return product(factors);
}

}  // namespace vcrit::symbolic::shortest
