#include "simulation/methods/equations.hpp"

#include <algorithm>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::simulation::methods {

namespace {

Chain chain(const Relaxation& form, double omega, double stiffness_unit) {
  Chain result{form.damper * omega / stiffness_unit, {}, 0};
  if (form.equilibrium > 0) result.branches.push_back({form.equilibrium / stiffness_unit, 0});
  for (const MaxwellBranch& branch : form.branches)
    result.branches.push_back({branch.stiffness / stiffness_unit, 1 / (branch.time * omega)});
  for (const Branch& branch : result.branches) result.glassy += branch.stiffness;
  return result;
}

// In stick the branches relax with their own rates; with the force given, the slowest of them
// creeps with about k_inf/eta.
double slowest_rate(const Chain& chain) {
  double slowest = 1, viscosity = chain.damper, spring = 0;
  for (const Branch& branch : chain.branches) {
    if (branch.rate == 0) {
      spring = branch.stiffness;
      continue;
    }
    slowest = std::min(slowest, branch.rate);
    viscosity += branch.stiffness / branch.rate;
  }
  return spring > 0 && viscosity > 0 ? std::min(slowest, spring / viscosity) : slowest;
}

}  // namespace

double Chain::sum(const double* forces) const {
  double total = 0;
  for (std::size_t j = 0; j < branches.size(); ++j) total += forces[j];
  return total;
}

double Chain::fading(const double* forces) const {
  double total = 0;
  for (std::size_t j = 0; j < branches.size(); ++j) total += branches[j].rate * forces[j];
  return total;
}

void Chain::rates(const double* forces, double velocity, double* out) const {
  for (std::size_t j = 0; j < branches.size(); ++j)
    out[j] = branches[j].stiffness * velocity - branches[j].rate * forces[j];
}

std::size_t Chain::main_branch() const {
  const auto stiffer = [](const Branch& a, const Branch& b) {
    return a.rate > 0 && (b.rate == 0 || a.stiffness < b.stiffness);
  };
  return static_cast<std::size_t>(std::max_element(branches.begin(), branches.end(), stiffer) -
                                  branches.begin());
}

Equations::Equations(const System& system, double drive_velocity) {
  if (system.opening) throw ModelError("does not support a contact that opens (separation = true)");
  const bool moves = system.drive && system.mass && *system.mass > 0;
  const Relaxation path =
      system.drive && !moves ? series({system.contact, *system.drive}) : system.contact;
  const double stiffness_unit = std::abs(dynamic_stiffness(path, system.omega));
  const double force_unit = system.friction * system.mean_normal_force;
  velocity = drive_velocity / (force_unit * system.omega / stiffness_unit);
  amplitude = std::abs(system.normal_force_amplitude) / system.mean_normal_force;
  phase = std::arg(system.normal_force_amplitude);
  contact = chain(path, system.omega, stiffness_unit);
  if (moves)
    body = DrivenBody{*system.mass * system.omega * (system.omega / stiffness_unit),
                      chain(*system.drive, system.omega, stiffness_unit)};
  if (system.masses) masses.emplace(system.masses->structure, system.omega, stiffness_unit);
}

std::size_t Equations::size() const { return contact_begin() + contact.branches.size(); }

std::size_t Equations::contact_begin() const {
  if (masses) return masses->size();
  return body ? 1 + body->drive.branches.size() : 0;
}

double Equations::slowest_rate() const {
  const double slowest = methods::slowest_rate(contact);
  if (masses) return std::min(slowest, masses->slowest_rate());
  return body ? std::min(slowest, methods::slowest_rate(body->drive)) : slowest;
}

std::vector<double> Equations::scales() const {
  std::vector<double> result(size(), 1.0);
  if (masses) std::ranges::copy(masses->scales(velocity), result.begin());
  if (body)
    result[0] = std::max(velocity, 1 / (body->mass + body->drive.damper + body->drive.glassy));
  return result;
}

std::vector<double> Equations::start(Start start) const {
  std::vector<double> y(size(), 0.0);
  if (masses)
    std::ranges::copy(start == Start::rest ? masses->at_rest(velocity) : masses->dragged(),
                      y.begin());
  if (start == Start::rest) return y;
  if (body) {
    y[0] = velocity;
    const Chain& drive = body->drive;
    if (!drive.branches.empty()) y[1 + drive.main_branch()] = 1;
  }
  if (!contact.branches.empty()) y[contact_begin() + contact.main_branch()] = bound(0);
  return y;
}

void Equations::rates(const double* y, double drive_velocity, double w, double force,
                      double* dydt) const {
  const double top = top_velocity(y, drive_velocity);
  contact.rates(contact_forces(y), top - w, dydt + contact_begin());
  if (masses) masses->rates(y, force, dydt);
  if (!body) return;
  const Chain& drive = body->drive;
  drive.rates(y + 1, drive_velocity - top, dydt + 1);
  dydt[0] = (drive.damper * (drive_velocity - top) + drive.sum(y + 1) - force) / body->mass;
}

double Equations::phase_at(double t) const {
  const double angle = t - phase, result = angle - two_pi * std::floor(angle / two_pi);
  return result < two_pi ? result : 0;
}

}  // namespace vcrit::simulation::methods
