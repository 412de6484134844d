// One step of algebra at one place: other ways to write an expression that are equal to it.
#pragma once

#include <cstddef>
#include <functional>
#include <unordered_map>
#include <vector>

#include "shortest/expressions.hpp"

namespace vcrit::symbolic::shortest {

/// The nodes of the expression, each once, parts first.
std::vector<ExNode> nodes_of(const Expressions& all, ExNode whole);

/// What may stand in place of a node, found once for all formulas that have it.
class Moves {
 public:
  explicit Moves(Expressions& all) : all_(all) {}

  /// Calls `visit` with the expression after each move, until it returns false: at each of its
  /// nodes a factor is taken out of a sum, multiplied into it, or moved across a bar or a root.
  void for_each(const Ex& whole, const std::function<bool(const Ex&)>& visit);

 private:
  struct Found {
    std::vector<Ex> others;
    std::size_t work = 0;  ///< that it took to find them: spent by each formula
  };
  const Found& alternatives(ExNode node);

  Expressions& all_;
  std::unordered_map<ExNode, Found> known_;
};

}  // namespace vcrit::symbolic::shortest
