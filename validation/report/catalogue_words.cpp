#include "report/catalogue_words.hpp"

#include <map>

#include "base/errors.hpp"

namespace vcrit::validation::report {

const RheologyWords& words_of(const std::string& rheology) {
  static const std::map<std::string, RheologyWords> all{
      {"spring",
       {"Hooke solid",
        "An elastic contact: force and indentation are in phase at every frequency, nothing is "
        "lost and nothing creeps."}},
      {"damper",
       {"Newton liquid",
        "Pure viscosity: the force is that of the rate alone. It creeps without end under a "
        "lasting load and is of use as a part of other networks or of a drive."}},
      {"mass",
       {"Rigid mass",
        "Not a contact but a part of a drive, between one of its points and inertial ground: a "
        "tool, a holder, an absorber."}},
      {"kelvin",
       {"Kelvin-Voigt solid",
        "A spring with a damper beside it. Under a lasting load it creeps to a final indentation "
        "with the retardation time c/k; a sudden indentation it resists without bound."}},
      {"maxwell",
       {"Maxwell liquid",
        "A spring and a damper one behind the other. A sudden indentation is met elastically and "
        "the force then relaxes to zero with the time c/k; under a lasting load it flows."}},
      {"zener",
       {"Standard linear solid",
        "The simplest solid that is elastic both at once and in the end, and relaxes in between; "
        "also named after Zener or Poynting and Thomson. The first choice for a polymer or an "
        "elastomer near one frequency."}},
      {"jeffreys",
       {"Jeffreys liquid",
        "A Maxwell liquid with a viscous one beside it, as of a polymer in its solvent. It flows "
        "under a lasting load and, by its direct damper, resists a sudden one without bound."}},
      {"burgers",
       {"Burgers liquid",
        "A Maxwell and a Kelvin-Voigt element one behind the other. Its creep has all three "
        "stages of a test: elastic at once, delayed elastic, then steady flow; used for bitumen, "
        "wood and polymers under load."}},
      {"prony",
       {"Generalised Maxwell solid",
        "A spring and any number of Maxwell branches side by side (Wiechert), the Prony series "
        "that is fitted to measured relaxation or to a master curve over many decades. Here with "
        "three branches."}},
  };
  const auto found = all.find(rheology);
  ensure(found != all.end(), "each rheology of the catalogue has words");
  return found->second;
}

}  // namespace vcrit::validation::report
