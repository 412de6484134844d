// A bound on the work of a search, counted and not timed, so that the same input always ends alike.
#pragma once

#include <cstddef>

#include "base/errors.hpp"
#include "base/interruption.hpp"

namespace vcrit::simulation {

/// Unit: one mode of the motion carried over one step, some 10 to 20 ns.
class Effort {
 public:
  /// whole: of all searches together, none without.
  explicit Effort(std::size_t most, Effort* whole = nullptr) : left_(most), whole_(whole) {}

  void renew(std::size_t most) { left_ = most; }

  void spend(std::size_t units) {
    if (!take(units))
      throw ModelError(
          "the steady state is not found within the bound on the work for one: its body rings, or "
          "stick and slip alternate, too many times");
    if (whole_ != nullptr && !whole_->take(units))
      throw ModelError(
          "the bound on the work for all steady states together is reached: bodies that ring take "
          "the most");
  }

 private:
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
};

/// For one steady state, a few seconds; and for all that an answer asks for together.
inline constexpr std::size_t effort_of_state = 200'000'000, effort_of_answer = 400'000'000;

}  // namespace vcrit::simulation
