// A variation is the problem that reading its scene again with --set gives.
#include "problem/variation.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/numbers.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_variation)

namespace {

using namespace vcrit;

void check(const std::string& file, const std::vector<std::string>& names,
           const std::vector<std::vector<double>>& rows, const Settings& base = {}) {
  const Variation varied(read_problem(VCRIT_SCENES "/" + file, base), names);
  for (const auto& row : rows) {
    const Problem problem = varied.at(row);
    Settings settings = base;
    for (std::size_t i = 0; i < names.size(); ++i) settings.emplace_back(names[i], to_text(row[i]));
    const Problem again = read_problem(VCRIT_SCENES "/" + file, settings);
    BOOST_TEST((*problem->elements == *again->elements));
    BOOST_TEST((problem.values() == again.values()));
    BOOST_TEST((problem->normal.network() == again->normal.network()));
    BOOST_TEST(problem->tangential.index() == again->tangential.index());
  }
}

// Zeros leave elements out and bring them back; 2 pi f is the product that the reader forms.
BOOST_AUTO_TEST_CASE(it_is_the_scene_read_again) {
  check("zener.toml", {"k1", "frequency", "poisson", "mass"},
        {{4e6, 20e3, 0.3, 5e-3}, {0, 12345.678, -0.25, 0}, {1e6, 1, 0.5, 1e-3}});
  check("zener.toml", {"omega", "amplitude", "mu0", "u_z0"}, {{1e5, 0, 0, 1}, {1, 1e-6, 0.5, 2}},
        {{"k1", "5 N/um"}});
}

// Where nothing is read again, a new value makes no new network.
BOOST_AUTO_TEST_CASE(values_share_the_networks) {
  const Problem problem = read_problem(VCRIT_SCENES "/zener.toml");
  const Variation varied(problem, {"k1"});
  BOOST_TEST(&varied.at(std::vector{7e6})->normal.network() == &problem->normal.network());
  BOOST_TEST(&varied.at(std::vector{0.0})->normal.network() != &problem->normal.network());
}

BOOST_AUTO_TEST_CASE(a_name_takes_the_place_of_its_setting) {
  const Variation varied(
      read_problem(VCRIT_SCENES "/zener.toml", {{"frequency", "3 kHz"}, {"k1", "1e6"}}),
      {"angular_frequency"});
  // 0 for k1 is read again: both times the setting of the frequency is gone.
  BOOST_TEST(*varied.at(std::vector{7.0})->angular_frequency.value == 7);
  BOOST_TEST(varied.at(std::vector{8.0}).values().at({"k1"}) == 1e6);
}

std::string refused(const std::vector<std::string>& names, const std::vector<double>& values) {
  const auto varied = [&] { return Variation(read_problem(VCRIT_SCENES "/zener.toml"), names); };
  const std::string words = test::refusal([&] { varied().at(values); });
  BOOST_TEST(test::refusal([&] { varied().refuse(values); }) == words);
  return words;
}

BOOST_AUTO_TEST_CASE(what_reading_refuses_is_refused) {
  BOOST_TEST(refused({"k8"}, {1}).find("\"k8\", which this scene does not have") !=
             std::string::npos);
  BOOST_TEST(refused({"mu0", "coefficient"}, {1, 1}).find("coefficient as well as mu0") !=
             std::string::npos);
  BOOST_TEST(refused({"frequency"}, {0}).find("a finite value above 0") != std::string::npos);
  BOOST_TEST(refused({"poisson"}, {0.6}).find("up to 0.5") != std::string::npos);
  BOOST_TEST(refused({"k0"}, {-1}).find("a finite value of at least 0") != std::string::npos);
  BOOST_TEST(refused({"k0"}, {std::nan("")}).find("set k0: found \"nan\"") == 0U);
  // 2 pi f has to be finite, too; the unit of the scene, kHz, is not asked of it.
  BOOST_TEST(refused({"frequency"}, {1e308})
                 .find("frequency = 1e+308; expected a finite value above 0, and 2 pi f within") !=
             std::string::npos);
}

// Each number may be right, and what a scene makes of both too large.
BOOST_AUTO_TEST_CASE(what_an_expression_makes_of_a_value_is_refused) {
  const Variation varied(
      test::scene_of(
          {.normal = "k0 | k1", .amplitude = 1e-9, .elements = {{"k0", 1e200}, {"k1", "3*k0"}}}),
      {"k0"});
  varied.refuse(std::vector{1e100});
  const std::vector too_large{1e308};
  const std::string words = test::refusal([&] { varied.at(too_large); });
  BOOST_TEST(words.find("k1 = 3*k0 = inf") != std::string::npos, words);
  BOOST_TEST(test::refusal([&] { varied.refuse(too_large); }) == words);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
