// A body between drive and contact as two linear systems, one for slip and one for stick, on the
// same vector Z = (forces of the contact's springs, of the drive's springs, velocity of the body |
// impulse of the contact force, 1, side, side cos t, side sin t). A branch force q obeys q' = k e'
// - q/tau.
#pragma once

#include <optional>
#include <utility>

#include "steps.hpp"

namespace reference {

/// A spring, a damper and Maxwell branches (stiffness, time) in parallel; 0: not there.
template <class Real>
struct Branches {
  Real spring = 0, damper = 0;
  std::vector<std::pair<Real, Real>> maxwell;
};

/// Units: omega = 1, mu0 <F_n> = 1.
template <class Real>
struct Scene {
  Branches<Real> contact;
  std::optional<Branches<Real>> drive;
  Real mass = 0, amplitude = 0, velocity = 0;
};

template <class To, class From>
Branches<To> converted(const Branches<From>& network) {
  Branches<To> result{To(network.spring), To(network.damper), {}};
  for (const auto& [k, tau] : network.maxwell) result.maxwell.push_back({To(k), To(tau)});
  return result;
}

template <class To, class From>
Scene<To> converted(const Scene<From>& scene) {
  Scene<To> result{
      converted<To>(scene.contact), {}, To(scene.mass), To(scene.amplitude), To(scene.velocity)};
  if (scene.drive) result.drive = converted<To>(*scene.drive);
  return result;
}

/// The linear system of one kind of motion, and what is read off Z.
template <class Real>
struct Law {
  Matrix<Real> matrix;
  Row<Real> force;                     ///< on the contact point
  Row<Real> velocity;                  ///< of the contact point
  Row<Real> contact_rate, drive_rate;  ///< of deformation
};

template <class Real>
class Laws {
 public:
  explicit Laws(const Scene<Real>& scene) : scene_(scene) {
    stores_of(scene.contact, contact_);
    if (scene.drive) stores_of(*scene.drive, drive_);
    stores_ = contact_.size() + drive_.size();
    states_ = stores_ + (scene.mass > 0 ? 1 : 0);
  }

  Eigen::Index states() const { return static_cast<Eigen::Index>(states_); }
  Eigen::Index size() const { return states() + 5; }
  Eigen::Index impulse() const { return states(); }
  Eigen::Index one() const { return states() + 1; }
  Eigen::Index side() const { return states() + 2; }

  /// side * b(t) and its rate; side is that in Z.
  Row<Real> bound() const { return unit(side()) + scene_.amplitude * unit(side() + 1); }
  Row<Real> bound_rate() const { return -scene_.amplitude * unit(side() + 2); }

  Law<Real> stick() const {
    const Row<Real> body = stuck_body();
    return law(body, body, zero(), sum(contact_, 0) + scene_.contact.damper * body);
  }

  Law<Real> slip() const {
    const Row<Real> rate = rate_under_bound(scene_.contact, contact_, 0);
    const Row<Real> body = sliding_body();
    return law(body, rate, body - rate, bound());
  }

  /// Dissipated in contact and drive by a motion.
  Matrix<Real> damping(const Law<Real>& law) const {
    Matrix<Real> form = scene_.contact.damper * law.contact_rate.transpose() * law.contact_rate;
    if (scene_.drive) form += scene_.drive->damper * law.drive_rate.transpose() * law.drive_rate;
    for (std::size_t i = 0; i < stores_; ++i) {
      const auto n = static_cast<Eigen::Index>(i);
      form(n, n) += store(i).decay / store(i).stiffness;
    }
    return form;
  }

  /// Half the energy is the square of this times the states: a scale for each of them.
  Vector<Real> scale() const {
    Vector<Real> result = Vector<Real>::Constant(states(), sqrt(scene_.mass));
    for (std::size_t i = 0; i < stores_; ++i)
      result(static_cast<Eigen::Index>(i)) = 1 / sqrt(store(i).stiffness);
    return result;
  }

  /// Rows that are 0 on Z: what the springs alone must bear where no damper or mass takes a part.
  Matrix<Real> constraints(bool stuck) const {
    const bool contact = scene_.contact.damper == 0;
    const bool drive = scene_.drive && scene_.mass == 0 && scene_.drive->damper == 0;
    std::vector<Row<Real>> rows;
    if (stuck && contact && drive) rows.push_back(sum(contact_, 0) - sum(drive_, contact_.size()));
    if (!stuck && contact) rows.push_back(sum(contact_, 0) - bound());
    if (!stuck && drive) rows.push_back(sum(drive_, contact_.size()) - bound());
    Matrix<Real> all(static_cast<Eigen::Index>(rows.size()), size());
    for (std::size_t i = 0; i < rows.size(); ++i) all.row(static_cast<Eigen::Index>(i)) = rows[i];
    return all;
  }

 private:
  struct Store {
    Real stiffness, decay;
  };
  using Stores = std::vector<Store>;

  static void stores_of(const Branches<Real>& network, Stores& stores) {
    if (network.spring > 0) stores.push_back({network.spring, Real(0)});
    for (const auto& [k, tau] : network.maxwell) stores.push_back({k, 1 / tau});
  }
  const Store& store(std::size_t i) const {
    return i < contact_.size() ? contact_[i] : drive_[i - contact_.size()];
  }

  Row<Real> zero() const { return Row<Real>::Zero(size()); }
  Row<Real> unit(Eigen::Index i) const {
    Row<Real> row = zero();
    row(i) = 1;
    return row;
  }
  Row<Real> sum(const Stores& stores, std::size_t first) const {
    Row<Real> row = zero();
    for (std::size_t i = 0; i < stores.size(); ++i) row(static_cast<Eigen::Index>(first + i)) = 1;
    return row;
  }
  Row<Real> relaxing(const Stores& stores, std::size_t first) const {
    Row<Real> row = zero();
    for (std::size_t i = 0; i < stores.size(); ++i)
      row(static_cast<Eigen::Index>(first + i)) = stores[i].decay;
    return row;
  }
  static Real stiffness(const Stores& stores) {
    Real total = 0;
    for (const Store& store : stores) total += store.stiffness;
    return total;
  }
  Row<Real> drawn() const { return scene_.velocity * unit(one()); }

  // Rate of deformation of a network whose force is side * b(t).
  Row<Real> rate_under_bound(const Branches<Real>& network, const Stores& stores,
                             std::size_t first) const {
    if (network.damper > 0) return (bound() - sum(stores, first)) / network.damper;
    return (bound_rate() + relaxing(stores, first)) / stiffness(stores);
  }

  Row<Real> sliding_body() const {
    if (!scene_.drive) return drawn();
    if (scene_.mass > 0) return unit(static_cast<Eigen::Index>(stores_));
    return drawn() - rate_under_bound(*scene_.drive, drive_, contact_.size());
  }

  // A massless body moves so that both networks pull alike.
  Row<Real> stuck_body() const {
    if (!scene_.drive) return drawn();
    if (scene_.mass > 0) return unit(static_cast<Eigen::Index>(stores_));
    const std::size_t first = contact_.size();
    const Real damper = scene_.contact.damper + scene_.drive->damper;
    if (damper > 0)
      return (sum(drive_, first) - sum(contact_, 0) + scene_.drive->damper * drawn()) / damper;
    const Real drive = stiffness(drive_);
    return (drive * drawn() - relaxing(drive_, first) + relaxing(contact_, 0)) /
           (drive + stiffness(contact_));
  }

  Law<Real> law(const Row<Real>& body, const Row<Real>& contact_rate, const Row<Real>& velocity,
                const Row<Real>& force) const {
    Law<Real> result{Matrix<Real>::Zero(size(), size()), force, velocity, contact_rate,
                     drawn() - body};
    for (std::size_t i = 0; i < stores_; ++i) {
      const auto n = static_cast<Eigen::Index>(i);
      const Row<Real>& rate = i < contact_.size() ? contact_rate : result.drive_rate;
      result.matrix.row(n) = store(i).stiffness * rate - store(i).decay * unit(n);
    }
    if (scene_.mass > 0)
      result.matrix.row(states() - 1) =
          (sum(drive_, contact_.size()) + scene_.drive->damper * result.drive_rate - force) /
          scene_.mass;
    result.matrix.row(impulse()) = force;
    result.matrix.row(side() + 1) = -unit(side() + 2);
    result.matrix.row(side() + 2) = unit(side() + 1);
    return result;
  }

  Scene<Real> scene_;
  Stores contact_, drive_;
  std::size_t stores_, states_;
};

}  // namespace reference
