#include "stiffness/dynamic_matrix.hpp"

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "linear/elimination.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit {

namespace {

using DynamicReal = long double;
using TermSizes = linear::DenseMatrix<DynamicReal>;
using SizeColumn = linear::DenseVector<DynamicReal>;
using DynamicSum = linear::DenseMatrix<std::complex<DynamicReal>>;
using DynamicColumn = linear::DenseVector<std::complex<DynamicReal>>;

// M s^2 + C s + K with what relaxes, and the sum of the sizes of these terms.
struct DynamicMatrix {
  DynamicMatrix(const DriveStructure& structure, std::complex<DynamicReal> s) {
    const auto n = static_cast<Eigen::Index>(structure.mass.size());
    sum.resize(n, n);
    sizes.resize(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) fill(structure, s, i, j);
  }

  DynamicSum sum;
  TermSizes sizes;

 private:
  void fill(const DriveStructure& structure, std::complex<DynamicReal> s, Eigen::Index i,
            Eigen::Index j) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    sum(i, j) = sizes(i, j) = 0;
    const auto add = [&](std::complex<DynamicReal> term) {
      sum(i, j) += term;
      sizes(i, j) += std::abs(term);
    };
    add(structure.stiffness(a, b) + s * structure.damping(a, b));
    for (const DriveBranch& branch : structure.branches)
      add(branch.stiffness * branch.pull[a] * branch.pull[b] * branch.time * s /
          (DynamicReal(1) + branch.time * s));
    if (i == j) add(static_cast<DynamicReal>(structure.mass[a]) * s * s);
  }
};

DynamicColumn as_column(const std::vector<DynamicReal>& numbers) {
  DynamicColumn result(static_cast<Eigen::Index>(numbers.size()));
  for (Eigen::Index i = 0; i < result.size(); ++i) result[i] = numbers[static_cast<std::size_t>(i)];
  return result;
}

}  // namespace

std::vector<std::complex<long double>> displacements(const DriveStructure& structure,
                                                     std::complex<long double> s) {
  check_sizes(structure);
  const DynamicColumn found =
      linear::solve_fully_pivoted(DynamicMatrix(structure, s).sum, as_column(structure.port));
  return {found.begin(), found.end()};
}

// A change E of the matrix, |E| <= u |terms|, changes p.q by q.E q to first order. Each entry is a
// sum with some four roundings, of half an epsilon each.
RoundedReceptance rounded_receptance(const DriveStructure& structure, std::complex<long double> s) {
  check_sizes(structure);
  const DynamicMatrix dynamic(structure, s);
  const DynamicColumn port = as_column(structure.port),
                      moved = linear::Lu<std::complex<DynamicReal>>(dynamic.sum).solve(port);
  const SizeColumn sizes = moved.cwiseAbs();
  const DynamicReal off =
      2 * std::numeric_limits<DynamicReal>::epsilon() * sizes.dot(dynamic.sizes * sizes);
  return {port.cwiseProduct(moved).sum(),
          std::isfinite(off) ? off : std::numeric_limits<DynamicReal>::infinity()};
}

}  // namespace vcrit
