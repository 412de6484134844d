// How formulas are printed: order, signs, notation, dialects; and the same bytes in every run.
#include <boost/test/unit_test.hpp>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "analysis/limits.hpp"
#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "document/findings.hpp"
#include "document/print.hpp"
#include "formula/form.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"
#include "record/json_text.hpp"
#include "support/program.hpp"

BOOST_AUTO_TEST_SUITE(test_print)

using namespace vcrit;
using namespace vcrit::symbolic;
using GiNaC::ex;

namespace {

ex sym(const char* name) { return symbol({name}); }

const ex k = sym("k0"), c = sym("c1"), w = sym("omega"), m = sym("m");

/// Whether every tag of an XML text is closed in order.
bool is_balanced(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (!tag.starts_with('/')) {
      open.push_back(tag.substr(0, tag.find(' ')));
      continue;
    }
    if (open.empty() || open.back() != tag.substr(1)) return false;
    open.pop_back();
  }
  return open.empty();
}

}  // namespace

BOOST_AUTO_TEST_CASE(sums_and_products_have_one_order) {
  BOOST_TEST(to_text(w * w * m * -1 + k) == "k0 - m*omega^2");
  BOOST_TEST(to_text(GiNaC::abs(m * w * w - k)) == "abs(k0 - m*omega^2)");
  BOOST_TEST(to_text(1 / (m * w * w - k)) == "-1/(k0 - m*omega^2)");
  BOOST_TEST(to_text(GiNaC::pow(m * w * w - k, -2)) == "1/(k0 - m*omega^2)^2");
  BOOST_TEST(to_text(GiNaC::sqrt((k + c) / (k + m))) == "sqrt((c1 + k0)/(k0 + m))");
  BOOST_TEST(to_text(sym("mu0") * w * sym("du_z") / k / (c + m)) == "mu0*omega*du_z/(k0*(c1 + m))");
  BOOST_TEST(to_text(ex(GiNaC::numeric(14, 17)) * k) == "14/17*k0");
  BOOST_TEST(to_text(-k / 3) == "-1/3*k0");
  BOOST_TEST(to_text(GiNaC::I * w * c) == "i*omega*c1");
  BOOST_TEST(to_text(GiNaC::pow(sym("mu0") * w * sym("du_z"), 2) * k) == "mu0^2*omega^2*du_z^2*k0");
  BOOST_TEST(to_text(k * quantity("Z") * w * w) == "k0*Z*omega^2");
  // Elements, then names of steps; what is the contact's, then the drive's.
  BOOST_TEST(to_text(quantity("P_3") * k * quantity("S")) == "k0*P_3*S");
  BOOST_TEST(to_text(real_quantity("Z") * positive_quantity("g") + k) == "k0 + g*Z");
  BOOST_TEST(to_text(GiNaC::pow(real_quantity("Z"), 2) * c - k) == "-k0 + c1*Z^2");
  BOOST_TEST(to_text(1 / (1 / k + 1 / (c * laplace()))) == "1/(1/(c1*s) + 1/k0)");
  BOOST_TEST(to_text(ex(0)) == "0");
}

BOOST_AUTO_TEST_CASE(names_are_ordered_as_people_count) {
  BOOST_TEST(natural_less("k2", "k10"));
  BOOST_TEST(natural_less("k[2]*c", "k[10]*c"));
  BOOST_TEST(!natural_less("k10", "k2"));
  BOOST_TEST(!natural_less("k2", "k2"));
  BOOST_TEST(natural_less("k", "k1"));
}

BOOST_AUTO_TEST_CASE(notation_in_latex) {
  const auto latex = [](const Symbol& s) { return to_latex(symbol(s)); };
  BOOST_TEST(to_latex(GiNaC::pow(quantity("v*"), 2)) == "\\left(v^{*}\\right)^{2}");
  BOOST_TEST(to_latex(GiNaC::pow(k + c, 2)) == "\\left(c_{1} + k_{0}\\right)^{2}");
  BOOST_TEST(latex({"k0"}) == "k_{0}");
  BOOST_TEST(latex({"k", 3}) == "k_{3}");
  BOOST_TEST(latex({"tau", 12}) == "\\tau_{12}");
  BOOST_TEST(latex({"mu0"}) == "\\mu_{0}");
  BOOST_TEST(latex({"omega"}) == "\\omega");
  BOOST_TEST(latex({"omega_d"}) == "\\omega_{d}");
  BOOST_TEST(latex({"du_z"}) == "\\Delta u_{z}");
  BOOST_TEST(latex({"u_z0"}) == "u_{z0}");
  BOOST_TEST(latex({"nu"}) == "\\nu");
  BOOST_TEST(latex({"kd"}) == "k_{d}");
  BOOST_TEST(latex({"c_eta"}) == "c_{\\eta}");
  BOOST_TEST(latex({"kspring"}) == "k_{\\mathrm{spring}}");
  BOOST_TEST(latex({"ratio"}) == "\\mathrm{ratio}");
  BOOST_TEST(latex({"exp"}) == "\\mathrm{exp}");
  BOOST_TEST(latex({"pi"}) == "\\pi");
  BOOST_TEST(latex({"dK_n"}) == "\\mathrm{d}K_{n}");
  BOOST_TEST(latex({"S_k", 3}) == "S_{k_{3}}");
}

BOOST_AUTO_TEST_CASE(dialects) {
  const ex formula = sym("mu0") * GiNaC::abs(k - m * w * w) / GiNaC::sqrt(k * k + c * c * w * w);
  BOOST_TEST(to_text(formula) == "mu0*abs(k0 - m*omega^2)/sqrt(k0^2 + c1^2*omega^2)");
  BOOST_TEST(to_latex(formula) ==
             "\\frac{\\mu_{0} \\left|k_{0} - m \\omega^{2}\\right|}"
             "{\\sqrt{k_{0}^{2} + c_{1}^{2} \\omega^{2}}}");
  BOOST_TEST(to_mathml(w / k) ==
             "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\"><mrow><mfrac>"
             "<mrow><mi>ω</mi></mrow><mrow><msub><mi>k</mi><mrow><mn>0</mn></mrow></msub></mrow>"
             "</mfrac></mrow></math>");
}

// What stands above or below a bar has no bar of its own: its letters would be tiny.
BOOST_AUTO_TEST_CASE(a_fraction_within_a_fraction_has_a_slash) {
  BOOST_TEST(to_latex(k / (c + 1 / c)) == "\\frac{k_{0}}{1/c_{1} + c_{1}}");
  BOOST_TEST(to_latex(k / (m + c / (k + m))) ==
             "\\frac{k_{0}}{m + c_{1}/\\left(k_{0} + m\\right)}");
  BOOST_TEST(to_latex(k / (1 + (k + m) / c)) ==
             "\\frac{k_{0}}{1 + \\left(k_{0} + m\\right)/c_{1}}");
  BOOST_TEST(to_latex(k + GiNaC::sqrt(k / m)) == "k_{0} + \\sqrt{\\frac{k_{0}}{m}}");
  BOOST_TEST(to_mathml(k / (m + k / m)).find("<mo>/</mo>") != std::string::npos);
  BOOST_TEST(to_mathml(k / m).find("<mo>/</mo>") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(mathml_is_well_formed) {
  BOOST_TEST(!is_balanced("<a><b></a></b>"));
  const Scene scene = test::kelvin_scene();
  const Derivation derivation = derive(scene);
  for (const Line& line : derivation.lines)
    BOOST_TEST(is_balanced(to_mathml(line)), line.words.text());
  for (const Limit& limit : limits(derive(scene))) BOOST_TEST(is_balanced(to_mathml(limit.result)));
}

BOOST_AUTO_TEST_CASE(text_shows_the_way_and_the_limits) {
  const std::string text = print(test::kelvin_scene(), {Format::text, true});
  for (const char* line : {"K_t*(x - y) = mu0*f_n", "x = A*exp(i*omega*t)",
                           "mu0*du_z*K_n + A*(K_d - m*omega^2) = 0", "K_t*(A - B) = mu0*du_z*K_n",
                           "v* = omega*abs(B)", "(13)", "(19)", "(24)", "(29)", "(30)", "(31)"})
    BOOST_TEST(text.find(line) != std::string::npos, line);
  BOOST_TEST(print(test::kelvin_scene(), {Format::text, false}).find("(31)") == std::string::npos);
}

// K_n + g Z over the denominator of K_n, by hand.
BOOST_AUTO_TEST_CASE(steps_have_the_ratio_and_the_stiffness_by_name) {
  for (const char* ratio : {"poisson = 0.3", "poisson = \"nu\""}) {
    const std::string text =
        print(test::scene_of(std::string("normal = \"k0 | (k1 - c1)\"\n") + ratio, "kd", "m"), {});
    for (const char* expected :
         {"with even and odd powers of s = i*omega separated, and Z = kd - m*omega^2:",
          "    P_1 = k1*(k0 + g*Z) + i*omega*c1*(k0 + k1 + g*Z)\n", "    P_2 = k1 + i*omega*c1\n",
          "    B = -mu0*du_z*P_1/(P_2*Z)\n",
          "    v* = mu0*omega*du_z*abs(P_1)/(abs(P_2)*abs(Z))\n"})
      BOOST_TEST((text.find(expected) != std::string::npos), text);
  }
}

// Nine units one behind the other are two lines, though each has two of its own.
BOOST_AUTO_TEST_CASE(lines_of_one_kind_stand_together) {
  const std::string text = print(
      test::scene_of("normal = \"generalized_kelvin(k, tau, 9)\"\npoisson = \"nu\"", "kd", "m"),
      {});
  BOOST_TEST((text.find("    R_j = omega*tau[j]  (j = 1..9)\n"
                        "    S_j = k[j] + k[j]*R_j^2  (j = 1..9)\n") != std::string::npos),
             text);
}

// By hand: k (1 + i eta) has no omega, though eta stands beside s/omega in k (1 + eta s/omega).
BOOST_AUTO_TEST_CASE(loss_factors_leave_no_omega_in_steps) {
  const std::string text = print(
      test::scene_of("normal = \"lossy(kn, eta)\"\ntangential = \"lossy(kt, zeta)\"", "kd", "m"),
      {});
  for (const char* expected :
       {"    P_1 = 1 + i*eta\n", "    P_2 = kt + Z + i*kt*zeta\n", "    P_3 = 1 + i*zeta\n",
        "    B = -mu0*du_z*kn*P_1*P_2/(kt*P_3*Z)\n"})
    BOOST_TEST((text.find(expected) != std::string::npos), text);
}

// Short lines of one kind are below one heading, and a Maxwell branch is one fraction.
BOOST_AUTO_TEST_CASE(short_lines_are_joined) {
  const std::string text =
      print(test::scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = 0.3", "kd", "m"), {});
  for (const char* expected :
       {"    x = A*exp(i*omega*t)\n    y = B*exp(i*omega*t)\n    f_n = ",
        "with s = i*omega:\n    K_n = k0 + c1*k1*s/(k1 + c1*s)\n    K_d = kd\n"})
    BOOST_TEST((text.find(expected) != std::string::npos), text);
}

BOOST_AUTO_TEST_CASE(json_has_the_promised_parts) {
  const auto json = record::read_json(print(test::kelvin_scene(), {Format::json, true}));
  BOOST_TEST(json.at("title") == "test");
  BOOST_TEST(json.at("parameters").size() == 9u);
  BOOST_TEST(json.at("critical_velocity").at("text") ==
             json.at("lines").back().at("text").get<std::string>().substr(5));
  BOOST_TEST(json.at("extrema").front().at("text").get<std::string>().ends_with(" = 0"));
  BOOST_TEST(json.at("fingerprint").get<std::string>().size() == 32u);
  BOOST_TEST(json.at("limits").size() == 11u);
  for (const auto& limit : json.at("limits"))
    for (const char* key : {"name", "equation", "text", "latex"}) BOOST_TEST(limit.contains(key));
}

BOOST_AUTO_TEST_CASE(json_has_what_was_asked_for) {
  const Scene scene = test::kelvin_scene();
  const auto plain = record::read_json(print(scene, {Format::json, false}));
  for (const char* key : {"limits", "asymptotes", "resonances", "sensitivities"})
    BOOST_TEST(plain.at(key).empty());
  const auto json = record::read_json(print(scene, {Format::json, true, true}));
  BOOST_TEST(json.at("asymptotes").size() == 2u);
  BOOST_TEST(json.at("asymptotes")[1].at("name") == "omega -> infinity");
  BOOST_TEST(json.at("asymptotes")[1].at("power") == 1);
  BOOST_TEST(json.at("asymptotes")[1].at("coefficient").at("text") == "mu0*du_z*cn/ct");
  BOOST_TEST(json.at("resonances")[0].at("name") == "resonance");
  BOOST_TEST(json.at("resonances")[0].at("frequency").at("latex") == "\\sqrt{\\frac{k_{d}}{m}}");
  BOOST_TEST(json.at("resonances")[1].at("damped") == true);
  BOOST_TEST(json.at("resonances")[1].at("frequency").is_null());
  BOOST_TEST(json.at("resonances")[1].at("imaginary_part").at("text") == "omega*ct = 0");
  BOOST_TEST(json.at("sensitivities").size() == json.at("parameters").size());
  BOOST_TEST(json.at("sensitivities")[4].at("parameter") == "kn");
  BOOST_TEST(json.at("sensitivities")[4].at("relative").at("text") == "kn^2/(kn^2 + cn^2*omega^2)");
}

BOOST_AUTO_TEST_CASE(all_markups_show_what_was_asked_for) {
  const Scene scene = test::kelvin_scene();
  const auto has = [&](Format format, const std::string& what) {
    return print(scene, {format, true, true}).find(what) != std::string::npos;
  };
  BOOST_TEST(has(Format::text, "v* ~ mu0*omega*du_z*cn/ct\n"));
  BOOST_TEST(has(Format::text, "omega = sqrt(kd/m)\n"));
  BOOST_TEST(has(Format::text, "S_kn = kn^2/(kn^2 + cn^2*omega^2)\n"));
  BOOST_TEST(has(Format::latex, "v^{*} \\sim \\frac{"));
  BOOST_TEST(has(Format::latex, "\\subsection*{Sensitivities}"));
  BOOST_TEST(has(Format::markdown, "## Low and high frequency"));
  BOOST_TEST(has(Format::markdown, "S_{k_{n}} & ="));
  BOOST_TEST(print(scene, {Format::text, true}).find("S_kn") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(large_formulas_are_nested_in_short) {
  const Scene prony =
      test::scene_of("normal = \"prony(k0, k, tau, 10)\"\npoisson = 0.3", "kd", "m");
  const std::string text = print(prony, {Format::text, true, false, ResultForm::nested});
  BOOST_TEST(text.find("k0 + sum(k[j]*tau[j]*s/(1 + tau[j]*s), j = 1..10)") != std::string::npos);
  BOOST_TEST(text.size() < 6000u);
}

BOOST_AUTO_TEST_CASE(the_result_is_the_shortest_form_where_it_fits_a_page) {
  const Scene zener = test::scene_of("normal = \"zener(k0, k1, c1)\"\npoisson = 0.3", "kd", "m");
  const std::string text = print(zener, {});
  BOOST_TEST(text.find("    Z = kd - m*omega^2\n") != std::string::npos, text);
  BOOST_TEST(text.find("17/14 = K_n/K_t (Mindlin) for nu = 0.3") != std::string::npos, text);
  const auto json = record::read_json(print(zener, {Format::json}));
  BOOST_TEST(json["form"] == "shortest");
  BOOST_TEST(json["definitions"][1]["text"] == "Z = kd - m*omega^2");
  BOOST_TEST(json["lines"].back()["text"].get<std::string>() ==
             "v* = " + json["critical_velocity"]["text"].get<std::string>());
  const Scene prony =
      test::scene_of("normal = \"prony(k0, k, tau, 100)\"\npoisson = 0.3", "kd", "m");
  // K of 100 Maxwell branches has (1 + 100/2) 2^100 terms, on one denominator with Z 2^100 more.
  std::string large = print(prony, {});
  std::replace(large.begin(), large.end(), '\n', ' ');
  BOOST_TEST(
      large.find("left in complex stiffnesses: of 102 elements, more than 48, no formula fits "
                 "a page; multiplied out, its polynomials have up to") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_document_with_all_that_can_be_asked_is_derived_once) {
  for (const Scene& scene :
       {test::kelvin_scene(), read_scene(VCRIT_SCENES "/separation.toml"),
        read_scene(VCRIT_SCENES "/sphere.toml"), read_scene(VCRIT_SCENES "/measured_drive.toml")})
    for (const ResultForm form :
         {ResultForm::shortest, ResultForm::nested, ResultForm::dimensionless}) {
      const std::size_t before = derivations_made();
      print(scene, {Format::json, true, true, form});
      BOOST_TEST(derivations_made() - before == 1u);
    }
}

// In the names of people for people, in those of the scene for programs; not both, as they take
// longest of all.
BOOST_AUTO_TEST_CASE(sensitivities_are_derived_once) {
  const Scene scene = test::kelvin_scene();
  for (const Format format : {Format::json, Format::text, Format::latex}) {
    const Findings found = findings_of(scene, {format, false, true});
    const bool json = format == Format::json;
    BOOST_TEST(found.sensitivities.each.empty() != json);
    BOOST_TEST(found.abbreviated.sensitivities.each.empty() == json);
  }
}

BOOST_AUTO_TEST_CASE(entries_of_an_array_are_told_from_elements) {
  const auto latex = [](const char* normal) {
    return print(test::scene_of(std::string("normal = \"") + normal + "\"\npoisson = 0.3", "kd"),
                 {Format::latex});
  };
  BOOST_TEST(latex("prony(k0, k, tau, 4)").find("\\frac{k_{j} \\tau_{j} s}") != std::string::npos);
  BOOST_TEST(latex("prony(k1, k, tau, 4)").find("\\frac{k_{(j)} \\tau_{j} s}") !=
             std::string::npos);
}

// GiNaC orders terms by addresses and hashes, which differ from run to run: five processes
// here, and each run of the suite against golden bytes.
BOOST_AUTO_TEST_CASE(all_runs_give_the_same_bytes) {
  const test::PrivateFolder folder;
  const test::Outcome first = test::run({VCRIT_PRINT_DOCUMENTS, "all"}, folder.path());
  BOOST_REQUIRE(first.status == 0);
  BOOST_TEST(first.output.size() > 10000u);
  for (int i = 1; i < 5; ++i) {
    const test::Outcome other = test::run({VCRIT_PRINT_DOCUMENTS, "all"}, folder.path());
    BOOST_TEST((other.output == first.output), "run " << i);
  }
}

BOOST_AUTO_TEST_SUITE_END()
