// Products of small matrices, with sums in registers and several columns at once, are those of
// plain sums to the bit, and touch nothing beside. Vectors keep their numbers, in the object and
// beyond.
#include "modes/storage.hpp"

#include <boost/test/unit_test.hpp>
#include <random>
#include <utility>
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

namespace {

// 1, 2, ... n
Vector counted(Index n) {
  Vector result;
  for (Index i = 0; i < n; ++i) result.push_back(static_cast<double>(i + 1));
  return result;
}

bool is_counted(const Vector& x, Index n) {
  if (x.size() != n) return false;
  for (Index i = 0; i < n; ++i)
    if (x[i] != static_cast<double>(i + 1)) return false;
  return true;
}

constexpr Index sizes[] = {0, 1, usual_states, usual_states + 1, 5 * usual_states};

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_are_kept_when_copied_and_moved) {
  for (const Index n : sizes) {
    Vector first = counted(n);
    Vector moved = std::move(first);
    BOOST_TEST(is_counted(moved, n));
    BOOST_TEST(first.empty());  // NOLINT(bugprone-use-after-move): as it was left
    first.push_back(7);
    BOOST_TEST((first.size() == 1 && first[0] == 7));
    BOOST_TEST(is_counted(moved, n));
    const Vector copy = moved;
    moved.push_back(8);
    BOOST_TEST(is_counted(copy, n));
    for (const Index m : sizes) {
      Vector other = counted(m);
      other = copy;
      BOOST_TEST(is_counted(other, n), m << " into " << n);
      Vector third = counted(m);
      third = std::move(other);
      BOOST_TEST(is_counted(third, n), m << " into " << n);
      Vector& same = third;
      third = same;
      BOOST_TEST(is_counted(third, n));
      third = std::move(same);
      BOOST_TEST(is_counted(third, n));
    }
  }
}

BOOST_AUTO_TEST_CASE(new_numbers_are_zero) {
  for (const Index n : sizes) {
    const Vector zeros(n);
    BOOST_TEST(sum_of_sizes(zeros) == 0);
    BOOST_TEST(zeros.size() == n);
    Vector grown = counted(n);
    grown.resize(n + 3);
    BOOST_TEST((grown[n] == 0 && grown[n + 1] == 0 && grown[n + 2] == 0));
    grown.resize(n);
    BOOST_TEST(is_counted(grown, n));
    const Vector more = counted(2);
    Vector whole(more.begin(), more.end());
    whole.append(grown.begin(), grown.end());
    BOOST_TEST(whole.size() == n + 2);
    BOOST_TEST(is_counted(Vector(whole.begin() + 2, whole.end()), n));
  }
  BOOST_TEST(sum_of_sizes(Vector{1, -2, 4}) == 7);
  BOOST_TEST(sum_of_sizes(Vector(3, 0.5)) == 1.5);
}

BOOST_AUTO_TEST_SUITE_END()
