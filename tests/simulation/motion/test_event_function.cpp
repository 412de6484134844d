// The first zero of event functions: known roots, grazing, and random sums against fine sampling.
#include "simulation/motion/event_function.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace vcrit::simulation;
using std::numbers::pi;

std::optional<double> zero_of(EventFunction f, double end, bool leaving) {
  return first_zero(f, end, leaving);
}

Spectrum decays(std::vector<double> rates) { return {std::move(rates), {}}; }

EventFunction with(int order, double value, const std::vector<double>& rates,
                   const std::vector<double>& amplitudes, std::complex<double> sinusoid) {
  EventFunction f(order, value, std::abs(value));
  const auto n = static_cast<Index>(rates.size());
  f.add_modes(decays(rates), Vector::Ones(n), Vector::Map(amplitudes.data(), n), 1);
  f.add_sinusoid(sinusoid);
  return f;
}

}  // namespace

// f = -cos t: the first zero is pi/2. Phases of order 1 are good to a few rounding errors.
BOOST_AUTO_TEST_CASE(cosine) {
  const auto zero = zero_of(with(1, -1, {}, {}, {0, -1}), 10, false);
  BOOST_REQUIRE(zero);
  BOOST_TEST(std::abs(*zero - pi / 2) < 1e-15);
}

// f = -(1 - e^{-t}) + t/2 - ...: f = 0.5 t - (1 - e^{-t}) leaves 0 downwards; its zero solves
// e^{-t} = 1 - t/2, t = 2 + W(-2 e^{-2}) = 1.5936242600400400923.
BOOST_AUTO_TEST_CASE(leaving_zero_downwards) {
  const auto zero = zero_of(with(1, 0, {1, 0}, {-1, 0.5}, 0), 10, true);
  BOOST_REQUIRE(zero);
  BOOST_TEST(std::abs(*zero - 1.5936242600400400923) < 2e-15);
}

// Order 2, f = f' = 0: f = cos t - 1 + eps t^3/6 has its zero where t = 3/eps (1 + O(t^2)) if that
// is small: a stick of length 3/eps, resolved to its own relative accuracy. With f'' = -1 + ... and
// f = -t^2/2 + t^4/24 + eps t^3/6 = 0: t = 3/eps + t^2 t/12 ..., relative correction t^2/12.
BOOST_AUTO_TEST_CASE(short_sticks_keep_their_relative_accuracy) {
  for (const double eps : {1e3, 1e5, 1e7, 1e9}) {
    // f'' = -cos t + eps t, eps t as the difference of two constants is a slow decay's integral:
    // eps (1 - e^{-r t})/r -> eps t for r t << 1, r = 1e-3, relative correction r t/4.
    const double r = 1e-3;
    const auto zero = zero_of(with(2, 0, {0, r}, {eps / r, -eps / r}, {-1, 0}), 1, true);
    BOOST_REQUIRE(zero);
    const double expected = 3 / eps;
    // The constant's and the decay's amplitudes, eps/r, cancel down to 1: that loses eps/r
    // roundings.
    const double lost = 8 * 1.1e-16 * eps / r;
    BOOST_TEST(std::abs(*zero / expected - 1) <= expected * expected + r * expected + lost);
  }
}

BOOST_AUTO_TEST_CASE(maxima_below_zero_are_passed_and_above_are_found) {
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
    // f = -1 -+ gap + sin t, whose maximum is at pi/2.
    BOOST_TEST(!zero_of(with(1, -1 - gap, {}, {}, {1, 0}), 20, false).has_value());
    const auto zero = zero_of(with(1, -1 + gap, {}, {}, {1, 0}), 20, false);
    BOOST_REQUIRE(zero);
    // asin(1 - gap) = pi/2 - sqrt(2 gap)(1 + gap/12); the rounding of 1 - gap moves it by
    // u/sqrt(2 gap), that of f by a few times as much.
    const double before = std::sqrt(2 * gap);
    BOOST_TEST(std::abs(pi / 2 - *zero - before) <= before * gap + 12 * 1.1e-16 / before);
  }
}

BOOST_AUTO_TEST_CASE(a_long_wait_takes_few_steps) {
  // f = 1e-7 t - 1 + 0.5 sin t: the first zero is the first maximum that reaches: near t = 5e6.
  const auto zero = zero_of(with(1, -1, {0}, {1e-7}, {0.5, 0}), 1e9, false);
  BOOST_REQUIRE(zero);
  const double t = *zero;
  BOOST_TEST(std::abs(1e-7 * t - 1 + 0.5 * std::sin(t)) < 1e-9);
  BOOST_TEST(t > (1 - 0.5) / 1e-7 - 1);
  BOOST_TEST(t < (1 - 0.5) / 1e-7 + 2 * pi + 1);
}

// Random sums: no sample before the zero found is positive, and f is zero there.
BOOST_AUTO_TEST_CASE(random_sums_against_sampling) {
  std::mt19937 random(31);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  int found = 0;
  for (int i = 0; i < 600; ++i) {
    std::vector<double> rates, amplitudes;
    for (int j = 0; j < 3; ++j) {
      rates.push_back(std::pow(10, uniform(-3, 3)));
      amplitudes.push_back(uniform(-1, 1) * (rates.back() > 1 ? rates.back() : 1));
    }
    EventFunction f =
        with(1, -uniform(0.01, 1), rates, amplitudes, std::polar(1.0, uniform(-3, 3)));
    const double frequency = uniform(0.1, 20), decay = uniform(0, 1);
    Spectrum pair{{}, ModePair{decay, -frequency * frequency}};
    f.add_modes(pair, Vector::Ones(2), Vector{{uniform(-1, 1), uniform(-1, 1)}}, 1);
    const double end = 12;
    const auto zero = first_zero(f, end, false);
    found += zero.has_value() ? 1 : 0;
    const double until = zero.value_or(end);
    double highest = -1;
    for (int k = 1; k < 2000; ++k) {
      // Finer towards the start, where the fast terms live.
      const double t = until * std::pow(k / 2000.0, 3) * (1 - 1e-9);
      const EventFunction::Point point = f.move_to(t);
      highest = std::max(highest, point.value - point.noise);
    }
    BOOST_TEST_CONTEXT("sum " << i) {
      BOOST_TEST(highest <= 0);
      // f is continuous with slope up to some 4: a zero good to 1e-14 t leaves 1e-12.
      if (zero && *zero < end) BOOST_TEST(std::abs(f.move_to(*zero).value) < 1e-12);
    }
  }
  BOOST_TEST(found > 300);
}
