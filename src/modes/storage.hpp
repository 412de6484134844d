// Vectors and matrices of a motion. Their numbers lie in the object itself as long as contact and
// drive have no more than four Maxwell branches each, and on the heap beyond: events are looked for
// without a single allocation.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>

namespace vcrit::simulation {

using Index = std::size_t;

/// Pairs of modes: one of a body without masses in its drive, one more for each of these.
inline constexpr Index usual_pairs = 4;

/// F, u, then spring and branches of the drive, of the contact, and its units.
inline constexpr Index usual_states = 2 + 5 + 5 + 5;

template <class Item, Index usual = usual_states>
using List = boost::container::small_vector<Item, usual>;

using View = std::span<double>;
using ConstView = std::span<const double>;

struct Vector : List<double> {
  using List<double>::List;
  operator View() { return {data(), size()}; }
  operator ConstView() const { return {data(), size()}; }
};

/// Column by column, zero at first.
class Matrix {
 public:
  Matrix() : Matrix(0, 0) {}
  Matrix(Index rows, Index columns) : rows_(rows), columns_(columns), numbers_(rows * columns) {}

  Index rows() const { return rows_; }
  Index columns() const { return columns_; }
  double& operator()(Index i, Index j) { return numbers_[j * rows_ + i]; }
  double operator()(Index i, Index j) const { return numbers_[j * rows_ + i]; }
  View column(Index j) { return {numbers_.data() + j * rows_, rows_}; }
  ConstView column(Index j) const { return {numbers_.data() + j * rows_, rows_}; }

 private:
  Index rows_, columns_;
  List<double, usual_states * usual_states> numbers_;
};

/// y += factor x.
inline void add(ConstView x, double factor, View y) {
  for (Index i = 0; i < x.size(); ++i) y[i] += factor * x[i];
}

/// y += a x.
inline void add_product(const Matrix& a, ConstView x, View y) {
  for (Index j = 0; j < a.columns(); ++j) add(a.column(j), x[j], y);
}

/// Numbers in the memory of others, column by column, `stride` apart.
template <class Number>
struct Columns {
  Columns(Number* numbers, Index row_count, Index column_count, Index step)
      : data(numbers), rows(row_count), columns(column_count), stride(step) {}
  Columns(std::span<Number> one) : Columns(one.data(), one.size(), 1, one.size()) {}

  std::span<Number> column(Index j) const { return {data + j * stride, rows}; }
  Columns part(Index first, Index count) const { return {data + first, count, columns, stride}; }
  Columns first(Index count) const { return part(0, count); }
  Columns last(Index count) const { return part(rows - count, count); }
  operator Columns<const Number>() const { return {data, rows, columns, stride}; }

  Number* data;
  Index rows, columns, stride;
};

using MatrixView = Columns<double>;
using ConstMatrixView = Columns<const double>;

inline MatrixView all(Matrix& a) { return {a.column(0).data(), a.rows(), a.columns(), a.rows()}; }
inline ConstMatrixView all(const Matrix& a) {
  return {a.column(0).data(), a.rows(), a.columns(), a.rows()};
}

namespace detail {

// Two doubles that a processor adds at once, in memory or held.
using Two = double __attribute__((vector_size(16)));
inline Two two_at(const double* from) {
  Two result;
  std::memcpy(&result, from, sizeof result);
  return result;
}
inline void put(Two both, double* to) { std::memcpy(to, &both, sizeof both); }

// y_i += sum_k a_ik x_k of 4, 2 or one rows, whose sums stay in registers meanwhile. The y_i were
// written one by one a moment ago, and are read so: as two they would have to reach memory first.
inline void add_four(const double* a, Index stride, ConstView x, double* y) {
  Two first{y[0], y[1]}, second{y[2], y[3]};
  for (const double factor : x) {
    first += two_at(a) * factor;
    second += two_at(a + 2) * factor;
    a += stride;
  }
  put(first, y);
  put(second, y + 2);
}
inline void add_two(const double* a, Index stride, ConstView x, double* y) {
  Two sum{y[0], y[1]};
  for (const double factor : x) {
    sum += two_at(a) * factor;
    a += stride;
  }
  put(sum, y);
}
inline void add_one(const double* a, Index stride, ConstView x, double* y) {
  double sum = *y;
  for (const double factor : x) {
    sum += *a * factor;
    a += stride;
  }
  *y = sum;
}

}  // namespace detail

/// y += a x, for more than a few rows: each sum goes from the first column of a to the last, as above.
inline void add_product(ConstMatrixView a, ConstMatrixView x, MatrixView y) {
  Index i = 0;
  const auto each_column = [&](auto add, Index rows) {
    for (Index j = 0; j < y.columns; ++j)
      add(a.data + i, a.stride, x.column(j).first(a.columns), y.column(j).data() + i);
    i += rows;
  };
  while (i + 4 <= a.rows) each_column(detail::add_four, 4);
  if (i + 2 <= a.rows) each_column(detail::add_two, 2);
  if (i < a.rows) each_column(detail::add_one, 1);
}

inline Matrix identity(Index n) {
  Matrix result(n, n);
  for (Index i = 0; i < n; ++i) result(i, i) = 1;
  return result;
}

inline double sum_of_sizes(ConstView x) {
  double sum = 0;
  for (const double value : x) sum += std::abs(value);
  return sum;
}

}  // namespace vcrit::simulation
