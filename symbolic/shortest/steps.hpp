// An expression as steps in which nothing is written twice: what two sums or two products have in
// common is a step of its own. The number of operations is exactly that of the formula printed
// with a name for each step that is used more than once.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "shortest/expressions.hpp"

namespace vcrit::symbolic::shortest {

/// One term (`sign` is that before it) or factor (-1: below the bar).
struct StepPart {
  std::uint32_t step = 0;
  std::int32_t sign = 1;
  friend auto operator<=>(const StepPart&, const StepPart&) = default;
};

/// A search makes millions of steps, nearly all of few parts: these need no heap.
using StepParts = boost::container::small_vector<StepPart, 6>;

struct FormulaStep {
  enum class Kind : std::uint8_t { symbol, number, sum, product, power, root, magnitude };
  Kind kind = Kind::symbol;
  ExNode node = 0;          ///< of a symbol
  std::int64_t number = 0;  ///< natural
  int exponent = 1;         ///< of a power
  StepParts parts;
  int uses = 0;
  std::uint64_t mask = 0;  ///< of the parts' steps: disjoint masks have no part in common
  bool distinct = true;    ///< no two parts have the same bit of the mask
  void sort_parts();
};

/// As many as nearly all formulas have need no heap.
using FormulaSteps = boost::container::small_vector<FormulaStep, 64>;

using StepNumbers = boost::container::small_vector<std::uint32_t, 64>;

class Steps {
 public:
  Steps(const Expressions& all, const Ex& whole) : Steps(all, std::span(&whole, 1)) {}
  /// Several expressions, of which a part that they share is one step: definitions, with their
  /// signs, then the whole, which is taken to be positive.
  Steps(const Expressions& all, std::span<const Ex> wholes);

  int operations() const { return operations_; }
  /// Steps that are used more than once.
  int shared() const { return shared_; }
  const FormulaSteps& steps() const { return steps_; }
  std::uint32_t whole() const { return wholes_.back(); }
  const StepNumbers& wholes() const { return wholes_; }
  /// a b + a c = a (b + c) and a (b + c/a) = a b + c where that is shorter: what the sharing of
  /// steps has left.
  void take_out_factors();
  /// Of a whole that begins with what leads, over a letter that is `omega` times a symbol: the
  /// symbol in place of the letter, where omega goes from what leads as well.
  bool cancel_in_front(ExNode omega);
  /// Makes the first half of a sum's terms a step of its own: as many operations.
  std::uint32_t halve(std::uint32_t sum);

 private:
  std::uint32_t definition(const Ex& meaning);
  std::uint32_t of(ExNode node);
  std::uint32_t of(const SmallFraction& factor, ExNode node);
  std::uint32_t number(std::int64_t value);
  std::uint32_t put(FormulaStep&& step);
  std::uint32_t append(FormulaStep&& step);
  std::uint32_t product(const SmallFraction& factor, std::span<const Item> items);
  void share(FormulaStep::Kind kind);
  /// The most parts that two of these steps have in common; none where it is less than two.
  StepParts most_shared(const StepNumbers& sets) const;
  /// Leaves in `sets` those that may have more in common.
  bool share_best(StepNumbers& sets);
  void replace(std::uint32_t in, const StepParts& common, std::uint64_t mask, std::uint32_t by);
  void count();
  std::uint32_t without(std::uint32_t product, const StepPart& factor);
  std::uint32_t times(std::uint32_t step, std::uint32_t factor);
  bool is_used_once(std::uint32_t step, FormulaStep::Kind kind) const;
  /// All steps as they are now, unless they are kept already.
  void keep(FormulaSteps& before) const;
  /// Before these change a step, `before` keeps all.
  bool take_out_of(std::uint32_t sum, FormulaSteps& before);
  bool multiply_into(std::uint32_t product, FormulaSteps& before);
  bool multiply_into(std::uint32_t product, std::uint32_t sum, std::uint32_t factor,
                     FormulaSteps& before);
  bool become_sum(std::uint32_t product, const StepParts& terms);

  const Expressions& all_;
  FormulaSteps steps_;
  /// The step of a node, and where the one before it with the same remainder is, from 1 on.
  struct KnownStep {
    ExNode node;
    std::uint32_t step, before;
  };
  boost::container::small_vector<KnownStep, 64> known_;
  std::array<std::uint32_t, 64> last_known_{};  ///< of each remainder
  StepNumbers wholes_;
  bool sharing_ = false;  ///< from here on a step may have parts behind it
  int operations_ = 0, shared_ = 0;
};

/// Operations of one step, its parts not counted.
int step_operations(const FormulaStep& step, const Expressions& all);

}  // namespace vcrit::symbolic::shortest
