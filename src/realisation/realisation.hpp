// A measured drive as a structure of springs, dampers and masses, so that it can move in time: what
// fits the rows of its receptance, how far off that may be, and what is wrong with the rows.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "realisation/structure.hpp"
#include "realisation/uncertainty.hpp"
#include "scene/receptance.hpp"

namespace vcrit::realisation {

/// Whether the body, whose mass hangs on the structure, is there: without one no damper may couple
/// the end to the masses (Damping::coupled), as its displacement would be a state of its own.
enum class BodyMass { heavy, none };

class Realisation {
 public:
  /// Throws InputError for a table most of whose rows give energy, for a static compliance less
  /// than that of the structure, and for an order that the rows cannot hold.
  explicit Realisation(const Receptance& table, BodyMass body = BodyMass::heavy);

  const Structure& structure() const { return structure_; }  ///< SI: y in m, K_yy = 1 N/m
  int pairs() const { return static_cast<int>(structure_.modes()); }
  double misfit() const { return misfit_; }  ///< |R_fit - R_i|/|R_i|, the greatest of all rows
  double noise() const { return noise_; }    ///< of real and imaginary part each, relative to |R_i|
  /// What is wrong with the rows, and with the fit where the rows are no such structure's.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// At an angular frequency, rad/s: R_d, m/N, and how far the drive's own may be from it.
  std::complex<double> response(double omega) const { return structure_.response(omega); }
  double error(double omega) const;
  /// What that is made of, m/N.
  Deviation deviation(double omega) const;
  /// By how much that is to be multiplied: the rows are no such structure's, but for noise.
  double caution() const;
  bool outside(double omega) const { return omega < first_ || omega > last_; }

  // Other structures (SI) that the rows allow as well.
  std::vector<Structure> refits() const;  ///< fitted to rows with other noise of the same size
  std::vector<Structure> rivals() const;  ///< of one mode more or less, or of other damping
  /// With a mode at omega (rad/s) in it that the rows do not show, as large as can be; none where
  /// no such fit is found.
  std::optional<Structure> with_hidden_mode(double omega) const;

 private:
  Structure in_si(const Structure& scaled) const;
  std::vector<Structure> all_in_si(const std::vector<Structure>& scaled) const;
  void judge_rows(const Receptance& table);
  void judge_fit(const Receptance& table);
  void add_static_compliance(const Receptance& table, double compliance);

  Rows rows_;
  Structure structure_;
  std::optional<Uncertainty> uncertainty_;
  std::optional<Mode> resting_;  ///< for the static compliance
  std::vector<std::string> warnings_;
  double misfit_ = 0, noise_ = 0, first_ = 0, last_ = 0;
  bool explained_ = true;
};

/// The same table is fitted once.
std::shared_ptr<const Realisation> realised(const Receptance& table,
                                            BodyMass body = BodyMass::heavy);

}  // namespace vcrit::realisation
