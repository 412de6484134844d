// Which steps are odd in omega. What is real at s = i omega is even, what stands beside i is odd,
// so that in |a + i b|^2 = a^2 + b^2 it is seen which square is that of the imaginary part.
#pragma once

#include <cstdint>
#include <map>
#include <set>

#include "shortest/expressions.hpp"
#include "shortest/steps.hpp"

namespace vcrit::symbolic::shortest {

class Parity {
 public:
  /// `odd`: symbols that are odd, as omega is.
  Parity(const Expressions& all, const Steps& steps, const std::set<ExNode>& odd)
      : all_(all), steps_(steps), odd_(odd) {}
  bool is_odd(std::uint32_t step) const;
  /// Whether it is the square of something odd.
  bool is_square_of_odd(std::uint32_t step) const;

 private:
  bool is_odd_node(ExNode node) const;
  bool of(const FormulaStep& step) const;

  const Expressions& all_;
  const Steps& steps_;
  const std::set<ExNode>& odd_;
  mutable std::map<std::uint32_t, bool> known_;
};

}  // namespace vcrit::symbolic::shortest
