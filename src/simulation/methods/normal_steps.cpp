#include "simulation/methods/normal_steps.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::simulation::methods {

namespace {

// Relaxation over thousands of periods is not waited for.
constexpr int most_periods = 20'000;

// What a step takes without branches, in units of effort.
constexpr std::size_t normal_step_work = 4;

class Steps {
 public:
  Steps(const NormalMotion& motion, double omega, int steps)
      : motion_(motion), h_(two_pi / steps), spring_(motion.network.equilibrium) {
    damper_ = motion.network.damper * omega / h_;
    slope_ = spring_ + damper_;
    for (const MaxwellBranch& branch : motion.network.branches) {
      const double kept = 1 / (1 + h_ / (branch.time * omega));
      branches_.push_back({kept, kept * branch.stiffness, 0});
      slope_ += branches_.back().gain;
    }
  }

  double force_after(int step) {
    const double target = motion_.mean + motion_.amplitude * std::cos((step + 1) * h_);
    double free = damper_ * deformation_;
    for (const Branch& branch : branches_)
      free += branch.gain * deformation_ - branch.kept * branch.force;
    free /= slope_;
    const double next = std::max(free, target), change = next - deformation_;
    for (Branch& branch : branches_)
      branch.force = branch.kept * branch.force + branch.gain * change;
    deformation_ = next;
    return free < target ? slope_ * (target - free) : 0;
  }

 private:
  struct Branch {
    double kept, gain, force;
  };

  const NormalMotion& motion_;
  double h_, spring_, damper_ = 0, slope_ = 0;
  double deformation_ = 0;
  std::vector<Branch> branches_;
};

}  // namespace

std::vector<double> normal_force_steps(const NormalMotion& motion, double omega, int steps,
                                       Effort& effort) {
  Steps normal(motion, omega, steps);
  std::vector<double> now(static_cast<std::size_t>(steps)), before;
  for (int period = 0; period < most_periods; ++period) {
    effort.spend(now.size() * (normal_step_work + motion.network.branches.size()));
    for (int i = 0; i < steps; ++i) now[static_cast<std::size_t>(i)] = normal.force_after(i);
    const double largest = *std::max_element(now.begin(), now.end());
    if (period > 0 && largest == 0)
      throw ModelError("the contact never closes: there is no friction");
    const auto near = [&](double a, double b) { return std::abs(a - b) <= 1e-13 * largest; };
    if (period > 0 && std::equal(now.begin(), now.end(), before.begin(), near)) return now;
    before = now;
  }
  throw ModelError("the normal force has not settled after 20000 periods");
}

}  // namespace vcrit::simulation::methods
