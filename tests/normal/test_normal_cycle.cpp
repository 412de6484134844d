// The normal force of a contact that opens: 25-digit references, closed forms, and random networks
// whose cycles close by another way to move freely.
#include "normal/normal_cycle.hpp"

#include <Eigen/Core>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "linear/elimination.hpp"
#include "simulation/random_systems.hpp"
#include "simulation/reference_tables.hpp"
#include "support/exponential.hpp"
#include "support/table.hpp"

BOOST_AUTO_TEST_SUITE(test_normal_cycle)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

constexpr double u = 1.1e-16, period = 2 * std::numbers::pi;

struct Reference {
  std::string name;
  Relaxation network;
  Indentation indentation;
  double begin, duration, mean;
};

std::vector<Reference> references() {
  std::vector<Reference> result;
  for (const auto& c : test::rows_of("normal_cycle.csv", 11))
    result.push_back({c.at(0),
                      reference::network("1 " + c.at(1) + " " + c.at(2)),
                      {std::stod(c.at(3)), std::stod(c.at(4))},
                      std::stod(c.at(5)),
                      std::stod(c.at(6)),
                      std::stod(c.at(7))});
  return result;
}

NormalCycle cycle_of(const Relaxation& network, const Indentation& indentation) {
  return normal_cycle(contact_modes(network), indentation);
}

double depth(const Indentation& indentation, double time) {
  return indentation.mean + indentation.amplitude * std::cos(time);
}

// The same cycle without Kelvin units: branch forces, and the deformation where a damper holds it.
// Free, it moves by the exponential of its matrix.
class Witness {
 public:
  Witness(const Relaxation& form, const Indentation& indentation, const NormalCycle& cycle)
      : form_(form), indentation_(indentation), cycle_(cycle), n_(count(form)), matrix_(n_, n_) {
    const bool held = form.damper > 0;
    const Eigen::Index first = held ? 1 : 0, n = n_ - first;
    Eigen::VectorXd k(n), rates(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      k[i] = form.branches[static_cast<std::size_t>(i)].stiffness;
      rates[i] = 1 / form.branches[static_cast<std::size_t>(i)].time;
    }
    if (held) {
      matrix_.row(0).setConstant(-1 / form.damper);
      matrix_(0, 0) *= form.equilibrium;
      matrix_.bottomRows(n) = k * matrix_.row(0);
      matrix_.bottomRightCorner(n, n).diagonal() -= rates;
    } else {
      // (1 + k 1^T/k_inf) f' = -f/tau
      matrix_ = linear::Lu<double>(Eigen::MatrixXd::Identity(n, n) +
                                   k * Eigen::RowVectorXd::Ones(n) / form.equilibrium)
                    .inverse() *
                Eigen::MatrixXd((-rates).asDiagonal());
    }
  }

  // State and force, a time after the contact closed.
  Eigen::VectorXd pressed(const NormalCycle::Touch& touch, double after) const {
    Eigen::VectorXd state(n_);
    const double time = touch.begin + after;
    if (form_.damper > 0) state[0] = depth(indentation_, time);
    for (std::size_t i = 0; i < form_.branches.size(); ++i) {
      const auto& [stiffness, relaxation_time] = form_.branches[i];
      const std::complex<double> rate(1 / relaxation_time, 1);
      const double swing =
          (stiffness * indentation_.amplitude * std::polar(1.0, time + std::numbers::pi / 2) / rate)
              .real();
      // Rates grow where times fall, and the spring comes first.
      const double decay = touch.decays[form_.branches.size() - i];
      state[n_ - static_cast<Eigen::Index>(form_.branches.size() - i)] =
          swing + decay * std::exp(-after / relaxation_time);
    }
    return state;
  }

  double reaction(const NormalCycle::Touch& touch, double after) const {
    double force = (cycle_.swing * std::polar(1.0, touch.begin + after)).real() + touch.decays[0];
    for (std::size_t i = 0; i < form_.branches.size(); ++i)
      force += touch.decays[form_.branches.size() - i] * std::exp(-after / form_.branches[i].time);
    return force;
  }

  Eigen::VectorXd freed(const Eigen::VectorXd& state, double duration) const {
    if (n_ == 0) return state;
    return test::exponential((matrix_ * duration).cast<long double>()).cast<double>() * state;
  }

  double deformation(const Eigen::VectorXd& state) const {
    return form_.damper > 0 ? state[0] : -state.sum() / form_.equilibrium;
  }

 private:
  static Eigen::Index count(const Relaxation& form) {
    return static_cast<Eigen::Index>(form.branches.size()) + (form.damper > 0 ? 1 : 0);
  }

  const Relaxation& form_;
  Indentation indentation_;
  const NormalCycle& cycle_;
  Eigen::Index n_;
  Eigen::MatrixXd matrix_;
};

// An elastic network: contact while cos t > -mean/amplitude, over an angle acos(-mean/amplitude) to
// both sides.
void check_elastic(const Relaxation& network, double mean) {
  const NormalCycle cycle = cycle_of(network, {2 * mean, 2});
  const double half = std::acos(-mean);
  const double exact = 10 * (mean * half + std::sqrt(1 - mean * mean)) / std::numbers::pi;
  BOOST_REQUIRE(cycle.touches.size() == 1u);
  BOOST_TEST(std::abs(cycle.mean - exact) <= cycle.error + 20 * u * std::abs(mean) * 10);
  BOOST_TEST(cycle.error <= 100 * u * 10);
  // acos loses as much as its argument is near to 1.
  BOOST_TEST(std::abs(cycle.touches[0].duration - 2 * half) <= 20 * u / std::sqrt(1 - mean * mean));
}

}  // namespace

// A period of 200 branches carries 200 changes through their matrices, 2 n^3/32 units and more:
// half of what passes between two questions whether to go on, and there are several. The modes are
// found before, as that search hears an interruption by itself.
BOOST_AUTO_TEST_CASE(the_search_can_be_interrupted) {
  struct Interrupted {};
  Relaxation network{1, 0, {}};
  for (int i = 0; i < 200; ++i) network.branches.push_back({0.01, std::pow(10, 0.03 * i - 3)});
  const ContactModes modes = contact_modes(network);
  const Interruptible asked([] { throw Interrupted{}; });
  BOOST_CHECK_THROW(normal_cycle(modes, {1, 1}), Interrupted);
}

BOOST_AUTO_TEST_CASE(agrees_with_references) {
  const auto rows = references();
  BOOST_REQUIRE(rows.size() == 11u);
  for (const Reference& row : rows) {
    const NormalCycle cycle = cycle_of(row.network, row.indentation);
    BOOST_REQUIRE(cycle.touches.size() == 1u);
    const auto& touch = cycle.touches.front();
    BOOST_TEST(std::abs(cycle.mean - row.mean) <= cycle.error, row.name);
    // Some forty rounding errors of all forces, of which the touch from far above leaves little.
    BOOST_TEST(cycle.error <= 100 * u * std::abs(cycle.swing), row.name);
    // Where the contact closes or opens, sines of an angle of at least 0.3 rad meet at an angle.
    BOOST_TEST(std::abs(touch.begin - row.begin) <= 20 * u * period, row.name);
    BOOST_TEST(std::abs(touch.duration - row.duration) <= 20 * u * period, row.name);
  }
}

BOOST_AUTO_TEST_CASE(elastic_closed_form) {
  for (const double mean : {-0.9, -0.5, -1e-6, 0.0, 1e-6, 0.5, 0.999})
    check_elastic({5, 0, {}}, mean);
}

// Dampers so weak that they are not seen, less than a rounding error of the spring: what they leave
// in the rates where the contact opens and meet is rounding alone, but far above what decides.
BOOST_AUTO_TEST_CASE(dampers_below_rounding_are_not_there) {
  for (const double mean : {-0.9, -0.5, 0.0, 0.37, 0.5, 0.9})
    for (const double weak : {1e-16, 1e-17, 1e-18, 1e-19, 1e-23, 1e-30}) {
      check_elastic({5, weak, {}}, mean);
      for (const double stiffness : {0.15, 5.0})
        check_elastic({5, 0, {{stiffness, weak / stiffness}}}, mean);
    }
}

BOOST_AUTO_TEST_CASE(contacts_that_never_open_or_never_close) {
  const Relaxation zener{1, 0, {{2, 0.7}}};
  const double dynamic = std::abs(dynamic_stiffness(zener, 1));
  const NormalCycle always = cycle_of(zener, {1, 0.99 / dynamic});
  BOOST_REQUIRE(always.touches.size() == 1u);
  BOOST_TEST(always.touches[0].duration == period);
  BOOST_TEST(always.mean == 1);
  const NormalCycle often = cycle_of(zener, {1, 1.01 / dynamic});
  BOOST_REQUIRE(often.touches.size() == 1u);
  BOOST_TEST(often.touches[0].duration < period);
  BOOST_TEST(often.mean > 1);
  const NormalCycle never = cycle_of(zener, {-1, 1});
  BOOST_TEST(never.touches.empty());
  BOOST_TEST(never.mean == 0);
}

// Random networks: what the cycle says of forces and times must close it, and the force must push,
// the gap be open.
BOOST_AUTO_TEST_CASE(random_networks_close) {
  reference::RandomSystems random(11, 2);
  int tried = 0;
  while (tried < 300) {
    Relaxation form = random.network(true);
    const Indentation indentation{random.uniform(-0.9, 1), random.logarithmic(0.3, 30)};
    if (indentation.mean + indentation.amplitude < 0.05) continue;
    if (std::abs(dynamic_stiffness(form, 1)) * indentation.amplitude <=
        1.01 * form.equilibrium * indentation.mean)
      continue;
    ++tried;
    const NormalCycle cycle = cycle_of(form, indentation);
    BOOST_REQUIRE(!cycle.touches.empty());
    const Witness witness(form, indentation, cycle);
    double size = std::abs(cycle.swing);
    for (const double decay : cycle.touches[0].decays) size += std::abs(decay);
    for (std::size_t i = 0; i < cycle.touches.size(); ++i) {
      const auto& touch = cycle.touches[i];
      const auto& next = cycle.touches[(i + 1) % cycle.touches.size()];
      // The matrix exponential loses as many roundings as its norm, up to 2 pi 10^4 here.
      const double allowed = 1e5 * u * size;
      for (int k = 1; k < 50; ++k)
        BOOST_TEST(witness.reaction(touch, touch.duration * k / 50) > -allowed);
      BOOST_TEST(std::abs(witness.reaction(touch, touch.duration)) <= allowed);
      const double parted = touch.begin + touch.duration;
      double apart = next.begin - parted;
      while (apart < 0) apart += period;
      const Eigen::VectorXd last = witness.pressed(touch, touch.duration);
      const double length = size / form.equilibrium;
      for (int k = 1; k < 50; ++k) {
        const double after = apart * k / 50;
        BOOST_TEST(witness.deformation(witness.freed(last, after)) >
                   depth(indentation, parted + after) - allowed / size * length);
      }
      const Eigen::VectorXd met = witness.freed(last, apart), expected = witness.pressed(next, 0);
      BOOST_TEST(std::abs(witness.deformation(met) - depth(indentation, next.begin)) <=
                 allowed / size * length);
      for (Eigen::Index j = form.damper > 0 ? 1 : 0; j < met.size(); ++j)
        BOOST_TEST(std::abs(met[j] - expected[j]) <= allowed);
    }
  }
}

// Integral of t sin t from 0 on.
double short_touch(double angle) {
  double term = angle * angle * angle, sum = 0;
  for (int k = 0; k < 30; ++k) {
    sum += term / (2 * k + 3);
    term *= -angle * angle / ((2 * k + 2) * (2 * k + 3));
  }
  return sum;
}

// Mean force where what relaxes takes ever so long: its branches, of stiffness k together, do not
// move, and their force has no mean. So it stands where the surface is in the mean, which open is
// at x0: <max(d - x0, 0)> = x0/k above a spring of 1, with force 1 + k.
double mean_of_frozen(double k, const Indentation& indentation) {
  double low = 0, high = std::numbers::pi;
  const auto apart = [&](double angle) { return depth(indentation, angle); };
  const auto lift = [&](double angle) {
    return indentation.amplitude / std::numbers::pi * short_touch(angle);
  };
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (lift(middle) < apart(middle) / k ? low : high) = middle;
  }
  return (1 + 1 / k) * apart(high);
}

// A weak spring below stiff branches that hardly relax: the contact is closed for a small part of a
// period, down to 1e-4 of it here. A period relaxes 1e-12 of what is slow.
BOOST_AUTO_TEST_CASE(short_touches_of_what_relaxes_slowly) {
  for (const double stiffness : {1.0, 1e2, 1e4, 1e6, 1e8, 1e10})
    for (const int branches : {1, 3, 8}) {
      Relaxation form{1, 0, {}};
      for (int j = 0; j < branches; ++j) {
        const double scale = std::pow(10, -j);
        form.branches.push_back({stiffness * scale, 1e14 * std::pow(10, 2 * j)});
      }
      double whole = 0;
      for (const MaxwellBranch& branch : form.branches) whole += branch.stiffness;
      const Indentation indentation{1.2, 1};
      const NormalCycle cycle = cycle_of(form, indentation);
      const double expected = mean_of_frozen(whole, indentation);
      BOOST_TEST(cycle.error <= 1e-7 * cycle.mean);
      BOOST_TEST(std::abs(cycle.mean - expected) <= cycle.error + 1e-12 * expected,
                 stiffness << ", " << branches << ": " << cycle.mean << " " << expected << " "
                           << cycle.error);
    }
}

// The mean force is the spring's at the mean deformation, and force goes with length: the cycle of
// a network with 24 branches over twenty decades, in units 1e9 apart.
BOOST_AUTO_TEST_CASE(twenty_decades) {
  Relaxation form{1, 0, {}};
  for (int j = 0; j < 24; ++j) form.branches.push_back({0.3, std::pow(10, -10 + 20.0 * j / 23)});
  const NormalCycle one = cycle_of(form, {1, 2}), other = cycle_of(form, {1e9, 2e9});
  BOOST_REQUIRE(one.touches.size() == 1u);
  BOOST_TEST(one.error <= 1e-12 * one.mean);
  BOOST_TEST(std::abs(other.mean / 1e9 - one.mean) <= one.error + other.error / 1e9);
}

BOOST_AUTO_TEST_SUITE_END()
