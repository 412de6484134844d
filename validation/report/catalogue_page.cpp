#include "report/catalogue_page.hpp"

#include <fmt/core.h>

#include "analysis/rheology.hpp"
#include "derivation/derivation.hpp"
#include "formulas.hpp"
#include "network/catalogue.hpp"
#include "network/masses.hpp"
#include "report/document.hpp"
#include "report/equations.hpp"
#include "report/html.hpp"
#include "report/network_drawing.hpp"
#include "scene/scene.hpp"

namespace vcrit::validation::report {

namespace {

using GiNaC::ex;

constexpr int shown_branches = 3;  // of what takes arrays
const char* const stiffness_sign =
    "<math><mi>K</mi><mo stretchy=\"false\">(</mo><mi>s</mi><mo stretchy=\"false\">)</mo></math>";
const char* const storage_sign = "<math><mi>K</mi><mo lspace=\"0\" rspace=\"0\">′</mo></math>";
const char* const loss_sign = "<math><mi>K</mi><mo lspace=\"0\" rspace=\"0\">″</mo></math>";

std::string signature(const Rheology& rheology) {
  std::string text = rheology.signature();
  if (rheology.has_arrays()) text.insert(text.size() - 1, fmt::format(", {}", shown_branches));
  return text;
}

/// Without values; `rest` says what there is besides the normal contact.
Scene scene_of(const std::string& normal, const std::string& rest) {
  return parse_scene("[contact]\nnormal = \"" + normal + "\"\n" + rest, "catalogue");
}

Network network_of(const Rheology& rheology) {
  std::vector<std::string> names;
  for (const auto& [name, kind] : rheology.arguments) names.push_back(name);
  return rheology.build(names, shown_branches);
}

/// One rheology and what is asked of it.
struct Entry {
  explicit Entry(const Rheology& rheology)
      : name(rheology.name),
        call(signature(rheology)),
        called(rheology.called),
        meaning(rheology.meaning),
        network(network_of(rheology)) {}
  std::string name, call;
  std::string called, meaning;
  Network network;

  bool in_a_drive_only() const { return has_masses(network); }
  bool flows() const {
    return !in_a_drive_only() && symbolic::extremes(network).equilibrium.is_zero();
  }
};

std::string equation_of(const char* left, const ex& right) {
  return equation(left, formula_of(right).mathml) + "\n";
}

std::string stiffness_part(const Network& network) {
  const symbolic::Response response = symbolic::response(network);
  return "<h3>Dynamic stiffness</h3>\n" + equation_of(stiffness_sign, response.stiffness) +
         equation_of(storage_sign, response.storage) + equation_of(loss_sign, response.loss);
}

/// A row of a table; none for what is zero.
std::string expression_row(const char* name, const ex& value) {
  if (value.is_zero()) return {};
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td><div class=\"scroll\" tabindex=\"0\">{}</div></td></tr>\n",
      name, formula_of(value).mathml);
}

std::string extremes_part(const symbolic::Extremes& extremes) {
  return "<h3>At rest and at once</h3>\n<table class=\"plain behaviour\"><tbody>\n" +
         expression_row("Equilibrium stiffness K(0)", extremes.equilibrium) +
         expression_row("Viscosity of steady flow", extremes.viscosity) +
         expression_row("Glassy stiffness K(∞)", extremes.glassy) +
         expression_row("Direct damper", extremes.damper) + "</tbody></table>\n";
}

/// Nothing for a quantity that is given as such.
std::string named(const symbolic::Line& line) {
  return line.left.is_equal(line.right) ? "" : equation(equations_of({line}).front()) + "\n";
}

std::string spectrum_part(const Network& network) {
  const auto spectrum = symbolic::spectrum(network);
  if (!spectrum || spectrum->lines.empty()) return {};
  std::string lines;
  for (const auto& [time, strength] : spectrum->lines) lines += named(time) + named(strength);
  if (lines.empty()) lines = "<p>The times and strengths are those that are given.</p>\n";
  return "<h3>Relaxation spectrum</h3>\n" + equation_of(stiffness_sign, spectrum->sum()) + lines;
}

/// Arrays are not multiplied out: even three branches would give hundreds of terms.
std::string velocity_part(const char* heading, symbolic::Derivation derivation) {
  if (!derivation.scene.arrays.empty()) derivation = nested_form(std::move(derivation));
  return fmt::format("<h3>{}</h3>\n{}", heading, numbered(derivation.equation)) +
         equation(velocity_sign, formula_of(derivation.critical_velocity).mathml) +
         definitions(equations_of(derivation.definitions));
}

std::string drawing_of(const Entry& entry) {
  return fmt::format("<figure><div class=\"scroll\" tabindex=\"0\">{}</div></figure>\n",
                     framed(draw(entry.network), entry.called));
}

std::string admissibility(const Entry& entry) {
  if (!entry.flows()) return {};
  return "<p class=\"warnings\">As normal contact not admissible: it flows, K(0) = 0, and cannot "
         "carry the mean normal load. Its formulas are the limit of a contact with a weak spring "
         "beside it.</p>\n";
}

std::string contact_part(const Entry& entry) {
  const symbolic::Derivation isotropic = symbolic::derive(scene_of(
      entry.call, "tangential_ratio = \"r\"\n[drive]\nnetwork = \"kd\"\n[body]\nmass = \"m\"\n"));
  return extremes_part(symbolic::extremes(entry.network)) + spectrum_part(entry.network) +
         velocity_part("Critical velocity, elastic drive with a mass", isotropic) +
         velocity_part("Critical velocity, elastic tangential contact, rigid drive",
                       symbolic::derive(scene_of(entry.call, "tangential = \"kt\"\n"))) +
         limits_table(limits_of(isotropic));
}

std::string drive_part(const Entry& entry) {
  const symbolic::Derivation derivation = symbolic::derive(
      scene_of("kn", "tangential = \"kt\"\n[drive]\nnetwork = \"kd | " + entry.call + "\"\n"));
  return velocity_part("Critical velocity, elastic contact, the mass beside an elastic drive",
                       derivation) +
         limits_table(limits_of(derivation));
}

std::string rheology_section(const Entry& entry) {
  return fmt::format(
             "<section class=\"scene\" id=\"{}\">\n<h2>{}: <code>{}</code></h2>\n<p>{}</p>\n",
             entry.name, escape(entry.called), escape(entry.call), escape(entry.meaning)) +
         admissibility(entry) + drawing_of(entry) + stiffness_part(entry.network) +
         (entry.in_a_drive_only() ? drive_part(entry) : contact_part(entry)) + "</section>\n";
}

std::string index_line(const Entry& entry) {
  return fmt::format(
      "<li><a href=\"#{}\"><span class=\"name\"><code>{}</code></span>"
      "<span class=\"velocity\">{}</span><span class=\"state\">{}</span></a></li>\n",
      entry.name, escape(entry.call), escape(entry.called),
      entry.in_a_drive_only() ? "in a drive only"
      : entry.flows()         ? "flows"
                              : "carries a lasting load");
}

std::string catalogue_opening() {
  return "<a class=\"skip\" href=\"#content\">To the rheologies</a>\n"
         "<header class=\"page\"><p class=\"program\">vcrit " VCRIT_VERSION
         "</p>\n<h1>Named rheologies</h1>\n"
         "<p class=\"lead\">The contacts and drives that a scene can call by name, and what each "
         "makes of the critical velocity v*.</p>\n"
         "<p>K(s) is the dynamic stiffness with s = iω, K′ and K″ its real and imaginary part at "
         "ω: storage and loss. Springs k and the strengths h of relaxation are in N/m, dampers c "
         "in N s/m, times τ in s. All formulas are derived from the network when this page is "
         "made.</p>\n"
         "<p>The first critical velocity of each is that of an isotropic contact, K<sub>t</sub> = "
         "r K<sub>n</sub> with r = 2(1 − ν)/(2 − ν) and Poisson’s ratio ν, that carries a body of "
         "mass m on an elastic drive k<sub>d</sub>; the limits are those of this formula. The "
         "second has the rheology along the normal alone, beside an elastic tangential contact "
         "k<sub>t</sub> under a rigid drive. Equations are numbered as in the "
         "paper.</p>\n</header>\n";
}

}  // namespace

std::string catalogue_page() {
  std::string index, sections;
  for (const Rheology& rheology : catalogue()) {
    const Entry entry(rheology);
    index += index_line(entry);
    sections += rheology_section(entry);
  }
  return document({"Named rheologies",
                   catalogue_opening() + "<nav aria-label=\"Rheologies\"><ol class=\"index\">\n" +
                       index + "</ol></nav>\n<main id=\"content\">\n" + sections + "</main>\n",
                   false,
                   {}});
}

}  // namespace vcrit::validation::report
