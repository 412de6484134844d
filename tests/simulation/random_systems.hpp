// Random systems over the kinds that scenes have, from a fixed seed. Units: omega = 1.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "simulation/steady/exact.hpp"

namespace vcrit::reference {

class RandomSystems {
 public:
  /// Relaxation times spread over 10^-decades .. 10^decades of 1/omega.
  RandomSystems(unsigned seed, double decades) : random_(seed), decades_(decades) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double logarithmic(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  bool chance(double share) { return uniform(0, 1) < share; }

  Relaxation network(bool solid) {
    Relaxation form;
    const int branches = static_cast<int>(uniform(0, 3.5));
    if (solid || (branches == 0 && chance(0.5))) form.equilibrium = logarithmic(0.1, 10);
    if (chance(0.5) || (form.equilibrium == 0 && branches == 0))
      form.damper = logarithmic(0.01, 10);
    for (int j = 0; j < branches; ++j)
      form.branches.push_back({logarithmic(0.1, 10), std::pow(10, uniform(-decades_, decades_))});
    std::sort(form.branches.begin(), form.branches.end(),
              [](const MaxwellBranch& a, const MaxwellBranch& b) { return a.time < b.time; });
    return form;
  }

  simulation::System system() {
    simulation::System s;
    s.contact = network(chance(0.8));
    if (chance(0.7)) s.drive = network(chance(0.8));
    if (s.drive && chance(0.7)) s.mass = logarithmic(0.01, 30);
    s.omega = 1;
    s.friction = uniform(0.1, 1);
    s.mean_normal_force = logarithmic(0.1, 10);
    const double phase =
        uniform(-3.1, 3.1);  // drawn on its own: compilers order arguments as they like
    s.normal_force_amplitude = std::polar(s.mean_normal_force * uniform(0.05, 0.99), phase);
    return s;
  }

 private:
  std::mt19937 random_;
  double decades_;
};

}  // namespace vcrit::reference
