#include "simulation/system/system.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "normal/mean_indentation.hpp"
#include "normal/mount.hpp"
#include "rules/rulebook.hpp"
#include "simulation/system/check.hpp"
#include "simulation/system/drive_rounding.hpp"
#include "simulation/system/measured_drive.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit::simulation {

namespace {

// What is left above a share of 1 is rounding.
void let_open(System& system, const Problem& problem) {
  const double share = std::abs(system.normal_force_amplitude) / system.mean_normal_force;
  if (problem->separation && share > 1 + least_separation(false))
    system.opening = opening_motion(problem);
  else if (share > 1)
    system.normal_force_amplitude /= share;
}

// Each number of a scene is right: what a system is refused for is what they came to.
template <class Work>
void within_number_range(const Work& work) {
  try {
    work();
  } catch (const InputError&) {
    require_si_doubles(false);
  }
}

// A product as the sum of two doubles, right to 2^-100.
struct Product {
  double high, low = 0;

  void times(double factor) {
    const double next = high * factor;
    low = std::fma(high, factor, -next) + low * factor;
    high = next + low;
    low -= high - next;
  }
};

double glassy_stiffness(const Relaxation& form) {
  double sum = form.equilibrium;
  for (const MaxwellBranch& branch : form.branches) sum += branch.stiffness;
  return sum;
}

}  // namespace

int free_harmonic(const Relaxation& drive, double mass, double omega, double within) {
  const auto& [spring, damper, branches] = drive;
  if (!(spring > 0) || !(mass > 0) || damper > 0 || !branches.empty()) return 0;
  const double n = std::round(std::sqrt(spring / mass) / omega);
  if (!(n >= 1 && n <= 1e6)) return 0;
  Product inertia{mass};
  for (const double factor : {n, n, omega, omega}) inertia.times(factor);
  const double off = std::abs((inertia.high - spring) + inertia.low);
  return off <= within * spring ? static_cast<int>(n) : 0;
}

int free_harmonic(const System& system) {
  if (system.masses) {
    const std::vector<int> harmonics = undamped_harmonics(system);
    return harmonics.empty() ? 0 : harmonics.front();
  }
  if (!system.drive || !system.mass) return 0;
  const double within = system.opening ? 1e-30 : equal_in_roundings * epsilon;
  return free_harmonic(*system.drive, *system.mass, system.omega, within);
}

namespace {

/// Those within a share of which there is a pole.
std::vector<int> harmonics_of_poles(const System& system, long double within) {
  std::vector<int> result;
  for (const std::complex<long double>& pole : system.masses->motion.poles) {
    const std::complex<long double> s = pole / static_cast<long double>(system.omega);
    const long double n = std::round(s.imag());
    if (!(n >= 1 && n <= 1e6L)) continue;
    if (std::abs(s - std::complex<long double>(0, n)) <= within * n)
      result.push_back(static_cast<int>(n));
  }
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

// The share is of a stiffness, which is as the square of the frequency. The force of a contact that
// opens drives every harmonic: only what is one but for the rounding of the poles is in resonance
// then.
std::vector<int> undamped_harmonics(const System& system) {
  constexpr long double rounding_of_poles = 1e-17L;
  if (!system.masses) return {};
  return harmonics_of_poles(system,
                            system.opening ? rounding_of_poles : equal_in_roundings / 2 * epsilon);
}

// Where Re K_d = m s^2 the network of the drive, springs and dampers, answers to a share of 1e-5
// alike over a tenth of the frequency if its loss is as faint; and as no such network stiffens as
// fast as inertia does, there is one place only, to which these steps lead.
int nearly_free_harmonic(const Relaxation& drive, double mass, double omega, double within) {
  constexpr int most_steps = 50;
  if (!(mass > 0)) return 0;
  const auto stiffness = [&](double s) { return dynamic_stiffness(drive, s); };
  double swing = std::sqrt(glassy_stiffness(drive) / mass);
  for (int i = 0; i < most_steps; ++i) swing = std::sqrt(stiffness(swing).real() / mass);
  const double n = std::round(swing / omega);
  if (!(n >= 1 && n <= 1e6)) return 0;
  const double s = n * omega, inertia = mass * s * s;
  return std::abs(stiffness(s) - inertia) <= within * inertia ? static_cast<int>(n) : 0;
}

int nearly_free_harmonic(const System& system) {
  constexpr double near_harmonic = 1e-5;
  if (system.masses) {
    // Of the stiffness, which is as the square of the frequency.
    const std::vector<int> harmonics = harmonics_of_poles(system, near_harmonic / 2);
    return harmonics.empty() ? 0 : harmonics.front();
  }
  if (!system.drive || !system.mass) return 0;
  return nearly_free_harmonic(*system.drive, *system.mass, system.omega, near_harmonic);
}

std::string why_sticks_linger(const System& system) {
  const int n = system.opening ? 0 : nearly_free_harmonic(system);
  if (n <= 1) return {};
  return fmt::format(
      "the body swings freely at harmonic {} of the oscillation{} and loses its sticks ever more "
      "slowly: no steady state tells where the last one ends",
      n, free_harmonic(system) > 1 ? "" : ", within a part in 1e5,");
}

void hold_by(System& system, DriveStructure structure, std::optional<double> compliance) {
  check_structure(structure);
  if (structure.lead) system.contact = series({system.contact, *structure.lead});
  DriveMotion motion = drive_motion(structure);
  const double rounding =
      drive_rounding(structure, motion, system.contact, system.omega, compliance);
  system.drive.reset();
  system.mass.reset();
  system.masses = std::make_shared<DriveWithMasses>(
      DriveWithMasses{std::move(structure), std::move(motion), rounding});
}

System system_of(const Problem& problem) {
  rules::require(rules::Question::motion, problem);
  const Values& values = problem.values();
  const Relaxation normal = relaxation_form(problem->normal.network(), values);
  const ScaledNetwork tangential = tangential_network(problem);

  System system;
  const bool isotropic = &tangential.network.network() == &problem->normal.network();
  system.contact =
      scaled(isotropic ? normal : relaxation_form(tangential.network.network(), values),
             tangential.factor);
  system.omega = values.at(problem->angular_frequency.symbol);
  system.friction = values.at(problem->coefficient.symbol);
  system.mean_normal_force = closed_mean_force(problem, normal.equilibrium);
  system.normal_force_amplitude =
      contact_amplitude(problem) * dynamic_stiffness(normal, system.omega);
  if (problem->has_masses()) {
    const ReducedNetwork& drive = *problem->drive_network();
    const bool body = problem->mass.has_value();
    const double mass = body ? values.at(problem->mass->symbol) : 0;
    DriveStructure structure =
        drive_structure(drive.network(), values, mass, body ? problem->mass->symbol : Symbol{});
    const auto stiffness = stiffness_on_real_axis(drive.reduction(), values, system.omega) +
                           static_cast<long double>(mass) * system.omega * system.omega;
    within_number_range(
        [&] { hold_by(system, std::move(structure), static_cast<double>(1 / stiffness)); });
  } else if (const ReducedNetwork* drive = problem->drive_network()) {
    system.drive = relaxation_form(drive->network(), values);
    if (problem->mass) system.mass = values.at(problem->mass->symbol);
  }
  if (const Receptance* table = problem->receptance())
    hold_by_table(system, *table,
                  problem->mass ? std::optional(values.at(problem->mass->symbol)) : std::nullopt);
  let_open(system, problem);
  within_number_range([&] { check_system(system); });
  return system;
}

}  // namespace vcrit::simulation
