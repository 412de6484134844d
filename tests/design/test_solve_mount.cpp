// The smallest frequency below a mount that gives: against the closed form of an elastic contact,
// and where the contact opens at frequencies in between.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "design/opening.hpp"
#include "design/solve.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_solve_mount)

namespace {

using namespace vcrit;
using design::DesignAnswer;
using design::DesignQuestion;
using design::Sought;

constexpr double turn = 2 * std::numbers::pi;

// Springs and one mass along the normal: the mount resonates at omega^2 = (km + kn)/mn = 7.
constexpr double kn = 1.5, kt = 1, km = 2, mn = 0.5, force = 1, mu0 = 0.4;

struct Machine {
  double amplitude;

  Problem problem() const {
    return test::scene_of({.tangential = "kt",
                           .mount = "km",
                           .mount_mass = mn,
                           .angular_frequency = 1,
                           .amplitude = amplitude,
                           .force = force,
                           .coefficient = mu0,
                           .elements = {{"kn", kn}, {"kt", kt}, {"km", km}}});
  }
  double height(double omega) const {
    return amplitude * km / std::abs(km + kn - mn * omega * omega);
  }
  double share(double omega) const { return kn * height(omega) / force; }
  double velocity(double omega) const { return mu0 * omega * height(omega) * kn / kt; }
  /// omega^2 where the share is 1, below the resonance and above.
  double opening(int sign) const {
    return std::sqrt((km + kn + sign * km * kn * amplitude / force) / mn);
  }
  DesignAnswer solve(double ratio, double speed, double from, double to) const {
    return design::solve({problem(), Sought::frequency, ratio, speed, from / turn, to / turn});
  }
};

}  // namespace

// mu/mu0 = 1 - share G(v/v*), G as in test_solve; below the resonance share and v* rise with the
// frequency, so that there is one frequency. Allowed is what test_solve allows there.
BOOST_AUTO_TEST_CASE(an_elastic_contact_has_the_frequency_of_the_closed_form) {
  constexpr struct {
    double vbar, g;
  } closed_form[]{
      {0.1, 0.75717136015312994339}, {0.5, 0.2014522033336686888}, {0.9, 0.0073108103345282100357}};
  const Machine machine{0.2};
  for (const double omega : {0.7, 1.3, 2.1})
    for (const auto& [vbar, g] : closed_form) {
      const DesignAnswer answer =
          machine.solve(1 - machine.share(omega) * g, vbar * machine.velocity(omega), 0.1, 30);
      BOOST_TEST(std::abs(turn * answer.value / omega - 1) < 2e-13 / (1 - vbar));
      BOOST_TEST(!answer.largest_frequency.has_value());
    }
}

// (4): the force of the height that is left below the mount.
BOOST_AUTO_TEST_CASE(the_least_load_is_what_the_mount_leaves_of_the_amplitude) {
  const Machine machine{0.2};
  const design::NormalContact contact(machine.problem());
  for (const double omega : {0.7, 2.1, 5.0})
    BOOST_TEST(std::abs(contact.least_force(0.2, omega) / (kn * machine.height(omega)) - 1) <
               1e-14);
}

// Between 1.7 and 3.2 the contact would open. From within that range on, the first frequency at
// which it is closed reaches what any does; a millionth of the amplitude is kept from there.
BOOST_AUTO_TEST_CASE(frequencies_at_which_the_contact_opens_are_left_out) {
  const Machine machine{0.7};
  BOOST_TEST(machine.opening(-1) == 1.67, boost::test_tools::tolerance(0.01));
  const DesignAnswer above = machine.solve(0.5, 0.01, 2, 30);
  // d omega/omega = d share/share km kn U/(2 W mn omega^2) = 1.1e-7.
  BOOST_TEST(std::abs(turn * above.value / machine.opening(1) - 1) < 2e-7);
  BOOST_TEST(turn * above.value > machine.opening(1));
  BOOST_TEST(above.at_start);
  BOOST_TEST(above.unanswered == 0);
  // From below on the answer is below.
  BOOST_TEST(turn * machine.solve(0.5, 0.01, 0.5, 30).value < machine.opening(-1));
  const auto refused = test::refusal<ModelError>([&] { machine.solve(0.5, 0.01, 2, 3); });
  BOOST_TEST(refused.find("the contact opens at all frequencies from 0.3183 Hz to 0.4775 Hz") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
