#include "derivation/meanings.hpp"

#include "network/law.hpp"

namespace vcrit::symbolic {

std::map<Symbol, Meaning> meanings_of(const Problem& problem) {
  std::map<Symbol, Meaning> all;
  // Below an indenter the contact's elements are those of a half-space; on a drive nothing is
  // derived.
  const bool half_space = problem->indenter.has_value();
  for_each_element(problem, [&](const Element& element) {
    for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
      const NumberRow& row = number_row(role);
      all[symbol] = {row.words, half_space ? row.in_half_space : row.dimension};
    });
  });
  all[{"mu0"}] = {"friction coefficient", Dimension::none};
  all[{"omega"}] = {"angular frequency", Dimension::angular_frequency};
  all[{"du_z"}] = {"amplitude", Dimension::length};
  all[{"u_z0"}] = {"mean indentation", Dimension::length};
  if (problem->load) all[problem->load->symbol] = {"mean normal force", Dimension::force};
  if (problem->mount) all[{"du_z"}] = {"amplitude of the vibrator", Dimension::length};
  if (problem->mount_mass)
    all[problem->mount_mass->symbol] = {"mass that moves along the normal", Dimension::mass};
  if (problem->mass) all[{"m"}] = {"mass", Dimension::mass};
  if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential)) {
    const bool poisson = isotropic->by == Isotropic::By::poisson;
    all[isotropic->quantity.symbol] = {poisson ? "Poisson's ratio" : "K_t/K_n", Dimension::none};
  }
  return all;
}

}  // namespace vcrit::symbolic
