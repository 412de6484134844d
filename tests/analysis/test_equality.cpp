// Two ways to write one v* are found equal and two functions are not; fingerprints; residues.
#include <boost/test/unit_test.hpp>

#include "analysis/equality.hpp"
#include "analysis/exact_scene.hpp"
#include "analysis/residues.hpp"
#include "derivation/scenes.hpp"

BOOST_AUTO_TEST_SUITE(test_equality)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

Scene with_normal(const std::string& normal, const std::string& values = "",
                  const std::string& drive = "kd") {
  const std::string elements = values.empty() ? "" : "[elements]\n" + values;
  return test::scene_of("normal = \"" + normal + "\"\ntangential = \"kt\"", drive, "m", elements);
}

/// The same network as a graph of its elements alone.
class Flattened {
 public:
  explicit Flattened(const Network& network) {
    graph_.nodes = {"a", "b"};
    place(network, 0, 1);
  }
  Network network() const { return {graph_}; }

 private:
  int node() {
    graph_.nodes.push_back(std::to_string(graph_.nodes.size()));
    return static_cast<int>(graph_.nodes.size()) - 1;
  }
  void place(const Network& network, int a, int b) {
    if (const auto* series = std::get_if<Series>(&network.form)) {
      for (std::size_t i = 0; i < series->parts.size(); ++i) {
        const int to = i + 1 == series->parts.size() ? b : node();
        place(series->parts[i], a, to);
        a = to;
      }
    } else if (const auto* parallel = std::get_if<Parallel>(&network.form)) {
      for (const Network& part : parallel->parts) place(part, a, b);
    } else if (const auto* graph = std::get_if<Graph>(&network.form)) {
      std::vector<int> names{a, b};
      while (names.size() < graph->nodes.size()) names.push_back(node());
      for (std::size_t i = 0; i < graph->parts.size(); ++i)
        place(graph->parts[i], names[static_cast<std::size_t>(graph->wires[i].from)],
              names[static_cast<std::size_t>(graph->wires[i].to)]);
    } else {
      graph_.parts.push_back(network);
      graph_.wires.push_back({a, b});
    }
  }

  Graph graph_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_order_of_writing_does_not_matter) {
  const Equality found = compare(with_normal("k0 | (k1 - c1)"), with_normal("(c1 - k1) | k0"));
  BOOST_TEST(found.equal);
  BOOST_TEST((found.scope == Equality::Scope::symbols));
  BOOST_TEST((found.evidence == Equality::Evidence::canonical_form));
  BOOST_TEST(found.chance_of_error == 0);
}

// The chain k_b - (k_a | c_a) is the Zener body k0 | (k1 - c1) with k_b = k0 + k1, k_a = k_b k0/k1,
// c_a = c1 (k_b/k1)^2: from K(0), K(infinity) and the relaxation time.
BOOST_AUTO_TEST_CASE(parallel_and_chain_form_of_one_rheology) {
  const Scene parallel =
      with_normal("k0 | (k1 - c1)", "k0 = 3e6\nk1 = 1e6\nc1 = 7\nkt = 2e6\nkd = 1e6", "kd");
  const auto chain = [](const char* ca) {
    return with_normal("kb - (ka | ca)",
                       std::string("kb = 4e6\nka = 12e6\nkt = 2e6\nkd = 1e6\nca = ") + ca, "kd");
  };
  BOOST_TEST(!compare(parallel, chain("112")).equal);  // the mass is a symbol
  const auto given = [](Scene scene) {
    scene.mass->value = 0.25;
    return scene;
  };
  const Equality equal = compare(given(parallel), given(chain("112")));
  BOOST_TEST(equal.equal);
  BOOST_TEST((equal.scope == Equality::Scope::values));
  BOOST_TEST((equal.evidence == Equality::Evidence::canonical_form));

  // A number with a unit is compared with all digits that were typed.
  BOOST_TEST(compare(given(parallel), given(chain("\"0.112 N.s/mm\""))).equal);
  const Equality typed =
      compare(given(parallel), given(chain("\"112.00000000000000000000000000001 N.s/m\"")));
  BOOST_TEST(!typed.equal);
  BOOST_REQUIRE(typed.counterexample.has_value());
  BOOST_TEST(typed.counterexample->difference > 0);

  const Scene near = given(chain("112.000001"));
  const Equality different = compare(given(parallel), near);
  BOOST_TEST(!different.equal);
  BOOST_TEST((different.scope == Equality::Scope::values));
  BOOST_REQUIRE(different.counterexample.has_value());
  BOOST_TEST(different.counterexample->first != different.counterexample->second);
}

// |1 + i omega c| with c = 1e-3 hardly differs from 1 where omega is small: what is shown is where
// it clearly does.
BOOST_AUTO_TEST_CASE(a_counterexample_shows_a_clear_difference) {
  const auto under = [](const char* normal, const std::string& values) {
    return test::scene_of("normal = \"" + std::string(normal) + "\"\ntangential = \"kt\"", "", "",
                          "[elements]\nkn = 1\nkt = 2\n" + values);
  };
  const Equality found = compare(under("kn | cn", "cn = 1e-3\n"), under("kn", ""));
  BOOST_REQUIRE(found.counterexample.has_value());
  BOOST_TEST(found.counterexample->difference >= 1e-3);
}

BOOST_AUTO_TEST_CASE(a_counterexample_is_one) {
  const Scene a = with_normal("k0 | (k1 - c1)"), b = with_normal("k1 | (k0 - c1)");
  const Equality found = compare(a, b);
  BOOST_TEST(!found.equal);
  BOOST_REQUIRE(found.counterexample.has_value());
  const auto nodal = [&found](Scene scene) {
    for (const auto& [symbol, value] : found.counterexample->values) {
      for (auto& [element, of] : scene.elements)
        if (element == symbol) of = value;
      for (Quantity* each : {&scene.coefficient, &scene.angular_frequency, &scene.amplitude})
        if (each->symbol == symbol) each->value = value;
      if (scene.mass->symbol == symbol) scene.mass->value = value;
    }
    scene.indentation.value = 1;
    return static_cast<double>(test::critical_velocity_by_nodes(scene));
  };
  // The program's v* is right to a unit in the last place times its condition, here below 1e4.
  BOOST_TEST(found.counterexample->first == nodal(a), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(found.counterexample->second == nodal(b), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(found.counterexample->first - found.counterexample->second) >
             1e-9 * found.counterexample->first);
}

BOOST_AUTO_TEST_CASE(random_networks_and_their_graphs) {
  test::RandomScenes random(20261124, 3);
  for (int i = 0; i < 150; ++i) {
    Scene scene = random.scene(i % 20 + 2);
    test::round_ratio(scene);
    Scene other = scene;
    other.normal = Flattened(scene.normal).network();
    if (scene.drive) other.drive = Flattened(*scene.drive).network();
    BOOST_TEST(compare(scene, other).equal, "scene " << i);
    BOOST_TEST(fingerprint(SymbolicModel(scene)) == fingerprint(SymbolicModel(other)),
               "scene " << i);
  }
}

// A body on a drive is a mass of the drive beside it.
BOOST_AUTO_TEST_CASE(a_body_is_a_mass_of_the_drive) {
  const std::string contact = "normal = \"k0 | (k1 - c1)\"\ntangential = \"kt | ct\"";
  const Scene body = test::scene_of(contact, "kd | cd", "m");
  const Equality found = compare(body, test::scene_of(contact, "mass(m) | kd | cd"));
  BOOST_TEST(found.equal);
  BOOST_TEST((found.evidence == Equality::Evidence::canonical_form));
  BOOST_TEST(!compare(body, test::scene_of(contact, "kd - (mass(m) | cd)")).equal);
}

// Found at a frequency of the table, whichever of the two is measured.
BOOST_AUTO_TEST_CASE(measured_drives_are_their_tables) {
  const Scene measured = read_scene(VCRIT_SCENES "/measured_drive.toml");
  BOOST_TEST(compare(measured, measured).equal);
  Scene other = measured;
  other.receptance.reset();
  other.drive = spring({"kd"});
  other.elements.emplace_back(Symbol{"kd"}, 2e6);
  for (const Equality& found : {compare(measured, other), compare(other, measured)}) {
    BOOST_TEST(!found.equal);
    BOOST_TEST(found.counterexample.has_value());
  }
  Scene stiffer = measured;
  stiffer.receptance->rows.front().re *= 0.5;
  BOOST_CHECK_THROW(compare(measured, stiffer), ModelError);
}

BOOST_AUTO_TEST_CASE(large_networks_are_compared_by_residues) {
  const Equality found =
      compare(with_normal("prony(k0, k, tau, 100)"), with_normal("prony(k0, k, tau, 100)"));
  BOOST_TEST(found.equal);
  BOOST_TEST((found.evidence == Equality::Evidence::residues));
  BOOST_TEST(found.chance_of_error > 0);
  BOOST_TEST(found.chance_of_error < 1e-40);
  BOOST_TEST(
      !compare(with_normal("prony(k0, k, tau, 100)"), with_normal("prony(k0, k, tau, 99)")).equal);
}

BOOST_AUTO_TEST_CASE(fingerprints_tell_functions_apart) {
  const auto of = [](const Scene& scene) { return fingerprint(SymbolicModel(scene)); };
  BOOST_TEST(of(with_normal("k0 | (k1 - c1)")) == of(with_normal("(k1 - c1) | k0")));
  BOOST_TEST(of(with_normal("k0 | (k1 - c1)")) != of(with_normal("k1 | (k0 - c1)")));
  BOOST_TEST(of(with_normal("k0")) != of(with_normal("k0", "", "k0")));
  BOOST_TEST(of(with_normal("k0")).size() == 32U);
  // Isotropic under a rigid drive: no network is left in the function.
  const auto isotropic = [](const char* normal) {
    return test::scene_of(std::string("normal = \"") + normal + "\"\npoisson = 0.3");
  };
  BOOST_TEST(of(isotropic("k1 | c1")) == of(isotropic("burgers(k1, c1, k2, c2)")));
}

BOOST_AUTO_TEST_CASE(residues_are_a_field) {
  const Residue a(123456789012345678), b(Residue::prime - 5);
  BOOST_TEST((a * inverse(a)).value() == 1U);
  BOOST_TEST((b + Residue(5)).value() == 0U);
  BOOST_TEST((b * b).value() == 25U);
  BOOST_TEST((-Residue(1) * -Residue(1)).value() == 1U);
  BOOST_TEST((-Residue(0)).value() == 0U);
  BOOST_CHECK_THROW(inverse(Residue(0)), NoInverse);
  // 2^61 = 1, so that 1/2 = 2^60.
  BOOST_TEST(Residue(GiNaC::numeric(1, 2)).value() == std::uint64_t{1} << 60);
  BOOST_TEST((Residue(GiNaC::numeric(-3, 7)) * Residue(7)).value() == Residue::prime - 3);
}

BOOST_AUTO_TEST_SUITE_END()
