// Friction of chains of masses at random by tables of their receptance, within the error that is
// stated: no factor of that error was set on these.
// VCRIT_RANDOM_CHAINS=200 runs so many, each as four tables. VCRIT_FIRST_CHAIN begins at another
// one.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <cstdlib>

#include "answers/random_chains.hpp"
#include "answers/realised_friction.hpp"
#include "problem/problem.hpp"
#include "realisation/chains.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/system/measured_drive.hpp"
#include "stiffness/dynamic_stiffness.hpp"

BOOST_AUTO_TEST_SUITE(test_realised_random)

namespace {

using namespace vcrit;

struct Known {
  double velocity, ratio, error;
};

/// The chain's own friction, at its part of v* by Eq. (24).
Known known(const test::RandomChain& chain) {
  const Problem problem(chain.scene);
  const auto system = simulation::system_of(problem);
  const std::complex<double> r = chain.receptance(1);
  const std::complex<double> give =
      1.0 / dynamic_stiffness(system.contact, 1.0) + r / (1.0 - chain.body * r);
  const double velocity = chain.velocity_part * system.friction *
                          std::abs(system.normal_force_amplitude) * std::abs(give);
  const auto state = simulation::steady_state(system, velocity);
  return {velocity, state.friction_ratio, state.friction_ratio_error};
}

}  // namespace

BOOST_AUTO_TEST_CASE(chains_at_random_within_the_stated_error) {
  const char* asked = std::getenv("VCRIT_RANDOM_CHAINS");
  const char* first = std::getenv("VCRIT_FIRST_CHAIN");
  const int from = first ? std::atoi(first) : 0, count = asked ? std::atoi(asked) : 4;
  struct Kind {
    double last, noise;
  };
  // An estimate, not a bound: of 320 tables two were outside, by up to 1.5 times
  // (docs/simulation.md). None of the first four chains is.
  int outside = 0;
  for (int number = from; number < from + count; ++number) {
    const test::RandomChain chain = test::random_chain(number);
    const Known own = known(chain);
    for (const Kind kind : {Kind{8, 0}, Kind{1.5, 0}, Kind{8, 0.01}, Kind{1.5, 0.01}}) {
      Scene scene = chain.scene;
      scene.drive.reset();
      scene.receptance =
          test::table_of(chain, kind.last, kind.noise, static_cast<unsigned>(number));
      const Problem problem(scene);
      const auto state = simulation::steady_state(simulation::system_of(problem), own.velocity);
      const RealisedFriction found = realised_friction(problem, own.velocity);
      const double off = std::abs(state.friction_ratio - own.ratio);
      const double stated = own.error + state.friction_ratio_error + found.error;
      BOOST_TEST_MESSAGE(chain.id << " to " << kind.last << " noise " << kind.noise << " off "
                                  << off << " stated " << stated << " factor " << off / stated);
      if (off > stated) ++outside;
      BOOST_TEST(off <= 4 * stated, chain.id << " to " << kind.last << " omega, noise "
                                             << kind.noise << ": off by " << off << ", stated "
                                             << stated);
    }
  }
  BOOST_TEST(outside <= count / 10);
}

BOOST_AUTO_TEST_SUITE_END()
