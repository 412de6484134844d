// Vectors and matrices of a motion. Their numbers lie in the object itself as long as contact and
// drive have no more than four Maxwell branches each, and on the heap beyond: events are looked for
// without a single allocation.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <span>

namespace vcrit::simulation {

using Index = std::size_t;

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
