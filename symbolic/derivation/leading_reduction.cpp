#include "derivation/leading_reduction.hpp"

#include <vector>

#include "base/interruption.hpp"

namespace vcrit::symbolic {

namespace {

class Leader {
 public:
  Leader(const Reduction& reduction, const std::function<int(const Element&)>& power) {
    for (const Step& step : reduction.steps) add(step, power);
  }

  /// The last step and all that it needs, in the old order.
  Reduction result() const {
    const std::vector<bool> needed = needed_steps();
    std::vector<std::size_t> place(steps_.size());
    Reduction left;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (!needed[i]) continue;
      const NeededStep& step = steps_[i];
      place[i] = left.steps.size();
      left.steps.push_back(
          {step.given->kind, step.given->element, place[step.a], place[step.b], place[step.total]});
    }
    return left;
  }

 private:
  void add(const Step& step, const std::function<int(const Element&)>& power) {
    const std::size_t itself = steps_.size();
    steps_.push_back({&step});
    if (step.kind == Step::Kind::element) return keep(itself, power(step.element));
    NeededStep& here = steps_.back();
    here.a = same_as_[step.a];
    here.b = same_as_[step.b];
    const int a = powers_[here.a], b = powers_[here.b];
    if (step.kind == Step::Kind::mesh) return add_mesh(itself);
    if (a == b) return keep(itself, a);
    keep((a > b) == (step.kind == Step::Kind::parallel) ? here.a : here.b);
  }

  /// a b/total is b where total is no more than a.
  void add_mesh(std::size_t itself) {
    NeededStep& here = steps_[itself];
    here.total = same_as_[here.given->total];
    if (here.total == here.a) return keep(here.b);
    if (here.total == here.b) return keep(here.a);
    keep(itself, powers_[here.a] + powers_[here.b] - powers_[here.total]);
  }

  void keep(std::size_t step) { keep(step, powers_[step]); }
  void keep(std::size_t step, int power) {
    same_as_.push_back(step);
    powers_.push_back(power);
  }

  std::vector<bool> needed_steps() const {
    std::vector<bool> needed(steps_.size());
    needed[same_as_.back()] = true;
    for (std::size_t i = steps_.size(); i-- > 0;) {
      const NeededStep& step = steps_[i];
      if (!needed[i] || step.given->kind == Step::Kind::element) continue;
      needed[step.a] = needed[step.b] = true;
      if (step.given->kind == Step::Kind::mesh) needed[step.total] = true;
    }
    return needed;
  }

  /// A step, and what it now needs; its names are copied where they stay.
  struct NeededStep {
    const Step* given;
    std::size_t a = 0, b = 0, total = 0;
  };
  std::vector<NeededStep> steps_;
  std::vector<std::size_t> same_as_;  ///< an earlier step with the same leading term, or itself
  std::vector<int> powers_;
};

}  // namespace

Reduction leading_reduction(const Reduction& reduction,
                            const std::function<int(const Element&)>& power) {
  hear_interruption();
  return Leader(reduction, power).result();
}

}  // namespace vcrit::symbolic
