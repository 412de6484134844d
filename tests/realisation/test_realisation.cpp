// What is asked for beside the table (order, static compliance), and that any table comes to an
// end.
#include "realisation/realisation.hpp"

#include <boost/test/unit_test.hpp>

#include "chains.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_realisation)

namespace {

using namespace vcrit::realisation;
using vcrit::Receptance;
using vcrit::test::chain;
using vcrit::test::refused;
using vcrit::test::table_of;

Receptance table_with(int rows, double decades, double noise) {
  const vcrit::test::Chain drive = chain("C-two-01");
  Receptance table{"table", {}};
  std::mt19937_64 engine(3);
  for (int i = 0; i < rows; ++i) {
    const double omega = std::pow(10, decades * (static_cast<double>(i) / (rows - 1) - 0.5));
    const std::complex<double> r = drive.receptance(omega);
    const auto off = [&] {
      return noise * std::abs(r) * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1);
    };
    table.rows.push_back({omega, r.real() + off(), std::min(r.imag() + off(), 0.0)});
  }
  return table;
}

Receptance with_order(Receptance table, int order) {
  table.order = order;
  return table;
}

void check_ends(const Receptance& table) {
  const Realisation found(table);
  BOOST_TEST(std::isfinite(found.misfit()));
  for (const double omega : {0.3, 1.0, 40.0}) {
    BOOST_TEST(std::isfinite(std::abs(found.response(omega))));
    BOOST_TEST(std::isfinite(found.error(omega)));
    BOOST_TEST(found.response(omega).imag() <= 0);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(few_rows_and_many) {
  for (const int rows : {2, 3, 4, 7}) check_ends(table_with(rows, 1, 0));
  check_ends(table_with(20000, 1.5, 0));
}

BOOST_AUTO_TEST_CASE(noise_of_a_tenth_and_twenty_decades) {
  check_ends(table_with(200, 1.5, 0.1));
  check_ends(table_with(400, 20, 0));
  check_ends(table_with(400, 20, 0.1));
}

BOOST_AUTO_TEST_CASE(the_same_response_in_all_rows_is_a_spring) {
  Receptance table{"spring", {}};
  for (int i = 0; i < 50; ++i) table.rows.push_back({1.0 + i, 0.25, 0});
  const Realisation found(table);
  BOOST_TEST(found.pairs() == 0);
  // alpha^2 is a square root squared, and tau a billionth of the least period.
  BOOST_TEST(std::abs(found.response(7) - 0.25) < 1e-8);
}

BOOST_AUTO_TEST_CASE(an_order_is_kept) {
  const Receptance table = table_of(chain("C-three-01"), 8, 0);
  const Realisation free(table), one(with_order(table, 1));
  BOOST_TEST(one.pairs() == 1);
  BOOST_TEST(Realisation(with_order(table, 4)).pairs() == 4);
  BOOST_TEST(one.misfit() > 100 * free.misfit());
  // docs/simulation.md: eight times where the rows are no such structure's.
  BOOST_TEST(free.caution() == 1);
  BOOST_TEST(one.caution() == 8);
  for (const Realisation* found : {&free, &one}) {
    const Deviation part = found->deviation(2);
    const double sum = part.misfit + 2 * part.rivals + 4 * part.noise + part.hidden;
    BOOST_TEST(std::abs(found->error(2) / (found->caution() * sum) - 1) < 1e-14);
  }
  BOOST_TEST(refused([&] { Realisation(with_order(table_with(3, 1, 0), 5)); }, "order = 5"));
}

BOOST_AUTO_TEST_CASE(a_static_compliance_changes_nothing_within_the_rows) {
  const Receptance table = table_of(chain("C-two-01"), 8, 0);
  const Realisation plain(table);
  const double own = plain.response(0).real();
  Receptance resting = table;
  resting.static_compliance = 50 * own;
  const Realisation soft(resting);
  BOOST_TEST(std::abs(soft.response(0).real() / (50 * own) - 1) < 1e-12);
  // Made to be a tenth of the noise at the first row, and to fall with omega^2 from there.
  for (const int n : {1, 2, 3})
    BOOST_TEST(std::abs(soft.response(n) - plain.response(n)) <
               0.2 * plain.noise() * std::abs(plain.response(0.2)));
  resting.static_compliance = own / 2;
  BOOST_TEST(refused([&] { Realisation{resting}; }, "static_compliance ="));
}

BOOST_AUTO_TEST_CASE(a_table_of_zeros_is_refused) {
  Receptance table{"nothing", {{1, 0, 0}, {2, 0, 0}}};
  BOOST_TEST(refused([&] { Realisation{table}; }, "no response in any row"));
}

BOOST_AUTO_TEST_CASE(the_same_table_is_fitted_once) {
  const Receptance table = table_of(chain("C-two-02"), 8, 0);
  BOOST_TEST(realised(table) == realised(table));
  BOOST_TEST(realised(table) != realised(with_order(table, 1)));
}

BOOST_AUTO_TEST_SUITE_END()
