#include "indenter/pieces.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace vcrit::indenter {

namespace {

// Of a polynomial: what is smooth needs one or two of these, a root at an end is not smooth.
constexpr Eigen::Index points = 21;

// By then a piece is 1e-3 of the whole; what is left there is lost in rounding, too.
constexpr int most_halvings = 10;

// The last ones tell what the next ones would be.
constexpr Eigen::Index told_by = 3;

// Values at Chebyshev's points to coefficients.
Eigen::MatrixXd transform() {
  Eigen::MatrixXd result(points, points);
  for (Eigen::Index k = 0; k < points; ++k)
    for (Eigen::Index i = 0; i < points; ++i)
      result(k, i) =
          (k == 0 ? 1.0 : 2.0) / points *
          std::cos(pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / points);
  return result;
}

double chebyshev_point(double low, double high, Eigen::Index i) {
  const double c = std::cos(pi * (static_cast<double>(i) + 0.5) / points);
  return low + (high - low) * 0.5 * (1 + c);
}

}  // namespace

Pieces::Pieces(const Functions& functions, Eigen::Index count, double tolerance) {
  const Eigen::MatrixXd to_coefficients = transform();
  Eigen::VectorXd size = Eigen::VectorXd::Constant(count, 1e-300), values(count);
  struct Span {
    double low, high;
    int halved;
  };
  std::vector<Span> left{{0, 1, 0}};
  while (!left.empty()) {
    const Span span = left.back();
    left.pop_back();
    Eigen::MatrixXd samples(points, count);
    for (Eigen::Index i = 0; i < points; ++i) {
      functions(chebyshev_point(span.low, span.high, i), values);
      samples.row(i) = values;
    }
    size = size.cwiseMax(samples.cwiseAbs().colwise().maxCoeff().transpose());
    const Eigen::MatrixXd found = to_coefficients * samples;
    const Eigen::VectorXd rest = found.bottomRows(told_by).cwiseAbs().colwise().maxCoeff();
    if (span.halved < most_halvings && (rest.array() > tolerance * size.array()).any()) {
      const double middle = 0.5 * (span.low + span.high);
      left.push_back({middle, span.high, span.halved + 1});
      left.push_back({span.low, middle, span.halved + 1});
      continue;
    }
    ends_.push_back(span.low);
    coefficients_.push_back(found.transpose());
  }
  ends_.push_back(1);
}

std::size_t Pieces::piece_of(double s) const {
  const auto after = std::upper_bound(ends_.begin(), ends_.end() - 1, s);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - ends_.begin() - 1, 0));
}

void Pieces::at(double s, Eigen::VectorXd& values) const {
  const Eigen::Index count = coefficients_.front().rows();
  values.resize(count);
  Eigen::Index i = 0;
  for (; count - i >= 4; i += 4) values.segment<4>(i) = several_at<4>(s, i);
  if (count - i >= 2) {
    values.segment<2>(i) = several_at<2>(s, i);
    i += 2;
  }
  if (count > i) values(i) = at(s, i);
}

// T_k' = k U_(k-1).
double Pieces::slope(double s, Eigen::Index i) const {
  const std::size_t piece = piece_of(s);
  const Eigen::MatrixXd& c = coefficients_[piece];
  const double length = ends_[piece + 1] - ends_[piece], x = inside(s, piece);
  double before = 0, second_kind = 1, sum = 0;
  for (Eigen::Index k = 1; k < c.cols(); ++k) {
    sum += static_cast<double>(k) * c(i, k) * second_kind;
    const double next = 2 * x * second_kind - before;
    before = second_kind;
    second_kind = next;
  }
  return sum * 2 / length;
}

}  // namespace vcrit::indenter
