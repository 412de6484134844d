// Products of small matrices, with sums in registers and several columns at once, are those of plain
// sums to the bit, and touch nothing beside.
#include "modes/storage.hpp"

#include <boost/test/unit_test.hpp>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_storage)

using namespace vcrit::simulation;

BOOST_AUTO_TEST_CASE(products_are_plain_sums) {
  std::mt19937 random(5);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  for (Index rows = 0; rows < 12; ++rows)
    for (Index depth = 0; depth < 5; ++depth)
      for (Index columns = 1; columns < 4; ++columns) {
        Matrix a(rows + 2, depth), x(depth, columns), y(rows + 3, columns);
        for (Matrix* each : {&a, &x, &y})
          for (Index j = 0; j < each->columns(); ++j)
            for (double& value : each->column(j)) value = number();
        Matrix expected = y;
        for (Index c = 0; c < columns; ++c)
          for (Index i = 0; i < rows; ++i)
            for (Index k = 0; k < depth; ++k) expected(i + 1, c) += a(i, k) * x(k, c);
        add_product(all(a).first(rows), all(x), all(y).part(1, rows));
        bool same = true;
        for (Index c = 0; c < columns; ++c)
          for (Index i = 0; i < y.rows(); ++i) same = same && y(i, c) == expected(i, c);
        BOOST_TEST(same, rows << " by " << depth << " times " << columns);
      }
}

BOOST_AUTO_TEST_SUITE_END()
