// The names of numbers, and lists of them in which a symbol knows its place.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

namespace vcrit {

/// The name of a number: a scalar ("k0"), or entry 1..N of an array ("k[3]"; entry 0: a scalar).
struct Symbol {
  std::string name;
  int entry = 0;
  /// In the list of the problem that it belongs to; -1: in none. It makes no other symbol of it.
  int place = -1;

  friend bool operator==(const Symbol& a, const Symbol& b) {
    return a.entry == b.entry && a.name == b.name;
  }
  friend std::strong_ordering operator<=>(const Symbol& a, const Symbol& b) {
    const auto by_name = a.name <=> b.name;
    return by_name != 0 ? by_name : a.entry <=> b.entry;
  }
};

/// "k0" or "k[3]".
std::string to_text(const Symbol& symbol);

/// Symbols, sorted, none twice. Each has its place in this list, and so have copies of it: they are
/// found without a search. A place in another list is no answer here, as the symbol at it is
/// another.
class SymbolList {
 public:
  SymbolList() = default;
  explicit SymbolList(std::vector<Symbol> symbols);

  std::size_t size() const { return symbols_.size(); }
  const Symbol& operator[](std::size_t place) const { return symbols_[place]; }
  /// size() for a symbol that is not in it.
  std::size_t place_of(const Symbol& symbol) const {
    const auto told = static_cast<std::size_t>(symbol.place);
    return told < symbols_.size() && symbols_[told] == symbol ? told : searched(symbol);
  }
  /// Where the symbol is now, which was not in it.
  std::size_t insert(const Symbol& symbol);
  /// With its place here, if it has one.
  Symbol placed(const Symbol& symbol) const;

 private:
  std::size_t searched(const Symbol& symbol) const;
  void number(std::size_t first);

  std::vector<Symbol> symbols_;
};

}  // namespace vcrit
