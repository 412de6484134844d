// The response of a chain of masses comes back from a table of it, within the stated error: at the
// oscillation's frequency omega = 1, at 2 and 3 omega, within the rows and beyond them.
// VCRIT_CHAINS=82 runs all rows of the table.
#include <boost/test/unit_test.hpp>
#include <cstdlib>

#include "chains.hpp"
#include "realisation/realisation.hpp"

BOOST_AUTO_TEST_SUITE(test_chains)

namespace {

using vcrit::realisation::Realisation;
using vcrit::test::Chain;
using vcrit::test::chains;
using vcrit::test::table_of;

// Every n-th chain: of all groups.
std::vector<Chain> picked(std::size_t usual) {
  const char* asked = std::getenv("VCRIT_CHAINS");
  const std::vector<Chain> all = chains();
  const std::size_t count = asked ? std::stoul(asked) : usual;
  std::vector<Chain> some;
  for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
  return some;
}

// Tuned absorbers have R(i omega) = 0: what is stated is absolute, so that does no harm.
void check_chain(const Chain& chain, double last, double noise) {
  BOOST_TEST_CONTEXT(chain.id << " to " << last << " omega, noise " << noise) {
    const Realisation found(table_of(chain, last, noise));
    for (const int n : {1, 2, 3}) {
      const double off = std::abs(found.response(n) - chain.receptance(n));
      BOOST_TEST(off <= found.error(n),
                 n << " omega: off by " << off << ", stated " << found.error(n));
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(five_digits_far_beyond_the_oscillation) {
  for (const Chain& chain : picked(8)) check_chain(chain, 8, 0);
}

BOOST_AUTO_TEST_CASE(five_digits_to_one_and_a_half_times_its_frequency) {
  for (const Chain& chain : picked(8)) check_chain(chain, 1.5, 0);
}

BOOST_AUTO_TEST_CASE(noise_of_a_hundredth) {
  for (const Chain& chain : picked(8)) check_chain(chain, 8, 0.01);
}

BOOST_AUTO_TEST_CASE(noise_of_a_hundredth_to_one_and_a_half_times_its_frequency) {
  for (const Chain& chain : picked(8)) check_chain(chain, 1.5, 0.01);
}

BOOST_AUTO_TEST_CASE(five_digits_give_five_digits_back) {
  // Rounding to five digits is at most 5e-5 of |R| in real and imaginary part: 7.1e-5 together, and
  // the fit is off by less than the rows are.
  for (const char* id : {"C-two-01", "C-two-14", "C-three-04", "C-three-12", "C-absorber-02"}) {
    const Chain drive = vcrit::test::chain(id);
    const Realisation found(table_of(drive, 8, 0));
    BOOST_TEST(found.misfit() < 1.5e-4, id << ": misfit " << found.misfit());
    for (const int n : {1, 2, 3})
      BOOST_TEST(std::abs(found.response(n) / drive.receptance(n) - 1.0) < 7.1e-5);
  }
}

BOOST_AUTO_TEST_SUITE_END()
