#include "simulators/cvode_integrator.hpp"

#include <cvode/cvode.h>
#include <fmt/core.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>

#include "base/constants.hpp"

namespace vcrit::simulators {

using Eigen::Index;
using Eigen::Map;
using Eigen::VectorXd;
using simulation::Motion;

namespace {

Map<const VectorXd> as_vector(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<Index>(N_VGetLength(v))};
}

double value(const Row& row, const Map<const VectorXd>& y, double t) {
  const Index n = y.size();
  return row.head(n).dot(y) + row(n) + row(n + 1) * std::cos(t) + row(n + 2) * std::sin(t);
}

}  // namespace

std::array<Row, 2> event_functions(const SwitchedSystem& system, Motion motion) {
  const Row never = Row::Unit(system.states() + 3, system.states());
  if (motion == Motion::slip) return {system.motion(motion).contact_velocity, never};
  if (motion == Motion::backslip) return {-system.motion(motion).contact_velocity, never};
  const Row bound = system.motion(Motion::slip).force, force = system.motion(motion).force;
  return {bound - force, bound + force};
}

CvodeIntegrator::CvodeIntegrator(const SwitchedSystem& system, Multistep formula,
                                 double relative_tolerance)
    : system_(system),
      motion_(&system.motion(Motion::stick)),
      events_(event_functions(system, Motion::stick)) {
  create(formula, relative_tolerance);
}

void CvodeIntegrator::create(Multistep formula, double relative_tolerance) {
  const auto n = static_cast<sunindextype>(system_.states());
  check(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
  y_ = N_VNew_Serial(n, context_);
  N_VConst(0, y_);
  matrix_ = SUNDenseMatrix(n, n, context_);
  solver_ = SUNLinSol_Dense(y_, matrix_, context_);
  memory_ = CVodeCreate(formula == Multistep::bdf ? CV_BDF : CV_ADAMS, context_);
  check(CVodeSetErrFile(memory_, nullptr), "CVodeSetErrFile");
  check(CVodeInit(memory_, rates, 0, y_), "CVodeInit");
  // States are of order one in units of the friction bound.
  check(CVodeSStolerances(memory_, relative_tolerance, 0.1 * relative_tolerance), "tolerances");
  check(CVodeSetLinearSolver(memory_, solver_, matrix_), "CVodeSetLinearSolver");
  check(CVodeSetJacFn(memory_, jacobian), "CVodeSetJacFn");
  check(CVodeSetUserData(memory_, this), "CVodeSetUserData");
  check(CVodeRootInit(memory_, 2, events), "CVodeRootInit");
  std::array<int, 2> falling{-1, -1};
  check(CVodeSetRootDirection(memory_, falling.data()), "CVodeSetRootDirection");
  check(CVodeSetNoInactiveRootWarn(memory_), "CVodeSetNoInactiveRootWarn");
  check(CVodeSetMaxNumSteps(memory_, 20'000'000), "CVodeSetMaxNumSteps");
  // Roots are looked for between steps only: short ones leave fewer pairs of events unseen.
  check(CVodeSetMaxStep(memory_, two_pi / 40), "CVodeSetMaxStep");
}

CvodeIntegrator::~CvodeIntegrator() {
  CVodeFree(&memory_);
  SUNLinSolFree(solver_);
  SUNMatDestroy(matrix_);
  N_VDestroy(y_);
  SUNContext_Free(&context_);
}

void CvodeIntegrator::check(int flag, const char* what) const {
  if (flag < 0) throw NotFinished(fmt::format("CVODE gave up: {} returned {}", what, flag));
}

void CvodeIntegrator::restart(const SwitchedState& start) {
  motion_ = &system_.motion(start.motion);
  events_ = event_functions(system_, start.motion);
  Map<VectorXd>(N_VGetArrayPointer(y_), start.y.size()) = start.y;
  check(CVodeReInit(memory_, start.t, y_), "CVodeReInit");
}

int CvodeIntegrator::advance(double end, SwitchedState& state) {
  check(CVodeSetStopTime(memory_, end), "CVodeSetStopTime");
  const int flag = CVode(memory_, end, y_, &state.t, CV_NORMAL);
  check(flag, "CVode");
  state.y = as_vector(y_);
  if (flag != CV_ROOT_RETURN) return -1;
  std::array<int, 2> found{};
  check(CVodeGetRootInfo(memory_, found.data()), "CVodeGetRootInfo");
  return found[0] != 0 ? 0 : 1;
}

int CvodeIntegrator::rates(double t, N_Vector y, N_Vector dy, void* self) {
  const LinearMotion& motion = *static_cast<CvodeIntegrator*>(self)->motion_;
  const auto state = as_vector(y);
  const Index n = state.size();
  Map<VectorXd>(N_VGetArrayPointer(dy), n) =
      motion.rates.leftCols(n).lazyProduct(state) + motion.rates.col(n) +
      motion.rates.col(n + 1) * std::cos(t) + motion.rates.col(n + 2) * std::sin(t);
  return 0;
}

int CvodeIntegrator::jacobian(double, N_Vector, N_Vector, SUNMatrix matrix, void* self, N_Vector,
                              N_Vector, N_Vector) {
  const LinearMotion& motion = *static_cast<CvodeIntegrator*>(self)->motion_;
  const Index n = motion.rates.rows();
  Map<Eigen::MatrixXd>(SUNDenseMatrix_Data(matrix), n, n) = motion.rates.leftCols(n);
  return 0;
}

int CvodeIntegrator::events(double t, N_Vector y, double* values, void* self) {
  const auto& functions = static_cast<CvodeIntegrator*>(self)->events_;
  for (std::size_t i = 0; i < 2; ++i) values[i] = value(functions[i], as_vector(y), t);
  return 0;
}

}  // namespace vcrit::simulators
