// The processes that share one sweep: this one alone, or all that mpirun started.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace vcrit::maps {

class Ranks {
 public:
  /// Throws InputError if several were started and this program knows no MPI.
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool first() const { return rank_ == 0; }

  /// The next number of 0, 1, 2, ... that no rank has got yet.
  std::size_t next();
  /// Lets other ranks' calls of next() get on; to be called now and then.
  void attend() const;
  /// Runs `action` on all ranks, and waits for all. Where it throws, the first rank of those throws
  /// the same and all others Silent.
  void together(const std::function<void()>& action) const;
  /// The same for an action of the first rank alone.
  void first_alone(const std::function<void()>& action) const;
  std::size_t sum(std::size_t value) const;
  /// The text of the first rank that has one.
  std::string first_text(std::string text) const;
  /// Ends all ranks at once, those too that wait for this one.
  void abort(int status) const;

  /// Something went wrong, and another rank tells it.
  struct Silent {};

 private:
  struct Counter;
  std::unique_ptr<Counter> counter_;
  int rank_ = 0, size_ = 1;
  std::size_t alone_ = 0;  // the counter of a single process
};

}  // namespace vcrit::maps
