// Random drives of two to five masses, body included, against their equations of motion, written
// here node by node from the same list of edges and integrated by GSL's rk8pd at 1e-13 from rest
// until the motion repeats itself. Each event is located within its step. Nothing is shared but the
// numbers. VCRIT_DRIVES in the environment takes the place of the number of drives.
#include <gsl/gsl_odeiv2.h>

#include <Eigen/Core>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "linear/elimination.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_masses_random)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

constexpr int far_end = -1;

// A spring and a damper in parallel, and a relaxing branch where its time is above 0.
struct Strut {
  int from = 0, to = far_end;
  double k = 1, c = 0, k_branch = 0, time = 0;
};

struct RandomDrive {
  int masses = 2, massless = 0;  // nodes: first those with masses, 0 the body
  std::vector<double> mass;
  std::vector<Strut> struts;
  // Contact: a spring, and a damper or a branch where these are above 0.
  double kt = 1, ct = 0, kt_branch = 0, t_branch = 0;
  double amplitude = 0.5, share = 0.5;
};

RandomDrive draw(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  const auto whole = [&](int low, int high) {
    return low + static_cast<int>(uniform(0, high - low + 1));
  };
  RandomDrive drive;
  drive.masses = whole(2, 5);
  drive.massless = whole(0, 2);
  drive.mass.push_back(std::pow(10, uniform(-1.7, 0.2)));  // a light body is lively
  for (int i = 1; i < drive.masses; ++i) drive.mass.push_back(uniform(0.1, 1.5));
  const auto strut = [&](int from, int to) {
    const double k = std::pow(10, uniform(-0.5, 0.8));
    Strut one{from, to, k, std::pow(10, uniform(-3, -0.7)) * std::sqrt(k)};
    if (uniform(0, 1) < 0.3) {
      one.k_branch = uniform(0.2, 4);
      one.time = std::pow(10, uniform(-0.7, 0.7));
    }
    drive.struts.push_back(one);
  };
  const int nodes = drive.masses + drive.massless;
  for (int i = 1; i < nodes; ++i) strut(i, whole(0, i - 1));
  for (int i = drive.masses; i < nodes; ++i) strut(i, far_end);  // no dead end without a mass
  strut(whole(0, drive.masses - 1), far_end);
  for (int extra = whole(0, 2); extra > 0; --extra) {
    const int from = whole(0, nodes - 1), to = whole(far_end, from - 1);
    strut(from, to);
  }
  drive.kt = uniform(0.5, 3);
  const int kind = whole(0, 2);
  if (kind == 1) drive.ct = uniform(0.1, 2);
  if (kind == 2) drive.kt_branch = uniform(0.3, 3), drive.t_branch = uniform(0.2, 4);
  drive.amplitude = uniform(0.3, 0.95);
  drive.share = std::pow(10, uniform(-2, -0.02));
  return drive;
}

constexpr double coefficient = 0.5;

test::SceneText scene_text(const RandomDrive& drive) {
  test::SceneText text{.normal = "kn",
                       .tangential = "kt",
                       .network = "frame",
                       .mass = drive.mass[0],
                       .angular_frequency = 1,
                       .amplitude = drive.amplitude,
                       .indentation = 1,
                       .coefficient = coefficient,
                       .elements = {{"kn", 1}, {"kt", drive.kt}}};
  if (drive.ct > 0) {
    text.tangential = "kt | ct";
    text.elements.emplace_back("ct", drive.ct);
  }
  if (drive.kt_branch > 0) {
    text.tangential = "kt | (kb - cb)";
    text.elements.emplace_back("kb", drive.kt_branch);
    text.elements.emplace_back("cb", drive.kt_branch * drive.t_branch);
  }
  const auto name = [](int node) {
    return node == far_end ? "\"housing\""
           : node == 0     ? "\"body\""
                           : "\"n" + std::to_string(node) + "\"";
  };
  std::string edges;
  for (std::size_t i = 0; i < drive.struts.size(); ++i) {
    const Strut& one = drive.struts[i];
    const std::string n = std::to_string(i);
    text.elements.emplace_back("k" + n, one.k);
    text.elements.emplace_back("c" + n, one.c);
    std::string form = "k" + n + " | c" + n;
    if (one.time > 0) {
      form += " | (kx" + n + " - cx" + n + ")";
      text.elements.emplace_back("kx" + n, one.k_branch);
      text.elements.emplace_back("cx" + n, one.k_branch * one.time);
    }
    edges += "[\"" + form + "\", " + name(one.from) + ", " + name(one.to) + "], ";
  }
  for (int i = 1; i < drive.masses; ++i) {
    const std::string symbol = "m" + std::to_string(i);
    text.elements.emplace_back(symbol, drive.mass[static_cast<std::size_t>(i)]);
    edges += "[\"mass(" + symbol + ")\", " + name(i) + ", \"ground\"], ";
  }
  text.more = "[networks.frame]\nterminals = [\"body\", \"housing\"]\nedges = [" + edges + "]\n";
  return text;
}

// y = (q, v of masses | p of massless nodes | branch forces | e, r of the contact | integral of F),
// in the frame of the far end. mode: +1 slip, -1 slip backward, 0 stick.
class Motions {
 public:
  Motions(const RandomDrive& drive, double velocity)
      : drive_(drive), velocity_(velocity), n_(drive.masses), m_(drive.massless) {
    for (const Strut& one : drive.struts) branch_.push_back(one.time > 0 ? branches_++ : -1);
    inner_.setZero(m_, m_);
    for (const Strut& one : drive.struts) {
      const int a = one.from - n_, b = one.to - n_;
      if (a >= 0) inner_(a, a) += one.c;
      if (b >= 0) inner_(b, b) += one.c;
      if (a >= 0 && b >= 0) inner_(a, b) -= one.c, inner_(b, a) -= one.c;
    }
    inverse_ = linear::Lu<double>(inner_).inverse();
  }

  int size() const { return 2 * n_ + m_ + branches_ + 3; }
  int mode = 0;

  double bound(double t) const { return coefficient * (1 + drive_.amplitude * std::cos(t)); }
  double bound_rate(double t) const { return -coefficient * drive_.amplitude * std::sin(t); }

  double force(double t, const double* y) const {
    if (mode != 0) return mode * bound(t);
    const double e = y[contact()], r = y[contact() + 1];
    return drive_.kt * e + r + drive_.ct * (velocity_ + y[n_]);
  }

  double strain_rate(double t, const double* y) const {
    if (mode == 0) return velocity_ + y[n_];
    const double e = y[contact()], r = y[contact() + 1];
    if (drive_.ct > 0) return (force(t, y) - drive_.kt * e - r) / drive_.ct;
    const double creep = drive_.kt_branch > 0 ? r / drive_.t_branch : 0;
    return (mode * bound_rate(t) + creep) / (drive_.kt + drive_.kt_branch);
  }

  // Reaches 0 from below where the mode ends.
  double event(double t, const double* y) const {
    if (mode != 0) return -mode * (velocity_ + y[n_] - strain_rate(t, y));
    return std::abs(force(t, y)) - bound(t);
  }

  void rates(double t, const double* y, double* dydt) const {
    const double *q = y, *v = y + n_, *p = y + 2 * n_, *f = p + m_;
    const auto place = [&](int i) { return i == far_end ? 0.0 : i < n_ ? q[i] : p[i - n_]; };
    std::array<double, 16> pull{}, speed{};
    for (int i = 0; i < n_; ++i) speed[static_cast<std::size_t>(i)] = v[i];
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    // Massless nodes: their dampers take what springs and branches pull and masses drag.
    Eigen::VectorXd left = Eigen::VectorXd::Zero(m_);
    for (std::size_t i = 0; i < drive_.struts.size(); ++i) {
      const Strut& one = drive_.struts[i];
      double tension = one.k * (place(one.from) - place(one.to));
      if (branch_[i] >= 0) tension += f[branch_[i]];
      const auto of_mass = [&](int node) {
        return node != far_end && node < n_ ? one.c * v[node] : 0.0;
      };
      if (one.from >= n_) left[one.from - n_] -= tension - of_mass(one.to);
      if (one.to >= n_) left[one.to - n_] += tension + of_mass(one.from);
    }
    const Eigen::VectorXd inner = inverse_ * left;
    for (int i = 0; i < m_; ++i) speed[at(n_ + i)] = inner[i];
    const auto moving = [&](int i) { return i == far_end ? 0.0 : speed[at(i)]; };
    for (std::size_t i = 0; i < drive_.struts.size(); ++i) {
      const Strut& one = drive_.struts[i];
      const double stretching = moving(one.from) - moving(one.to);
      double tension = one.k * (place(one.from) - place(one.to)) + one.c * stretching;
      if (branch_[i] >= 0) {
        tension += f[branch_[i]];
        dydt[2 * n_ + m_ + branch_[i]] = one.k_branch * stretching - f[branch_[i]] / one.time;
      }
      pull[at(one.from)] -= tension;
      if (one.to != far_end) pull[at(one.to)] += tension;
    }
    const double friction = force(t, y), strain = strain_rate(t, y);
    pull[0] -= friction;
    for (int i = 0; i < n_; ++i) {
      dydt[i] = v[i];
      dydt[n_ + i] = pull[at(i)] / drive_.mass[at(i)];
    }
    for (int i = 0; i < m_; ++i) dydt[2 * n_ + i] = speed[at(n_ + i)];
    const double r = y[contact() + 1];
    dydt[contact()] = strain;
    dydt[contact() + 1] =
        drive_.kt_branch > 0 ? drive_.kt_branch * strain - r / drive_.t_branch : 0;
    dydt[contact() + 2] = friction;
  }

 private:
  int contact() const { return 2 * n_ + m_ + branches_; }

  const RandomDrive& drive_;
  double velocity_;
  int n_, m_, branches_ = 0;
  std::vector<int> branch_;
  Eigen::MatrixXd inner_, inverse_;
};

class Integrator {
 public:
  explicit Integrator(Motions& motions)
      : motions_(motions),
        system_{rates, nullptr, static_cast<std::size_t>(motions.size()), &motions},
        step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, system_.dimension)),
        control_(gsl_odeiv2_control_y_new(1e-13, 1e-13)),
        evolve_(gsl_odeiv2_evolve_alloc(system_.dimension)) {}
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;
  ~Integrator() {
    gsl_odeiv2_evolve_free(evolve_);
    gsl_odeiv2_control_free(control_);
    gsl_odeiv2_step_free(step_);
  }

  // From t on until `end`, from event to event.
  void run(double t, double end, std::vector<double>& y) {
    while (t < end) {
      const std::vector<double> before = y;
      const double from = t;
      h_ = std::min(h_, longest);
      gsl_odeiv2_evolve_apply(evolve_, control_, step_, &system_, &t, end, &h_, y.data());
      const bool old = from == switched_;  // the event that began this mode is still at its zero
      if (!(motions_.event(t, y.data()) > (old ? 1e-14 : 0))) continue;
      if (old) {  // it may leave its zero to the wrong side by rounding; else it is a new one
        if (motions_.event(t, y.data()) < 1e-12) continue;
      }
      t = locate(from, before, t - from, y);
      const int mode = motions_.mode;
      motions_.mode = mode != 0 ? 0 : motions_.force(t, y.data()) > 0 ? 1 : -1;
      switched_ = t;
      ++events;
      gsl_odeiv2_step_reset(step_);
      gsl_odeiv2_evolve_reset(evolve_);
      h_ = 1e-3;
    }
  }

  int events = 0;

 private:
  // No event is missed that is farther from its neighbour.
  static constexpr double longest = 0.02;

  static int rates(double t, const double* y, double* dydt, void* self) {
    static_cast<Motions*>(self)->rates(t, y, dydt);
    return 0;
  }

  double locate(double from, const std::vector<double>& before, double h, std::vector<double>& y) {
    double low = 0, high = h;
    for (int i = 0; i < 100 && high - low > 1e-15 * (1 + from); ++i) {
      const double middle = 0.5 * (low + high);
      advance(from, before, middle, y);
      (motions_.event(from + middle, y.data()) > 0 ? high : low) = middle;
    }
    advance(from, before, high, y);
    return from + high;
  }

  void advance(double from, const std::vector<double>& before, double h, std::vector<double>& y) {
    y = before;
    std::vector<double> error(y.size());
    gsl_odeiv2_step_reset(step_);
    gsl_odeiv2_step_apply(step_, from, h, y.data(), error.data(), nullptr, nullptr, &system_);
  }

  Motions& motions_;
  gsl_odeiv2_system system_;
  gsl_odeiv2_step* step_;
  gsl_odeiv2_control* control_;
  gsl_odeiv2_evolve* evolve_;
  double h_ = 1e-3, switched_ = -1;
};

struct Repeated {
  double ratio = 0, change = 0;
  int events = 0;
};

// From rest, period by period. `change`: by which the mean force changed over the last period; what
// is left to come is that over 1 - rho, rho the share that a period leaves.
Repeated integrated(const RandomDrive& drive, double velocity) {
  Motions motions(drive, velocity);
  Integrator integrator(motions);
  std::vector<double> y(static_cast<std::size_t>(motions.size()));
  for (int i = 0; i < drive.masses; ++i) y[static_cast<std::size_t>(drive.masses + i)] = -velocity;
  // Two pi is no double, and time goes from 0 on in each period, so that no phase is lost.
  constexpr double period = 2 * std::numbers::pi;
  Repeated result;
  for (int n = 0; n < 1500; ++n) {
    const std::vector<double> before = y;
    y.back() = 0;
    integrator.events = 0;
    integrator.run(0, period, y);
    const double ratio = y.back() / (period * coefficient);
    result.change = std::abs(ratio - result.ratio);
    result.ratio = ratio;
    result.events = integrator.events;
    double moved = 0;
    for (std::size_t i = 0; i + 1 < y.size(); ++i)
      moved = std::max(moved, std::abs(y[i] - before[i]));
    if (moved < 1e-12 && result.change < 1e-12) break;
  }
  return result;
}

int drives() {
  const char* given = std::getenv("VCRIT_DRIVES");
  return given == nullptr ? 14 : std::atoi(given);
}

}  // namespace

// The integration errs by 1e-13 a step, over a thousand steps a period, of which the slowest motion
// here keeps up to 0.97 a period: 1e-13 x 1000/0.03 = 3e-9 at the worst, and half of that in the
// mean of a force of 1/2.
BOOST_AUTO_TEST_CASE(the_friction_of_random_drives_is_that_of_an_integration) {
  std::mt19937 random(20240611);
  int done = 0, lively = 0;
  while (done < drives()) {
    const RandomDrive drive = draw(random);
    const test::SceneText text = scene_text(drive);
    const System system = system_of(test::scene_of(text));
    double slowest = 1e300;
    for (const std::complex<long double>& pole : system.masses->motion.poles)
      slowest = std::min(slowest, static_cast<double>(-pole.real()));
    if (slowest < 0.005) continue;  // it would take the integration too long
    ++done;
    BOOST_TEST_CONTEXT("drive " << done << "\n" << test::to_toml(text)) {
      const double velocity = drive.share * sliding_threshold(system).drive_velocity;
      const SteadyState sliding = steady_state(system, velocity, Start::sliding);
      const SteadyState rest = steady_state(system, velocity, Start::rest);
      const Repeated other = integrated(drive, velocity);
      BOOST_TEST(std::abs(sliding.friction_ratio - other.ratio) < 3e-9);
      BOOST_TEST(std::abs(rest.friction_ratio - sliding.friction_ratio) <=
                 rest.friction_ratio_error + sliding.friction_ratio_error);
      BOOST_TEST(sliding.events.size() == static_cast<std::size_t>(other.events));
      const auto energy = energy_balance(system, velocity);
      BOOST_REQUIRE(energy);
      BOOST_TEST(std::abs(energy->drive - energy->friction - energy->dampers) <= energy->error);
      if (other.events > 2) ++lively;
    }
  }
  if (drives() >= 200) BOOST_TEST(lively > 0);
}

BOOST_AUTO_TEST_SUITE_END()
