#include "indenter/collocation.hpp"

#include <gsl/gsl_poly.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <utility>
#include <vector>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "linear/elimination.hpp"
#include "simulation/system/effort.hpp"

namespace vcrit::indenter {

namespace {

constexpr int nodes_of_step = TimeStep::nodes;
using Square = Eigen::Matrix<double, nodes_of_step, nodes_of_step>;
using Complex = std::complex<double>;

// Legendre's polynomial of degree n at 2 c - 1.
long double shifted_legendre(int n, long double c) {
  const long double x = 2 * c - 1;
  long double before = 1, here = x;
  if (n == 0) return 1;
  for (int k = 1; k < n; ++k)
    before = std::exchange(here, ((2 * k + 1) * x * here - k * before) / (k + 1));
  return here;
}

struct Scheme {
  std::array<long double, nodes_of_step> nodes{};
  Square to_stages;    ///< rates at the nodes to x at the nodes, in units of the length
  Square to_powers;    ///< rates to the coefficients of x
  Square to_legendre;  ///< rates to their coefficients in Legendre's polynomials
  /// Eigenvectors of to_stages, one of each conjugate pair and the real one: rates R, one node a
  /// column, are the real part of the sum of (R part) vector, and R to_stages^T is that of value
  /// (R part) vector.
  struct Mode {
    Complex value;
    Eigen::VectorXcd part;
    Eigen::RowVectorXcd vector;
  };
  std::vector<Mode> modes;

  Scheme() {
    find_nodes();
    using Wide = linear::DenseMatrix<long double>;
    Wide powers(nodes_of_step, nodes_of_step), integrals = powers, legendre = powers;
    for (int i = 0; i < nodes_of_step; ++i)
      for (int j = 0; j < nodes_of_step; ++j) {
        const long double c = nodes[static_cast<std::size_t>(i)];
        powers(i, j) = std::pow(c, j);
        integrals(i, j) = std::pow(c, j + 1) / (j + 1);
        legendre(i, j) = shifted_legendre(j, c);
      }
    const Wide inverse = linear::Lu<long double>(powers).inverse();
    to_stages = (integrals * inverse).cast<double>();
    to_legendre = linear::Lu<long double>(legendre).inverse().cast<double>();
    Wide scaled = inverse;
    for (int j = 0; j < nodes_of_step; ++j) scaled.row(j) /= j + 1;
    to_powers = scaled.cast<double>();
    find_modes();
  }

  // Zeros of P_s - P_{s-1}, which lie in (0, 1], the last one at 1.
  void find_nodes() {
    constexpr int parts = 1000;  // far closer than any two of the nodes
    const auto radau = [](long double c) {
      return shifted_legendre(nodes_of_step, c) - shifted_legendre(nodes_of_step - 1, c);
    };
    std::size_t found = 0;
    for (int i = 0; i + 1 < parts; ++i) {
      long double low = static_cast<long double>(i) / parts, high = low + 1.0L / parts;
      const bool positive = radau(low) > 0;
      if (positive == (radau(high) > 0)) continue;
      for (long double middle = (low + high) / 2; middle > low && middle < high;
           middle = (low + high) / 2)
        ((radau(middle) > 0) == positive ? low : high) = middle;
      nodes[found++] = high;
    }
    nodes[found] = 1;
  }

  // The inverse eigenvalues are the poles of the stability function, a Pade approximant of e^z
  // (Hairer and Wanner, IV.3 and IV.5), whose denominator has the coefficients
  // (-1)^k s! (2s - 1 - k)!/((2s - 1)! k! (s - k)!). The vectors come by inverse iteration.
  void find_modes() {
    constexpr int s = nodes_of_step;
    std::array<double, s + 1> denominator{1};
    for (std::size_t k = 0; k < s; ++k)
      denominator[k + 1] = -denominator[k] * static_cast<double>(s - k) /
                           static_cast<double>((2 * s - 1 - k) * (k + 1));
    std::array<double, 2UL * s> poles{};
    const std::unique_ptr<gsl_poly_complex_workspace, void (*)(gsl_poly_complex_workspace*)> space(
        gsl_poly_complex_workspace_alloc(s + 1), gsl_poly_complex_workspace_free);
    gsl_poly_complex_solve(denominator.data(), s + 1, space.get(), poles.data());
    Eigen::MatrixXcd vectors(s, s);
    std::array<Complex, s> values;
    for (Eigen::Index k = 0; k < s; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const Complex value = values[at] = 1.0 / Complex(poles[2 * at], poles[2 * at + 1]);
      Eigen::MatrixXcd shifted = to_stages.cast<Complex>();
      shifted.diagonal().array() -= value * (1 + 1e-10);
      const linear::Lu<Complex> factors(shifted);
      Eigen::VectorXcd vector = Eigen::VectorXcd::Ones(s);
      for (int i = 0; i < 3; ++i) vector = factors.solve(vector).normalized();
      vectors.col(k) = vector;
    }
    const Eigen::MatrixXcd inverse = linear::Lu<Complex>(vectors).inverse();
    for (Eigen::Index k = 0; k < s; ++k) {
      const Complex value = values[static_cast<std::size_t>(k)];
      const double turn = std::arg(value);
      constexpr double none = 1e-6;  // far less than that of any pair
      if (turn > -none)
        modes.push_back({value, inverse.row(k).transpose(),
                         vectors.col(k).transpose() * (turn < none ? 1.0 : 2.0)});
    }
  }
};

const Scheme& scheme() {
  static const Scheme once;
  return once;
}

// Of a period of 2 pi: below this nothing of a motion is left but rounding.
constexpr double shortest_step = 1e-13;

// What a step takes, in products for each square of the state's size: four complex factorisations
// of a third of a cube each; and rates at all nodes and solutions in some ten iterations.
constexpr std::size_t products_of_factors = 6, products_of_rates = 150;

// Simplified Newton steps, which gain three digits each where the Jacobian is that of the step.
constexpr int most_iterations = 12;

}  // namespace

StateVector TimeStep::at(double t) const {
  const double share = (t - begin_) / length_;
  StateVector sum = powers_.col(powers_.cols() - 1);
  for (Eigen::Index i = powers_.cols() - 2; i >= 0; --i) sum = sum * share + powers_.col(i);
  return from_ + share * sum;
}

TimeStep::WithRate TimeStep::with_rate(double t, Eigen::Index i) const {
  const double share = (t - begin_) / length_;
  double sum = 0, slope = 0;
  for (Eigen::Index j = powers_.cols() - 1; j >= 0; --j) {
    slope = slope * share + sum;
    sum = sum * share + powers_(i, j);
  }
  return {from_(i) + share * sum, (sum + share * slope) / length_};
}

Collocation::Collocation(Rates rates, double tolerance, SharedEffort* whole)
    : rates_(std::move(rates)),
      effort_(simulation::effort_of_state, whole),
      tolerance_(tolerance) {}

void Collocation::slopes(double t, const StateVector& x) {
  constexpr double nudge = 1e-7;  // about the root of a rounding, of numbers of about 1
  const Eigen::Index n = x.size();
  rate_.resize(n);
  moved_.resize(n);
  jacobian_.resize(n, n);
  rates_(t, x, rate_);
  value_ = x;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double by = nudge * std::max(1.0, std::abs(x(i)));
    value_(i) = x(i) + by;
    rates_(t, value_, moved_);
    jacobian_.col(i) = (moved_ - rate_) / by;
    value_(i) = x(i);
  }
}

// Newton's change of the rates at the nodes. Sums are written out, as states have few numbers.
void Collocation::iterate(double t, const StateVector& x, double length) {
  const Scheme& radau = scheme();
  const Eigen::Index n = x.size();
  for (Eigen::Index k = 0; k < nodes_of_step; ++k) {
    for (Eigen::Index i = 0; i < n; ++i) {
      double sum = 0;
      for (Eigen::Index j = 0; j < nodes_of_step; ++j)
        sum += length * stages_(i, j) * radau.to_stages(k, j);
      value_(i) = x(i) + sum;
    }
    rates_(t + length * static_cast<double>(radau.nodes[static_cast<std::size_t>(k)]), value_,
           moved_);
    residual_.col(k) = moved_ - stages_.col(k);
  }
  change_.setZero(n, nodes_of_step);
  part_.resize(n);
  for (std::size_t m = 0; m < factors_.size(); ++m) {
    const Scheme::Mode& mode = radau.modes[m];
    for (Eigen::Index i = 0; i < n; ++i) {
      Complex sum = 0;
      for (Eigen::Index j = 0; j < nodes_of_step; ++j) sum += residual_(i, j) * mode.part(j);
      part_(i) = sum;
    }
    factors_[m].solve(part_, found_);
    for (Eigen::Index j = 0; j < nodes_of_step; ++j)
      for (Eigen::Index i = 0; i < n; ++i)
        change_(i, j) +=
            found_(i).real() * mode.vector(j).real() - found_(i).imag() * mode.vector(j).imag();
  }
}

// The rates at the nodes, from one of the begin.
bool Collocation::solve(double t, const StateVector& x, double length) {
  const Scheme& radau = scheme();
  const Eigen::Index n = x.size();
  // A step's equations for all stages fall apart into those of the modes.
  factors_.resize(radau.modes.size());
  for (std::size_t j = 0; j < factors_.size(); ++j)
    factors_[j].factorise(jacobian_, length * radau.modes[j].value);
  const auto size_of_state = static_cast<std::size_t>(n);
  effort_.spend(Effort::of_products(size_of_state * size_of_state *
                                    (products_of_factors * size_of_state + products_of_rates)));
  stages_.resize(n, nodes_of_step);
  stages_.colwise() = rate_;
  residual_.resize(n, nodes_of_step);
  double before = infinity;
  for (int k = 0; k < most_iterations; ++k) {
    iterate(t, x, length);
    stages_ += change_;
    const double size = length * change_.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(size)) return false;
    if (size <= 0.01 * tolerance_) return true;
    // Rounding of f: nothing below is to be had.
    if (k > 2 && size > 0.3 * before) return before <= tolerance_;
    before = size;
  }
  return before <= tolerance_;
}

// The last of Legendre's polynomials in the rates: more than what is left out.
double Collocation::fault(double length) const {
  return length * (stages_ * scheme().to_legendre.row(nodes_of_step - 1).transpose())
                      .lpNorm<Eigen::Infinity>();
}

TimeStep Collocation::step(double t, const StateVector& x, double length) {
  slopes(t, x);
  while (true) {
    if (!(length > shortest_step))
      throw ModelError(
          "the motion below the indenter cannot be followed: its steps become too short");
    if (!solve(t, x, length)) {
      length *= 0.25;
      continue;
    }
    const double grown = std::clamp(
        0.9 * std::pow(tolerance_ / (fault(length) + 1e-300), 1.0 / nodes_of_step), 0.1, 4.0);
    if (fault(length) > tolerance_) {
      length *= std::min(grown, 0.7);
      continue;
    }
    next_length_ = grown * length;
    break;
  }
  TimeStep step;
  step.begin_ = t;
  step.length_ = length;
  step.end_ = t + length;
  step.from_ = x;
  step.powers_ = length * stages_ * scheme().to_powers.transpose();
  return step;
}

}  // namespace vcrit::indenter
