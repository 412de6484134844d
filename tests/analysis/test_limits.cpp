// Limits are what the formula tends to, and the right ones are there.
#include <boost/test/unit_test.hpp>

#include "analysis/limits.hpp"
#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "derivation/values.hpp"
#include "formula/text.hpp"
#include "formula/value.hpp"
#include "support/random_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_limits)

using namespace vcrit;
using namespace vcrit::symbolic;
using test::scene_of;

namespace {

/// |v(T)/limit - 1| with the limit's symbols at their values times T^rate.
GiNaC::numeric distance(const Derivation& full, const Limit& limit, test::ExactValues values,
                        int decades) {
  const GiNaC::numeric at_limit = value_at(limit.result, limit.definitions, values);
  const GiNaC::numeric ten(10);
  for (const auto& [symbol, rate] : limit.rates)
    values.at(symbol) *= GiNaC::pow(ten, GiNaC::numeric(rate * decades));
  const GiNaC::numeric near = value_at(full.critical_velocity, full.definitions, values);
  return GiNaC::abs(near / at_limit - 1);
}

/// In g and Z it is the same number: to a hundred digits, of 200 that are carried.
void check_shown(const Limit& limit, const Abbreviations& names, const test::ExactValues& values) {
  std::vector<Line> definitions = names.used_by({limit.shown});
  definitions.insert(definitions.end(), limit.definitions.begin(), limit.definitions.end());
  const GiNaC::numeric shown = value_at(limit.shown, definitions, values);
  const GiNaC::numeric result = value_at(limit.result, limit.definitions, values);
  BOOST_TEST((GiNaC::abs(shown / result - 1) < GiNaC::numeric("1e-100")), limit.name);
}

// Rational functions approach their limits at least like C/T: ten decades in T are ten digits. C is
// a ratio of values, far below T = 1e15, so that the first distance is small already.
std::size_t check_limits(const Scene& scene, const test::ExactValues& values) {
  const Derivation full = derive(scene);
  const Abbreviations names = abbreviations(full);
  std::size_t checked = 0;
  for (const Limit& limit : limits(full, names)) {
    check_shown(limit, names, values);
    if (limit.rates.empty()) continue;
    ++checked;
    const GiNaC::numeric far = distance(full, limit, values, 15);
    const GiNaC::numeric near = distance(full, limit, values, 25);
    BOOST_TEST((far < GiNaC::numeric("1e-6")), limit.name);
    BOOST_TEST((near <= far * GiNaC::numeric("2e-10")), limit.name);
  }
  return checked;
}

std::vector<std::string> names(const Scene& scene) {
  std::vector<std::string> result;
  for (const Limit& limit : limits(derive(scene))) result.push_back(limit.name);
  return result;
}

const Limit& named(const std::vector<Limit>& all, const std::string& name) {
  for (const Limit& limit : all)
    if (limit.name == name) return limit;
  throw std::runtime_error("no limit " + name);
}

using Names = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_CASE(limits_are_approached) {
  GiNaC::Digits = 200;
  const auto check = [](const Scene& scene, std::size_t expected) {
    BOOST_TEST(check_limits(scene, test::some_values(scene)) == expected);
  };
  // Kelvin: kd; m; cn to 0 only (the normal force would grow without end, and without kn nothing
  // carries its mean); kt and ct both ways; all dampers to 0; then kd.
  check(test::kelvin_scene(), 9);
  // Zener, isotropic: K_d; m; k1, c1, kd, cd both ways; all to 0; then K_d. k0 carries the mean.
  check(scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd | cd", "m"), 12);
  // Burgers: k1 or c1 to 0 cuts the network; to infinity, and k2 and c2 both ways; kd.
  check(scene_of("normal = \"burgers(k1, c1, k2, c2)\"\ntangential_ratio = 0.7", "kd"), 7);
  // Prony, too large to be multiplied out: kd, m, k to 0, tau to 0 and infinity, tau to 0 and kd.
  check(scene_of("normal = \"prony(k0, k, tau, 10)\"\npoisson = 0.25", "kd", "m"), 6);
  // kd; m; k to 0; tau, kt, ct both ways; tau and ct to 0; then kd.
  check(scene_of("normal = \"prony(k0, k, tau, 12)\"\ntangential = \"kt | ct\"", "kd", "m"), 11);
  // The bridge: kd, m, k1, k2, k3 to infinity (a chain that carries the mean), c1, c2, kt, ct both
  // ways, all dampers to 0, then kd.
  check(scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", test::bridge_network),
        15);
  // Under a rigid drive: cn to 0, kt to 0, ct to 0, all dampers to 0; a rigid contact would not
  // move.
  check(scene_of(test::kelvin_contact), 4);
}

BOOST_AUTO_TEST_CASE(limits_of_random_scenes_are_approached) {
  GiNaC::Digits = 200;
  constexpr unsigned seed = 20240612;
  BOOST_TEST_MESSAGE("seed " << seed);
  // Values within a decade: ten elements make a C of up to some 1e8.
  test::RandomScenes random(seed, 0.5);
  std::size_t checked = 0;
  for (int i = 0; i < 40; ++i) {
    Scene scene = random.scene(i % 8 + 1);
    test::round_ratio(scene);
    BOOST_TEST_CONTEXT("scene " << i) { checked += check_limits(scene, test::exact_values(scene)); }
  }
  BOOST_TEST(checked > 100u);
}

BOOST_AUTO_TEST_CASE(an_element_of_several_networks_goes_to_its_limit_in_all) {
  GiNaC::Digits = 200;
  // ks to 0 leaves the dampers of contact and drive; to infinity both are rigid: nothing moves.
  const Scene both = scene_of("normal = \"kn\"\ntangential = \"ks | ct\"", "ks | cd", "m");
  check_limits(both, test::some_values(both));
  BOOST_TEST((names(both) == Names{"K_d -> infinity", "m -> 0", "ks -> 0", "ct -> 0",
                                   "ct -> infinity", "cd -> 0", "cd -> infinity", "ct, cd -> 0",
                                   "ct, cd -> 0, K_d -> infinity"}));
  // ks grows in the contact and drops out of the drive.
  const Scene mixed = scene_of("normal = \"kn\"\ntangential = \"ks\"", "kd - (ks | cd)", "m");
  check_limits(mixed, test::some_values(mixed));
  BOOST_TEST(to_text(named(limits(derive(mixed)), "ks -> infinity").result) ==
             "mu0*omega*du_z*kn/abs(kd - m*omega^2)");
  // One spring that is the drive and a part of the normal network.
  const Scene drive = scene_of("normal = \"k0 | (ks - c)\"\ntangential = \"kt\"", "ks");
  check_limits(drive, test::some_values(drive));
  BOOST_TEST(to_text(named(limits(derive(drive)), "ks -> infinity").result) ==
             "mu0*omega*du_z*sqrt(k0^2 + c^2*omega^2)/kt");
  BOOST_TEST(to_text(named(limits(derive(drive)), "K_d -> infinity").result) ==
             "mu0*omega*du_z*sqrt((k0^2*ks^2 + c^2*omega^2*(k0 + ks)^2)/(ks^2 + c^2*omega^2))/kt");
}

// One spring that is the drive and a part of the mount: it grows in both, or the drive alone does.
BOOST_AUTO_TEST_CASE(a_spring_of_drive_and_mount_goes_to_its_limit_in_both) {
  GiNaC::Digits = 200;
  const Scene scene = scene_of("normal = \"kn\"\ntangential_ratio = \"r\"", "ks", "",
                               "[mount]\nnetwork = \"ks | km\"\nmass = \"m_n\"\n");
  test::ExactValues values = test::some_values(scene);
  values.insert({{"m_n"}, GiNaC::numeric(5, 9)});
  check_limits(scene, values);
  const std::vector<Limit> all = limits(derive(scene));
  BOOST_TEST(to_text(named(all, "ks -> infinity").result) == "mu0*omega*du_z/r");
  BOOST_TEST(to_text(named(all, "K_d -> infinity").result) ==
             "mu0*omega*du_z*(km + ks)/(r*abs(km + kn + ks - m_n*omega^2))");
}

BOOST_AUTO_TEST_CASE(a_drive_that_was_the_contact_network_can_grow_alone) {
  const Scene scene = scene_of("normal = \"k1 | c1\"\ntangential = \"k2\"", "k1 | c1");
  BOOST_TEST(to_text(named(limits(derive(scene)), "K_d -> infinity").result) ==
             "mu0*omega*du_z*sqrt(k1^2 + c1^2*omega^2)/k2");
}

BOOST_AUTO_TEST_CASE(limits_that_cut_a_network_or_unload_the_contact_are_left_out) {
  // c1 to 0 cuts the normal network, c2 to 0 the tangential one, as k1 and k2; all may grow.
  BOOST_TEST((names(scene_of("normal = \"k1 - c1\"\ntangential = \"k2 - c2\"")) ==
              Names{"k1 -> infinity", "c1 -> infinity", "k2 -> infinity", "c2 -> infinity",
                    "isotropic contact, K_t = k2*K_n/k1"}));
  // Springs that are all there is; kt -> infinity leaves the drive to move.
  BOOST_TEST((names(scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd")) ==
              Names{"kd -> infinity", "kt -> infinity", "isotropic contact, K_t = kt*K_n/kn",
                    "isotropic contact, K_t = kt*K_n/kn, kd -> infinity"}));
  // k0 alone carries the mean normal load; without k1 the contact still does.
  BOOST_TEST((names(scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"kt\"")) ==
              Names{"k1 -> 0", "k1 -> infinity", "c1 -> 0", "c1 -> infinity"}));
}

// An inner part with millions of terms is not multiplied out only to be let go of.
BOOST_AUTO_TEST_CASE(what_a_limit_lets_go_of_costs_nothing) {
  std::string network = "k0";
  for (int i = 1; i <= 40; ++i)
    network = "(c" + std::to_string(i) + " | (k" + std::to_string(i) + " - " + network + "))";
  const Scene ladder = scene_of("normal = \"k | " + network + "\"\ntangential = \"kt\"", "kd");
  const std::vector<Limit> all = limits(derive(ladder));
  BOOST_TEST(to_text(named(all, "k40 -> 0").result) ==
             "mu0*omega*du_z*(kd + kt)*sqrt(k^2 + c40^2*omega^2)/(kd*kt)");
  BOOST_TEST(named(all, "k30 -> 0").definitions.size() > 1u);
  for (const Line& line : named(all, "k30 -> 0").definitions)
    BOOST_TEST(to_text(line.right).find("k29") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(equation_numbers_belong_to_the_limit) {
  const std::vector<Limit> all = limits(derive(test::kelvin_scene()));
  BOOST_TEST(named(all, "kt -> infinity").equation.empty());
  BOOST_TEST(named(all, "cn, ct -> 0").equation == "(30)");
  const Scene two = scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd | cd", "m");
  BOOST_TEST(named(limits(derive(two)), "kd -> infinity").equation == "(31)");
  BOOST_TEST(named(limits(derive(two)), "kt -> infinity").equation.empty());
}

BOOST_AUTO_TEST_SUITE_END()
