#include "shortest/moves.hpp"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

namespace vcrit::symbolic::shortest {

namespace {

/// The expressions that may stand in place of a node.
class Alternatives {
 public:
  explicit Alternatives(Expressions& all) : all_(all) {}

  const std::vector<Ex>& of(ExNode node) {
    node_ = node;
    found_.clear();
    if (all_[node].kind == ExpressionKind::sum) of_sum(items(node));
    if (all_[node].kind == ExpressionKind::product) of_product(items(node));
    return found_;
  }

 private:
  using Items = std::span<const Item>;
  struct Power {
    ExNode node;
    int exponent;
    friend bool operator==(const Power&, const Power&) = default;
  };

  Items items(ExNode node) const { return all_[node].items; }

  void offer(const Ex& ex) {
    const Ex same{{}, node_};
    if (!(ex == same) && std::find(found_.begin(), found_.end(), ex) == found_.end())
      found_.push_back(ex);
  }

  /// A term as its factors, until another term's are asked for.
  std::span<const Item> factors(ExNode term) const {
    if (term == 0) return {};
    if (all_[term].kind == ExpressionKind::product) return all_[term].items;
    single_ = {term, 1, {}};
    return {&single_, 1};
  }

  Ex over(const Item& term, const Power& power) {
    return all_.product({{{term.factor, term.node}, 1}, {{{}, power.node}, -power.exponent}});
  }

  Ex sum_over(const Items& terms, const Power& power) {
    std::vector<Ex> left;
    left.reserve(terms.size());
    for (const Item& term : terms) left.push_back(over(term, power));
    return all_.sum(left);
  }

  static void remember(std::vector<Power>& powers, const Power& power) {
    if (std::find(powers.begin(), powers.end(), power) == powers.end()) powers.push_back(power);
  }

  /// Each factor of a term, with the powers in which it occurs.
  std::vector<Power> powers_in(const Items& terms) const {
    std::vector<Power> powers;
    for (const Item& term : terms)
      for (const Item& factor : factors(term.node))
        remember(powers, {factor.node, factor.exponent});
    return powers;
  }

  bool has(const Item& term, const Power& power) const {
    for (const Item& factor : factors(term.node))
      if (factor.node == power.node)
        return power.exponent > 0 ? factor.exponent >= power.exponent
                                  : factor.exponent <= power.exponent;
    return false;
  }

  /// a b + a c + d = a (b + c) + d; and the whole over a.
  void of_sum(const Items& terms) {
    for (const Power& power : powers_in(terms)) {
      take_out(terms, power);
      const Ex all = sum_over(terms, power);
      offer(all_.product({{all, 1}, {{{}, power.node}, power.exponent}}));
    }
    for (const Item& term : terms) expand(terms, term);
  }

  void take_out(const Items& terms, const Power& power) {
    std::vector<Ex> with, without;
    for (const Item& term : terms) {
      if (has(term, power))
        with.push_back(over(term, power));
      else
        without.push_back({term.factor, term.node});
    }
    if (with.size() < 2 || without.empty()) return;
    without.push_back(all_.product({{all_.sum(with), 1}, {{{}, power.node}, power.exponent}}));
    offer(all_.sum(without));
  }

  /// The term's product with a sum among its factors multiplied out.
  void expand(const Items& terms, const Item& term) {
    for (const Item& factor : factors(term.node)) {
      if (all_[factor.node].kind != ExpressionKind::sum || factor.exponent != 1) continue;
      const Ex rest = over(term, {factor.node, 1});
      std::vector<Ex> whole;
      for (const Item& part : items(factor.node))
        whole.push_back(all_.multiply(rest, {part.factor, part.node}));
      for (const Item& other : terms)
        if (other.node != term.node) whole.push_back({other.factor, other.node});
      offer(all_.sum(whole));
    }
  }

  /// Roots and absolute values stay factors of the whole, and so does what leads it.
  bool stays_rational(ExNode factor) const {
    const ExpressionKind kind = all_[factor].kind;
    return !all_.leads(factor) && kind != ExpressionKind::root && kind != ExpressionKind::magnitude;
  }

  void of_product(const Items& factors) {
    for (const Item& sum : factors)
      if (all_[sum.node].kind == ExpressionKind::sum) {
        for (const Item& factor : factors)
          if (factor.node != sum.node && stays_rational(factor.node)) move_in(factors, sum, factor);
        scale_quotient(factors, sum);
      }
    for (const Item& root : factors)
      if (all_[root.node].kind == ExpressionKind::root)
        for (const Item& factor : factors)
          if (factor.node != root.node && !all_.leads(factor.node))
            move_under_root(factors, root, factor);
  }

  Ex product_without(std::span<const Item> factors, ExNode a, ExNode b) {
    std::vector<ExPower> rest;
    rest.reserve(factors.size());
    for (const Item& factor : factors)
      if (factor.node != a && factor.node != b)
        rest.push_back({{{}, factor.node}, factor.exponent});
    return all_.product(rest);
  }

  /// a (b + c) = a b + a c, a/(b + c) = 1/(b/a + c/a), a^2 (b + c)^2 = (a b + a c)^2.
  void move_in(const Items& factors, const Item& sum, const Item& factor) {
    if (factor.exponent % sum.exponent != 0) return;
    const Ex inside = sum_over(items(sum.node), {factor.node, -(factor.exponent / sum.exponent)});
    offer(all_.product(
        {{product_without(factors, sum.node, factor.node), 1}, {inside, sum.exponent}}));
  }

  /// (a + b)/(c + d) = (a f + b f)/(c f + d f) for what stands below a bar, or in all terms, of
  /// one.
  void scale_quotient(const Items& factors, const Item& sum) {
    for (const Item& other : factors) {
      if (other.node == sum.node || all_[other.node].kind != ExpressionKind::sum) continue;
      if (other.exponent != -sum.exponent) continue;
      for (const Power& power : powers_in(items(sum.node))) {
        const Ex a = sum_over(items(sum.node), power), b = sum_over(items(other.node), power);
        offer(all_.product({{product_without(factors, sum.node, other.node), 1},
                            {a, sum.exponent},
                            {b, other.exponent}}));
      }
    }
  }

  /// a sqrt(b + c) = sqrt(a^2 b + a^2 c).
  void move_under_root(const Items& factors, const Item& root, const Item& factor) {
    if (factor.exponent % root.exponent != 0) return;
    const Item argument = items(root.node)[0];
    const ExNode base = all_[factor.node].kind == ExpressionKind::magnitude
                            ? items(factor.node)[0].node
                            : factor.node;
    const int exponent = 2 * factor.exponent / root.exponent;
    for (const Item& inner : this->factors(argument.node)) {
      if (all_[inner.node].kind != ExpressionKind::sum || exponent % inner.exponent != 0) continue;
      const Ex inside = sum_over(items(inner.node), {base, -(exponent / inner.exponent)});
      const Ex rest = product_without(this->factors(argument.node), inner.node, inner.node);
      const Ex whole =
          all_.product({{{argument.factor, 0}, 1}, {rest, 1}, {inside, inner.exponent}});
      offer(all_.product({{product_without(factors, root.node, factor.node), 1},
                          {all_.root(whole), root.exponent}}));
    }
  }

  Expressions& all_;
  ExNode node_ = 0;
  std::vector<Ex> found_;
  mutable Item single_;
};

/// The expression with one node replaced, wherever it occurs.
class Replacing {
 public:
  Replacing(Expressions& all, const std::vector<ExNode>& order) : all_(all), order_(order) {}

  Ex operator()(const Ex& whole, std::size_t place, const Ex& by) {
    made_.resize(order_.size());
    changed_.assign(order_.size(), false);
    made_[place] = by, changed_[place] = true;
    for (std::size_t i = place + 1; i < order_.size(); ++i) rebuild(i, place);
    const Ex& node = made_.back();
    if (!changed_.back()) return whole;
    return {whole.factor * node.factor, node.node};
  }

 private:
  const Ex* new_of(ExNode node, std::size_t from, std::size_t to) const {
    for (std::size_t i = from; i < to; ++i)
      if (order_[i] == node) return changed_[i] ? &made_[i] : nullptr;
    return nullptr;
  }

  void rebuild(std::size_t i, std::size_t place) {
    const NodeData& data = all_[order_[i]];
    bool any = false;
    for (const Item& item : data.items) any = any || new_of(item.node, place, i) != nullptr;
    if (!any) return;
    changed_[i] = true;
    const auto part = [&](const Item& item) {
      const Ex* changed = new_of(item.node, place, i);
      return changed != nullptr ? *changed : Ex{{}, item.node};
    };
    const auto scaled = [&](const Item& item) {
      const Ex ex = part(item);
      return Ex{ex.factor * item.factor, ex.node};
    };
    if (data.kind == ExpressionKind::sum) {
      terms_.clear();
      for (const Item& item : data.items) terms_.push_back(scaled(item));
      made_[i] = all_.sum(terms_);
    } else if (data.kind == ExpressionKind::product) {
      factors_.clear();
      for (const Item& item : data.items) factors_.emplace_back(part(item), item.exponent);
      made_[i] = all_.product(factors_);
    } else if (data.kind == ExpressionKind::root) {
      made_[i] = all_.root(scaled(data.items[0]));
    } else {
      made_[i] = all_.magnitude(part(data.items[0]));
    }
  }

  Expressions& all_;
  const std::vector<ExNode>& order_;
  std::vector<Ex> made_;
  std::vector<char> changed_;
  std::vector<Ex> terms_;  // of what is being made, as the next
  std::vector<ExPower> factors_;
};

}  // namespace

std::vector<ExNode> nodes_of(const Expressions& all, ExNode whole) {
  std::vector<ExNode> order;
  std::vector<std::pair<ExNode, std::size_t>> open{{whole, 0}};
  while (!open.empty()) {
    auto& [node, next] = open.back();
    if (next == all[node].items.size()) {
      order.push_back(node);
      open.pop_back();
      continue;
    }
    const ExNode part = all[node].items[next++].node;
    const auto is_open = [&](const auto& each) { return each.first == part; };
    if (std::find(order.begin(), order.end(), part) == order.end() &&
        std::none_of(open.begin(), open.end(), is_open))
      open.emplace_back(part, 0);
  }
  return order;
}

const Moves::Found& Moves::alternatives(ExNode node) {
  const auto [known, is_new] = known_.try_emplace(node);
  Found& found = known->second;
  if (!is_new) {
    all_.spend(found.work);
    return found;
  }
  const std::size_t before = all_.work();
  found.others = Alternatives(all_).of(node);
  found.work = all_.work() - before;
  return found;
}

void Moves::for_each(const Ex& whole, const std::function<bool(const Ex&)>& visit) {
  const std::vector<ExNode> order = nodes_of(all_, whole.node);
  Replacing replacing(all_, order);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const Ex& other : alternatives(order[i]).others) {
      const Ex moved = replacing(whole, i, other);
      all_.spend(2 * order.size());
      if (!(moved == whole) && !visit(moved)) return;
    }
}

}  // namespace vcrit::symbolic::shortest
