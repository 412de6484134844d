#include "simulation/motion/contact_modes.hpp"

namespace vcrit::simulation {

ContactModes contact_modes(const Relaxation& contact) {
  const PoleSum branches = stiffness_poles(contact);
  const DualPoles units = dual(branches);
  const auto n = static_cast<Index>(branches.rates.size());
  const auto m = static_cast<Index>(units.rates.size());
  ContactModes modes;
  modes.damper = contact.damper;
  modes.glassy = units.direct;
  modes.fluidity = units.at_rest;
  modes.branch_rates = branches.rates;
  modes.branch_stiffness = Vector::Map(branches.weights.data(), n);
  modes.unit_fluidity = Vector::Map(units.weights.data(), m);
  modes.to_branches = Matrix(n, m);
  for (Index j = 0; j < m; ++j) {
    const OffsetRate& rate = units.rates[static_cast<std::size_t>(j)];
    modes.unit_rates.push_back(rate.value());
    for (Index i = 0; i < n; ++i) {
      const double distance = rate.minus(branches.rates[static_cast<std::size_t>(i)]);
      modes.to_branches(i, j) = modes.branch_stiffness(i) * (rate.value() / distance);
    }
  }
  return modes;
}

}  // namespace vcrit::simulation
