// A bound on the work of a search, counted and not timed, so that the same input always ends alike.
#pragma once

#include <cstddef>

#include "base/errors.hpp"
#include "base/interruption.hpp"

namespace vcrit {

/// Unit: one mode of a motion carried over one step, some 10 to 20 ns.
class Effort {
 public:
  /// whole: of all searches together, none without. spent: what the error says where this one's
  /// effort does not suffice.
  explicit Effort(std::size_t most, Effort* whole = nullptr, const char* spent = by_a_steady_state)
      : left_(most), whole_(whole), spent_(spent) {}

  void renew(std::size_t most) { left_ = most; }

  void spend(std::size_t units) {
    if (!take(units)) throw ModelError(spent_);
    if (whole_ != nullptr && !whole_->take(units))
      throw ModelError(
          "the bound on the work for all steady states together is reached: bodies that ring and "
          "networks of many branches take the most");
  }

  /// Of full matrices, in units, where so many numbers are multiplied and added.
  static constexpr std::size_t of_products(std::size_t count) { return count / 32; }

 private:
  static constexpr const char* by_a_steady_state =
      "the steady state is not found within the bound on the work for one: its body rings, stick "
      "and slip alternate too many times, or its networks have too many branches";

  bool take(std::size_t units) {
    const bool enough = units <= left_;
    const std::size_t left = enough ? left_ - units : 0;
    if (left_ / units_between_questions != left / units_between_questions) hear_interruption();
    left_ = left;
    return enough;
  }

  static constexpr std::size_t units_between_questions = 1U << 20U;  // some 10 to 20 ms

  std::size_t left_;
  Effort* whole_;
  const char* spent_;
};

}  // namespace vcrit
