#include "simulation/motion/flow.hpp"

#include <algorithm>

namespace vcrit::simulation {

Flow::Flow(const Model& model, bool stuck, double duration)
    : model_(&model), stuck_(stuck), factors_(phase().modes.spectrum, duration) {
  model.effort.spend(1 + phase().modes.spectrum.size());
  if (stuck) filter_units();
}

// r_j after the duration: its own decay, and the integral of psi_j F' e^{-beta_j (t - x)}.
void Flow::filter_units() {
  const Spectrum& spectrum = phase().modes.spectrum;
  const Index units = model_->units(), n = spectrum.singles();
  model_->effort.spend(convolution_work * units * spectrum.size());
  unit_answer_ = Matrix(units, spectrum.size());
  unit_integral_ = Matrix(model_->slow_units, spectrum.size());
  for (Index j = 0; j < units; ++j) {
    const double s = -model_->contact.unit_rates[j], fluidity = model_->contact.unit_fluidity[j];
    const Integrals<double>& own = units_.emplace_back(integrals(-s, duration()));
    const auto answer = [&](auto r, const auto& factor, auto weight, const auto& set) {
      const auto convolved = convolution(r, factor[0], s, own[0], duration());
      set(unit_answer_, weight * convolved);
      if (j >= model_->slow_units) return;
      set(unit_integral_,
          weight * integrated_convolution(r, factor[1], s, own[1], convolved, duration()));
    };
    for (Index i = 0; i < n; ++i)
      answer(-spectrum.rates[i], factors_.single(i), fluidity * phase().event[i],
             [&](Matrix& matrix, double value) { matrix(j, i) = value; });
    for (Index p = 0; p < spectrum.pairs.size(); ++p)
      answer(spectrum.pairs[p].exponent, factors_.pair(p),
             spectrum.weight(phase().event, p) * fluidity, [&](Matrix& matrix, PairNumber value) {
               matrix(j, spectrum.place(p)) = value.b;
               matrix(j, spectrum.place(p) + 1) = value.a;
             });
  }
}

namespace {

// Of so few modes, as a body without masses in its drive has, each is added by itself; products of
// whole matrices pay from there on.
constexpr Index few_modes = 3;

}  // namespace

void Flow::move(ConstMatrixView z, MatrixView x, MatrixView integrals) const {
  const Index levels = model_->level_states(), own = phase().own.rows();
  const MatrixView held = integrals.first(model_->integrated_levels());
  const MatrixView slow = integrals.last(model_->slow_units);
  const MatrixView contact = x.part(levels, own);
  for (Index j = 0; j < x.columns; ++j) {
    add(x.column(j).first(held.rows), duration(), held.column(j));
    std::ranges::fill(contact.column(j), 0.0);
  }
  if (z.rows <= few_modes) {
    for (Index j = 0; j < x.columns; ++j)
      add_modes(z.column(j), x.column(j), held.column(j), slow.column(j));
  } else {
    const Factors::Passed passed = factors_.passed(z);
    const ConstMatrixView rates = all(phase().levels), states = all(phase().own);
    add_product(rates, passed.once(), x.first(levels));
    add_product(rates.first(held.rows), passed.twice(), held);
    add_product(states, passed.now(), contact);
    if (!stuck_) add_product(states.first(slow.rows), passed.once(), slow);
  }
  if (stuck_) move_units(z, x.last(model_->units()), slow);
}

// The same, mode by mode.
void Flow::add_modes(ConstView z, View x, View held, View slow) const {
  const Index levels = model_->level_states();
  const auto add_mode = [&](Index mode, double now, double once, double twice) {
    const ConstView rate = phase().levels.column(mode), state = phase().own.column(mode);
    add(rate, once, x.first(levels));
    add(rate.first(held.size()), twice, held);
    add(state, now, x.subspan(levels, state.size()));
    if (!stuck_) add(state.first(slow.size()), once, slow);
  };
  const Spectrum& spectrum = phase().modes.spectrum;
  for (Index i = 0; i < spectrum.singles(); ++i) {
    const Integrals<double>& single = factors_.single(i);
    add_mode(i, z[i] * single[0], z[i] * single[1], z[i] * single[2]);
  }
  // Of so few modes two are a pair at most.
  if (spectrum.pairs.empty()) return;
  const Index i = spectrum.place(0);
  const Integrals<PairNumber>& pair = factors_.pair(0);
  const PairNumber start{z[i], z[i + 1], pair[0].q};
  const PairNumber now = start * pair[0], once = start * pair[1], twice = start * pair[2];
  add_mode(i, now.a, once.a, twice.a);
  add_mode(i + 1, now.b, once.b, twice.b);
}

void Flow::move_units(ConstMatrixView z, MatrixView units, MatrixView slow) const {
  for (Index c = 0; c < units.columns; ++c) {
    const View each = units.column(c), sums = slow.column(c);
    for (Index j = 0; j < sums.size(); ++j) sums[j] += each[j] * units_[j][1];
    for (Index j = 0; j < each.size(); ++j) each[j] *= units_[j][0];
  }
  add_product(all(unit_answer_), z, units);
  add_product(all(unit_integral_), z, slow);
}

void Flow::carry(Changes& changes) const {
  const Matrix& to_modes = phase().modes.to_modes;
  const Index columns = changes.state.columns(), modes = to_modes.rows();
  const Index states = to_modes.columns() + changes.state.rows() + unit_integral_.rows();
  model_->effort.spend(columns * (1 + modes + Effort::of_products(modes * states)));
  if (columns == 0) return;
  if (modes > few_modes) {
    Matrix y(to_modes.columns(), columns), z(modes, columns);
    for (Index j = 0; j < columns; ++j)
      model_->rates(changes.state.column(j), stuck_, y.column(j));
    add_product(all(to_modes), all(y), all(z));
    return move(all(z), all(changes.state), all(changes.integrals));
  }
  Vector y(to_modes.columns()), z(modes);
  for (Index j = 0; j < columns; ++j) {
    const View x = changes.state.column(j);
    model_->rates(x, stuck_, y);
    std::ranges::fill(z, 0.0);
    for (Index i = 0; i < y.size(); ++i) add(to_modes.column(i), y[i], z);
    move(ConstView(z), x, changes.integrals.column(j));
  }
}

}  // namespace vcrit::simulation
