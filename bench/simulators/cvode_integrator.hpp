// SUNDIALS CVODE on one motion of a switched system: variable order, the exact Jacobian, a dense
// solver, and CVODE's own root finding for the end of the motion.
#pragma once

#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nvector.h>

#include <array>
#include <stdexcept>

#include "simulators/switched_system.hpp"

namespace vcrit::simulators {

enum class Multistep { bdf, adams };

/// The integrator gave up, or so many periods were not enough: what() says which.
struct NotFinished : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct SwitchedState {
  double t = 0;
  Eigen::VectorXd y;
  simulation::Motion motion = simulation::Motion::stick;
};

class CvodeIntegrator {
 public:
  CvodeIntegrator(const SwitchedSystem& system, Multistep formula, double relative_tolerance);
  ~CvodeIntegrator();
  CvodeIntegrator(const CvodeIntegrator&) = delete;
  CvodeIntegrator& operator=(const CvodeIntegrator&) = delete;

  /// The integration begins anew, at first order.
  void restart(const SwitchedState& start);
  /// On with the motion until `end` or until one of its event functions falls through zero. Returns
  /// the index of that function, -1 at the end. Throws NotFinished.
  int advance(double end, SwitchedState& state);

 private:
  static int rates(double t, N_Vector y, N_Vector dy, void* self);
  static int jacobian(double t, N_Vector y, N_Vector dy, SUNMatrix matrix, void* self, N_Vector,
                      N_Vector, N_Vector);
  static int events(double t, N_Vector y, double* value, void* self);
  void create(Multistep formula, double relative_tolerance);
  void check(int flag, const char* what) const;

  const SwitchedSystem& system_;
  const LinearMotion* motion_;
  std::array<Row, 2> events_;
  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
  void* memory_ = nullptr;
};

/// The event functions of a motion, positive in it: w or -w in slip (the second one never falls),
/// b - F and b + F in stick.
std::array<Row, 2> event_functions(const SwitchedSystem& system, simulation::Motion motion);

}  // namespace vcrit::simulators
