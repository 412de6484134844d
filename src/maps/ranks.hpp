// The processes that share one sweep: this one alone, or all that mpirun started (mpi_ranks.hpp).
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace vcrit::maps {

/// How many processes mpirun says that it has started: 1 without it.
int started_ranks();

/// One process, which is alone.
class Ranks {
 public:
  Ranks() = default;
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool first() const { return rank_ == 0; }

  /// The next number of 0, 1, 2, ... that no rank has got yet.
  virtual std::size_t next() { return alone_++; }
  /// Lets other ranks' calls of next() get on; to be called now and then.
  virtual void attend() const {}
  /// Runs `action` on all ranks, and waits for all. Where it throws, the first rank of those throws
  /// the same and all others Silent.
  virtual void together(const std::function<void()>& action) const { action(); }
  /// The same for an action of the first rank alone.
  void first_alone(const std::function<void()>& action) const;
  virtual std::size_t sum(std::size_t value) const { return value; }
  /// The text of the first rank that has one.
  virtual std::string first_text(std::string text) const { return text; }
  /// Ends all ranks at once, those too that wait for this one.
  virtual void abort(int) const {}

  /// Something went wrong, and another rank tells it.
  struct Silent {};

 protected:
  int rank_ = 0, size_ = 1;

 private:
  std::size_t alone_ = 0;  // the counter of a single process
};

}  // namespace vcrit::maps
