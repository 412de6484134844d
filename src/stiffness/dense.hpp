// A matrix of numbers, zero at first, for rooms that keep Eigen out of their headers.
#pragma once

#include <cstddef>
#include <vector>

namespace vcrit {

template <class Number>
class Dense {
 public:
  Dense() = default;
  Dense(std::size_t rows, std::size_t columns) : columns_(columns), numbers_(rows * columns) {}

  std::size_t rows() const { return columns_ == 0 ? 0 : numbers_.size() / columns_; }
  std::size_t columns() const { return columns_; }
  Number& operator()(std::size_t i, std::size_t j) { return numbers_[i * columns_ + j]; }
  const Number& operator()(std::size_t i, std::size_t j) const {
    return numbers_[i * columns_ + j];
  }

  /// row by row
  std::vector<Number>& numbers() { return numbers_; }
  const std::vector<Number>& numbers() const { return numbers_; }

 private:
  std::size_t columns_ = 0;
  std::vector<Number> numbers_;
};

}  // namespace vcrit
