// Eigenvalues and couplings to the last row, compared with closed forms.
#include "stiffness/eigenmodes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(test_eigenmodes)

namespace {

using namespace vcrit;

constexpr slong bits = 500;

// Entries on the diagonal, next to it, and elsewhere.
SymmetricRows matrix(std::size_t size, double diagonal, double beside, double elsewhere) {
  SymmetricRows rows(size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k <= i; ++k)
      rows[i].emplace_back(k == i ? diagonal : (k + 1 == i ? beside : elsewhere), bits);
  return rows;
}

// Within 2^20 roundings of numbers of size 1.
bool agree(const BigFloat& a, const BigFloat& b) { return abs(a - b) < ldexp(1, 20 - bits); }

}  // namespace

// A row of springs with both ends held has the eigenvalues 2 - 2 cos(j pi/(n + 1)). The last of the
// n = 7 components of eigenvector j is sqrt(2/(n + 1)) sin(j n pi/(n + 1)). In doubles these closed
// forms take about six roundings: 1e-15.
BOOST_AUTO_TEST_CASE(springs_in_a_row) {
  const auto modes = modes_coupled_to_last_row(matrix(8, 2, -1, 0));
  BOOST_REQUIRE(modes.has_value());
  BOOST_REQUIRE_EQUAL(modes->size(), 7U);
  for (std::size_t j = 1; j <= 7; ++j) {
    const double angle = static_cast<double>(j) * std::numbers::pi / 8;
    const double component = std::sin(7 * angle) / 2;
    const auto& [value, squared_coupling] = (*modes)[j - 1];
    BOOST_TEST(std::abs(value.to_double() - (2 - 2 * std::cos(angle))) < 1e-15);
    BOOST_TEST(std::abs(squared_coupling.to_double() - component * component) < 1e-15);
  }
}

// The eigenvalues solve (x - 2)(x - 1) = 1, so they are (3 -+ sqrt 5)/2. The last row is (0, 1),
// and the squares of its components are (5 +- sqrt 5)/10.
BOOST_AUTO_TEST_CASE(all_bits) {
  SymmetricRows rows = matrix(3, 2, 1, 0);
  rows[1][1] = BigFloat(1, bits);
  const auto modes = modes_coupled_to_last_row(rows);
  BOOST_REQUIRE(modes.has_value());
  const BigFloat root = sqrt(BigFloat(5, bits));
  BOOST_TEST(agree((*modes)[0].value, (3 - root) / 2));
  BOOST_TEST(agree((*modes)[1].value, (3 + root) / 2));
  BOOST_TEST(agree((*modes)[0].squared_coupling, (5 + root) / 10));
  BOOST_TEST(agree((*modes)[1].squared_coupling, (5 - root) / 10));
}

// 3 on the diagonal and 1 elsewhere: the eigenvalue 2 five times, and 8 with all of the coupling.
BOOST_AUTO_TEST_CASE(multiple_eigenvalues) {
  const auto modes = modes_coupled_to_last_row(matrix(7, 3, 1, 1));
  BOOST_REQUIRE(modes.has_value());
  BOOST_REQUIRE_EQUAL(modes->size(), 6U);
  for (std::size_t j = 0; j < 5; ++j) {
    BOOST_TEST(agree((*modes)[j].value, 2));
    BOOST_TEST(agree((*modes)[j].squared_coupling, 0));
  }
  BOOST_TEST(agree((*modes)[5].value, 8));
  BOOST_TEST(agree((*modes)[5].squared_coupling, 6));
}

BOOST_AUTO_TEST_CASE(one_row_and_no_coupling) {
  const auto alone = modes_coupled_to_last_row(matrix(1, 3, 0, 0));
  BOOST_REQUIRE(alone.has_value());
  BOOST_TEST(alone->empty());
  const auto apart = modes_coupled_to_last_row(matrix(4, 3, 0, 0));
  BOOST_REQUIRE(apart.has_value());
  for (const auto& [value, squared_coupling] : *apart) {
    BOOST_TEST((value == 3));
    BOOST_TEST((squared_coupling == 0));
  }
}

BOOST_AUTO_TEST_SUITE_END()
