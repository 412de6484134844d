#include "network/catalogue.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/joined.hpp"
#include "network/masses.hpp"

namespace vcrit {

namespace {

using Names = std::vector<std::string>;

Network k(const std::string& name) { return spring({name}); }
Network c(const std::string& name) { return damper({name}); }

Network prony(const Names& n, int branches) {
  std::vector<Network> parts{k(n[0])};
  for (int j = 1; j <= branches; ++j) parts.push_back(maxwell({n[1], j}, {n[2], j}));
  return parallel(std::move(parts));
}

// The damper of a Kelvin-Voigt element with the retardation time tau_j is k_j tau_j.
Network generalized_kelvin(const Names& n, int elements) {
  std::vector<Network> parts;
  for (int j = 1; j <= elements; ++j) {
    const Symbol stiffness{n[0], j};
    const AmountTreePointer damping = make_expression(
        AmountTree::Kind::product, make_expression(stiffness, NumberRole::stiffness),
        make_expression({n[1], j}, NumberRole::time));
    parts.push_back(parallel({spring(stiffness), damper({Symbol{}, damping})}));
  }
  return series(std::move(parts));
}

// From the last rung to the first.
Network ladder(const Names& n, int rungs) {
  Network whole = series({spring({n[0], rungs}), damper({n[1], rungs})});
  for (int j = rungs - 1; j >= 1; --j)
    whole = series({spring({n[0], j}), parallel({damper({n[1], j}), std::move(whole)})});
  return whole;
}

}  // namespace

bool Rheology::has_arrays() const {
  return std::any_of(arguments.begin(), arguments.end(),
                     [](const auto& argument) { return argument.second == Argument::array; });
}

bool Rheology::in_drives_only() const {
  std::vector<std::string> names;
  for (const auto& [argument, kind] : arguments) names.push_back(argument);
  return has_masses(build(names, has_arrays() ? 1 : 0));
}

bool Rheology::goes_by(const std::string& other) const {
  return name == other || std::find(also.begin(), also.end(), other) != also.end();
}

std::string Rheology::signature(const std::string& other) const {
  Names names;
  for (const auto& [argument, kind] : arguments) names.push_back(argument);
  return fmt::format("{}({})", other.empty() ? name : other, joined(names, ", "));
}

const std::vector<Rheology>& catalogue() {
  constexpr auto scalar = Rheology::Argument::scalar;
  constexpr auto array = Rheology::Argument::array;
  static const std::vector<Rheology> rheologies{
      {"spring",
       "Hooke solid",
       "An elastic contact: force and indentation are in phase at every frequency, nothing is "
       "lost and nothing creeps.",
       {{"k", scalar}},
       [](const Names& n, int) { return k(n[0]); }},
      {"damper",
       "Newton liquid",
       "Pure viscosity: the force is that of the rate alone. It creeps without end under a "
       "lasting load and is of use as a part of other networks or of a drive.",
       {{"c", scalar}},
       [](const Names& n, int) { return c(n[0]); }},
      {"mass",
       "Rigid mass",
       "Not a contact but a part of a drive, between one of its points and inertial ground: a "
       "tool, a holder, an absorber.",
       {{"m", scalar}},
       [](const Names& n, int) { return mass({n[0]}); }},
      {"lossy",
       "Spring with a loss factor",
       "Structural (hysteretic) damping: of the energy that it stores the same share is lost in "
       "each cycle, at all frequencies. It stands for a material whose loss factor is known at the "
       "frequency of the oscillation, and has no motion in time.",
       {{"k", scalar}, {"eta", scalar}},
       [](const Names& n, int) {
         return Network{Element{ElementKind::lossy, {n[0]}, {n[1]}}};
       }},
      {"kelvin",
       "Kelvin-Voigt solid",
       "A spring with a damper beside it. Under a lasting load it creeps to a final indentation "
       "with the retardation time c/k; a sudden indentation it resists without bound.",
       {{"k", scalar}, {"c", scalar}},
       [](const Names& n, int) {
         return parallel({k(n[0]), c(n[1])});
       }},
      {"maxwell",
       "Maxwell liquid",
       "A spring and a damper one behind the other. A sudden indentation is met elastically and "
       "the force then relaxes to zero with the time c/k; under a lasting load it flows.",
       {{"k", scalar}, {"c", scalar}},
       [](const Names& n, int) {
         return series({k(n[0]), c(n[1])});
       }},
      {"zener",
       "Standard linear solid",
       "The simplest solid that is elastic both at once and in the end, and relaxes in between. "
       "The first choice for a polymer or an elastomer near one frequency.",
       {{"k0", scalar}, {"k1", scalar}, {"c1", scalar}},
       [](const Names& n, int) {
         return parallel({k(n[0]), series({k(n[1]), c(n[2])})});
       },
       {"sls"}},
      {"poynting_thomson",
       "Standard linear solid in Kelvin form",
       "A spring behind a Kelvin-Voigt element, named after Poynting and Thomson. It can do what "
       "the Zener solid does, with other numbers: k0 is its stiffness at once, and its creep has "
       "the retardation time c1/k1.",
       {{"k0", scalar}, {"k1", scalar}, {"c1", scalar}},
       [](const Names& n, int) {
         return series({k(n[0]), parallel({k(n[1]), c(n[2])})});
       }},
      {"jeffreys",
       "Jeffreys liquid",
       "A Maxwell liquid with a viscous one beside it, as of a polymer in its solvent. It flows "
       "under a lasting load and, by its direct damper, resists a sudden one without bound.",
       {{"c0", scalar}, {"k1", scalar}, {"c1", scalar}},
       [](const Names& n, int) {
         return parallel({c(n[0]), series({k(n[1]), c(n[2])})});
       }},
      {"burgers",
       "Burgers liquid",
       "A Maxwell and a Kelvin-Voigt element one behind the other. Its creep has all three "
       "stages of a test: elastic at once, delayed elastic, then steady flow; used for bitumen, "
       "wood and polymers under load.",
       {{"k1", scalar}, {"c1", scalar}, {"k2", scalar}, {"c2", scalar}},
       [](const Names& n, int) {
         return series({k(n[0]), c(n[1]), parallel({k(n[2]), c(n[3])})});
       }},
      {"prony",
       "Generalised Maxwell solid",
       "A spring and any number of Maxwell branches side by side (Wiechert), the Prony series "
       "that is fitted to measured relaxation or to a master curve over many decades. Here with "
       "three branches.",
       {{"k0", scalar}, {"k", array}, {"tau", array}},
       prony,
       {"generalized_maxwell"}},
      {"generalized_kelvin",
       "Generalised Kelvin solid",
       "Any number of Kelvin-Voigt elements one behind the other, as measured creep is written: "
       "J(t) is a sum of 1/k (1 - exp(-t/tau)) with the retardation times tau. A sudden "
       "indentation "
       "it resists without bound, unless a spring stands in line. Here with three elements.",
       {{"k", array}, {"tau", array}},
       generalized_kelvin},
      {"ladder",
       "Ladder",
       "Springs one behind the other with a damper from behind each of them to the far end "
       "(Schiessel and Blumen). The first spring answers at once, the others ever later: with many "
       "rungs force and frequency follow a power law over decades. It flows under a lasting load. "
       "Here with three rungs.",
       {{"k", array}, {"c", array}},
       ladder,
       {},
       true},
  };
  return rheologies;
}

}  // namespace vcrit
