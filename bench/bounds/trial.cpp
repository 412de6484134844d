#include "bounds/trial.hpp"

#include <flint/flint.h>
#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "run/compiler.hpp"

namespace vcrit::bounds {

namespace {

// Cases of one process and one seed: many, so that starting the process costs little; few, so that
// all cores have chunks and a case can be made again by itself.
constexpr std::uint64_t chunk_size = 10'000;

std::string exact_text(const Exact& exact) {
  switch (exact.kind) {
    case Exact::Kind::zero:
      return "0";
    case Exact::Kind::pole:
      return "infinite";
    case Exact::Kind::undefined:
      return "0/0";
    case Exact::Kind::number:
      break;
  }
  return fmt::format("({:a} + {:a}) 2^{}", exact.high, exact.low, exact.exponent);
}

/// Cases first, first + 1, ... of one seed of their own.
class Chunk {
 public:
  Chunk(const TrialSystem& system, const CompiledHeader& evaluator, const TrialOptions& options,
        std::uint64_t first)
      : system_(system),
        evaluator_(evaluator),
        options_(options),
        first_(first),
        draws_(draws_for(system)),
        reference_(system),
        cases_(system, reference_, seed()) {}

  Tallies tried() {
    const std::uint64_t count = std::min(chunk_size, options_.cases - first_);
    numbers_.resize(count * slots());
    for (std::uint64_t i = 0; i < count; ++i) cases_.fill(draw(i), numbers_of(i));
    const validation::PrivateFolder folder;
    const std::vector<CertifiedAnswers> answers = evaluator_.evaluate(numbers_, folder.path());
    Tallies tallies;
    for (std::uint64_t i = 0; i < count; ++i) judge_case(i, answers[i], tallies[draw(i)]);
    return tallies;
  }

 private:
  std::uint64_t seed() const {
    std::seed_seq sequence{options_.seed, options_.seed >> 32, first_, first_ >> 32};
    std::uint32_t words[2];
    sequence.generate(words, words + 2);
    return std::uint64_t{words[0]} << 32 | words[1];
  }

  std::size_t slots() const { return system_.slots.size(); }
  Draw draw(std::uint64_t i) const { return draws_[(first_ + i) % draws_.size()]; }
  std::span<double> numbers_of(std::uint64_t i) {
    return std::span(numbers_).subspan(i * slots(), slots());
  }

  void judge_case(std::uint64_t i, const CertifiedAnswers& answers, TrialTally& tally) {
    const Exact exact = reference_.velocity(numbers_of(i));
    if (exact.kind == Exact::Kind::undefined) {
      ++tally.undefined;
      return;
    }
    const Verdict verdict = judge(answers, exact);
    tally.add(verdict);
    if (!verdict.violation) return;
    auto& first = tally.firsts[static_cast<std::size_t>(*verdict.violation)];
    if (!first) first = {first_ + i, report(i, answers, exact, *verdict.violation)};
  }

  std::string report(std::uint64_t i, const CertifiedAnswers& answers, const Exact& exact,
                     Violation violation) {
    return fmt::format(
        "{} violated, {}, case {} ({}) of seed {}\n"
        "  Parameters{}\n"
        "  v* = {}\n"
        "  value {:a}, bound {:a}; fast value {:a}, bound {:a}",
        name_of(violation), system_.name, first_ + i, name_of(draw(i)), options_.seed,
        evaluator_.parameters(numbers_of(i)), exact_text(exact), answers.value, answers.bound,
        answers.fast_value, answers.fast_bound);
  }

  const TrialSystem& system_;
  const CompiledHeader& evaluator_;
  const TrialOptions& options_;
  std::uint64_t first_;
  std::vector<Draw> draws_;
  ExactReference reference_;
  Cases cases_;
  std::vector<double> numbers_;
};

}  // namespace

TrialTally sum_of(const Tallies& tallies) {
  TrialTally sum;
  for (const auto& [draw, tally] : tallies) sum += tally;
  return sum;
}

void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) task(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
    flint_cleanup();  // what FLINT keeps for the thread
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < threads; ++i) workers.emplace_back(work);
  workers.clear();
  if (failure) std::rethrow_exception(failure);
}

Tallies try_cases(const TrialSystem& system, const CompiledHeader& evaluator,
                  const TrialOptions& options) {
  Tallies all;
  std::mutex mutex;
  const std::uint64_t chunks = (options.cases + chunk_size - 1) / chunk_size;
  in_parallel(chunks, options.threads, [&](std::size_t number) {
    const Tallies tallies = Chunk(system, evaluator, options, number * chunk_size).tried();
    const std::lock_guard lock(mutex);
    for (const auto& [draw, tally] : tallies) all[draw] += tally;
  });
  return all;
}

}  // namespace vcrit::bounds
