#include "simulation/motion/model.hpp"

#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "simulation/motion/body_modes.hpp"

namespace vcrit::simulation {

namespace {

Relaxation without_dimensions(Relaxation form, double omega, double stiffness_unit) {
  form = scaled(std::move(form), 1 / stiffness_unit);
  form.damper *= omega;
  for (MaxwellBranch& branch : form.branches) branch.time *= omega;
  return form;
}

// The poles of drive and contact together: where they agree, a force may pass from the one network
// to the other without moving the body.
struct SharedPoles {
  PoleSum sum;
  std::vector<std::optional<Index>> contact, drive;  // index in each network

  SharedPoles(const ContactModes& c, const PoleSum& d) : sum{c.damper + d.direct, {}, {}} {
    std::size_t i = 0, j = 0;
    const double close = 4 * std::numeric_limits<double>::epsilon();
    while (i < c.branch_rates.size() || j < d.rates.size()) {
      const bool no_contact = i == c.branch_rates.size(), no_drive = j == d.rates.size();
      const double a = no_contact ? d.rates[j] : c.branch_rates[i];
      const double b = no_drive ? a : d.rates[j];
      const bool same = !no_contact && !no_drive && std::abs(a - b) <= close * std::max(a, b);
      const bool take_contact = !no_contact && (same || no_drive || a < b);
      const bool take_drive = !take_contact || same;
      sum.rates.push_back(take_contact ? a : b);
      sum.weights.push_back(0);
      contact.push_back(take_contact ? std::optional(static_cast<Index>(i)) : std::nullopt);
      drive.push_back(take_drive ? std::optional(static_cast<Index>(j)) : std::nullopt);
      if (take_contact) sum.weights.back() += c.branch_stiffness(static_cast<Index>(i++));
      if (take_drive) sum.weights.back() += d.weights[j++];
    }
  }
};

// The stuck body's modes on y = (u', g', rho): those of the body on both networks in parallel, and
// one for each shared pole.
Modes stuck_modes(const Body& body, const ContactModes& contact) {
  const SharedPoles poles(contact, body.drive);
  const Modes whole = body_modes(body.mass, poles.sum);
  std::vector<double> passing;
  for (std::size_t l = 0; l < poles.sum.rates.size(); ++l)
    if (poles.contact[l] && poles.drive[l]) passing.push_back(poles.sum.rates[l]);
  const Modes both = beside(whole, uncoupled(passing));

  // y = from h, h = to y with h = (u', sums of branch forces, parts that pass).
  const auto drives = static_cast<Index>(body.drive.rates.size());
  const Index n = both.to_modes.cols(), sums = whole.to_modes.cols();
  Matrix to = Matrix::Zero(n, n), from = Matrix::Zero(n, n);
  to(0, 0) = from(0, 0) = 1;
  Index part = sums;
  for (std::size_t l = 0; l < poles.sum.rates.size(); ++l) {
    const Index h = static_cast<Index>(l) + 1;
    const Index c = poles.contact[l] ? 1 + drives + *poles.contact[l] : 0;
    const Index d = poles.drive[l] ? 1 + *poles.drive[l] : 0;
    const double share =
        c == 0 ? 0 : contact.branch_stiffness(*poles.contact[l]) / poles.sum.weights[l];
    const double other =
        d == 0 ? 0 : body.drive.weights[static_cast<std::size_t>(d - 1)] / poles.sum.weights[l];
    if (c != 0) to(h, c) = 1, from(c, h) = share;
    if (d != 0) to(h, d) = 1, from(d, h) = other;
    if (c == 0 || d == 0) continue;
    to(part, c) = other;
    to(part, d) = -share;
    from(c, part) = 1;
    from(d, part++) = -1;
  }
  return {both.spectrum, both.to_modes * to, from * both.from_modes};
}

}  // namespace

Model::Model(const System& system) {
  const bool moves = system.drive && system.mass && *system.mass > 0;
  const Relaxation path =
      system.drive && !moves ? series(system.contact, *system.drive) : system.contact;
  const double stiffness_unit = std::abs(dynamic_stiffness(path, system.omega));
  force_unit = system.friction * system.mean_normal_force;
  velocity_unit = force_unit * system.omega / stiffness_unit;
  amplitude = std::abs(system.normal_force_amplitude) / system.mean_normal_force;
  phase = std::arg(system.normal_force_amplitude);
  ensure(amplitude < 1, "the normal force stays positive");
  contact = contact_modes(without_dimensions(path, system.omega, stiffness_unit));
  if (moves) {
    const PoleSum drive =
        stiffness_poles(without_dimensions(*system.drive, system.omega, stiffness_unit));
    body = Body{*system.mass * system.omega * (system.omega / stiffness_unit), drive,
                dual(drive).at_rest};
  }
  set_stick();
  set_slip();
  set_sliding();
}

Index Model::body_states() const {
  return body ? 1 + static_cast<Index>(body->drive.rates.size()) : 0;
}

void Model::set_stick() {
  stick.modes = body ? stuck_modes(*body, contact) : uncoupled(contact.branch_rates);
  const Matrix& from = stick.modes.from_modes;
  const Index states = body_states();
  stick.event = from.bottomRows(from.rows() - states).colwise().sum();
  if (body) stick.event += contact.damper * from.row(0).transpose();
  stick.levels = Matrix(1 + states, from.cols());
  stick.levels.row(0) = stick.event.transpose();
  stick.levels.bottomRows(states) = from.topRows(states);
}

void Model::set_slip() {
  const Modes units = uncoupled(contact.unit_rates);
  const Modes none{{}, Matrix(0, 0), Matrix(0, 0)};
  const Modes moving = body ? body_modes(body->mass, body->drive) : none;
  slip.modes = beside(moving, units);
  const Matrix& from = slip.modes.from_modes;
  const Index states = body_states();
  slip.levels = Matrix::Zero(1 + states, from.cols());
  slip.levels.bottomRows(states) = from.topRows(states);
  slip.event = body ? Vector(from.row(0).transpose()) : Vector::Zero(from.cols());
  const Index first = moving.spectrum.singles();
  for (std::size_t j = 0; j < contact.unit_rates.size(); ++j)
    slip.event(first + static_cast<Index>(j)) = contact.unit_rates[j];
}

void Model::set_sliding() {
  using namespace std::complex_literals;
  const Index states = body_states();
  sliding_rates = Eigen::VectorXcd::Zero(slip.modes.to_modes.cols());
  sliding_velocity = -amplitude * (1i * contact.glassy + contact.fluidity);
  creep = contact.fluidity;
  for (std::size_t j = 0; j < contact.unit_rates.size(); ++j) {
    const std::complex<double> rate = 1i * amplitude *
                                      contact.unit_fluidity(static_cast<Index>(j)) /
                                      (contact.unit_rates[j] + 1i);
    sliding_rates(states + static_cast<Index>(j)) = rate;
    sliding_velocity -= rate;
  }
  if (!body) return;
  std::complex<double> impedance = 1i * body->mass + body->drive.direct;
  double size = body->mass + body->drive.direct;
  for (std::size_t j = 0; j < body->drive.rates.size(); ++j) {
    const std::complex<double> part = body->drive.weights[j] / (body->drive.rates[j] + 1i);
    impedance += part;
    size += std::abs(part);
  }
  resonance = size / std::abs(impedance);
  if (impedance == 0.0) {
    sliding_velocity = std::numeric_limits<double>::infinity();
    return;
  }
  const std::complex<double> velocity = -amplitude / impedance;
  sliding_velocity += velocity;
  sliding_rates(0) = 1i * velocity;
  for (std::size_t j = 0; j < body->drive.rates.size(); ++j)
    sliding_rates(static_cast<Index>(j) + 1) =
        1i * velocity * body->drive.weights[j] / (body->drive.rates[j] + 1i);
  creep += body->fluidity;
}

Matrix Model::rates(const Matrix& x, bool stuck) const {
  const Index states = body_states(), own = stuck ? branches() : units();
  Matrix y(states + own, x.cols());
  y.bottomRows(own) = x.middleRows(level_states(), own);
  if (!body) return y;
  const auto& drive = body->drive;
  y.row(0) = -x.row(0) - drive.direct * x.row(1);
  for (Index j = 0; j + 1 < states; ++j) {
    const auto branch = static_cast<std::size_t>(j);
    y.row(0) -= x.row(2 + j);
    y.row(1 + j) = drive.weights[branch] * x.row(1) - drive.rates[branch] * x.row(2 + j);
  }
  y.row(0) /= body->mass;
  return y;
}

}  // namespace vcrit::simulation
