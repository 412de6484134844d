#include "document/appendix.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "base/units.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/series.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "network/number_words.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

std::string unit_text(Dimension dimension) {
  std::string unit = si_unit(dimension);
  std::replace(unit.begin(), unit.end(), '.', ' ');
  return unit;
}

/// The rows of a table of symbols.
class Nomenclature {
 public:
  explicit Nomenclature(const Findings& findings)
      : derivation_(findings.derivation), problem_(derivation_.problem) {}

  std::vector<SymbolRow> rows() {
    result_and_oscillation();
    contact();
    drive();
    elements();
    derivation();
    return std::move(rows_);
  }

 private:
  void row(const ex& symbol, const Prose& meaning, Dimension dimension) {
    rows_.push_back({{symbol}, meaning, unit_text(dimension)});
  }

  void result_and_oscillation() {
    row(quantity("v*"), "critical velocity", Dimension::velocity);
    row(quantity("v0"), "velocity of the drive", Dimension::velocity);
    row(symbol({"mu0"}), "coefficient of friction", Dimension::none);
    row(omega(), "angular frequency of the oscillation", Dimension::angular_frequency);
    row(symbol({"du_z"}),
        problem_->mount ? "amplitude of the vibrator" : "amplitude of the normal oscillation",
        Dimension::length);
    row(symbol({"u_z0"}), "mean indentation", Dimension::length);
    if (problem_->load) row(symbol(problem_->load->symbol), "mean normal force", Dimension::force);
  }

  void contact() {
    if (problem_->mass) row(symbol({"m"}), "mass of the body", Dimension::mass);
    if (problem_->mount_mass &&
        !(problem_->mass && problem_->mass->symbol == problem_->mount_mass->symbol))
      row(symbol(problem_->mount_mass->symbol), "mass that moves with the contact",
          Dimension::mass);
    if (problem_->mount)
      row(quantity("K_m"), "dynamic stiffness of the mount", Dimension::stiffness);
    row(quantity("K_n"), "dynamic stiffness of the normal contact", Dimension::stiffness);
    row(quantity("K_t"), "dynamic stiffness of the tangential contact", Dimension::stiffness);
    const auto* isotropic = std::get_if<Isotropic>(&problem_->tangential);
    if (isotropic == nullptr) return;
    const bool poisson = isotropic->by == Isotropic::By::poisson;
    const Quantity& given = isotropic->quantity;
    if (poisson)
      row(given.value ? quantity("nu") : poisson_ratio(given.symbol), "Poisson's ratio",
          Dimension::none);
    else if (!given.value)
      row(symbol(given.symbol), "tangential over normal stiffness", Dimension::none);
  }

  void drive() {
    if (problem_->rigid()) return;
    row(quantity("K_d"), "dynamic stiffness of the drive", Dimension::stiffness);
    if (problem_->receptance() != nullptr)
      rows_.push_back({{quantity("R_d")}, "measured receptance of the drive", "m/N"});
  }

  /// Each number of the networks once, an array by its general entry, with the places it is in.
  void elements() {
    place(problem_->normal.network(), "normal contact");
    if (const auto* own = std::get_if<ReducedNetwork>(&problem_->tangential))
      place(own->network(), "tangential contact");
    if (const auto* network = problem_->drive_network()) place(network->network(), "drive");
    for (const auto& [name, found] : elements_) {
      std::string places;
      for (const std::string& each : found.places) places += (places.empty() ? "" : " and ") + each;
      Form shown = form_of(symbol({name})).form;
      if (found.entries > 0) shown.text += "[" + series_index() + "]";
      rows_.push_back({{Statement{{false, shown}}}, found.words + " of the " + places, found.unit});
    }
  }

  struct Found {
    std::string words, unit;
    std::vector<std::string> places;
    int entries = 0;
  };

  void place(const Network& network, const std::string& where) {
    for_each_element(network, [&](const Element& element) {
      for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
        const NumberRow& is = number_row(role);
        auto known = std::find_if(elements_.begin(), elements_.end(),
                                  [&](const auto& each) { return each.first == symbol.name; });
        if (known == elements_.end())
          known = elements_.insert(
              known, {symbol.name,
                      {number_words(element, symbol, role),
                       unit_text(problem_->indenter ? is.in_half_space : is.dimension),
                       {},
                       0}});
        Found& found = known->second;
        found.entries = std::max(found.entries, symbol.entry);
        if (std::find(found.places.begin(), found.places.end(), where) == found.places.end())
          found.places.push_back(where);
      });
    });
  }

  void derivation() {
    const bool moves = !problem_->rigid();
    if (moves) row(quantity("x"), "oscillation of the body", Dimension::length);
    row(quantity("y"), "oscillation of the contact point", Dimension::length);
    if (moves) row(quantity("A"), "complex amplitude of the body", Dimension::length);
    row(quantity("B"), "complex amplitude of the contact point", Dimension::length);
    row(quantity("phi"), {"phase of ", quantity("B"), " to the normal oscillation"},
        Dimension::angle);
    rows_.push_back({{quantity("f_n")}, "oscillation of the normal force", "N"});
    rows_.push_back({{quantity("H")}, "receptance of the contact point", "m/N"});
    rows_.push_back({{stated(laplace(), GiNaC::I * omega())}, "time derivative", "1/s"});
    row(quantity("t"), "time", Dimension::time);
  }

  const Derivation& derivation_;
  const Problem& problem_;
  std::vector<SymbolRow> rows_;
  std::vector<std::pair<std::string, Found>> elements_;
};

DocumentSection nomenclature(const Findings& findings) {
  DocumentSection section{"Symbols", "", {}};
  section.symbols = Nomenclature(findings).rows();
  return section;
}

bool holds_closed(const Problem& problem) { return !problem->separation; }

DocumentSection assumptions(const Findings& findings) {
  const Problem& problem = findings.derivation.problem;
  DocumentSection section{"Assumptions", "", {}};
  const ex v = quantity("v*"), wave = symbol({"du_z"}) * GiNaC::cos(omega() * quantity("t"));
  const Statement u{
      {false, {Form::Kind::sum, "", {}, {}, {form_of(symbol({"u_z0"})), form_of(wave)}, 1}}};
  section.items = {
      problem->mount ? Prose("The motion of the vibrator is prescribed, whatever the force on it.")
                     : Prose{"The height of the body is prescribed: the indentation is ", u,
                             ", whatever the normal force."},
      {"The contact point has no mass. There Coulomb's law holds with the constant coefficient ",
       symbol({"mu0"}), "."},
      "All networks are linear, and the motion is the steady one."};
  section.items.push_back(holds_closed(problem)
                              ? Prose{"The normal force stays above 0: the contact never opens."}
                              : Prose{"The contact may open: while it is open there is no normal "
                                      "and no friction force."});
  section.items.push_back(
      {v,
       " is the mean velocity of the contact point. A drive or contact that creeps under the "
       "mean friction makes the drive faster than that."});
  return section;
}

DocumentSection reference() {
  DocumentSection section{"Reference", "", {}};
  section.note =
      "Equation numbers are those of: Zughaibi, Schulze, Li, Critical velocity of controllability "
      "of sliding friction by normal oscillations for an arbitrary linear rheology, Physical "
      "Mesomechanics (2018), doi:10.24411/1683-805X-2018-12009.";
  return section;
}

}  // namespace

std::vector<DocumentSection> appendix(const Findings& findings) {
  const AlgebraLock lock;
  std::vector<DocumentSection> all{assumptions(findings), nomenclature(findings)};
  for (DocumentSection& section : sections(findings, FactsPlace::behind_the_result))
    all.push_back(std::move(section));
  if (all.size() > 2 && all[2].title.empty()) all[2].title = "Derivation";
  all.push_back(reference());
  return all;
}

}  // namespace vcrit::symbolic
