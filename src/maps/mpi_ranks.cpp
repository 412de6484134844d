#include "maps/mpi_ranks.hpp"

#ifdef VCRIT_WITH_MPI
#include <mpi.h>

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#else
#include <fmt/core.h>

#include "base/errors.hpp"
#endif

namespace vcrit::maps {

#ifdef VCRIT_WITH_MPI

namespace {

/// MPI begins and ends with it.
class MpiRanks : public Ranks {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    counter_.emplace(first());
  }
  ~MpiRanks() override {
    counter_.reset();
    MPI_Finalize();
  }

  std::size_t next() override { return counter_->next(); }

  void attend() const override {
    int there = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
  }

  void together(const std::function<void()>& action) const override {
    std::exception_ptr error;
    try {
      action();
    } catch (...) {
      error = std::current_exception();
    }
    const int mine = error ? rank_ : size_;
    int failed = mine;
    MPI_Allreduce(&mine, &failed, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (failed == size_) return;
    if (failed == rank_) std::rethrow_exception(error);
    throw Silent{};
  }

  std::size_t sum(std::size_t value) const override {
    const auto mine = static_cast<std::uint64_t>(value);
    std::uint64_t all = 0;
    MPI_Allreduce(&mine, &all, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    return static_cast<std::size_t>(all);
  }

  std::string first_text(std::string text) const override {
    const int mine = text.empty() ? size_ : rank_;
    int from = size_;
    MPI_Allreduce(&mine, &from, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (from == size_) return {};
    auto length = static_cast<int>(text.size());
    MPI_Bcast(&length, 1, MPI_INT, from, MPI_COMM_WORLD);
    text.resize(static_cast<std::size_t>(length));
    MPI_Bcast(text.data(), length, MPI_CHAR, from, MPI_COMM_WORLD);
    return text;
  }

  void abort(int status) const override { MPI_Abort(MPI_COMM_WORLD, status); }

 private:
  /// A number in the memory of the first rank.
  struct Counter {
    MPI_Win window = MPI_WIN_NULL;
    std::int64_t* number = nullptr;

    explicit Counter(bool first) {
      MPI_Win_allocate(first ? sizeof *number : 0, sizeof *number, MPI_INFO_NULL, MPI_COMM_WORLD,
                       static_cast<void*>(&number), &window);
      if (first) *number = 0;
      MPI_Barrier(MPI_COMM_WORLD);
      MPI_Win_lock_all(0, window);
    }
    ~Counter() {
      MPI_Win_unlock_all(window);
      MPI_Win_free(&window);
    }
    Counter(const Counter&) = delete;
    Counter& operator=(const Counter&) = delete;

    std::size_t next() const {
      const std::int64_t one = 1;
      std::int64_t before = 0;
      MPI_Fetch_and_op(&one, &before, MPI_INT64_T, 0, 0, MPI_SUM, window);
      MPI_Win_flush(0, window);
      return static_cast<std::size_t>(before);
    }
  };

  std::optional<Counter> counter_;
};

}  // namespace

std::unique_ptr<Ranks> all_ranks() {
  // MPI is not even initialised without need, which would cost a tenth of a second.
  if (started_ranks() == 1) return std::make_unique<Ranks>();
  return std::make_unique<MpiRanks>();
}

#else

std::unique_ptr<Ranks> all_ranks() {
  if (const int size = started_ranks(); size > 1)
    throw InputError({"sweep"}, fmt::format("{} processes of mpirun", size),
                     "one: this program was built without MPI");
  return std::make_unique<Ranks>();
}

#endif

}  // namespace vcrit::maps
