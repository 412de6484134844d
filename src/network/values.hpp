// Numbers by their symbols: one array beside a list of symbols, which copies share.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "network/symbol.hpp"

namespace vcrit {

/// Of the symbols in its list some have a number, and it acts as if it held those alone, in the
/// order of the symbols. A copy takes one array. References hold until a symbol is added.
template <class Number>
class BySymbol {
 public:
  BySymbol() = default;
  BySymbol(std::initializer_list<std::pair<Symbol, Number>> all) {
    for (const auto& [symbol, number] : all) emplace(symbol, number);
  }
  /// Without a number yet.
  explicit BySymbol(SymbolList symbols)
      : symbols_(std::make_shared<SymbolList>(std::move(symbols))), numbers_(symbols_->size()) {}
  /// The same, with the list of another one.
  template <class Other>
  static BySymbol beside(const BySymbol<Other>& other) {
    BySymbol made;
    made.symbols_ = other.symbols_;
    made.numbers_.resize(other.numbers_.size());
    return made;
  }

  /// Null where there is none.
  const Number* find(const Symbol& symbol) const {
    const std::size_t place = place_of(symbol);
    return place < numbers_.size() && numbers_[place] ? &*numbers_[place] : nullptr;
  }
  bool contains(const Symbol& symbol) const { return find(symbol) != nullptr; }
  /// Throws Bug where there is none.
  const Number& at(const Symbol& symbol) const {
    const Number* const found = find(symbol);
    if (found == nullptr) throw Bug("no number of " + to_text(symbol));
    return *found;
  }
  /// 0 or an empty one where there was none.
  Number& operator[](const Symbol& symbol) {
    std::optional<Number>& own = numbers_[place_with(symbol)];
    return own ? *own : own.emplace();
  }
  /// Where there is none yet.
  void emplace(const Symbol& symbol, Number number) {
    std::optional<Number>& own = numbers_[place_with(symbol)];
    if (!own) own = std::move(number);
  }
  void erase(const Symbol& symbol) {
    const std::size_t place = place_of(symbol);
    if (place < numbers_.size()) numbers_[place].reset();
  }

  /// How many numbers there are.
  std::size_t size() const {
    return static_cast<std::size_t>(
        std::count_if(numbers_.begin(), numbers_.end(), [](const auto& own) { return !!own; }));
  }
  bool empty() const { return size() == 0; }
  /// With its place in the list, if it has one.
  Symbol placed(const Symbol& symbol) const {
    return symbols_ == nullptr ? symbol : symbols_->placed(symbol);
  }

  /// Over pairs of a symbol and its number.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = std::pair<const Symbol&, const Number&>;
    using difference_type = std::ptrdiff_t;
    using reference = value_type;
    struct Pointer {
      value_type pair;
      const value_type* operator->() const { return &pair; }
    };
    using pointer = Pointer;

    Iterator() = default;
    Iterator(const BySymbol* of, std::size_t place) : of_(of), place_(place) { skip(); }
    reference operator*() const { return {(*of_->symbols_)[place_], *of_->numbers_[place_]}; }
    Pointer operator->() const { return {**this}; }
    Iterator& operator++() {
      ++place_;
      skip();
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    void skip() {
      while (place_ < of_->numbers_.size() && !of_->numbers_[place_]) ++place_;
    }

    const BySymbol* of_ = nullptr;
    std::size_t place_ = 0;
  };
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, numbers_.size()}; }

  friend bool operator==(const BySymbol& a, const BySymbol& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
  }

 private:
  template <class Other>
  friend class BySymbol;

  std::size_t place_of(const Symbol& symbol) const {
    return symbols_ == nullptr ? 0 : symbols_->place_of(symbol);
  }

  // A list that others have, too, stays as it is.
  std::size_t place_with(const Symbol& symbol) {
    const std::size_t place = place_of(symbol);
    if (place < numbers_.size()) return place;
    if (symbols_ == nullptr)
      symbols_ = std::make_shared<SymbolList>();
    else if (symbols_.use_count() > 1)
      symbols_ = std::make_shared<SymbolList>(*symbols_);
    else
      std::atomic_thread_fence(std::memory_order_acquire);  // others of another thread have read it
    const std::size_t added = symbols_->insert(symbol);
    numbers_.emplace(numbers_.begin() + static_cast<std::ptrdiff_t>(added));
    return added;
  }

  std::shared_ptr<SymbolList> symbols_;
  std::vector<std::optional<Number>> numbers_;
};

using Values = BySymbol<double>;

}  // namespace vcrit
