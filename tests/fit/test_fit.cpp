// Series recovered from data that the test makes itself, with and without noise.
#include "fit/fit.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>

#include "base/errors.hpp"

BOOST_AUTO_TEST_SUITE(test_fit)

namespace {

using namespace vcrit;
using fit::Fit;
using Stiffness = std::function<std::complex<double>(double)>;

using namespace std::complex_literals;

/// Normal deviates by Box and Muller from a seeded engine, the same everywhere.
class Noise {
 public:
  explicit Noise(unsigned seed) : engine_(seed) {}
  double operator()() {
    const double u = uniform(), v = uniform();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
  }

 private:
  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) / 9007199254740992.0; }
  std::mt19937_64 engine_;
};

// Each component off by `noise` times |K|; with `stated` that many times the true errors are given.
StiffnessTable measured(const Stiffness& stiffness, double from, double to, int count, double noise,
                        unsigned seed, double stated = 0) {
  Noise deviate(seed);
  StiffnessTable data{"made", {}, stated > 0};
  for (int i = 0; i < count; ++i) {
    const double omega = from * std::pow(to / from, static_cast<double>(i) / (count - 1));
    const std::complex<double> k = stiffness(omega);
    const double error = noise * std::abs(k), stated_error = stated * error;
    const double storage = k.real() + error * deviate();
    data.rows.push_back({omega, storage, k.imag() + error * deviate(), stated_error, stated_error});
  }
  return data;
}

struct Truth {
  double k0;
  std::vector<std::pair<double, double>> branches;  // k, tau
  std::complex<double> operator()(double omega) const {
    std::complex<double> sum = k0;
    for (const auto& [k, tau] : branches) sum += k * 1i * omega * tau / (1.0 + 1i * omega * tau);
    return sum;
  }
};
const Truth three{2e6, {{1e6, 1e-5}, {3e6, 1e-3}, {5e5, 2e-2}}};

std::complex<double> spring_pot(double omega) { return 1e5 * std::pow(1i * omega, 0.4); }

BOOST_AUTO_TEST_CASE(exact_data_give_the_series_back) {
  const Fit fit = fit::fitted(measured(three, 1, 1e7, 60, 0, 1));
  BOOST_TEST_REQUIRE(fit.branches.size() == 3U);
  BOOST_TEST_REQUIRE(fit.equilibrium.has_value());
  // The search ends where no logarithm moves by 1e-11; a hundredfold for the condition.
  const auto same = [](double a, double b) { return std::abs(a / b - 1) < 1e-9; };
  BOOST_TEST(same(fit.equilibrium->value, 2e6));
  for (std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(same(fit.branches[i].stiffness.value, three.branches[i].first));
    BOOST_TEST(same(fit.branches[i].time.value, three.branches[i].second));
  }
  BOOST_TEST(fit.rms_relative < 1e-10);
}

// Two branches of nearly one time: a factor of two apart, a third of what one branch is wide.
BOOST_AUTO_TEST_CASE(neighbours_are_told_apart_without_noise) {
  const Truth pair{1e6, {{1e6, 1e-3}, {1e6, 2e-3}}};
  const Fit fit = fit::fitted(measured(pair, 1, 1e6, 50, 0, 1));
  BOOST_TEST_REQUIRE(fit.branches.size() == 2U);
  BOOST_TEST(std::abs(fit.branches[0].time.value / 1e-3 - 1) < 1e-7);
  // A tenth apart their loss differs from one branch's by (ln 1.1/2)^2 = 0.2 %: noise of 1 % hides
  // it.
  const Truth close{1e6, {{1e6, 1e-3}, {1e6, 1.1e-3}}};
  BOOST_TEST(fit::fitted(measured(close, 1, 1e6, 50, 0.01, 1)).branches.size() == 1U);
}

BOOST_AUTO_TEST_CASE(noisy_data_give_as_many_branches_and_honest_errors) {
  int within_one = 0, within_two = 0, all = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const Fit fit = fit::fitted(measured(three, 1, 1e7, 60, 0.01, seed));
    BOOST_TEST_CONTEXT("seed " << seed) {
      BOOST_TEST_REQUIRE(fit.branches.size() == 3U);
      BOOST_TEST_REQUIRE(fit.equilibrium.has_value());
      // 120 numbers less 7 parameters: the estimate scatters by 1/sqrt(226) = 6.7 %, and four times
      // that is never met in 30 draws.
      BOOST_TEST_REQUIRE(fit.noise.has_value());
      BOOST_TEST(std::abs(*fit.noise / 0.01 - 1) < 0.27);
      // Both components of K together: the root of two; less by 3 % for the parameters.
      BOOST_TEST(std::abs(fit.rms_relative / (0.01 * std::sqrt(2)) - 1) < 0.3);
      const auto count = [&](const fit::Uncertain& found, double truth) {
        const double off = std::abs(found.value - truth) / found.error;
        BOOST_TEST(off < 6);  // one of 210 in 10^6 such tests
        within_one += off < 1;
        within_two += off < 2;
        ++all;
      };
      count(*fit.equilibrium, 2e6);
      for (std::size_t i = 0; i < 3; ++i) {
        count(fit.branches[i].stiffness, three.branches[i].first);
        count(fit.branches[i].time, three.branches[i].second);
      }
    }
  }
  // 68.3 % and 95.4 % of 210, which scatter by 3.2 % and 1.4 % (the seven of one fit go together,
  // so that it is somewhat more): four times that.
  BOOST_TEST(std::abs(static_cast<double>(within_one) / all - 0.683) < 0.13);
  BOOST_TEST(std::abs(static_cast<double>(within_two) / all - 0.954) < 0.06);
}

BOOST_AUTO_TEST_CASE(given_errors_are_believed_and_judged) {
  const Fit right = fit::fitted(measured(three, 1, 1e7, 60, 0.01, 3, 1));
  BOOST_TEST(right.branches.size() == 3U);
  BOOST_TEST(!right.noise.has_value());
  BOOST_TEST(right.degrees_of_freedom == 113);
  // chi-squared has mean 113 and deviation sqrt(226) = 15: four of them.
  BOOST_TEST(std::abs(right.sum_of_squares - 113) < 60);
  BOOST_TEST_REQUIRE(right.chance.has_value());
  BOOST_TEST(*right.chance > 1e-4);
  // With a third of the errors chi-squared is nine times as large, whatever is fitted.
  const Fit wrong = fit::fitted(measured(three, 1, 1e7, 60, 0.01, 3, 1.0 / 3));
  BOOST_TEST(*wrong.chance < 1e-10);
}

// No finite series is a spring-pot, |K| ~ omega^0.4 over eight decades: the noise says how long a
// series is.
BOOST_AUTO_TEST_CASE(a_spring_pot_over_eight_decades_is_fitted_to_the_noise) {
  std::size_t before = 0;
  for (const double noise : {0.1, 0.01, 0.001}) {
    const Fit fit = fit::fitted(measured(spring_pot, 0.1, 1e7, 81, noise, 5));
    BOOST_TEST_CONTEXT("noise " << noise) {
      BOOST_TEST(!fit.exhausted);
      // 162 numbers less some 30: the estimate scatters by 1/sqrt(264) = 6.2 %; four times that,
      // and what a shorter series may leave without being significant.
      BOOST_TEST(std::abs(*fit.noise / noise - 1) < 0.3);
      BOOST_TEST(fit.branches.size() > before);
      // Between the data and off their ends it is the spring-pot, too, not the noise: some ten
      // numbers make a branch, so that it is known to a third of the noise; four times that.
      for (double omega = 1; omega < 1e6; omega *= 1.37) {
        const std::complex<double> k = spring_pot(omega);
        BOOST_TEST(std::abs(dynamic_stiffness(fit.series, omega) / k - 1.0) < 4.0 / 3 * noise);
      }
    }
    before = fit.branches.size();
  }
}

// As few as the noise allows: all lengths below are worse by more than chance, and one or two more
// branches are better by no more.
BOOST_AUTO_TEST_CASE(the_length_is_where_chance_takes_over) {
  const Fit fit = fit::fitted(measured(spring_pot, 0.1, 1e7, 81, 0.01, 5));
  const int n = static_cast<int>(fit.branches.size());
  BOOST_TEST_REQUIRE(fit.trials.size() >= fit.branches.size() + 2);
  for (const fit::Trial& trial : fit.trials) {
    if (trial.branches == n) BOOST_TEST(*trial.chance < fit::significance);
    if (trial.branches > n) BOOST_TEST(*trial.chance >= fit::significance);
    // Dropping a branch leaves clearly more than the noise: chi-squared of 1 % errors.
    if (trial.branches == n - 2) BOOST_TEST(trial.sum_of_squares / 1e-4 > 162 + 4 * 18);
  }
}

// Two branches of neighbouring times, which some tables tell apart, some do not, and some leave in
// doubt: the last one taken by chance in more than 1e-4, or one not taken in less than 5 %.
BOOST_AUTO_TEST_CASE(a_length_that_noise_may_change_is_in_doubt) {
  int too_long = 0, too_short = 0, sure = 0;
  const Truth close{1e6, {{1e6, 1}, {1e6, 3}}};
  for (const int rows : {4, 6, 8})
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const Fit fit = fit::fitted(measured(close, 0.03, 10, rows, 0.01, seed));
      bool longer = false, shorter = false;
      for (const fit::Trial& trial : fit.trials) {
        if (trial.taken) longer = *trial.chance > 1e-4, shorter = false;
        if (!trial.taken && trial.chance) shorter |= *trial.chance < 0.05;
      }
      BOOST_TEST(fit.order_in_doubt == (longer || shorter), rows << " rows, seed " << seed);
      too_long += longer && !shorter;
      too_short += shorter && !longer;
      sure += !longer && !shorter;
    }
  BOOST_TEST((too_long > 0 && too_short > 0 && sure > 0));
}

BOOST_AUTO_TEST_CASE(exact_data_that_no_series_matches_stop_at_the_most_branches) {
  fit::Options options;
  options.most_branches = 9;
  const Fit fit = fit::fitted(measured(spring_pot, 0.1, 1e7, 81, 0, 1), options);
  BOOST_TEST(fit.exhausted);
  BOOST_TEST(fit.branches.size() == 9U);
}

BOOST_AUTO_TEST_CASE(terms_that_the_data_do_not_need_are_left_out) {
  const Truth maxwell{0, {{1e6, 1e-3}}};
  fit::Options options;
  options.damper = true;
  const Fit fluid = fit::fitted(measured(maxwell, 1, 1e6, 60, 0.01, 2), options);
  BOOST_TEST(fluid.branches.size() == 1U);
  BOOST_TEST(!fluid.equilibrium.has_value());
  BOOST_TEST(!fluid.damper.has_value());
  BOOST_TEST(fluid.series.equilibrium == 0);
  const auto kelvin = [](double omega) { return 1e6 + 20i * omega; };
  const Fit damped = fit::fitted(measured(kelvin, 1e3, 1e6, 40, 0.01, 2), options);
  BOOST_TEST(damped.branches.empty());
  BOOST_TEST_REQUIRE(damped.damper.has_value());
  BOOST_TEST(std::abs(damped.damper->value - 20) < 5 * damped.damper->error);
  BOOST_TEST(damped.damper->error < 0.1);
  const Fit spring = fit::fitted(measured([](double) { return 7.0 + 0i; }, 1, 100, 5, 0, 1));
  BOOST_TEST(spring.branches.empty());
  BOOST_TEST(std::abs(spring.equilibrium->value / 7 - 1) < 1e-12);
}

BOOST_AUTO_TEST_CASE(the_unit_of_stiffness_and_time_does_not_matter) {
  for (const double stiffness : {1e-12, 1e12})
    for (const double time : {1e-9, 1e9}) {
      const auto scaled = [&](double omega) { return stiffness * three(omega * time); };
      const Fit fit = fit::fitted(measured(scaled, 1 / time, 1e7 / time, 60, 0.01, 1));
      BOOST_TEST(fit.branches.size() == 3U);
      BOOST_TEST(std::abs(fit.equilibrium->value / (2e6 * stiffness) - 1) < 0.02);
    }
}

BOOST_AUTO_TEST_CASE(few_rows_leave_a_degree_of_freedom) {
  const Fit fit = fit::fitted(measured(three, 10, 1e4, 3, 0.01, 1));
  BOOST_TEST(fit.degrees_of_freedom >= 1);
  BOOST_CHECK_THROW(fit::fitted(measured(three, 10, 1e4, 2, 0.01, 1)), InputError);
  BOOST_CHECK_THROW(fit::fitted(measured(three, 1, 10, 3, 0, 1), {false, 0}), InputError);
  BOOST_CHECK_THROW(fit::fitted(measured(three, 1, 10, 100'001, 0, 1)), InputError);
}

// Springs without loss get a branch no more often than noise shows a loss by two deviations, 2.3 %,
// or a branch at the level of the first one, 1 %: 10 of 300.
BOOST_AUTO_TEST_CASE(springs_stay_springs) {
  const auto spring = [](double) { return 5e5 + 0i; };
  for (const int rows : {3, 5, 40})
    BOOST_TEST(fit::fitted(measured(spring, 1, 1e3, rows, 0, 1)).branches.empty());
  int with_branches = 0;
  for (unsigned seed = 1; seed <= 300; ++seed)
    with_branches += !fit::fitted(measured(spring, 1, 1e3, 12, 0.01, seed)).branches.empty();
  BOOST_TEST(with_branches <= 10);
}

// No branch within the data's range is a damper, so that one is tried where springs and branches
// fail. Noise-free, the numbers are those of the body to rounding.
BOOST_AUTO_TEST_CASE(dampers_are_found_unasked) {
  for (const double size : {1e-3, 1.0, 1e9})
    for (const int rows : {3, 10}) {
      const auto damper = [&](double omega) { return size * 1i * omega; };
      const Fit alone = fit::fitted(measured(damper, 0.1, 10, rows, 0, 1));
      BOOST_TEST(alone.branches.empty());
      BOOST_TEST_REQUIRE(alone.damper.has_value());
      BOOST_TEST(std::abs(alone.damper->value / size - 1) < 1e-9);
      const auto kelvin = [&](double omega) { return size * (1.0 + 3i * omega); };
      const Fit both = fit::fitted(measured(kelvin, 0.1, 10, rows, 0, 1));
      BOOST_TEST(both.branches.empty());
      BOOST_TEST_REQUIRE(both.damper.has_value());
      BOOST_TEST_REQUIRE(both.equilibrium.has_value());
      BOOST_TEST(std::abs(both.damper->value / (3 * size) - 1) < 1e-9);
      BOOST_TEST(std::abs(both.equilibrium->value / size - 1) < 1e-9);
    }
}

// A Zener body and a damper that one branch has to fit: the more noise there is, the less a damper
// lowers the misfit. A third of it is asked for.
BOOST_AUTO_TEST_CASE(a_damper_divides_the_misfit_by_three) {
  const auto body = [](double omega) {
    return 1.0 + 1i * omega / (1.0 + 1i * omega) + 0.03i * omega;
  };
  const fit::Options one{false, 1}, with_damper{true, 1};
  const auto misfit = [](const Fit& fit) {
    return std::sqrt(fit.sum_of_squares / fit.degrees_of_freedom);
  };
  for (const double noise : {0.01, 0.03, 0.04, 0.06}) {
    const StiffnessTable data = measured(body, 0.1, 30, 30, noise, 1);
    const Fit unasked = fit::fitted(data, one), damped = fit::fitted(data, with_damper);
    BOOST_TEST(damped.damper.has_value());
    BOOST_TEST(unasked.damper.has_value() == (noise < 0.035));
    if (unasked.damper) continue;
    BOOST_TEST(misfit(unasked) < 3 * misfit(damped));
    BOOST_TEST(misfit(unasked) > 1.8 * misfit(damped));
  }
}

// A branch at the end of the range fits such a loss as well, to the noise, and is no better known:
// a damper is taken then, however little it lowers the misfit.
BOOST_AUTO_TEST_CASE(a_damper_is_taken_for_a_tail) {
  for (const auto& [damper, noise] : {std::pair(0.3, 0.003), {0.3, 0.01}, {3.0, 0.01}, {3.0, 0.03}})
    for (const unsigned seed : {1U, 2U}) {
      const double c = damper;
      const auto kelvin = [c](double omega) { return 1.0 + 1i * c * omega; };
      const Fit fit = fit::fitted(measured(kelvin, 0.01, 1, 20, noise, seed));
      BOOST_TEST(fit.branches.empty(), damper << " " << noise << " " << seed);
      BOOST_TEST(fit.damper.has_value());
    }
}

// A loss that falls like 1/omega is the tail of a branch slower than the search allows.
BOOST_AUTO_TEST_CASE(the_tail_of_a_loss_is_kept) {
  const Truth slow{1e6, {{1e5, 100}}};
  const Fit fit = fit::fitted(measured(slow, 1, 30, 6, 0, 1));
  BOOST_TEST(fit.branches.size() == 1U);
  BOOST_TEST(fit.time_at_an_end);
}

BOOST_AUTO_TEST_CASE(noise_below_zero_is_fitted_and_more_is_refused) {
  StiffnessTable data = measured(three, 1, 1e7, 20, 0.003, 1);
  data.rows[0].loss = -0.002 * data.rows[0].storage;
  BOOST_TEST(fit::fitted(data).branches.size() == 3U);
  data.rows[0].loss = -0.05 * data.rows[0].storage;
  BOOST_CHECK_THROW(fit::fitted(data), InputError);
  // More than a tenth of |K| where the noise is: 5 %, and four of it are 20 %.
  StiffnessTable noisy = measured(Truth{1e6, {{1e6, 1e-4}}}, 1, 1e6, 60, 0.05, 1);
  noisy.rows[0].loss = -0.15 * noisy.rows[0].storage;
  BOOST_TEST(fit::fitted(noisy).branches.size() == 1U);
  noisy.rows[0].loss = -0.35 * noisy.rows[0].storage;
  BOOST_CHECK_THROW(fit::fitted(noisy), InputError);
  // Three rows tell nothing of so large a noise.
  StiffnessTable few = measured(three, 1, 1e7, 3, 0, 1);
  few.rows[1].loss = -0.2 * few.rows[1].storage;
  BOOST_CHECK_THROW(fit::fitted(few), InputError);
  // Of exact rows four thousandths are the phase that no measurement resolves.
  StiffnessTable exact = measured([](double) { return 1.0 + 0i; }, 1, 32, 6, 0, 1);
  exact.rows[3].loss = -0.0038;
  BOOST_TEST(fit::fitted(exact).branches.empty());
  exact.rows[3].loss = -0.0042;
  BOOST_CHECK_THROW(fit::fitted(exact), InputError);
  // The other sign of i: all losses negative.
  StiffnessTable conjugate = measured(Truth{1e6, {{5e4, 1e-2}}}, 10, 1000, 6, 0.001, 1);
  for (StiffnessRow& row : conjugate.rows) row.loss = -row.loss;
  BOOST_CHECK_THROW(fit::fitted(conjugate), InputError);
}

// Errors given that are a third of the true ones: the misfit tells, and widens what is said of the
// numbers threefold.
BOOST_AUTO_TEST_CASE(errors_that_are_too_small_do_not_narrow_the_answer) {
  const Fit right = fit::fitted(measured(three, 1, 1e7, 60, 0.01, 3, 1));
  const Fit wrong = fit::fitted(measured(three, 1, 1e7, 60, 0.01, 3, 1.0 / 3));
  const double ratio = wrong.equilibrium->error / right.equilibrium->error;
  // Of chi-squared with 113 degrees: 6.7 %, four times that. (Longer series would leave fewer.)
  BOOST_TEST(std::abs(ratio - 1) < 0.3);
}

// Chi-squared and F distributions with two degrees of freedom more have closed forms: exp(-x/2),
// and (after/before)^(nu/2).
BOOST_AUTO_TEST_CASE(chances_are_those_of_the_closed_forms) {
  BOOST_TEST(std::abs(fit::chance_of_fall(30, 20, 2, 50, true) / std::exp(-5.0) - 1) < 1e-13);
  BOOST_TEST(std::abs(fit::chance_of_fall(30, 20, 2, 50, false) / std::pow(2.0 / 3, 25) - 1) <
             1e-13);
  BOOST_TEST(fit::chance_of_fall(20, 20, 2, 50, false) == 1);
  for (const bool known : {false, true}) BOOST_TEST(fit::chance_of_fall(20, 19, 0, 50, known) == 0);
  BOOST_TEST(fit::chance_of_fall(20, 21, 2, 50, true) == 1);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
