#include "fit/refine.hpp"

#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/gsl_errors.hpp"
#include "fit/nnls.hpp"

namespace vcrit::fit {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the logarithms: digits beyond these no measurement has.
constexpr double settled = 1e-11;
constexpr int most_refining_steps = 400;

// GSL's vectors and matrices by row as Eigen sees them.
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class Residuals {
 public:
  Residuals(const Weighed& data, const Terms& terms, Index branches)
      : data_(data), terms_(terms), branches_(branches) {}

  Index parameters() const { return extra() + 2 * branches_; }

  VectorXd logarithms(const Relaxation& series) const {
    VectorXd x(parameters());
    Index i = 0;
    if (terms_.equilibrium) x[i++] = std::log(series.equilibrium);
    if (terms_.damper) x[i++] = std::log(series.damper);
    for (const MaxwellBranch& branch : series.branches) {
      x[i] = std::log(branch.stiffness);
      x[branches_ + i++] = std::log(branch.time);
    }
    return x;
  }

  Relaxation series(const VectorXd& x) const {
    Relaxation result;
    Index i = 0;
    if (terms_.equilibrium) result.equilibrium = std::exp(x[i++]);
    if (terms_.damper) result.damper = std::exp(x[i++]);
    for (; i < extra() + branches_; ++i)
      result.branches.push_back({std::exp(x[i]), std::exp(x[branches_ + i])});
    return result;
  }

  VectorXd residual(const VectorXd& x) const { return data_.residual(series(x)); }

  MatrixXd slopes(const VectorXd& x) const {
    const Relaxation now = series(x);
    MatrixXd result(data_.size(), parameters());
    Index i = 0;
    if (terms_.equilibrium) result.col(i++) = now.equilibrium * data_.spring();
    if (terms_.damper) result.col(i++) = now.damper * data_.damper();
    for (const MaxwellBranch& branch : now.branches) {
      result.col(i) = branch.stiffness * data_.branch(branch.time);
      result.col(branches_ + i++) = branch.stiffness * data_.branch_slope(branch.time);
    }
    return result;
  }

 private:
  Index extra() const { return Index{terms_.equilibrium} + Index{terms_.damper}; }

  const Weighed& data_;
  Terms terms_;
  Index branches_;
};

VectorXd of_gsl(const gsl_vector* vector) {
  VectorXd result(static_cast<Index>(vector->size));
  for (std::size_t i = 0; i < vector->size; ++i)
    result[static_cast<Index>(i)] = gsl_vector_get(vector, i);
  return result;
}

int residual_for_gsl(const gsl_vector* x, void* problem, gsl_vector* f) {
  const VectorXd value = static_cast<const Residuals*>(problem)->residual(of_gsl(x));
  for (std::size_t i = 0; i < f->size; ++i) gsl_vector_set(f, i, value[static_cast<Index>(i)]);
  return value.allFinite() ? GSL_SUCCESS : GSL_EDOM;
}

int slopes_for_gsl(const gsl_vector* x, void* problem, gsl_matrix* j) {
  Eigen::Map<RowMajor, 0, Eigen::OuterStride<>>(j->data, static_cast<Index>(j->size1),
                                                static_cast<Index>(j->size2),
                                                Eigen::OuterStride<>(static_cast<Index>(j->tda))) =
      static_cast<const Residuals*>(problem)->slopes(of_gsl(x));
  return GSL_SUCCESS;
}

using Workspace =
    std::unique_ptr<gsl_multifit_nlinear_workspace, void (*)(gsl_multifit_nlinear_workspace*)>;

// The gradient's own criterion of GSL is absolute and would stop early where residuals are small.
std::optional<VectorXd> least_squares(Residuals& problem, Index size, VectorXd start) {
  const GslErrorsOff errors_off;
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.scale = gsl_multifit_nlinear_scale_levenberg;
  const auto n = static_cast<std::size_t>(size), p = static_cast<std::size_t>(start.size());
  gsl_multifit_nlinear_fdf functions{};
  functions.f = residual_for_gsl;
  functions.df = slopes_for_gsl;
  functions.n = n;
  functions.p = p;
  functions.params = &problem;
  const Workspace workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, n, p),
                            gsl_multifit_nlinear_free);
  const auto at = gsl_vector_view_array(start.data(), p);
  if (!workspace ||
      gsl_multifit_nlinear_init(&at.vector, &functions, workspace.get()) != GSL_SUCCESS)
    return std::nullopt;
  int info = 0;
  gsl_multifit_nlinear_driver(most_refining_steps, settled, 0, 0, nullptr, nullptr, &info,
                              workspace.get());
  const VectorXd found = of_gsl(gsl_multifit_nlinear_position(workspace.get()));
  return found.allFinite() ? std::optional(found) : std::nullopt;
}

}  // namespace

TimeRange time_range(const Weighed& data) { return {0.1 / data.highest(), 10 / data.lowest()}; }

Relaxation linear_fit(const Weighed& data, const Terms& terms, const std::vector<double>& times) {
  std::vector<VectorXd> columns;
  if (terms.equilibrium) columns.push_back(data.spring());
  if (terms.damper) columns.push_back(data.damper());
  for (const double time : times) columns.push_back(data.branch(time));
  MatrixXd matrix(data.size(), static_cast<Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) matrix.col(static_cast<Index>(i)) = columns[i];
  const VectorXd x = nonnegative_least_squares(matrix, data.target());
  Relaxation result;
  Index i = 0;
  if (terms.equilibrium) result.equilibrium = x[i++];
  if (terms.damper) result.damper = x[i++];
  for (const double time : times) result.branches.push_back({x[i++], time});
  return result;
}

Refined as_it_is(const Weighed& data, const Terms& terms, const Relaxation& series) {
  const Residuals problem(data, terms, static_cast<Index>(series.branches.size()));
  const VectorXd x = problem.logarithms(series);
  return {series, problem.residual(x).squaredNorm(), problem.slopes(x)};
}

std::optional<Refined> refined(const Weighed& data, const Terms& terms, const Relaxation& start) {
  Residuals problem(data, terms, static_cast<Index>(start.branches.size()));
  VectorXd x = problem.logarithms(start);
  if (x.size() > 0) {
    const auto found = least_squares(problem, data.size(), x);
    if (!found) return std::nullopt;
    x = *found;
  }
  Refined result{problem.series(x), problem.residual(x).squaredNorm(), problem.slopes(x)};
  const TimeRange range = time_range(data);
  const auto outside = [&](const MaxwellBranch& branch) {
    return branch.time < range.from || branch.time > range.to;
  };
  const auto& branches = result.series.branches;
  if (std::any_of(branches.begin(), branches.end(), outside)) return std::nullopt;
  return result;
}

}  // namespace vcrit::fit
