#include "modes/contact_modes.hpp"

#include <fmt/core.h>

#include "base/errors.hpp"

namespace vcrit::simulation {

ContactModes contact_modes(const Relaxation& contact) {
  if (contact.branches.size() > most_moving_branches)
    throw ModelError(fmt::format("a network of {} Maxwell branches is too large to simulate: at "
                                 "most {}",
                                 contact.branches.size(), most_moving_branches),
                     "a series of fewer branches");
  const PoleSum branches = stiffness_poles(contact);
  const DualPoles units = dual(branches);
  const Index n = branches.rates.size(), m = units.rates.size();
  ContactModes modes;
  modes.damper = contact.damper;
  modes.glassy = units.direct;
  modes.fluidity = units.at_rest;
  modes.branch_rates.assign(branches.rates.begin(), branches.rates.end());
  modes.branch_stiffness.assign(branches.weights.begin(), branches.weights.end());
  modes.unit_fluidity.assign(units.weights.begin(), units.weights.end());
  modes.to_branches = Matrix(n, m);
  for (Index j = 0; j < m; ++j) {
    const OffsetRate& rate = units.rates[j];
    modes.unit_rates.push_back(rate.value());
    for (Index i = 0; i < n; ++i)
      modes.to_branches(i, j) =
          branches.weights[i] * (rate.value() / rate.minus(branches.rates[i]));
  }
  return modes;
}

}  // namespace vcrit::simulation
