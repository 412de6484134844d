#include "report/catalogue_page.hpp"

#include <fmt/core.h>

#include <optional>
#include <string>
#include <vector>

#include "analysis/rheology.hpp"
#include "compare/formulas.hpp"
#include "derivation/derivation.hpp"
#include "formula/names.hpp"
#include "network/catalogue.hpp"
#include "problem/problem.hpp"
#include "report/assets.hpp"
#include "report/document.hpp"
#include "report/network_drawing.hpp"
#include "report/records.hpp"

namespace vcrit::validation::report {

namespace {

using GiNaC::ex;

constexpr int catalogue_branches = 3;  // of what takes arrays
std::string signature(const Rheology& rheology, const std::string& name = "") {
  std::string text = rheology.signature(name);
  if (rheology.has_arrays()) text.insert(text.size() - 1, fmt::format(", {}", catalogue_branches));
  return text;
}

/// Without values; `rest` says what there is besides the normal contact.
Problem problem_of(const std::string& normal, const std::string& rest) {
  return parse_problem("[contact]\nnormal = \"" + normal + "\"\n" + rest, "catalogue");
}

Network network_of(const Rheology& rheology) {
  std::vector<std::string> names;
  for (const auto& [name, kind] : rheology.arguments) names.push_back(name);
  return rheology.build(names, catalogue_branches);
}

/// One rheology and what is asked of it.
struct Entry {
  explicit Entry(const Rheology& rheology)
      : name(rheology.name),
        call(signature(rheology)),
        called(rheology.called),
        meaning(rheology.meaning),
        network(network_of(rheology)),
        in_drives_only(rheology.in_drives_only()) {
    for (const std::string& other : rheology.also) also.push_back(signature(rheology, other));
  }
  std::string name, call;
  std::vector<std::string> also;  ///< other calls of it
  std::string called, meaning;
  Network network;
  bool in_drives_only;

  bool flows() const {
    return !in_drives_only && symbolic::extremes(network).equilibrium.is_zero();
  }
};

record::Json formula_record(const ex& expression) {
  return record::page_of(formula_of(expression));
}

/// A row of a table; none for what is zero.
record::Json unless_zero(const ex& value) {
  return value.is_zero() ? record::Json() : formula_record(value);
}

record::Json extremes_record(const Network& network) {
  const symbolic::StiffnessExtremes extremes = symbolic::extremes(network);
  return {{"equilibrium", unless_zero(extremes.equilibrium)},
          {"viscosity", unless_zero(extremes.viscosity)},
          {"glassy", unless_zero(extremes.glassy)},
          {"direct_damper", unless_zero(extremes.damper)}};
}

/// What is given as such has no line. Times that are not are no times of the call, tau[1], which
/// would read alike.
record::Json spectrum_record(const Entry& entry) {
  const auto spectrum = symbolic::spectrum(entry.network);
  if (!spectrum || spectrum->lines.empty()) return nullptr;
  std::vector<symbolic::Line> lines;
  for (const auto& [time, strength] : spectrum->lines)
    for (const symbolic::Line& line : {time, strength})
      if (!line.left.is_equal(line.right)) lines.push_back(line);
  std::optional<symbolic::NamesOfScene> names;
  if (!lines.empty()) names.emplace(problem_of(entry.call, "tangential = \"kt\"\n"));
  return {{"sum", formula_record(spectrum->sum())},
          {"lines", record::page_of(equations_of(lines))}};
}

record::Json velocity_record(const symbolic::Derivation& derivation) {
  record::Json record = record::page_of(shown_velocity(derivation));
  record["equation"] = derivation.equation;
  return record;
}

void add_limits(const symbolic::Derivation& derivation, record::Json& record) {
  const std::vector<LimitLine> limits = limits_of(derivation);
  record["limits"] = record::page_of(limits);
  record["many_limits"] = limits.size() > shown_limits;
}

void add_contact(const Entry& entry, record::Json& record) {
  const symbolic::Derivation isotropic = symbolic::derive(problem_of(
      entry.call, "tangential_ratio = \"r\"\n[drive]\nnetwork = \"kd\"\n[body]\nmass = \"m\"\n"));
  record["extremes"] = extremes_record(entry.network);
  record["spectrum"] = spectrum_record(entry);
  record["under_an_elastic_drive"] = velocity_record(isotropic);
  record["under_a_rigid_drive"] =
      velocity_record(symbolic::derive(problem_of(entry.call, "tangential = \"kt\"\n")));
  add_limits(isotropic, record);
}

void add_drive(const Entry& entry, record::Json& record) {
  const symbolic::Derivation derivation = symbolic::derive(
      problem_of("kn", "tangential = \"kt\"\n[drive]\nnetwork = \"kd | " + entry.call + "\"\n"));
  record["beside_a_drive"] = velocity_record(derivation);
  add_limits(derivation, record);
}

record::Json rheology_record(const Entry& entry) {
  const symbolic::Response response = symbolic::response(entry.network);
  record::Json record{{"name", entry.name},
                      {"call", entry.call},
                      {"also", entry.also},
                      {"called", entry.called},
                      {"meaning", entry.meaning},
                      {"in_a_drive", entry.in_drives_only},
                      {"flows", entry.flows()},
                      {"drawing", record::page_of(Picture{draw(entry.network), entry.called})},
                      {"stiffness", formula_record(response.stiffness)},
                      {"storage", formula_record(response.storage)},
                      {"loss", formula_record(response.loss)}};
  if (entry.in_drives_only)
    add_drive(entry, record);
  else
    add_contact(entry, record);
  return record;
}

}  // namespace

std::string catalogue_page() {
  record::Json record{{"version", VCRIT_VERSION}, {"rheologies", record::Json::array()}};
  for (const Rheology& rheology : catalogue())
    record["rheologies"].push_back(rheology_record(Entry(rheology)));
  return document("catalogue", record, {"Named rheologies", false, {std::string(page_script())}});
}

}  // namespace vcrit::validation::report
