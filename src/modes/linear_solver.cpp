#include "modes/linear_solver.hpp"

#include <algorithm>
#include <utility>

#include "base/constants.hpp"

namespace vcrit::simulation {

LinearSolver::LinearSolver(Matrix a, ConstView sizes)
    : n_(a.rows()), lu_(std::move(a)), size_(sizes.begin(), sizes.end()) {
  for (Index j = 0; j < n_; ++j)
    for (double& value : lu_.column(j)) value *= size_[j];
  for (Index i = 0; i < n_; ++i) {
    double size = 0;
    for (Index j = 0; j < n_; ++j) size = std::max(size, std::abs(lu_(i, j)));
    scale_.push_back(size > 0 ? 1 / size : 1);
    for (Index j = 0; j < n_; ++j) lu_(i, j) *= scale_.back();
    row_.push_back(i);
    column_.push_back(i);
  }
  double largest = 0;
  for (Index k = 0; k < n_; ++k) {
    pivot(k);
    const double here = std::abs(lu_(k, k));
    largest = std::max(largest, here);
    if (!(here > static_cast<double>(n_) * epsilon * largest)) return;
    rank_ = k + 1;
    const View under = lu_.column(k).subspan(k);
    for (Index i = 1; i < under.size(); ++i) under[i] /= under[0];
    for (Index j = k + 1; j < n_; ++j) {
      const View right = lu_.column(j).subspan(k);
      const double factor = right[0];
      for (Index i = 1; i < right.size(); ++i) right[i] -= under[i] * factor;
    }
  }
}

void LinearSolver::pivot(Index k) {
  Index row = k, column = k;
  double largest = std::abs(lu_(k, k));
  for (Index j = k; j < n_; ++j) {
    const ConstView here = std::as_const(lu_).column(j);
    for (Index i = k; i < n_; ++i)
      if (const double size = std::abs(here[i]); size > largest)
        largest = size, row = i, column = j;
  }
  for (Index j = 0; row != k && j < n_; ++j) std::swap(lu_(k, j), lu_(row, j));
  for (Index i = 0; column != k && i < n_; ++i) std::swap(lu_(i, k), lu_(i, column));
  std::swap(row_[k], row_[row]);
  std::swap(column_[k], column_[column]);
}

Vector LinearSolver::solve(ConstView right) const {
  Vector y(n_), x(n_);
  for (Index i = 0; i < n_; ++i) {
    y[i] = right[row_[i]] * scale_[row_[i]];
    for (Index j = 0; j < i && j < rank_; ++j) y[i] -= lu_(i, j) * y[j];
  }
  for (Index i = rank_; i-- > 0;) {
    for (Index j = i + 1; j < rank_; ++j) y[i] -= lu_(i, j) * y[j];
    y[i] /= lu_(i, i);
    x[column_[i]] = y[i] * size_[column_[i]];
  }
  return x;
}

Vector LinearSolver::solve_transposed(ConstView right) const {
  Vector y(n_), x(n_);
  for (Index i = 0; i < rank_; ++i) {
    y[i] = right[column_[i]] * size_[column_[i]];
    for (Index j = 0; j < i; ++j) y[i] -= lu_(j, i) * y[j];
    y[i] /= lu_(i, i);
  }
  for (Index i = rank_; i-- > 0;) {
    for (Index j = i + 1; j < rank_; ++j) y[i] -= lu_(j, i) * y[j];
    x[row_[i]] = y[i] * scale_[row_[i]];
  }
  return x;
}

}  // namespace vcrit::simulation
