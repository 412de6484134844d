// One step of algebra at one place: other ways to write an expression that are equal to it.
#pragma once

#include <functional>
#include <vector>

#include "shortest/expressions.hpp"

namespace vcrit::symbolic::shortest {

/// The nodes of the expression, each once, parts first.
std::vector<ExNode> nodes_of(const Expressions& all, ExNode whole);

/// Calls `visit` with the expression after each move, until it returns false: at each of its nodes
/// a factor is taken out of a sum, multiplied into it, or moved across a bar or a root.
void for_each_move(Expressions& all, const Ex& whole, const std::function<bool(const Ex&)>& visit);

}  // namespace vcrit::symbolic::shortest
