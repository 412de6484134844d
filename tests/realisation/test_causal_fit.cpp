// Relaxed vector fitting finds poles that are known, and the noise of rows.
#include "realisation/causal_fit.hpp"

#include <boost/test/unit_test.hpp>

#include "chains.hpp"

BOOST_AUTO_TEST_SUITE(test_causal_fit)

namespace {

using namespace vcrit::realisation;
using Complex = std::complex<double>;

vcrit::Receptance two_pairs() {
  vcrit::Receptance table{"poles", {}};
  for (int i = 0; i < 80; ++i) {
    const double omega = 0.05 * (i + 1);
    const Complex s(0, omega);
    const Complex r = 1.0 / (s * s + 0.1 * s + 1.0) + 0.3 / (s * s + 0.05 * s + 9.0) + 0.2;
    table.rows.push_back({omega, r.real(), r.imag()});
  }
  return table;
}

}  // namespace

BOOST_AUTO_TEST_CASE(poles_of_exact_rows_are_found) {
  const Rows rows = rows_of(two_pairs());
  const CausalFit fit = causal_fit(rows, 2, false);
  // The iteration converges quadratically, so what is left are roundings times the condition of
  // partial fractions, here below 1e4.
  BOOST_TEST(std::sqrt(fit.sum) < 1e-11);
  for (const Complex& known :
       {Complex(-0.05, std::sqrt(1 - 0.0025)), Complex(-0.025, std::sqrt(9 - 0.000625))}) {
    double nearest = 1;
    for (const Complex& pole : fit.poles)
      nearest = std::min(nearest, std::abs(pole * rows.frequency_unit - known));
    BOOST_TEST(nearest < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(the_noise_is_what_was_added) {
  const vcrit::test::Chain drive = vcrit::test::chain("C-three-01");
  for (const double noise : {0.003, 0.01, 0.05}) {
    const CausalFit fit = best_causal_fit(rows_of(vcrit::test::table_of(drive, 8, noise)));
    // Of 200 rows the median scatters by a twelfth, and the fit takes some of the noise: five times
    // that is a half.
    BOOST_TEST(std::abs(robust_noise(fit.left) / noise - 1) < 0.5);
  }
}

BOOST_AUTO_TEST_SUITE_END()
