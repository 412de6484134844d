// Real expressions as one graph in which equal parts are one node: sums, products with whole
// powers, square roots and absolute values of symbols. What is built is brought to one order at
// once (sums and products flat, like terms joined, squares out of roots), so that equal node
// numbers are equal expressions. Nodes are numbered in the order in which they are made, which
// depends on nothing but the calls: the same in every run.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shortest/fraction.hpp"

namespace vcrit::symbolic::shortest {

using ExNode = std::uint32_t;

/// factor * node.
struct Ex {
  SmallFraction factor;
  ExNode node = 0;  ///< 0 is the number one
  bool is_zero() const { return factor.is_zero(); }
  bool is_one() const { return node == 0 && factor.is_one(); }
  bool is_number() const { return node == 0; }
  friend bool operator==(const Ex&, const Ex&) = default;
};

enum class ExpressionKind : std::uint8_t { one, symbol, sum, product, root, magnitude };

/// A term of a sum (factor * node), a factor of a product (node ^ exponent) or the argument of a
/// root (factor * node) or an absolute value.
struct Item {
  ExNode node = 0;
  int exponent = 1;
  SmallFraction factor;
  friend bool operator==(const Item&, const Item&) = default;
};

/// Those of an expression that is being made: nearly all have few, which need no heap.
using ItemList = boost::container::small_vector<Item, 12>;

/// A factor of a product: a power.
using ExPower = std::pair<Ex, int>;

struct NodeData {
  ExpressionKind kind = ExpressionKind::one;
  bool positive = true;  ///< for all values of its symbols, of which none is zero
  std::uint32_t name = 0;
  std::span<const Item> items;  ///< by node number
};

/// Nodes and their items, which stay where they are when more come; a place is found by a shift,
/// where std::deque divides.
class NodeStore {
 public:
  std::size_t size() const { return size_; }
  NodeData& operator[](std::size_t i) { return chunks_[i / chunk][i % chunk]; }
  const NodeData& operator[](std::size_t i) const { return chunks_[i / chunk][i % chunk]; }
  /// Of the node the items are kept, too.
  void push_back(NodeData node);

 private:
  static constexpr std::size_t chunk = 256;
  std::vector<std::unique_ptr<NodeData[]>> chunks_;
  std::size_t size_ = 0;
  std::vector<std::unique_ptr<Item[]>> item_chunks_;
  std::span<Item> left_;  ///< of the last of these
};

/// Which nodes there are, by a hash of what they are: a table with open addressing, as most
/// expressions that are made are known.
class KnownNodes {
 public:
  /// The node with that hash for which `same` holds, or `next`, which is then known.
  template <class Same>
  ExNode find_or_add(std::uint64_t hash, ExNode next, const Same& same) {
    if (2 * count_ >= slots_.size()) grow();
    const auto mark = static_cast<std::uint32_t>(hash >> 32);
    std::size_t at = mark & (slots_.size() - 1);
    for (; slots_[at].node != none; at = (at + 1) & (slots_.size() - 1))
      if (slots_[at].mark == mark && same(slots_[at].node)) return slots_[at].node;
    ++count_;
    slots_[at] = {mark, next};
    return next;
  }

 private:
  static constexpr ExNode none = std::numeric_limits<ExNode>::max();
  struct Slot {
    std::uint32_t mark = 0;
    ExNode node = none;
  };
  void grow();

  std::size_t count_ = 0;
  std::vector<Slot> slots_ = std::vector<Slot>(2048);
};

class Expressions {
 public:
  Expressions();

  /// A new symbol at each call, positive. `operations` is what writing it takes: 0 for a name. One
  /// that `leads` stays in front of the formula.
  Ex symbol(std::string name, int operations = 0, bool leads = false);
  /// One that may be negative.
  Ex signed_symbol(std::string name);
  /// A symbol for what people give a letter of its own (T = omega tau): nothing looks into it. One
  /// symbol for one meaning, and none for a symbol or a number.
  Ex named(std::string letter, const Ex& meaning, int operations, bool positive);
  bool is_positive(const Ex& ex) const { return !ex.factor.negative() && nodes_[ex.node].positive; }
  static Ex number(std::int64_t over, std::int64_t under = 1) { return {reduced(over, under), 0}; }

  Ex add(const Ex& a, const Ex& b) {
    const Ex both[] = {a, b};
    return sum(both);
  }
  Ex subtract(const Ex& a, const Ex& b) { return add(a, negative(b)); }
  Ex multiply(const Ex& a, const Ex& b) { return product({{a, 1}, {b, 1}}); }
  Ex divide(const Ex& a, const Ex& b) { return product({{a, 1}, {b, -1}}); }
  Ex power(const Ex& a, int exponent) { return product({{a, exponent}}); }
  static Ex negative(Ex a) { return {-a.factor, a.node}; }
  Ex sum(std::span<const Ex> terms);
  Ex product(std::span<const ExPower> factors);
  Ex product(std::initializer_list<ExPower> factors) {
    return product(std::span(factors.begin(), factors.size()));
  }
  Ex root(const Ex& argument);
  Ex magnitude(const Ex& argument);

  const NodeData& operator[](ExNode node) const { return nodes_[node]; }
  std::size_t size() const { return nodes_.size(); }
  const std::string& name(ExNode symbol) const { return names_[nodes_[symbol].name].text; }
  int operations(ExNode symbol) const { return names_[nodes_[symbol].name].operations; }
  /// What a named symbol stands for; 0 for others.
  const Ex& meaning(ExNode symbol) const { return names_[nodes_[symbol].name].meaning; }
  bool leads(ExNode node) const {
    return nodes_[node].kind == ExpressionKind::symbol && names_[nodes_[node].name].leads;
  }

  /// What has been worked, in steps of some ten nanoseconds: what bounds a search without a clock.
  std::size_t work() const { return work_; }
  void spend(std::size_t work) const {
    if ((work_ += work) > allowed_) throw TooLarge{};
  }
  /// From here on no more work than this.
  void allow(std::size_t work) { allowed_ = work_ + work; }

  /// The node of the items as they are: a sum or product part of a larger one.
  ExNode make(ExpressionKind kind, std::span<const Item> items);

 private:
  bool is_positive(ExpressionKind kind, std::span<const Item> items) const;
  void multiply_into(ItemList& items, SmallFraction& factor, ItemList& under_root,
                     SmallFraction& root_factor, const Ex& base, int exponent);

  mutable std::size_t work_ = 0;
  std::size_t allowed_ = std::numeric_limits<std::size_t>::max();
  NodeStore nodes_;
  struct Name {
    std::string text;
    int operations = 0;
    bool leads = false;
    Ex meaning = {{0, 1}, 0};
    ExNode symbol = 0;
  };
  std::vector<Name> names_;
  KnownNodes known_;
};

}  // namespace vcrit::symbolic::shortest
