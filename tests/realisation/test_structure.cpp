// The structure: its matrices, its response against a chain worked out by hand, the derivatives of
// the response against finite differences.
#include "realisation/structure.hpp"

#include <boost/test/unit_test.hpp>
#include <random>

#include "linear/orthogonal.hpp"

BOOST_AUTO_TEST_SUITE(test_structure)

namespace {

using namespace vcrit::realisation;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd drawn_parameters(const StructureShape& shape, unsigned seed) {
  std::mt19937_64 engine(seed);
  VectorXd parameters(shape.parameters());
  for (double& each : parameters) each = static_cast<double>(engine() >> 11) * 0x1p-52 - 1;
  return parameters;
}

Rows some_rows() {
  Rows rows;
  rows.omega = VectorXd::LinSpaced(9, 0.1, 2);
  rows.value = Eigen::VectorXcd::Constant(9, {1, -0.3});
  rows.weight = VectorXd::LinSpaced(9, 0.5, 1.5);
  return rows;
}

const std::vector<StructureShape> shapes{
    {0, Damping::modal}, {1, Damping::modal},   {1, Damping::coupled}, {3, Damping::modal},
    {3, Damping::full},  {3, Damping::coupled}, {2, Damping::coupled}};

}  // namespace

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_finite_differences) {
  const Rows rows = some_rows();
  for (const StructureShape& shape : shapes) {
    const VectorXd at = drawn_parameters(shape, 5);
    VectorXd residual, up, down;
    MatrixXd slope;
    residuals(shape, rows, at, residual, &slope);
    for (Index k = 0; k < shape.parameters(); ++k) {
      // Central: h^2/6 times a third derivative (of resonances of damping 1 at most some 1e3), and
      // rounding of 1e-16/h.
      constexpr double h = 1e-6;
      VectorXd moved = at;
      moved[k] = at[k] + h;
      residuals(shape, rows, moved, up, nullptr);
      moved[k] = at[k] - h;
      residuals(shape, rows, moved, down, nullptr);
      const double off = ((up - down) / (2 * h) - slope.col(k)).cwiseAbs().maxCoeff();
      BOOST_TEST(off < 1e-7 * (1 + slope.col(k).cwiseAbs().maxCoeff()),
                 "parameter " << k << " of " << shape.parameters() << " off by " << off);
    }
  }
}

BOOST_AUTO_TEST_CASE(parameters_and_structure_are_the_same) {
  for (const StructureShape& shape : shapes) {
    const VectorXd at = drawn_parameters(shape, 8);
    const VectorXd back = parameters_of(shape, structure_of(shape, at));
    BOOST_TEST((back - at).cwiseAbs().maxCoeff() < 1e-15);  // exp and log of numbers below 1
  }
}

BOOST_AUTO_TEST_CASE(whatever_the_parameters_it_stores_and_loses_energy_only) {
  for (unsigned seed = 0; seed < 50; ++seed)
    for (const StructureShape& shape : shapes) {
      const Structure structure = structure_of(shape, 3 * drawn_parameters(shape, seed));
      const VectorXd stiffness =
                         vcrit::linear::symmetric_eigen(structure.stiffness_matrix()).values,
                     damping = vcrit::linear::symmetric_eigen(structure.damping_matrix()).values;
      // Eigenvalues are right to a few roundings of the greatest.
      BOOST_TEST(stiffness.minCoeff() > -1e-13 * stiffness.maxCoeff());
      BOOST_TEST(damping.minCoeff() > -1e-13 * damping.maxCoeff());
      for (const double omega : {0.01, 0.7, 1.0, 30.0}) {
        const auto response = structure.response(omega);
        BOOST_TEST(response.imag() <= 1e-13 * std::abs(response));
      }
    }
}

// Parameters that no row could tell from others would lose the digits of what moves.
BOOST_AUTO_TEST_CASE(no_parameter_leaves_what_rows_can_tell) {
  const Rows rows = some_rows();
  for (const StructureShape& shape : shapes) {
    VectorXd parameters = 1e9 * drawn_parameters(shape, 4);
    keep_in_reach(shape, rows, parameters);
    const Structure structure = structure_of(shape, parameters);
    // Each entry of L L^T is a sum of at most three products of two entries of L.
    if (shape.modes > 0)
      BOOST_TEST(
          structure.damping_matrix().bottomRightCorner(shape.modes, shape.modes).maxCoeff() <=
          3.001e5 * rows.last());
    BOOST_TEST(structure.tau <= 1e5 / rows.first());
    for (const double w : structure.frequency) BOOST_TEST((w > 1e-4 && w < 1e4));
  }
}

BOOST_AUTO_TEST_CASE(a_spring_in_series_with_two_masses) {
  // R = 1/(4 + 0.2 s) + 1/(2 s^2 + 0.3 s + 5), phi^2 = 1/2, w^2 = 5/2, c = 0.15.
  Structure structure;
  structure.alpha = 0.5, structure.tau = 0.05;
  structure.phi = VectorXd::Constant(1, std::sqrt(0.5));
  structure.frequency = VectorXd::Constant(1, std::sqrt(2.5));
  structure.factor = MatrixXd::Constant(1, 1, std::sqrt(0.15));
  structure.lean = VectorXd::Zero(1);
  const std::complex<double> s(0, 1.3);
  const auto expected = 1.0 / (4.0 + 0.2 * s) + 1.0 / (2.0 * s * s + 0.3 * s + 5.0);
  BOOST_TEST(std::abs(structure.response(1.3) - expected) <
             1e-15 * 4);  // few operations on numbers about 1
  BOOST_TEST(std::abs(structure.static_compliance() - 0.45) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
