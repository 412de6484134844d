// Vectors and matrices of a motion. Their numbers lie in the object itself as long as contact and
// drive have no more than four Maxwell branches each, and on the heap beyond: events are looked for
// without a single allocation.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <span>
#include <utility>

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

/// Doubles as List holds them. A motion makes hundreds in a period, so each costs no more than its
/// numbers: no call for the room, and no loop over elements where one is moved.
/// In place of Boost's small_vector: that one has as many bytes, and copies, moves and assigns in
/// up to a fifth more time, but takes 16 ns for 17 zeros (here 4; g++ 12, -O3). Up to Boost 1.74 it
/// is no range of contiguous numbers to C++20 either, so that it could not be given as a View.
template <Index usual>
class Numbers {
 public:
  using value_type = double;

  Numbers() {}  // NOLINT(modernize-use-equals-default): by default {} would clear all the room
  explicit Numbers(Index size) : Numbers(size, Unset{}) {
    std::memset(data_, 0, size * sizeof(double));
  }
  Numbers(Index size, double value) : Numbers(size, Unset{}) { std::fill_n(data_, size, value); }
  Numbers(std::initializer_list<double> numbers) : Numbers(numbers.begin(), numbers.end()) {}
  template <std::input_iterator Iterator>
  Numbers(Iterator first, Iterator last) {
    assign(first, last);
  }
  Numbers(const Numbers& other) : Numbers(other.size_, Unset{}) {
    std::copy_n(other.data_, size_, data_);
  }
  Numbers(Numbers&& other) noexcept { take(other); }
  Numbers& operator=(const Numbers& other) {
    if (this == &other) return *this;
    set_size(other.size_);
    std::copy_n(other.data_, size_, data_);
    return *this;
  }
  Numbers& operator=(Numbers&& other) noexcept {
    if (this == &other) return *this;
    leave();
    take(other);
    return *this;
  }
  ~Numbers() { leave(); }

  Index size() const { return size_; }
  bool empty() const { return size_ == 0; }
  double* data() { return data_; }
  const double* data() const { return data_; }
  double* begin() { return data_; }
  const double* begin() const { return data_; }
  double* end() { return data_ + size_; }
  const double* end() const { return data_ + size_; }
  double& operator[](Index i) { return data_[i]; }
  double operator[](Index i) const { return data_[i]; }
  double& front() { return data_[0]; }
  double front() const { return data_[0]; }
  double& back() { return data_[size_ - 1]; }
  double back() const { return data_[size_ - 1]; }

  /// New ones are zero.
  void resize(Index size) {
    const Index before = size_;
    if (size > capacity_) grow(size);
    size_ = size;
    if (size > before) std::fill(data_ + before, data_ + size, 0.0);
  }
  void push_back(double value) {
    if (size_ == capacity_) grow(2 * size_);
    data_[size_++] = value;
  }
  template <std::input_iterator Iterator>
  void assign(Iterator first, Iterator last) {
    size_ = 0;
    append(first, last);
  }
  template <std::input_iterator Iterator>
  void append(Iterator first, Iterator last) {
    for (; first != last; ++first) push_back(*first);
  }

 private:
  struct Unset {};
  Numbers(Index size, Unset) {
    if (size > usual) [[unlikely]]
      grow(size);
    size_ = size;
  }

  [[gnu::noinline]] void grow(Index capacity) {
    auto* const more = new double[capacity];
    std::copy_n(data_, size_, more);
    leave();
    data_ = more;
    capacity_ = capacity;
  }
  /// For numbers that are all written next.
  void set_size(Index size) {
    size_ = 0;
    if (size > capacity_) [[unlikely]]
      grow(size);
    size_ = size;
  }
  void leave() {
    if (data_ != own_) [[unlikely]]
      delete[] data_;
  }
  /// Of one that has left its own numbers.
  void take(Numbers& other) {
    size_ = other.size_;
    if (other.data_ == other.own_) [[likely]] {
      data_ = own_;
      capacity_ = usual;
      std::copy_n(other.own_, size_, own_);
    } else {
      data_ = std::exchange(other.data_, other.own_);
      capacity_ = std::exchange(other.capacity_, usual);
    }
    other.size_ = 0;
  }

  double* data_ = own_;
  Index size_ = 0, capacity_ = usual;
  double own_[usual];  // no numbers beyond size_
};

using Vector = Numbers<usual_states>;

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
  Numbers<usual_states * usual_states> numbers_;
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

/// y += a x, for more than a few rows: each sum goes from the first column of a to the last, as
/// above.
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
