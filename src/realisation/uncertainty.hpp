// How far the realised response may be from the drive's, at any frequency.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "linear/orthogonal.hpp"
#include "realisation/search.hpp"

namespace vcrit::realisation {

/// In the units of Rows, each a distance in R.
struct Deviation {
  double rivals = 0;  ///< greatest, to other structures that fit as well
  double noise = 0;   ///< standard deviation of refits to rows with other noise of the same size
  double hidden = 0;  ///< by a mode there that the misfit would not show
  double misfit = 0;  ///< of the rows on both sides, or their noise
};

class Uncertainty {
 public:
  Uncertainty(const Rows& rows, const FoundStructures& found, double noise);

  Deviation at(double omega) const;
  /// What R may be off there, those together: with caution where the rows end.
  double error(double omega) const;

  /// Refits to rows with other noise of the same size.
  const std::vector<Structure>& refits() const { return refits_; }
  /// Others that fit as well: of another order or damping, and of parameters along which the rows
  /// tell hardly anything.
  const std::vector<Structure>& rivals() const { return rivals_; }
  /// Fitted anew with a mode at omega in it, as large as three standard deviations let it be; none
  /// where no such fit is found.
  std::optional<Structure> with_hidden_mode(double omega) const;

 private:
  void drift();
  double allowed_sum() const;
  double largest_compliance_above() const;
  /// How large an unseen mode may be, and how much of a mode with phi^2 = 1 the others absorb.
  struct Hidden {
    Mode mode;
    Eigen::VectorXd taken;
  };
  Hidden hidden_at(double omega) const;
  double hidden_change(double omega) const;
  double misfit_beside(double omega) const;

  const Rows rows_;
  StructureShape shape_;
  Eigen::VectorXd parameters_;
  Structure structure_;
  std::vector<Structure> rivals_, refits_;
  double spread_ = 0;  ///< of one number's misfit
  double sum_ = 0;     ///< of squares of those
  Eigen::MatrixXd slope_;
  linear::PivotedQr others_;
};

}  // namespace vcrit::realisation
