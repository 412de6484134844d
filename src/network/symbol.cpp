#include "network/symbol.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace vcrit {

std::string to_text(const Symbol& symbol) {
  return symbol.entry == 0 ? symbol.name : fmt::format("{}[{}]", symbol.name, symbol.entry);
}

SymbolList::SymbolList(std::vector<Symbol> symbols) : symbols_(std::move(symbols)) {
  std::sort(symbols_.begin(), symbols_.end());
  symbols_.erase(std::unique(symbols_.begin(), symbols_.end()), symbols_.end());
  number(0);
}

std::size_t SymbolList::searched(const Symbol& symbol) const {
  const auto found = std::lower_bound(symbols_.begin(), symbols_.end(), symbol);
  if (found == symbols_.end() || *found != symbol) return symbols_.size();
  return static_cast<std::size_t>(found - symbols_.begin());
}

std::size_t SymbolList::insert(const Symbol& symbol) {
  const auto behind = std::lower_bound(symbols_.begin(), symbols_.end(), symbol);
  const auto place = static_cast<std::size_t>(behind - symbols_.begin());
  symbols_.insert(behind, symbol);
  number(place);
  return place;
}

Symbol SymbolList::placed(const Symbol& symbol) const {
  const std::size_t place = place_of(symbol);
  return place < symbols_.size() ? symbols_[place] : symbol;
}

void SymbolList::number(std::size_t first) {
  for (std::size_t i = first; i < symbols_.size(); ++i) symbols_[i].place = static_cast<int>(i);
}

}  // namespace vcrit
