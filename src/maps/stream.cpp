#include "maps/stream.hpp"

#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>

namespace vcrit::maps {

namespace {

// How far a block may be ahead of the earliest one that is not written yet, for each thread: a
// table is written in order.
constexpr std::size_t ahead = 4;

struct Found {
  BlockAnswer answer;
  std::string prepared;
  std::exception_ptr error;
};

/// Threads that answer blocks, and the two queues to and from them.
class Answering {
 public:
  Answering(const Sweeping& sweeping, const MapFile& file, std::size_t threads)
      : sweeping_(sweeping), file_(file) {
    for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
  }
  ~Answering() {
    {
      const std::scoped_lock lock(mutex_);
      asked_.clear();
      stop_ = true;
    }
    more_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }
  Answering(const Answering&) = delete;
  Answering& operator=(const Answering&) = delete;

  void ask(std::size_t block) {
    {
      const std::scoped_lock lock(mutex_);
      asked_.push_back(block);
    }
    more_.notify_one();
  }

  /// An answer, or nothing within a short time.
  std::optional<Found> take() {
    std::unique_lock lock(mutex_);
    if (!ready_.wait_for(lock, std::chrono::milliseconds(5), [this] { return !found_.empty(); }))
      return std::nullopt;
    Found found = std::move(found_.front());
    found_.pop_front();
    return found;
  }

 private:
  void work() {
    for (std::unique_lock lock(mutex_);;) {
      more_.wait(lock, [this] { return stop_ || !asked_.empty(); });
      if (stop_) return;
      const std::size_t block = asked_.front();
      asked_.pop_front();
      lock.unlock();
      Found found = answer(block);
      lock.lock();
      found_.push_back(std::move(found));
      ready_.notify_one();
    }
  }

  Found answer(std::size_t block) const {
    Found found;
    try {
      found.answer = sweeping_.answer(block);
      found.prepared = file_.prepare(found.answer);
    } catch (...) {
      found.error = std::current_exception();
    }
    return found;
  }

  const Sweeping& sweeping_;
  const MapFile& file_;
  std::mutex mutex_;
  std::condition_variable more_, ready_;
  std::deque<std::size_t> asked_;
  std::deque<Found> found_;
  bool stop_ = false;
  std::vector<std::thread> threads_;
};

/// One run of a sweep on this rank.
class Run {
 public:
  Run(const Sweeping& sweeping, MapFile& file, const StreamOptions& options, Ranks& ranks)
      : sweeping_(sweeping), file_(file), options_(options), ranks_(ranks) {
    const std::vector<bool> done = file_.done();
    progress_.rows = result_.rows = sweeping.grid().rows();
    for (std::size_t block = 0; block < done.size(); ++block)
      if (done[block])
        progress_.done += sweeping.grid().block(block).rows;
      else
        open_.push_back(block);
  }

  Streamed run() {
    const auto threads = static_cast<std::size_t>(
        options_.threads > 0 ? options_.threads : tbb::info::default_concurrency());
    {
      Answering answering(sweeping_, file_, threads);
      while (ask_more(answering, threads), !asked_.empty()) {
        ranks_.attend();
        if (auto found = answering.take()) write(*found);
      }
    }
    return result_;
  }

 private:
  void ask_more(Answering& answering, std::size_t threads) {
    while (!exhausted_ && asked_.size() < 2 * threads &&
           (asked_.empty() || last_ - *asked_.begin() < ahead * threads)) {
      const std::size_t number = ranks_.next();
      exhausted_ = number >= open_.size();
      if (exhausted_) return;
      last_ = open_[number];
      asked_.insert(last_);
      answering.ask(last_);
    }
  }

  void write(const Found& found) {
    if (found.error) std::rethrow_exception(found.error);
    const std::size_t rows = sweeping_.grid().block(found.answer.block).rows;
    file_.write(found.answer, found.prepared);
    asked_.erase(found.answer.block);
    result_.found += rows;
    result_.outside += found.answer.outside;
    if (result_.reason.empty()) result_.reason = found.answer.reason;
    progress_.done += rows;
    progress_.in_this_run += rows;
    if (options_.told && ranks_.first()) options_.told(progress_);
  }

  const Sweeping& sweeping_;
  MapFile& file_;
  const StreamOptions& options_;
  Ranks& ranks_;
  std::vector<std::size_t> open_;  // blocks that were not in the file at the start
  std::set<std::size_t> asked_;    // being answered
  std::size_t last_ = 0;
  bool exhausted_ = false;
  StreamProgress progress_;
  Streamed result_;
};

}  // namespace

Streamed stream(const Sweeping& sweeping, const std::filesystem::path& file,
                const StreamOptions& options, Ranks& ranks) {
  std::unique_ptr<MapFile> map;
  // All ranks count the same blocks as open: nobody may write before everybody has read.
  ranks.together(
      [&] { map = open_map(sweeping, file, options.resume, ranks, options.open_array); });
  Streamed result = Run(sweeping, *map, options, ranks).run();
  result.found = ranks.sum(result.found);
  result.outside = ranks.sum(result.outside);
  result.reason = ranks.first_text(result.reason);
  if (result.outside == result.rows) {
    map->discard();
    ranks.first_alone([&] { throw ModelError(result.reason); });
  }
  map->finish();
  return result;
}

}  // namespace vcrit::maps
