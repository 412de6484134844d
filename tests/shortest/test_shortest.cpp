// The shortest form of v*, held against formulas that were written by hand:
// tests/data/hand_forms.csv has 18 rheologies under 4 drives with 3 kinds of Poisson's ratio, each
// with the formula that an expert prints (checked at three points to 60 digits) and its operations,
// and the operations of the program's own formula when it was last made shorter.
#include <boost/test/unit_test.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <random>

#include "analysis/dimensionless.hpp"
#include "analysis/expanded.hpp"
#include "analysis/rational_form.hpp"
#include "analysis/rational_lines.hpp"
#include "base/files.hpp"
#include "critical/critical_velocity.hpp"
#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "shortest/proof.hpp"
#include "shortest/shortest.hpp"
#include "shortest/storage_loss.hpp"
#include "shortest/value_of.hpp"

BOOST_AUTO_TEST_SUITE(test_shortest)

using namespace vcrit;
using namespace vcrit::symbolic;
using test::scene_of;

namespace {

std::optional<ShortestForm> form_for(const Scene& scene) {
  const NamesOfScene names(scene);
  return shortest_form(scene);
}

std::string text_of(const ShortestForm& form) {
  std::string text;
  for (const ShortestForm::Definition& each : form.definitions)
    text += text_dialect().equation({false, each.name}, {false, each.meaning}) + "; ";
  return text + "v* = " + text_dialect().print({false, form.velocity});
}

std::string text_for(const Scene& scene) {
  const NamesOfScene names(scene);
  return text_of(form_for(scene).value());
}

/// Each + - * / ^ sqrt abs of a text.
int operations_in_text(const std::string& text) {
  int count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool star_of_velocity = text[i] == '*' && i > 0 && text[i - 1] == 'v';
    if (std::string_view("+-*/^").find(text[i]) != std::string_view::npos && !star_of_velocity)
      ++count;
    for (const char* function : {"sqrt(", "abs("}) count += text.compare(i, 4, function, 4) == 0;
  }
  return count;
}

/// The scene with random values for all that it leaves open.
Scene filled(Scene scene, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return 0.3 + 2.0 * static_cast<double>(random() % 1000) / 1000; };
  for (auto& [symbol, value] : scene.elements)
    if (!value) value = number();
  auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
  for (Quantity* quantity : {isotropic != nullptr ? &isotropic->quantity : nullptr,
                             &scene.coefficient, &scene.angular_frequency, &scene.amplitude,
                             &scene.indentation, scene.mass ? &*scene.mass : nullptr})
    if (quantity != nullptr && !quantity->value) quantity->value = number();
  if (isotropic != nullptr && isotropic->by == Isotropic::By::poisson)
    isotropic->quantity.value = 0.1 + number() / 10;
  return scene;
}

double value_at(const ShortestForm& form, const Scene& filled) {
  std::map<std::string, double> names;
  for (const auto& [symbol, value] : filled.elements) names[to_text(symbol)] = *value;
  for (const Quantity& quantity : quantities(filled))
    if (quantity.value) names[to_text(quantity.symbol)] = *quantity.value;
  for (const ShortestForm::Definition& each : form.definitions)
    names[each.name.text] = test::value_of(each.meaning, names);
  return test::value_of(form.velocity, names);
}

/// That it is v*, is proved so, and counts what it prints.
void check(const Scene& scene, const ShortestForm& form) {
  const Scene open = scene;
  BOOST_CHECK_NO_THROW(prove(form, *derive(open).model));
  const bool given = std::get_if<Isotropic>(&scene.tangential) != nullptr &&
                     std::get<Isotropic>(scene.tangential).quantity.value.has_value();
  for (const unsigned seed : {1U, 2U}) {
    Scene numbers = filled(scene, seed);
    if (given) numbers.tangential = scene.tangential;
    BOOST_TEST(value_at(form, numbers) == critical_velocity(numbers),
               boost::test_tools::tolerance(1e-9));
  }
  const NamesOfScene names(scene);
  BOOST_TEST(form.operations == operations_in_text(text_of(form)), text_of(form));
}

/// Cells in quotes may have several lines.
std::vector<std::vector<std::string>> table(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"' && quoted && text[i + 1] == '"')
      rows.back().back() += text[++i];
    else if (text[i] == '"')
      quoted = !quoted;
    else if (text[i] == ',' && !quoted)
      rows.back().emplace_back();
    else if (text[i] == '\n' && !quoted)
      rows.emplace_back(1);
    else
      rows.back().back() += text[i];
  }
  rows.pop_back();
  return rows;
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_formula_is_longer_than_an_experts) {
  const auto rows = table(read_file(VCRIT_TEST_DATA "/hand_forms.csv"));
  std::vector<double> ratios;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::vector<std::string>& row = rows[i];
    BOOST_TEST_CONTEXT(row[0] + ", " + row[1] + ", " + row[2]) {
      const Scene scene = parse_scene(row[3], "cell.toml");
      const std::optional<ShortestForm> form = form_for(scene);
      BOOST_TEST_REQUIRE(form.has_value());
      check(scene, *form);
      BOOST_TEST(form->operations <= std::stoi(row[6]));
      ratios.push_back(form->operations / std::stod(row[5]));
      BOOST_TEST(ratios.back() <= 1.1);
    }
  }
  std::sort(ratios.begin(), ratios.end());
  BOOST_TEST(ratios.size() == 216);
  BOOST_TEST(ratios[ratios.size() / 2] <= 1.0);
}

// Every form that can be asked for, over all rows of the table: those in named steps, where groups
// make no formula longer, and what is multiplied out.
BOOST_AUTO_TEST_CASE(every_form_is_the_derived_formula) {
  const auto rows = table(read_file(VCRIT_TEST_DATA "/hand_forms.csv"));
  int multiplied = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::vector<std::string>& row = rows[i];
    BOOST_TEST_CONTEXT(row[0] + ", " + row[1] + ", " + row[2]) {
      const Scene scene = parse_scene(row[3], "cell.toml");
      const NamesOfScene names(scene);
      const std::optional<ShortestForm> parts = find_storage_loss_form(scene).form;
      BOOST_TEST_REQUIRE(parts.has_value());
      check(scene, *parts);
      const Derivation derivation = derive(scene);
      const DimensionlessGroups groups = dimensionless_groups(scene);
      const std::optional<ShortestForm> in_groups = find_dimensionless_form(scene, groups).form;
      BOOST_TEST_REQUIRE(in_groups.has_value());
      BOOST_CHECK_NO_THROW(prove(*in_groups, *derivation.model, groups.lines));
      BOOST_TEST(in_groups->operations <= std::stoi(row[6]), text_of(*in_groups));
      if (terms_before_squaring(*derivation.model) > 100) continue;
      ++multiplied;
      BOOST_CHECK_NO_THROW(
          prove(expanded_form(derivation, 100).critical_velocity, *derivation.model));
      std::vector<Line> rational =
          lines_of(rational_form(*derivation.model, 100, in_ratio(scene)), swinging(scene));
      if (const auto ratio = ratio_line(scene)) rational.push_back(*ratio);
      BOOST_CHECK_NO_THROW(prove_square(rational.front().right, rational, *derivation.model));
    }
  }
  BOOST_TEST(multiplied > 150);
}

BOOST_AUTO_TEST_CASE(storage_and_loss_read_as_people_write_them) {
  const Scene scene = scene_of("normal = \"kn | cn\"\npoisson = 0.3", "kd");
  const NamesOfScene names(scene);
  BOOST_TEST(text_of(find_storage_loss_form(scene).form.value()) ==
             "K_n'' = omega*cn; v* = mu0*omega*du_z*sqrt((kn + 17/14*kd)^2 + K_n''^2)/kd");
  BOOST_TEST(!find_storage_loss_form(read_scene(VCRIT_SCENES "/measured_drive.toml")).form);
  // A mass has a negative storage, which a line says.
  const Scene absorber =
      scene_of("normal = \"kn\"\npoisson = 0.3", "k1 - (mass(m1) | kd | cd)", "m");
  check(absorber, find_storage_loss_form(absorber).form.value());
  const Scene bridge =
      scene_of("normal = \"bridge\"\ntangential_ratio = 0.8", "kd | cd", "m", test::bridge_network);
  check(bridge, find_storage_loss_form(bridge).form.value());
  const Problem with_mass = scene_of("normal = \"kn\"\npoisson = 0.3", "k1 - (mass(m1) | kd)");
  const StorageAndLoss drive =
      storage_and_loss_of(with_mass, *with_mass->drive_network(), "K_d").value();
  BOOST_TEST(drive.loss_factor.has_value());
}

// |Z| was multiplied into 1/k1 + 1/km, where no proof looks for an absolute value.
BOOST_AUTO_TEST_CASE(absolute_values_stay_factors) {
  const Scene scene = scene_of("normal = \"k1\"\ntangential = \"kt | ct\"", "kd", "m",
                               "[mount]\nnetwork = \"km\"\n");
  const ShortestForm form = find_storage_loss_form(scene).form.value();
  BOOST_CHECK_NO_THROW(prove(form, *derive(scene).model));
}

// K_d' = -(G - Q4 R/S) was printed without its parentheses: what is printed has to have the value.
BOOST_AUTO_TEST_CASE(a_difference_that_is_taken_away_reads_right) {
  const Scene scene =
      scene_of("normal = \"k1\"\ntangential_ratio = \"r\"", "net", "",
               "[networks.net]\nterminals = [\"a\", \"b\"]\nedges = [[\"k3\", \"a\", \"x\"], "
               "[\"c4\", \"a\", "
               "\"y\"], [\"c4\", \"x\", \"y\"], [\"c5\", \"x\", \"b\"], [\"c6\", \"y\", \"b\"]]\n");
  const ShortestForm form = find_storage_loss_form(scene).form.value();
  check(scene, form);
  const NamesOfScene names(scene);
  BOOST_TEST(text_of(form).find("K_d' = Q4*R/S - G;") != std::string::npos, text_of(form));
}

// sigma = 1 + g kappa_d (1 - beta): by hand, 1 for the reference k0.
BOOST_AUTO_TEST_CASE(groups_read_as_people_write_them) {
  const Scene scene = scene_of("normal = \"zener(k0, k1, c1)\"\npoisson = \"nu\"", "kd", "m");
  const NamesOfScene names(scene);
  const ShortestForm form =
      find_dimensionless_form(scene, dimensionless_groups(scene)).form.value();
  BOOST_TEST(text_of(form).find("zeta = kappa_kd*(1 - beta_m)") != std::string::npos,
             text_of(form));
}

BOOST_AUTO_TEST_CASE(formulas_read_as_people_write_them) {
  BOOST_TEST(text_for(scene_of("normal = \"k0\"\npoisson = 0.3")) == "v* = 17/14*mu0*omega*du_z");
  BOOST_TEST(text_for(scene_of("normal = \"k0\"\npoisson = 0")) == "v* = mu0*omega*du_z");
  BOOST_TEST(text_for(scene_of("normal = \"k0\"\npoisson = \"nu\"")) ==
             "v* = mu0*omega*du_z*(2 - nu)/(2*(1 - nu))");
  BOOST_TEST(text_for(scene_of("normal = \"prony(k0, k, tau, 2)\"\npoisson = \"nu\"", "kd")) ==
             "g = (2 - nu)/(2*(1 - nu)); T1 = omega*tau[1]; T2 = omega*tau[2]; "
             "G1 = k[1]/(T1 + 1/T1); G2 = k[2]/(T2 + 1/T2); "
             "v* = mu0*omega*du_z*sqrt((k0 + g*kd + G1*T1 + G2*T2)^2 + (G1 + G2)^2)/kd");
  // Three dampers one behind the other, and the real part before the imaginary one.
  BOOST_TEST(text_for(scene_of("normal = \"k0 | (c1 - c2 - c3)\"\npoisson = \"nu\"", "kd")) ==
             "g = (2 - nu)/(2*(1 - nu)); "
             "v* = mu0*omega*du_z*sqrt((g + k0/kd)^2 + (omega/(kd/c1 + kd/c2 + kd/c3))^2)");
  // omega of the prefactor and of a damper.
  BOOST_TEST(text_for(scene_of("normal = \"cn\"\ntangential = \"kt\"")) ==
             "v* = mu0*omega^2*du_z*cn/kt");
  BOOST_TEST(text_for(scene_of("normal = \"cn\"\ntangential = \"kt\"", "kd", "m")) ==
             "v* = mu0*omega^2*du_z*cn*abs(1/kt + 1/(kd - m*omega^2))");
  // omega cancels.
  BOOST_TEST(text_for(scene_of("normal = \"kn | cn\"\ntangential = \"k1 - c1\"", "kd")) ==
             "W = omega*c1; "
             "v* = mu0*du_z*sqrt((1 + (W/k1 + W/kd)^2)*(kn^2 + (omega*cn)^2))/c1");
}

// By hand: |K_t|/omega = |ct + kt/(i omega)| in place of |kt + i omega ct|, and the like.
BOOST_AUTO_TEST_CASE(formulas_are_multiplied_through_by_omega_where_that_is_shorter) {
  BOOST_TEST(text_for(scene_of("normal = \"kn\"\ntangential = \"kt | ct\"", "")) ==
             "v* = mu0*du_z*kn/sqrt(ct^2 + (kt/omega)^2)");
  BOOST_TEST(text_for(scene_of("normal = \"kn | cn\"\ntangential_ratio = 1", "kd | cd", "m")) ==
             "Z = kd - m*omega^2; "
             "v* = mu0*du_z*sqrt(((kn + Z)^2 + (omega*(cd + cn))^2)/(cd^2 + (Z/omega)^2))");
  BOOST_TEST(text_for(scene_of("normal = \"c0 | (c1 - c2)\"\ntangential = \"kt\"", "")) ==
             "v* = mu0*omega^2*du_z*(c0 + c1*c2/(c1 + c2))/kt");
  // Normal, tangential, drive and mass, operations of a hand form.
  const std::string spring = "kd", damped = "kd | cd";
  const struct {
    std::string normal, tangential, drive, mass;
    int by_hand;
  } rows[] = {
      {"k0 - (k1 | c0) - c1 - c2", "kt0 - ct0", spring, "", 27},
      {"k0 | (c0 - (c1 | c2)) | c3", "ct0 - (kt0 | ct1)", damped, "", 34},
      {"k0 - k1", "kt0 - ct0", spring, "m", 16},
      {"k0 - k1", "kt0 | ct0", damped, "", 22},
      {"k0 - (c0 | c1) - k1", "ct0 - (kt0 | kt1)", spring, "", 20},
  };
  for (const auto& row : rows) {
    const Scene scene =
        scene_of("normal = \"" + row.normal + "\"\ntangential = \"" + row.tangential + "\"",
                 row.drive, row.mass);
    const ShortestForm form = form_for(scene).value();
    check(scene, form);
    BOOST_TEST(form.operations <= row.by_hand, text_of(form));
  }
}

BOOST_AUTO_TEST_CASE(other_scenes_have_a_formula_that_is_proved) {
  const std::string own = "normal = \"kelvin(kn, cn)\"\ntangential = ";
  const std::string open = "\"\npoisson = \"nu\"", zener = "zener(k0, k1, c1)";
  for (const Scene& scene :
       {scene_of("normal = \"" + zener + open, zener, "m"),
        scene_of("normal = \"" + zener + open, zener), scene_of("normal = \"k0" + open, "k0", "m"),
        scene_of(own + "\"" + zener + "\"", zener, "m"), scene_of(own + "\"" + zener + "\"", zener),
        scene_of("normal = \"lossy(k0, eta)" + open, "lossy(kd, eta)", "m"),
        scene_of("normal = \"" + zener + "\"\ntangential_ratio = \"r\"", "kd | cd", "m"),
        scene_of("normal = \"" + zener + "\"\ntangential_ratio = 0.5", "kd | cd", "m"),
        scene_of("normal = \"k0" + open, "k1 - (mass(m1) | kd | cd)", "m"),
        scene_of("normal = \"k0 - (k1 | c1) - (k2 | c2) - (k3 | c3)" + open, "kd", "m"),
        scene_of("normal = \"k0 | (k1 - (c1 | (k2 - (c2 | (k3 - c3)))))" + open, "kd | cd", "m"),
        scene_of("normal = \"bridge\"\npoisson = 0.3", "bridge", "m", test::bridge_network),
        test::scene_of_others()}) {
    const std::optional<ShortestForm> form = form_for(scene);
    BOOST_TEST_REQUIRE(form.has_value());
    check(scene, *form);
  }
}

BOOST_AUTO_TEST_CASE(names_are_nobody_elses) {
  const std::string text =
      text_for(scene_of("normal = \"prony(k0, k, T, 2)\"\npoisson = \"g\"", "kelvin(Z, W)", "M"));
  for (const char* taken : {"T = ", "g = ", "Z = ", "W = ", "M = "})
    BOOST_TEST(text.find(taken) == std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(the_form_does_not_depend_on_what_was_asked_before) {
  const Scene scene = scene_of("normal = \"burgers(k1, c1, k2, c2)\"\npoisson = \"nu\"", "kd", "m");
  const std::string first = text_for(scene);
  text_for(scene_of("normal = \"k2 | c1\"\npoisson = 0.3", "k1", "m"));
  BOOST_TEST(text_for(scene) == first);
}

BOOST_AUTO_TEST_CASE(what_fits_no_page_has_none) {
  BOOST_TEST(!form_for(scene_of("normal = \"prony(k0, k, tau, 100)\"\npoisson = 0.3", "kd", "m")));
  std::string edges;
  const auto node = [](int i, int j) { return fmt::format("\"{}{}\"", i, j); };
  int count = 0;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      if (i < 4) edges += fmt::format("[\"k{}\", {}, {}], ", ++count, node(i, j), node(i + 1, j));
      if (j < 4) edges += fmt::format("[\"c{}\", {}, {}], ", ++count, node(i, j), node(i, j + 1));
    }
  edges.resize(edges.size() - 2);
  const std::string grid =
      "[networks.grid]\nterminals = [\"00\", \"44\"]\nedges = [" + edges + "]\n";
  BOOST_TEST(!form_for(scene_of("normal = \"grid\"\npoisson = 0.3", "kd", "m", grid)));
}

BOOST_AUTO_TEST_CASE(a_form_that_is_not_the_formula_is_refused) {
  const Scene scene = scene_of("normal = \"zener(k0, k1, c1)\"\npoisson = 0.3", "kd", "m");
  ShortestForm form = form_for(scene).value();
  std::swap(form.definitions.front().meaning, form.definitions.back().meaning);
  const Derivation derivation = derive(scene);
  BOOST_CHECK_THROW(prove(form, *derivation.model), Bug);
  BOOST_CHECK_THROW(prove(2 * derivation.critical_velocity, *derivation.model), Bug);
  BOOST_CHECK_THROW(prove_square(omega(), {}, *derivation.model), Bug);
}

BOOST_AUTO_TEST_SUITE_END()
