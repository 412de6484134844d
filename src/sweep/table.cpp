// A sweep as one table in memory.
#include <tbb/parallel_for.h>

#include "sweep/sweep.hpp"

namespace vcrit {

SweptTable swept(const Sweep& sweep) {
  const Sweeping sweeping(sweep);
  const Grid& grid = sweeping.grid();
  std::vector<BlockAnswer> answers(grid.blocks());
  tbb::parallel_for(std::size_t{0}, answers.size(),
                    [&](std::size_t block) { answers[block] = sweeping.answer(block); });
  SweptTable table;
  table.rows = grid.rows();
  for (const Axis& axis : grid.axes()) table.columns.push_back(axis.name);
  for (const SweptQuantity& quantity : sweep.quantities)
    table.columns.push_back(column_name(quantity));
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
