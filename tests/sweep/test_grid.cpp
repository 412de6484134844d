// Blocks: every row once, in order, whatever the sizes of the axes.
#include "sweep/grid.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_grid)

namespace {

using namespace vcrit;

std::vector<Axis> axes(const std::vector<std::size_t>& sizes, std::size_t speed) {
  std::vector<Axis> all;
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    Axis axis{a == speed ? "velocity" : "k" + std::to_string(a), {}};
    for (std::size_t i = 0; i < sizes[a]; ++i)
      axis.values.push_back(100.0 * static_cast<double>(a) + static_cast<double>(i));
    all.push_back(std::move(axis));
  }
  return all;
}

void check(const std::vector<std::size_t>& sizes, std::size_t at_once, std::size_t speed) {
  const Grid grid(axes(sizes, speed), at_once, 4);
  std::size_t next = 0;
  for (std::size_t index = 0; index < grid.blocks(); ++index) {
    const Block block = grid.block(index);
    BOOST_TEST_REQUIRE(block.first == next);
    std::size_t rows = 1;
    for (const std::size_t count : block.count) rows *= count;
    BOOST_TEST(rows == block.rows);
    // The first and the last row of the box have the indices that it says.
    for (std::size_t a = 0; a < sizes.size(); ++a) {
      const auto& values = grid.axes()[a].values;
      BOOST_TEST(grid.value(a, block.first) == values[block.start[a]]);
      BOOST_TEST(grid.value(a, block.first + block.rows - 1) ==
                 values[block.start[a] + block.count[a] - 1]);
    }
    if (speed < sizes.size() && block.count[speed] != sizes[speed] && block.count[speed] > 1 &&
        block.start[speed] + block.count[speed] != sizes[speed])
      BOOST_TEST(block.count[speed] % 4 == 0U);
    next += block.rows;
  }
  BOOST_TEST(next == grid.rows());
}

BOOST_AUTO_TEST_CASE(every_row_once_and_in_order) {
  const std::vector<std::vector<std::size_t>> shapes{
      {1}, {7}, {100}, {1, 1, 1}, {3, 5, 7}, {2, 40, 3}, {50, 2, 1}, {10, 10, 10}};
  for (const auto& sizes : shapes)
    for (const std::size_t at_once : {1, 2, 6, 16, 37, 100, 100000})
      for (std::size_t speed = 0; speed <= sizes.size(); ++speed)
        BOOST_TEST_CONTEXT(sizes.size() << " axes, " << at_once << " at once, speed " << speed)
  check(sizes, at_once, speed);
}

BOOST_AUTO_TEST_CASE(blocks_are_about_as_large_as_asked_for) {
  const Grid grid(axes({31, 1000, 20}, 9), 1000);
  BOOST_TEST(grid.block(0).rows == 1000U);
  BOOST_TEST(grid.blocks() == 31U * 20U);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
