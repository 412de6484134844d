// A bound on the work of a search, counted and not timed, so that the same input always ends alike.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "base/errors.hpp"
#include "base/interruption.hpp"

namespace vcrit {

/// Of several searches together, on any number of threads: whether it suffices does not depend on
/// their order. Unit: see Effort.
class SharedEffort {
 public:
  /// whole: of which this is a part, none without.
  explicit SharedEffort(std::size_t most, SharedEffort* whole = nullptr)
      : most_(most), whole_(whole) {}

  std::size_t left() const {
    const std::size_t done = done_.load(std::memory_order_relaxed);
    const std::size_t own = most_ - std::min(most_, done);
    return whole_ != nullptr ? std::min(own, whole_->left()) : own;
  }

  void add(std::size_t units) {
    done_.fetch_add(units, std::memory_order_relaxed);
    if (whole_ != nullptr) whole_->add(units);
  }

  /// For who started the searches, in the end: one that has failed may have been taken for one
  /// without an answer.
  void require_enough() const {
    if (done_.load() > most_) throw spent();
    if (whole_ != nullptr) whole_->require_enough();
  }

  static ModelError spent() {
    return ModelError(
        "the bound on the work for all steady states together is reached: bodies that ring and "
        "networks of many branches take the most");
  }

 private:
  std::size_t most_;
  SharedEffort* whole_;
  std::atomic<std::size_t> done_ = 0;
};

/// Of one search. Unit: one mode of a motion carried over one step, some 10 to 20 ns.
class Effort {
 public:
  /// whole: of all searches together, none without. spent: what the error says where this one's
  /// effort does not suffice.
  explicit Effort(std::size_t most, SharedEffort* whole = nullptr,
                  const char* spent = by_a_steady_state)
      : left_(most), whole_(whole), spent_(spent) {}
  /// Goes on with as much as is left there; what was spent counts once.
  Effort(const Effort& other) : left_(other.left_), whole_(other.whole_), spent_(other.spent_) {}
  Effort& operator=(const Effort&) = delete;
  ~Effort() { settle(); }

  void renew(std::size_t most) { left_ = most; }

  void spend(std::size_t units) {
    if (units > left_) throw ModelError(spent_);
    if (left_ / units_between_questions != (left_ - units) / units_between_questions)
      hear_interruption();
    left_ -= units;
    if (whole_ != nullptr) spend_of_whole(units);
  }

  /// Of full matrices, in units, where so many numbers are multiplied and added.
  static constexpr std::size_t of_products(std::size_t count) { return count / 32; }

 private:
  static constexpr const char* by_a_steady_state =
      "the steady state is not found within the bound on the work for one: its body rings, stick "
      "and slip alternate too many times, or its networks have too many branches";

  /// Threads would wait for each other if each step were told.
  void spend_of_whole(std::size_t units) {
    unsettled_ += units;
    const std::size_t left = whole_->left();
    const bool enough = unsettled_ <= left;
    if (!enough || unsettled_ >= std::min(most_unsettled, left / 64)) settle();
    if (!enough) throw SharedEffort::spent();
  }

  void settle() {
    if (whole_ != nullptr) whole_->add(unsettled_);
    unsettled_ = 0;
  }

  static constexpr std::size_t units_between_questions = 1U << 20U;  // some 10 to 20 ms

  static constexpr std::size_t most_unsettled = 1U << 16U;  // 1 ms

  std::size_t left_, unsettled_ = 0;
  SharedEffort* whole_;
  const char* spent_;
};

}  // namespace vcrit
