#include "normal/normal_stays.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/constants.hpp"
#include "modes/first_zero.hpp"

namespace vcrit::simulation {

namespace {

// Radians: with slower units a speed has 13 digits.
constexpr double fast = 1e3;

double sum(ConstView x) {
  double result = 0;
  for (const double value : x) result += value;
  return result;
}

double swung(ComplexDouble swing, PairNumber x) { return swing.real() * x.a - swing.imag() * x.b; }

// What each unit takes up over a touch, from the decay of each branch and from the oscillation, per
// unit of fluidity: strain at its end, and the integral of that.
struct Uptake {
  Uptake(const ContactModes& network, const Spectrum& branches, const ModalFactors& factors)
      : strain(network.unit_rates.size(), branches.singles()), sum(strain) {
    const double duration = factors.duration();
    for (Index j = 0; j < strain.rows(); ++j) {
      const double rate = network.unit_rates[j];
      const Integrals<double> own = integrals(rate, duration);
      const auto answer = [&](auto r, const auto& factor, auto& now_there, auto& integral) {
        now_there = convolution(r, factor[0], -rate, own[0], duration);
        integral = integrated_convolution(r, factor[1], -rate, own[1], now_there, duration);
      };
      for (Index i = 0; i < branches.singles(); ++i)
        answer(-branches.rates[i], factors.single(i), strain(j, i), sum(j, i));
      answer(PairNumber{0, 1, -1}, factors.turn(), swing_strain.emplace_back(),
             swing_sum.emplace_back());
    }
  }

  Matrix strain, sum;
  List<PairNumber> swing_strain, swing_sum;
};

void relax(NormalState& now, NormalIntegrals& sums, Index j, Index k,
           const Integrals<double>& own) {
  sums.strains(j, k) += now.strains(j, k) * own[1];
  now.strains(j, k) *= own[0];
}

}  // namespace

NormalStays::NormalStays(const ContactModes& network, const Indentation& indentation,
                         Effort& effort)
    : network_(network),
      indentation_(indentation),
      effort_(effort),
      branches_{network.branch_rates, {}},
      units_{network.unit_rates, {}} {
  using namespace std::complex_literals;
  swing_ = network.damper * 1i * indentation.amplitude;
  for (Index i = 0; i < branches_.singles(); ++i) swing_ += branch_swing(i);
}

double NormalStays::gap(const NormalState& now) const {
  return sum(now.strains.column(0)) - depth(now.time);
}

NormalState NormalStays::start() const {
  NormalState result{-pi, Matrix(units(), 1), false};
  const double deepest = indentation_.mean + indentation_.amplitude;
  for (Index j = 0; j < units(); ++j)
    result.strains(j, 0) =
        network_.branch_stiffness[0] * deepest * network_.unit_fluidity[j] / network_.unit_rates[j];
  return result;
}

bool NormalStays::stay_apart(NormalState& now, double end, NormalStay& stay,
                             NormalIntegrals& sums) const {
  const auto closing = touch_down(now, end - now.time);
  stay = {false, now.time, closing.value_or(end - now.time), {}};
  for (Index j = 0; j < units(); ++j) {
    const auto own = integrals(units_.rates[j], stay.duration);
    for (Index k = 0; k < now.strains.columns(); ++k) relax(now, sums, j, k, own);
  }
  now.time = closing ? now.time + *closing : end;
  now.released = false;
  return closing.has_value();
}

bool NormalStays::stay_closed(NormalState& now, double end, NormalStay& stay,
                              NormalIntegrals& sums) const {
  strike(now, sums);
  const Matrix decays = decays_at(now);
  const auto opening = lift_off(now, decays.column(0), end - now.time);
  stay = {true, now.time, opening.value_or(end - now.time),
          Vector(decays.column(0).begin(), decays.column(0).end())};
  press(now, decays, stay.duration, sums);
  now.time = opening ? now.time + *opening : end;
  now.released = opening.has_value();
  return now.released;
}

double NormalStays::depth(double time) const {
  return indentation_.mean + indentation_.amplitude * std::cos(time);
}

ComplexDouble NormalStays::branch_swing(Index i) const {
  using namespace std::complex_literals;
  return network_.branch_stiffness[i] * indentation_.amplitude * 1i / (branches_.rates[i] + 1i);
}

// By how much the substrate comes nearer to the surface, or the surface further from it.
double NormalStays::raised(const NormalState& now, Index column) {
  const double strains = sum(now.strains.column(column));
  return column == now.deeper ? strains - 1 : strains;
}

// A contact that closes a little earlier or later: a direct damper, whose force jumps up there,
// makes an impulse of the difference.
void NormalStays::strike(NormalState& now, NormalIntegrals& sums) const {
  for (Index k = 1; k < now.strains.columns() && network_.damper > 0; ++k) {
    const double impulse = -network_.damper * raised(now, k);
    sums.impulse[k] += impulse;
    add(network_.unit_fluidity, impulse, now.strains.column(k));
  }
}

// Forces of the branches where the contact closes, k_i sum_j beta_j eps_j/(beta_j - a_i), less
// their swing: the spring's is that of the mean indentation. With changed strains at the same
// place F = -sum_j eps_j/J_g begins elsewhere, too; with the same strains deeper down as well.
Matrix NormalStays::decays_at(const NormalState& now) const {
  const ComplexDouble turn = std::polar(1.0, now.time);
  const Index columns = now.strains.columns();
  effort_.spend(Effort::of_products(branches_.singles() * units() * columns));
  Matrix result(branches_.singles(), columns);
  for (Index k = 0; k < columns; ++k) {
    const View decays = result.column(k);
    add_product(network_.to_branches, now.strains.column(k), decays);
    if (k > 0) add(network_.branch_stiffness, -raised(now, k), decays);
    for (Index i = 0; i < decays.size(); ++i) {
      if (k == 0) decays[i] -= (branch_swing(i) * turn).real();
      if (branches_.rates[i] == 0)
        decays[i] = k == 0            ? network_.branch_stiffness[i] * indentation_.mean
                    : k == now.deeper ? network_.branch_stiffness[i]
                                      : 0;
    }
  }
  return result;
}

// The surface less the substrate, as a function that reaches 0 from below. With a direct damper
// the gap begins with no speed, but that is a difference of rates, whose rounding of a fast unit
// would stay in the speed for good: of such a one the rates are taken as they are.
std::optional<double> NormalStays::touch_down(const NormalState& now, double horizon) const {
  const ConstView strains = now.strains.column(0);
  const int order = now.released && network_.damper > 0 && !has_fast_unit() ? 2 : 1;
  const double size = std::abs(depth(now.time)) + sum_of_sizes(strains);
  EventFunction f(units_, order, now.released ? 0 : -gap(now), now.released ? 0 : size, &effort_);
  f.add_modes(units_.rates, strains, 1, order - 1);
  using namespace std::complex_literals;
  const ComplexDouble rate = 1i * indentation_.amplitude * std::polar(1.0, now.time);
  f.add_sinusoid(order == 2 ? 1i * rate : rate);
  return now.released ? first_zero_after_leaving(f, horizon) : first_zero(f, horizon, false);
}

bool NormalStays::has_fast_unit() const {
  return std::any_of(units_.rates.begin(), units_.rates.end(),
                     [](double rate) { return rate > fast; });
}

std::optional<double> NormalStays::lift_off(const NormalState& now, ConstView decays,
                                            double horizon) const {
  const ComplexDouble swing = swing_ * std::polar(1.0, now.time);
  const double force = swing.real() + sum(decays), size = std::abs(swing) + sum_of_sizes(decays);
  // One within rounding is no force to begin with.
  const bool steps = network_.damper > 0 && force > 8 * epsilon * size;
  EventFunction f(branches_, 1, steps ? -force : 0, steps ? size : 0, &effort_);
  f.add_modes(branches_.rates, decays, 1);
  using namespace std::complex_literals;
  f.add_sinusoid(-1i * swing);
  return steps ? first_zero(f, horizon, false) : first_zero_after_leaving(f, horizon);
}

// eps_j' = psi_j F - beta_j eps_j.
void NormalStays::press(NormalState& now, const Matrix& decays, double duration,
                        NormalIntegrals& sums) const {
  const ModalFactors factors(branches_, duration);
  const ComplexDouble swing = swing_ * std::polar(1.0, now.time);
  const Index columns = decays.columns();
  effort_.spend(units() * decays.rows() * (convolution_work + Effort::of_products(2 * columns)));
  for (Index i = 0; i < decays.rows(); ++i) {
    for (Index k = 0; k < columns; ++k) sums.impulse[k] += decays(i, k) * factors.single(i)[1];
    sums.size += std::abs(decays(i, 0) * factors.single(i)[1]);
  }
  sums.impulse[0] += swung(swing, factors.turn()[1]);
  sums.size += std::abs(swing) * magnitude(factors.turn()[1]);
  const Uptake taken(network_, branches_, factors);
  for (Index j = 0; j < units(); ++j) {
    const Integrals<double> own = integrals(units_.rates[j], duration);
    for (Index k = 0; k < columns; ++k) relax(now, sums, j, k, own);
  }
  const auto take_up = [&](const Matrix& of, Index k, View strains) {
    for (Index i = 0; i < decays.rows(); ++i)
      for (Index j = 0; j < strains.size(); ++j)
        strains[j] += network_.unit_fluidity[j] * decays(i, k) * of(j, i);
  };
  for (Index k = 0; k < columns; ++k) {
    take_up(taken.strain, k, now.strains.column(k));
    take_up(taken.sum, k, sums.strains.column(k));
  }
  for (Index j = 0; j < units(); ++j) {
    const double fluidity = network_.unit_fluidity[j];
    now.strains(j, 0) += fluidity * swung(swing, taken.swing_strain[j]);
    sums.strains(j, 0) += fluidity * swung(swing, taken.swing_sum[j]);
  }
}

}  // namespace vcrit::simulation
