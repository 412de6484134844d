// Free motion over one duration: what stick or slip make of a state's modes, and of any change of a
// state, since both go the same linear way.
#pragma once

#include "simulation/motion/model.hpp"

namespace vcrit::simulation {

/// Changes of a state, column by column and at fixed time, and of integrals (see model.hpp).
struct Changes {
  Matrix state, integrals;
};

class Flow {
 public:
  Flow(const Model& model, bool stuck, double duration);

  double duration() const { return factors_.duration(); }
  const ModalFactors& factors() const { return factors_; }

  /// x after the free motion of its modes z: levels by their integrals, own contact states from the
  /// modes, and in stick the units driven by F'. Adds the integrals.
  void move(ConstView z, View x, View integrals) const;
  /// Carries changes on.
  void carry(Changes& changes) const;

 private:
  const Phase& phase() const { return stuck_ ? model_->stick : model_->slip; }
  void filter_units();
  void move_units(ConstView z, View units, View slow) const;
  void carry_together(Changes& changes) const;

  const Model* model_;
  bool stuck_;
  ModalFactors factors_;
  // In stick: each unit on its own, what it takes up from the modes, and the integral of that.
  List<Integrals<double>> units_;
  Matrix unit_answer_, unit_integral_;
};

}  // namespace vcrit::simulation
