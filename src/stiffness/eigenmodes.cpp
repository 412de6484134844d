#include "stiffness/eigenmodes.hpp"

#include <algorithm>
#include <utility>

#include "base/interruption.hpp"

namespace vcrit {

namespace {

using Vector = std::vector<BigFloat>;

struct Tridiagonal {
  Vector diagonal, beside;
};

BigFloat dot(const Vector& a, const Vector& b, std::size_t size) {
  BigFloat sum = a[0] * b[0];
  for (std::size_t k = 1; k < size; ++k) sum.add_product(a[k], b[k]);
  return sum;
}

// The leading block of the matrix times v. Only the lower triangle is stored.
Vector product(const SymmetricRows& matrix, const Vector& v, std::size_t size) {
  Vector result(size, BigFloat(0, v[0].bits()));
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      result[i].add_product(matrix[i][k], v[k]);
      result[k].add_product(matrix[i][k], v[i]);
    }
    result[i].add_product(matrix[i][i], v[i]);
  }
  return result;
}

// B - v w^T - w v^T is (1 - v v^T/h) B (1 - v v^T/h), where h = v^T v/2.
void reflect(SymmetricRows& matrix, const Vector& v, const BigFloat& h, std::size_t size) {
  Vector w = product(matrix, v, size);
  const BigFloat along = dot(v, w, size) / (2 * h);
  for (std::size_t i = 0; i < size; ++i) w[i] = (w[i] - along * v[i]) / h;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      matrix[i][k].subtract_product(v[i], w[k]);
      matrix[i][k].subtract_product(w[i], v[k]);
    }
}

// Householder reflections, from the last row upwards: they leave the last coordinate alone.
Tridiagonal tridiagonal(SymmetricRows matrix) {
  Tridiagonal result{Vector(matrix.size()), Vector(matrix.size() - 1)};
  for (std::size_t i = matrix.size() - 1; i > 0; --i) {
    hear_interruption();
    result.diagonal[i] = matrix[i][i];
    Vector& v = matrix[i];
    const BigFloat norm = sqrt(dot(v, v, i)), size = abs(v[i - 1]);
    if (norm == 0) continue;
    result.beside[i - 1] = v[i - 1] > 0 ? -norm : norm;
    v[i - 1] -= result.beside[i - 1];
    reflect(matrix, v, norm * (norm + size), i);
  }
  result.diagonal[0] = matrix[0][0];
  return result;
}

// Implicit QR with Wilkinson's shift for a tridiagonal matrix (Golub and Van Loan, section 8.3).
// The rotations also act on one vector, as in Golub and Welsch's method.
class Diagonalisation {
 public:
  Diagonalisation(Tridiagonal matrix, Vector vector)
      : d_(std::move(matrix.diagonal)), e_(std::move(matrix.beside)), z_(std::move(vector)) {
    for (const Vector& numbers : {d_, e_})
      for (const BigFloat& x : numbers) tiny_ = std::max(tiny_, abs(x));
    tiny_ = ldexp(tiny_, -z_.front().bits());
  }

  // Whether it converged. An eigenvalue usually takes two or three steps.
  bool run() {
    std::size_t steps_left = 100 * d_.size();
    for (std::size_t end = d_.size() - 1; end > 0;) {
      if (abs(e_[end - 1]) <= tiny_) {
        --end;
        continue;
      }
      hear_interruption();
      if (steps_left-- == 0) return false;
      std::size_t begin = end - 1;
      while (begin > 0 && abs(e_[begin - 1]) > tiny_) --begin;
      step(begin, end);
    }
    return true;
  }

  std::vector<Eigenmode> modes() const {
    std::vector<Eigenmode> result;
    for (std::size_t i = 0; i < d_.size(); ++i) result.push_back({d_[i], z_[i] * z_[i]});
    std::ranges::sort(result, {}, &Eigenmode::value);
    return result;
  }

 private:
  BigFloat shift(std::size_t end) const {
    const BigFloat &e = e_[end - 1], half = (d_[end - 1] - d_[end]) / 2;
    const BigFloat root = sqrt(half * half + e * e);
    return d_[end] - e * e / (half < 0 ? half - root : half + root);
  }

  void step(std::size_t begin, std::size_t end) {
    BigFloat x = d_[begin] - shift(end), bulge = e_[begin];
    for (std::size_t k = begin; k < end; ++k) {
      const BigFloat r = sqrt(x * x + bulge * bulge);
      if (k > begin) e_[k - 1] = r;
      if (r == 0) return;  // the block splits here
      const BigFloat c = x / r, s = bulge / r;
      rotate(k, c, s);
      if (k + 1 == end) return;
      x = e_[k];
      bulge = s * e_[k + 1];
      e_[k + 1] = c * e_[k + 1];
    }
  }

  void rotate(std::size_t k, const BigFloat& c, const BigFloat& s) {
    const BigFloat cross = c * s * 2 * e_[k], apart = c * s * (d_[k + 1] - d_[k]);
    const BigFloat cc = c * c, ss = s * s, first = d_[k], z = z_[k];
    d_[k] = cc * first + cross + ss * d_[k + 1];
    d_[k + 1] = ss * first - cross + cc * d_[k + 1];
    e_[k] = (cc - ss) * e_[k] + apart;
    z_[k] = c * z + s * z_[k + 1];
    z_[k + 1] = c * z_[k + 1] - s * z;
  }

  Vector d_, e_, z_;
  BigFloat tiny_;
};

}  // namespace

std::optional<std::vector<Eigenmode>> modes_coupled_to_last_row(SymmetricRows matrix) {
  const slong bits = matrix[0][0].bits();
  Tridiagonal inner = tridiagonal(std::move(matrix));
  inner.diagonal.pop_back();
  if (inner.diagonal.empty()) return std::vector<Eigenmode>{};
  Vector seen(inner.diagonal.size(), BigFloat(0, bits));
  seen.back() = inner.beside.back();
  inner.beside.pop_back();
  Diagonalisation diagonalisation(std::move(inner), std::move(seen));
  if (!diagonalisation.run()) return {};
  return diagonalisation.modes();
}

}  // namespace vcrit
