#include "maps/ranks.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <string>

#include "base/errors.hpp"

#ifdef VCRIT_WITH_MPI
#include <mpi.h>
#endif

namespace vcrit::maps {

namespace {

// What Open MPI, MPICH and Slurm tell the processes that they start. Without any of them MPI is not
// even initialised, which would cost a tenth of a second.
int started_ranks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(name)) return std::atoi(size);
  return 1;
}

}  // namespace

#ifdef VCRIT_WITH_MPI

/// A number in the memory of the first rank.
struct Ranks::Counter {
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
  std::size_t next() const {
    const std::int64_t one = 1;
    std::int64_t before = 0;
    MPI_Fetch_and_op(&one, &before, MPI_INT64_T, 0, 0, MPI_SUM, window);
    MPI_Win_flush(0, window);
    return static_cast<std::size_t>(before);
  }
};

Ranks::Ranks() {
  if (started_ranks() == 1) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  counter_ = std::make_unique<Counter>(first());
}

Ranks::~Ranks() {
  if (!counter_) return;
  counter_.reset();
  MPI_Finalize();
}

std::size_t Ranks::next() { return counter_ ? counter_->next() : alone_++; }

void Ranks::attend() const {
  int there = 0;
  if (counter_) MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
}

void Ranks::together(const std::function<void()>& action) const {
  std::exception_ptr error;
  try {
    action();
  } catch (...) {
    error = std::current_exception();
  }
  const int mine = error ? rank_ : size_;
  int failed = mine;
  if (counter_) MPI_Allreduce(&mine, &failed, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (failed == size_) return;
  if (failed == rank_) std::rethrow_exception(error);
  throw Silent{};
}

std::size_t Ranks::sum(std::size_t value) const {
  if (!counter_) return value;
  const auto mine = static_cast<std::uint64_t>(value);
  std::uint64_t all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  return static_cast<std::size_t>(all);
}

std::string Ranks::first_text(std::string text) const {
  if (!counter_) return text;
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

void Ranks::abort(int status) const {
  if (counter_) MPI_Abort(MPI_COMM_WORLD, status);
}

#else

struct Ranks::Counter {};

Ranks::Ranks() {
  if (const int size = started_ranks(); size > 1)
    throw InputError({"sweep"}, fmt::format("{} processes of mpirun", size),
                     "one: this program was built without MPI");
}
Ranks::~Ranks() = default;
std::size_t Ranks::next() { return alone_++; }
void Ranks::attend() const {}
void Ranks::together(const std::function<void()>& action) const { action(); }
std::size_t Ranks::sum(std::size_t value) const { return value; }
std::string Ranks::first_text(std::string text) const { return text; }
void Ranks::abort(int) const {}

#endif

void Ranks::first_alone(const std::function<void()>& action) const {
  together([&] {
    if (first()) action();
  });
}

}  // namespace vcrit::maps
