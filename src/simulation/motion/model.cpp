#include "simulation/motion/model.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/free_swings.hpp"
#include "modes/beyond_doubles.hpp"
#include "modes/body_modes.hpp"
#include "modes/driven_modes.hpp"
#include "modes/endless_times.hpp"
#include "simulation/system/check.hpp"

namespace vcrit::simulation {

namespace {

Relaxation without_dimensions(Relaxation form, double omega, double stiffness_unit) {
  form = scaled(std::move(form), 1 / stiffness_unit);
  form.damper *= omega;
  for (MaxwellBranch& branch : form.branches) branch.time *= omega;
  return form;
}

bool all_in_doubles(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

// Branches keep times above 0, whose inverses are finite.
bool in_doubles(const Relaxation& form) {
  return all_in_doubles({form.equilibrium, form.damper}) &&
         std::all_of(form.branches.begin(), form.branches.end(), [](const MaxwellBranch& branch) {
           return branch.time > 0 &&
                  all_in_doubles({branch.stiffness, branch.time, 1 / branch.time});
         });
}

// The poles of drive and contact together: where they agree, a force may pass from the one network
// to the other without moving the body.
struct SharedPoles {
  PoleSum sum;
  List<std::optional<Index>> contact, drive;  // index in each network

  SharedPoles(const ContactModes& c, const PoleSum& d) : sum{c.damper + d.direct, {}, {}} {
    Index i = 0, j = 0;
    const double close = 4 * epsilon;
    while (i < c.branch_rates.size() || j < d.rates.size()) {
      const bool no_contact = i == c.branch_rates.size(), no_drive = j == d.rates.size();
      const double a = no_contact ? d.rates[j] : c.branch_rates[i];
      const double b = no_drive ? a : d.rates[j];
      const bool same = !no_contact && !no_drive && std::abs(a - b) <= close * std::max(a, b);
      const bool take_contact = !no_contact && (same || no_drive || a < b);
      const bool take_drive = !take_contact || same;
      sum.rates.push_back(take_contact ? a : b);
      sum.weights.push_back(0);
      contact.push_back(take_contact ? std::optional(i) : std::nullopt);
      drive.push_back(take_drive ? std::optional(j) : std::nullopt);
      if (take_contact) sum.weights.back() += c.branch_stiffness[i++];
      if (take_drive) sum.weights.back() += d.weights[j++];
    }
  }

  bool passing(Index l) const { return contact[l] && drive[l]; }
};

// The stuck body's modes on y = (u', g', rho): those of the body on both networks in parallel, and
// one for each shared pole.
Modes stuck_modes(const Body& body, const ContactModes& contact) {
  const SharedPoles poles(contact, body.drive);
  const Modes whole = body_modes(body.mass, poles.sum);
  Vector passing;
  for (Index l = 0; l < poles.sum.rates.size(); ++l)
    if (poles.passing(l)) passing.push_back(poles.sum.rates[l]);
  const Modes both = passing.empty() ? whole : beside(whole, uncoupled(passing));

  // y = from h, h = to y with h = (u', sums of branch forces, parts that pass): two numbers a row
  // at most, by which rows and columns are added.
  const Index drives = body.drive.rates.size(), n = both.to_modes.columns();
  Modes result{both.spectrum, Matrix(n, n), Matrix(n, n)};
  const auto link = [&](Index h, Index y, double to, double from) {
    add(both.to_modes.column(h), to, result.to_modes.column(y));
    for (Index j = 0; j < n; ++j) result.from_modes(y, j) += from * both.from_modes(h, j);
  };
  link(0, 0, 1, 1);
  Index part = whole.to_modes.columns();
  for (Index l = 0; l < poles.sum.rates.size(); ++l) {
    const Index h = l + 1;
    const Index c = poles.contact[l] ? 1 + drives + *poles.contact[l] : 0;
    const Index d = poles.drive[l] ? 1 + *poles.drive[l] : 0;
    const double share =
        c == 0 ? 0 : contact.branch_stiffness[*poles.contact[l]] / poles.sum.weights[l];
    const double other = d == 0 ? 0 : body.drive.weights[d - 1] / poles.sum.weights[l];
    if (c != 0) link(h, c, 1, share);
    if (d != 0) link(h, d, 1, other);
    if (!poles.passing(l)) continue;
    link(part, c, other, 1);
    link(part++, d, -share, -1);
  }
  return result;
}

Matrix rows(const Matrix& a, Index first, Index count) {
  Matrix result(count, a.columns());
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < count; ++i) result(i, j) = a(first + i, j);
  return result;
}

// Rates of the levels from the modes: F' on top, then those of y that belong to the body.
Matrix levels(const Vector& force_rate, const Matrix& body) {
  Matrix result(1 + body.rows(), body.columns());
  for (Index j = 0; j < body.columns(); ++j) {
    result(0, j) = force_rate[j];
    for (Index i = 0; i < body.rows(); ++i) result(1 + i, j) = body(i, j);
  }
  return result;
}

// All rates of one network are found among all of the other form, and full matrices lead from one
// to the other: some dozen numbers for each two branches.
std::size_t setup_work(const System& system) {
  std::size_t branches = system.contact.branches.size();
  if (system.drive) branches += system.drive->branches.size();
  if (system.masses) branches += system.masses->motion.poles.size();
  if (system.opening) branches += system.opening->network.branches.size();
  return 10 * branches * branches;
}

// Of a body without masses in its drive, and of that drive.
std::complex<double> impedance(const Body& body, std::complex<double> s) {
  std::complex<double> sum = s * body.mass + body.drive.direct;
  for (Index j = 0; j < body.drive.rates.size(); ++j)
    sum += body.drive.weights[j] / (body.drive.rates[j] + s);
  return sum;
}

// How many of the rates, in increasing order, are below 1.
template <class Rates>
Index slow(const Rates& rates) {
  return static_cast<Index>(std::lower_bound(rates.begin(), rates.end(), 1.0) - rates.begin());
}

}  // namespace

std::complex<double> Body::mobility(std::complex<double> s) const {
  if (masses) return simulation::mobility(*masses, s);
  return 1.0 / impedance(*this, s);
}

Model::Model(const System& system) : effort(effort_of_state, system.effort) {
  check_system(system);
  effort.spend(setup_work(system));
  const bool moves = !system.masses && system.drive && system.mass && *system.mass > 0;
  const Relaxation path = system.drive && !moves && !system.masses
                              ? series({system.contact, *system.drive})
                              : system.contact;
  const double stiffness_unit = std::abs(dynamic_stiffness(path, system.omega));
  set_bound(system);
  velocity_unit = force_unit * system.omega / stiffness_unit;
  const Relaxation plain = without_dimensions(path, system.omega, stiffness_unit);
  require_doubles(stiffness_unit > 0 && velocity_unit > 0 && in_doubles(plain) &&
                  all_in_doubles({stiffness_unit, force_unit, velocity_unit}));
  contact = contact_modes(path_without_endless_times(plain));
  if (moves) {
    const Relaxation form = without_dimensions(*system.drive, system.omega, stiffness_unit);
    const double mass = *system.mass * system.omega * (system.omega / stiffness_unit);
    require_doubles(in_doubles(form) && mass > 0 && std::isfinite(mass));
    const PoleSum drive = stiffness_poles(without_endless_times(form));
    body = Body{mass, drive, dual(drive).at_rest};
    free_harmonic = simulation::free_harmonic(system);
  }
  if (system.masses) {
    Masses masses(system.masses->motion, system.omega, stiffness_unit);
    merging = threshold_error = system.masses->rounding;
    body = Body{masses.mass, {}, masses.fluidity, std::move(masses)};
    free_harmonic = simulation::free_harmonic(system);
  }
  slow_units = slow(contact.unit_rates);
  if (body) slow_branches = slow(body->drive.rates);
  set_stick(system.known_modes);
  set_slip(system.known_modes);
  set_sliding();
  set_free_swings(system);
}

void Model::set_free_swings(const System& system) {
  threshold = std::abs(sliding_velocity);
  if (free_harmonic > 1 && !system.masses) {
    const double quarter = pi / (2 * free_harmonic);
    free_swings.push_back({free_harmonic, threshold * std::sin(quarter) / free_harmonic});
    threshold *= std::cos(quarter);
  }
  if (!system.masses || free_harmonic <= 1) return;
  const std::vector<int> harmonics = undamped_harmonics(system);
  const auto least = least_maximum(harmonics);
  if (!least)
    throw ModelError(
        "the masses of the drive swing freely at too many harmonics of the oscillation");
  for (std::size_t i = 0; i < harmonics.size(); ++i)
    free_swings.push_back({harmonics[i], -threshold * least->swings[i]});
  threshold *= least->upper;
}

// What merging modes take of its digits.
const Modes& Model::heard(const GeneralModes& found) {
  constexpr double usual = 1e3;
  double share = found.change;
  if (found.amplification > usual) {
    share += epsilon * found.amplification;
    amplification = std::max(amplification, found.amplification);
  }
  merging = std::max(merging, share);
  return found.modes;
}

void Model::set_bound(const System& system) {
  if (system.opening) {
    opening.emplace(*system.opening, system.omega, system.effort);
    normal_force = opening->mean_force;
    force_unit = system.friction * normal_force;
    amplitude = opening->amplitude;
    phase = opening->phase;
    if (!opening->closed) {
      mean = opening->constant;
      return;
    }
    load = mean;
    amplitude = std::min(1.0, amplitude);
    closed_error_ = opening->error;
    opening.reset();
    return;
  }
  load = mean;
  normal_force = system.mean_normal_force;
  force_unit = system.friction * normal_force;
  amplitude = std::abs(system.normal_force_amplitude) / normal_force;
  phase = std::arg(system.normal_force_amplitude);
}

// Both phases have the decaying parts of b behind their own y: stick beside it, for its end, and
// slip under F = b (or -b, with the parts taken negative), whose rate pushes the body and the
// units.
void Model::set_stick(KnownModes* known) {
  if (body && body->masses)
    stick.modes = heard(stick_modes(*body->masses, contact, known));
  else
    stick.modes = body ? stuck_modes(*body, contact) : uncoupled(contact.branch_rates);
  const Index first = stick.modes.to_modes.columns(), states = body_states();
  if (opening) stick.modes = beside(stick.modes, uncoupled(opening->rates));
  const Matrix& from = stick.modes.from_modes;
  stick.own = rows(from, states, branches());
  for (Index j = 0; j < from.columns(); ++j) {
    double force_rate = body ? contact.damper * from(0, j) : 0;
    for (const double rate : stick.own.column(j)) force_rate += rate;
    stick.event.push_back(force_rate);
    if (!opening) continue;
    double bound_rate = 0;
    for (Index i = 0; i < opening->rates.size(); ++i)
      bound_rate -= opening->rates[i] * from(first + i, j);
    stick.bound.push_back(bound_rate);
  }
  stick.levels = levels(stick.event, rows(from, 0, states));
}

void Model::set_slip(KnownModes* known) {
  const Modes creeping = uncoupled(contact.unit_rates);
  if (body && body->masses)
    slip.modes = beside(heard(slip_modes(*body->masses, known)), creeping);
  else
    slip.modes = body ? beside(body_modes(body->mass, body->drive), creeping) : creeping;
  const Index first = slip.modes.to_modes.columns(), states = body_states();
  double flexible = contact.fluidity;
  if (opening) {
    Vector push(first);
    if (body) push[0] = -1 / body->mass;
    for (Index j = 0; j < units(); ++j) {
      push[states + j] = contact.unit_fluidity[j];
      flexible += contact.unit_fluidity[j];
    }
    slip.modes = driven(slip.modes, push, opening->rates);
  }
  const Matrix& from = slip.modes.from_modes;
  slip.own = rows(from, states, units());
  slip.levels = levels(Vector(from.columns()), rows(from, 0, states));
  for (Index j = 0; j < from.columns(); ++j) {
    double acceleration = body ? from(0, j) : 0;
    for (Index i = 0; i < units(); ++i) acceleration += contact.unit_rates[i] * slip.own(i, j);
    for (Index i = 0; opening && i < opening->rates.size(); ++i) {
      // -J_g F'' - (phi + sum_j psi_j) F'
      const double rate = opening->rates[i];
      acceleration += (flexible - contact.glassy * rate) * rate * from(first + i, j);
    }
    slip.event.push_back(acceleration);
  }
}

void Model::set_sliding() {
  using namespace std::complex_literals;
  sliding_rates.resize(slip.modes.to_modes.columns());
  sliding_velocity = -amplitude * (1i * contact.glassy + contact.fluidity);
  creep = contact.fluidity;
  for (Index j = 0; j < units(); ++j) {
    const std::complex<double> rate =
        1i * amplitude * contact.unit_fluidity[j] / (contact.unit_rates[j] + 1i);
    sliding_rates[body_states() + j] = rate;
    sliding_velocity -= rate;
  }
  if (!body) return;
  if (body->masses) return set_sliding_of_masses();
  const PoleSum& drive = body->drive;
  const std::complex<double> opposed = impedance(*body, 1i);
  resonance = impedance(*body, 1).real() / std::abs(opposed);
  if (!(resonance < infinity)) {
    resonance = infinity;
    sliding_velocity = infinity;
    return;
  }
  const std::complex<double> velocity = -amplitude / opposed;
  sliding_velocity += velocity;
  sliding_rates[0] = 1i * velocity;
  for (Index j = 0; j < drive.rates.size(); ++j)
    sliding_rates[j + 1] = 1i * velocity * drive.weights[j] / (drive.rates[j] + 1i);
  creep += body->fluidity;
}

void Model::set_sliding_of_masses() {
  using namespace std::complex_literals;
  const Masses& masses = *body->masses;
  const List<std::complex<double>> answer = response(masses.exact, 1i);
  const double at_rising_force = response(masses.exact, 1)[0].real();
  resonance = std::abs(answer[0]) / at_rising_force;
  unlike = (1 + std::abs(masses.rates(0, 0))) * at_rising_force;
  if (!(resonance < infinity) || free_harmonic == 1) {
    resonance = infinity;
    sliding_velocity = infinity;
    return;
  }
  sliding_velocity -= amplitude / masses.mass * answer[0];
  for (Index i = 0; i < masses.states(); ++i)
    sliding_rates[i] = -1i * amplitude / masses.mass * answer[i];
  // The contact's compliance is 1. A share of the drive's stiffness changes its compliance by the
  // square of that.
  threshold_error *= amplitude * (1 + at_rising_force / masses.mass) * resonance * resonance;
  creep += body->fluidity;
}

void Model::add_steady(double times, View x) const {
  x[0] += times;
  if (!body) return;
  if (body->masses) return add(body->masses->steady, times, x.subspan(1, body_states()));
  x[1] -= times * body->fluidity;
  for (Index j = 0; j < body->drive.rates.size(); ++j) {
    const double rate = body->drive.rates[j];
    x[2 + j] -= rate == 0 ? times : times * body->drive.weights[j] * body->fluidity / rate;
  }
}

void Model::rates(ConstView x, bool stuck, View y) const {
  const Index states = body_states(), own = stuck ? branches() : units();
  for (Index j = 0; j < own; ++j) y[states + j] = x[1 + states + j];
  if (!body) return;
  if (body->masses) {
    const View top = y.first(states);
    std::fill(top.begin(), top.end(), 0.0);
    return add_rates(*body->masses, x.subspan(1, states), x[0], top);
  }
  const PoleSum& drive = body->drive;
  double force = -x[0] - drive.direct * x[1];
  for (Index j = 0; j < drive.rates.size(); ++j) {
    force -= x[2 + j];
    y[1 + j] = drive.weights[j] * x[1] - drive.rates[j] * x[2 + j];
  }
  y[0] = force / body->mass;
}

}  // namespace vcrit::simulation
