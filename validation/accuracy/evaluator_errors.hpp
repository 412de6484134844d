// Ways to evaluate v* against its correctly rounded value, over many parameter sets.
#pragma once

#include <memory>

#include "accuracy/data.hpp"
#include "accuracy/inputs.hpp"
#include "run/driver.hpp"

namespace vcrit::validation::accuracy {

/// v* correctly rounded and the condition number of Eq. 24, of each set; NaN where v* is 0/0.
struct VelocityReference {
  std::vector<double> right, condition;
};
VelocityReference reference_of(const Problem& problem, const Inputs& inputs);

/// |found - right| in units in the last place of `right`: 0 for equal values, infinite or NaN where
/// only one is finite.
double ulps(double found, double right);

/// Errors of one way. It fails where it gives a value that is not finite for one that is, or one
/// that is off by more than 1e-10 of it and by more than 32 roundings of 2^-53 times the condition
/// number. Sets without a finite reference count nowhere.
EvaluatorError assess(const WayAnswers& answers, const Inputs& inputs,
                      const VelocityReference& reference);

/// By cost and worst error; those that failed are left aside.
void mark_front(std::vector<EvaluatorError>& ways);

/// All ways of the driver (none without one) and the library's critical_velocity().
EvaluatorErrors evaluator_errors(const Problem& problem, const Driver* driver,
                                 const Inputs& inputs);

}  // namespace vcrit::validation::accuracy
