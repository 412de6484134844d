// A sweep as one table in memory.
#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>

#include "base/interruption.hpp"
#include "base/units.hpp"
#include "sweep/sweep.hpp"

namespace vcrit {

namespace {

// Whoever asked for a sweep may be interrupted while other threads work on it: they hear of it.
struct SweepEnded {};
thread_local const std::atomic<bool>* end_of_sweep = nullptr;

void hear_end_of_sweep() {
  if (*end_of_sweep) throw SweepEnded{};
}

std::vector<BlockAnswer> answers_until(const std::atomic<bool>& end, const Sweeping& sweeping) {
  std::vector<BlockAnswer> answers(sweeping.grid().blocks());
  tbb::parallel_for(std::size_t{0}, answers.size(), [&](std::size_t block) {
    end_of_sweep = &end;
    const Interruptible interruptible(&hear_end_of_sweep);
    try {
      hear_interruption();
      answers[block] = sweeping.answer(block);
    } catch (const SweepEnded&) {  // nobody reads the answers
    }
  });
  return answers;
}

/// The calling thread does nothing but listen, where it can be interrupted.
std::vector<BlockAnswer> answers_of(const Sweeping& sweeping) {
  std::atomic<bool> end{false};
  if (interruption == nullptr) return answers_until(end, sweeping);
  auto found = std::async(std::launch::async, answers_until, std::cref(end), std::cref(sweeping));
  try {
    while (found.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
      hear_interruption();
  } catch (...) {
    end = true;
    found.wait();
    throw;
  }
  return found.get();
}

}  // namespace

std::vector<SweptColumn> swept_columns(const Sweep& sweep) {
  std::vector<SweptColumn> all;
  for (const Axis& axis : sweep.axes) all.push_back({axis.name, si_unit(axis.dimension)});
  for (const SweptQuantity& quantity : sweep.quantities)
    all.push_back({column_name(quantity), unit(quantity)});
  return all;
}

std::string column_heading(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : fmt::format("{} [{}]", name, unit);
}

SweptTable swept(const Sweep& sweep) {
  const Sweeping sweeping(sweep);
  const Grid& grid = sweeping.grid();
  const std::vector<BlockAnswer> answers = answers_of(sweeping);
  SweptTable table;
  table.rows = grid.rows();
  for (const SweptColumn& column : swept_columns(sweep)) table.columns.push_back(column.name);
  for (const BlockAnswer& answer : answers) {
    const Block block = grid.block(answer.block);
    for (std::size_t row = 0; row < block.rows; ++row) {
      for (std::size_t a = 0; a < grid.axes().size(); ++a)
        table.values.push_back(grid.value(a, block.first + row));
      for (const auto& column : answer.values) table.values.push_back(column[row]);
    }
    table.outside += answer.outside;
    if (table.reason.empty()) table.reason = answer.reason;
  }
  return table;
}

}  // namespace vcrit
