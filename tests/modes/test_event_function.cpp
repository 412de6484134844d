// The first zero of event functions: known roots, grazing, and random sums against fine sampling.
#include "modes/first_zero.hpp"
#include "modes/highest.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

BOOST_AUTO_TEST_SUITE(test_event_function)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;
using std::numbers::pi;

// A sum of decays, a pair and a sinusoid with a spectrum of its own.
class Sum {
 public:
  Sum(int order, double value, const std::vector<double>& rates,
      const std::vector<double>& amplitudes, std::complex<double> sinusoid)
      : spectrum_{Vector(rates.begin(), rates.end()), {}},
        order_(order),
        value_(value),
        amplitudes_(amplitudes.begin(), amplitudes.end()),
        sinusoid_(sinusoid) {}

  void add_pair(ModePair pair, double a, double b) {
    spectrum_.pairs.push_back(pair);
    amplitudes_.push_back(a);
    amplitudes_.push_back(b);
  }
  EventFunction function(Effort* effort = nullptr) const {
    EventFunction f(spectrum_, order_, value_, std::abs(value_), effort);
    f.add_modes(Vector(amplitudes_.size(), 1.0), amplitudes_, 1);
    f.add_sinusoid(sinusoid_);
    return f;
  }
  std::optional<double> zero(double end, bool leaving = false) const {
    EventFunction f = function();
    return first_zero(f, end, leaving);
  }

 private:
  Spectrum spectrum_;
  int order_;
  double value_;
  Vector amplitudes_;
  std::complex<double> sinusoid_;
};

}  // namespace

// f = -cos t: the first zero is pi/2. Phases of order 1 are good to a few rounding errors.
BOOST_AUTO_TEST_CASE(cosine) {
  const auto zero = Sum(1, -1, {}, {}, {0, -1}).zero(10);
  BOOST_REQUIRE(zero);
  BOOST_TEST(std::abs(*zero - pi / 2) < 1e-15);
}

// A step takes as long as a dozen modes even if there is one: a light body on a spring would ring
// for a minute within a bound of ten seconds.
BOOST_AUTO_TEST_CASE(a_step_of_few_modes_is_no_less_work_than_it_is) {
  const Sum sum(1, -1, {1}, {0}, {0, -1});
  Effort two_steps(2 * 12);
  EventFunction f = sum.function(&two_steps);
  f.move_to(1);
  BOOST_CHECK_THROW(f.safe_duration(-1, 1), ModelError);
}

// The same of the search for the highest point: it looks at both ends, and goes from one of them to
// the other.
BOOST_AUTO_TEST_CASE(the_search_for_the_highest_point_counts) {
  const Sum sum(1, -1, {1}, {0}, {0, -1});
  Effort three_steps(3 * 13);
  EventFunction f = sum.function(&three_steps);
  BOOST_CHECK_THROW(highest(f, 2 * pi), ModelError);
}

// f = -(1 - e^{-t}) + t/2 - ...: f = 0.5 t - (1 - e^{-t}) leaves 0 downwards; its zero solves
// e^{-t} = 1 - t/2, t = 2 + W(-2 e^{-2}) = 1.5936242600400400923.
BOOST_AUTO_TEST_CASE(leaving_zero_downwards) {
  const auto zero = Sum(1, 0, {1, 0}, {-1, 0.5}, 0).zero(10, true);
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
    const auto zero = Sum(2, 0, {0, r}, {eps / r, -eps / r}, {-1, 0}).zero(1, true);
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
    BOOST_TEST(!Sum(1, -1 - gap, {}, {}, {1, 0}).zero(20).has_value());
    const auto zero = Sum(1, -1 + gap, {}, {}, {1, 0}).zero(20);
    BOOST_REQUIRE(zero);
    // asin(1 - gap) = pi/2 - sqrt(2 gap)(1 + gap/12); the rounding of 1 - gap moves it by
    // u/sqrt(2 gap), that of f by a few times as much.
    const double before = std::sqrt(2 * gap);
    BOOST_TEST(std::abs(pi / 2 - *zero - before) <= before * gap + 12 * 1.1e-16 / before);
  }
}

// A start within rounding of 0 from which f falls, however soon it rises again, is no zero: f =
// (1 - cos t) - b sin t is -2 sin(t/2) (b cos(t/2) - sin(t/2)), and back at 0 where tan(t/2) = b.
BOOST_AUTO_TEST_CASE(a_start_that_falls_and_curves_up_is_no_zero) {
  for (const double b : {1.0, 1e-1, 1e-3, 1e-6})
    for (const double off : {-1e-17, 0.0, 1e-17}) {
      // f' = sin t - b cos t.
      const auto zero = Sum(1, off, {}, {}, {-b, -1}).zero(4);
      BOOST_REQUIRE(zero);
      // Rounding of f moves it by as much over the slope there, which is b.
      BOOST_TEST(std::abs(*zero - 2 * std::atan(b)) <= 32 * 1.1e-16 / b, b << " " << off);
    }
  // Not out of the rounding: the start is as good a zero as any.
  const auto zero = Sum(1, 0, {}, {}, {-1e-9, -1}).zero(4);
  BOOST_REQUIRE(zero);
  BOOST_TEST(*zero <= 1e-8);
}

BOOST_AUTO_TEST_CASE(a_long_wait_takes_few_steps) {
  // f = 1e-7 t - 1 + 0.5 sin t: the first zero is the first maximum that reaches: near t = 5e6.
  const auto zero = Sum(1, -1, {0}, {1e-7}, {0.5, 0}).zero(1e9);
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
    Sum sum(1, -uniform(0.01, 1), rates, amplitudes, std::polar(1.0, uniform(-3, 3)));
    const double frequency = uniform(0.1, 20), decay = uniform(0, 1);
    sum.add_pair({decay, -frequency * frequency}, uniform(-1, 1), uniform(-1, 1));
    const double end = 12;
    const auto zero = sum.zero(end);
    EventFunction f = sum.function();
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

// Up to five pairs, as a drive with masses has them, of both orders. Zeros are missed by no step:
// the samples are thousand for each radian of the fastest.
BOOST_AUTO_TEST_CASE(random_sums_of_several_pairs_against_sampling) {
  std::mt19937 random(32);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const int order = 1 + i % 2, pairs = 2 + i % 4;
    Sum sum(order, -uniform(0.001, 0.3), {0, std::pow(10, uniform(-1, 2))},
            {uniform(-0.1, 0.1), uniform(-1, 1)}, std::polar(1.0, uniform(-3, 3)));
    for (int p = 0; p < pairs; ++p) {
      const double frequency = std::pow(10, uniform(-0.5, 1)), size = order == 1 ? 1 : frequency;
      sum.add_pair({uniform(0, 0.2) * frequency, -frequency * frequency}, size * uniform(-1, 1),
                   uniform(-1, 1) * size);
    }
    const double end = 6;
    const auto zero = sum.zero(end);
    EventFunction f = sum.function();
    found += zero.has_value() ? 1 : 0;
    const double until = zero.value_or(end);
    double highest = -1;
    for (int k = 1; k < 10'000; ++k) {
      const EventFunction::Point point = f.move_to(until * std::pow(k / 10'000.0, 2) * (1 - 1e-9));
      highest = std::max(highest, point.value - point.noise);
    }
    BOOST_TEST_CONTEXT("sum " << i) {
      BOOST_TEST(highest <= 0);
      // Slopes are up to some tens here.
      if (zero && *zero < end) BOOST_TEST(std::abs(f.move_to(*zero).value) < 1e-11);
    }
  }
  BOOST_TEST(found > 150);
}

BOOST_AUTO_TEST_SUITE_END()
