#include "bounds/draws.hpp"

#include <algorithm>
#include <cmath>

namespace vcrit::bounds {

std::string_view name_of(Draw draw) {
  switch (draw) {
    case Draw::moderate:
      return "moderate";
    case Draw::stiff:
      return "stiff";
    case Draw::stiff_within:
      return "stiff within";
    case Draw::zeros:
      return "zeros";
    case Draw::resonance:
      return "resonance";
    case Draw::antiresonance:
      return "antiresonance";
    case Draw::slow:
      return "slow";
    case Draw::any:
      return "any size";
    case Draw::extreme:
      return "extreme v*";
    case Draw::powers:
      break;
  }
  return "powers of 2";
}

std::vector<Draw> draws_for(const TrialSystem& system) {
  std::vector<Draw> draws{Draw::moderate, Draw::stiff, Draw::stiff_within, Draw::zeros};
  if (system.mass) draws.insert(draws.end(), {Draw::resonance, Draw::antiresonance});
  draws.insert(draws.end(), {Draw::slow, Draw::any, Draw::extreme, Draw::powers});
  return draws;
}

/// Decimal exponents of omega, and what omega damps and relaxes at.
struct Cases::Decades {
  double least_omega, most_omega;
  bool slow = false;  ///< dampers as for omega = 1
};

void Cases::fill(Draw draw, std::span<double> x) {
  constexpr Decades usual{2, 7};
  switch (draw) {
    case Draw::stiff:
      return stiff(x);
    case Draw::any:
      return any(x);
    case Draw::powers:
      return powers(x);
    case Draw::slow:
      return ordinary({-300, -6, true}, x);
    case Draw::moderate:
      return ordinary(usual, x);
    case Draw::stiff_within:
      ordinary(usual, x);
      return stretch(x);
    case Draw::zeros:
      ordinary(usual, x);
      return leave_out(x);
    case Draw::extreme:
      ordinary(usual, x);
      return extreme(x);
    case Draw::resonance:
    case Draw::antiresonance:
      ordinary(usual, x);
      return resonate(draw == Draw::antiresonance, x);
  }
}

double Cases::decade(double from, double to) { return std::pow(10, uniform(from, to)); }

double Cases::power(int from, int to) {
  return std::ldexp(1.0, std::uniform_int_distribution(from, to)(random_));
}

void Cases::ordinary(const Decades& decades, std::span<double> x) {
  x[omega_slot] = decade(decades.least_omega, decades.most_omega);
  const double omega = decades.slow ? 1 : x[omega_slot];
  for (std::size_t i = 0; i < x.size(); ++i) switch (system_.slots[i].role) {
      case Role::omega:
        break;
      case Role::coefficient:
        x[i] = uniform(0.05, 1);
        break;
      case Role::amplitude:
        x[i] = decade(-9, -5);
        break;
      case Role::poisson:
        x[i] = uniform(0, 0.5);
        break;
      case Role::spring:
        x[i] = decade(4, 8);
        break;
      case Role::damper:
        x[i] = decade(4, 8) * decade(-3, 3) / omega;
        break;
      case Role::time:
        x[i] = decade(-3, 3) / omega;
        break;
      case Role::mass:
        x[i] = decade(4, 8) * decade(-2, 2) / (omega * omega);
        break;
    }
}

void Cases::stiff(std::span<double> x) {
  ordinary({-6, 15}, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Role role = system_.slots[i].role;
    if (role == Role::spring || role == Role::mass) x[i] = decade(-30, 30);
    if (role == Role::damper) x[i] = decade(-30, 30) * decade(-12, 12);
    if (role == Role::time) x[i] = decade(-12, 12);
  }
}

void Cases::stretch(std::span<double> x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Role role = system_.slots[i].role;
    if (role == Role::spring || role == Role::damper || role == Role::mass || role == Role::time)
      x[i] *= chance(0.5) ? decade(-15, 15) : chance(0.5) ? decade(-30, -25) : decade(25, 30);
  }
}

void Cases::leave_out(std::span<double> x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Role role = system_.slots[i].role;
    if (role != Role::coefficient && role != Role::omega && role != Role::amplitude && chance(0.25))
      x[i] = 0;
  }
}

// Only what is hardly damped comes near a resonance.
void Cases::weaken_dampers(const SlotRange& range, std::span<double> x) {
  const double factor = decade(-20, 0);
  for (std::size_t i = range.first; i < range.first + range.count; ++i)
    if (system_.slots[i].role == Role::damper || system_.slots[i].role == Role::time)
      x[i] *= factor;
}

void Cases::undamp(const SlotRange& range, std::span<double> x) {
  const double spring = power(10, 30);
  for (std::size_t i = range.first; i < range.first + range.count; ++i)
    x[i] = system_.slots[i].role == Role::spring ? spring : 0;
}

void Cases::resonate(bool with_tangential, std::span<double> x) {
  if (chance(0.125) && resonate_exactly(with_tangential, x)) return;
  weaken_dampers(system_.driving, x);
  if (with_tangential) weaken_dampers(system_.poisson ? system_.normal : system_.tangential, x);
  const double part = decade(-17, -1) * (chance(0.5) ? 1 : -1);
  x[*system_.mass] = reference_.mass_near_resonance(x, with_tangential, part);
}

// Springs all the same and powers of 2, so that K is one, too, where the network allows for it.
bool Cases::resonate_exactly(bool with_tangential, std::span<double> x) {
  std::vector<double> exact(x.begin(), x.end());
  exact[omega_slot] = power(5, 20);
  undamp(system_.driving, exact);
  if (with_tangential) undamp(system_.poisson ? system_.normal : system_.tangential, exact);
  if (system_.poisson && with_tangential) exact[*system_.poisson] = 0;
  const double mass = reference_.mass_near_resonance(exact, with_tangential, 0);
  if (!(mass > 0)) return false;
  exact[*system_.mass] = mass;
  std::copy(exact.begin(), exact.end(), x.begin());
  return true;
}

void Cases::any(std::span<double> x) {
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = std::exp2(uniform(-1000, system_.slots[i].role == Role::poisson ? -1 : 1000));
}

// v* = mu0 du_z omega times a ratio: mu0 and du_z share what is missing.
void Cases::extreme(std::span<double> x) {
  x[coefficient_slot] = x[amplitude_slot] = 1;
  const Exact exact = reference_.velocity(x);
  const double wanted = chance(0.5) ? uniform(-1080, -1015) : uniform(1015, 1030);
  const double missing = wanted - exact.exponent, share = uniform(0.3, 0.7);
  x[coefficient_slot] = std::exp2(missing * share);
  x[amplitude_slot] = std::exp2(missing * (1 - share));
}

void Cases::powers(std::span<double> x) {
  const int most = chance(0.5) ? 3 : 40;
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = system_.slots[i].role == Role::poisson ? power(-most, -1) : power(-most, most);
}

}  // namespace vcrit::bounds
