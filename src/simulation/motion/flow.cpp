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

void Flow::move(ConstView z, View x, View integrals) const {
  const Index levels = model_->level_states(), own = phase().own.rows();
  const View held = integrals.first(model_->integrated_levels());
  const View slow = integrals.last(model_->slow_units);
  for (Index i = 0; i < held.size(); ++i) held[i] += x[i] * duration();
  const View contact = x.subspan(levels, own);
  std::fill(contact.begin(), contact.end(), 0.0);
  factors_.apply(z, [&](Index mode, const Integrals<double>& passed) {
    const ConstView rate = phase().levels.column(mode), state = phase().own.column(mode);
    add(rate, passed[1], x.first(levels));
    add(rate.first(held.size()), passed[2], held);
    add(state, passed[0], contact);
    if (!stuck_) add(state.first(slow.size()), passed[1], slow);
  });
  if (stuck_) move_units(z, x.last(model_->units()), slow);
}

void Flow::move_units(ConstView z, View units, View slow) const {
  for (Index j = 0; j < slow.size(); ++j) slow[j] += units[j] * units_[j][1];
  for (Index j = 0; j < units.size(); ++j) units[j] *= units_[j][0];
  for (Index mode = 0; mode < z.size(); ++mode) {
    add(unit_answer_.column(mode), z[mode], units);
    add(unit_integral_.column(mode), z[mode], slow);
  }
}

void Flow::carry(Changes& changes) const {
  const Matrix& to_modes = phase().modes.to_modes;
  const Index columns = changes.state.columns(), modes = to_modes.rows();
  const Index states = to_modes.columns() + changes.state.rows() + unit_integral_.rows();
  model_->effort.spend(columns * (1 + modes + Effort::of_products(modes * states)));
  if (model_->body && model_->body->masses) return carry_together(changes);
  Vector y(to_modes.columns()), z(to_modes.rows());
  for (Index j = 0; j < changes.state.columns(); ++j) {
    const View x = changes.state.column(j);
    model_->rates(x, stuck_, y);
    std::fill(z.begin(), z.end(), 0.0);
    add_product(to_modes, y, z);
    move(z, x, changes.integrals.column(j));
  }
}

// The same sums in the same order, as products of whole matrices: of the modes of several masses
// they take half as long.
void Flow::carry_together(Changes& changes) const {
  const Matrix& to_modes = phase().modes.to_modes;
  const Index columns = changes.state.columns(), own = phase().own.rows();
  if (columns == 0) return;
  Matrix y(to_modes.columns(), columns), z(to_modes.rows(), columns);
  const MatrixView x = all(changes.state), integrals = all(changes.integrals);
  const MatrixView levels = x.first(model_->level_states()), contact = x.part(levels.rows, own);
  const MatrixView held = integrals.first(model_->integrated_levels());
  const MatrixView slow = integrals.last(model_->slow_units);
  for (Index j = 0; j < columns; ++j) {
    model_->rates(x.column(j), stuck_, y.column(j));
    add(x.column(j).first(held.rows), duration(), held.column(j));
    std::ranges::fill(contact.column(j), 0.0);
  }
  add_product(all(to_modes), all(y), all(z));
  const ModalFactors::Passed passed = factors_.passed(all(z));
  const ConstMatrixView rates = all(phase().levels), states = all(phase().own);
  add_product(rates, passed.once(), levels);
  add_product(rates.first(held.rows), passed.twice(), held);
  add_product(states, passed.now(), contact);
  if (!stuck_) return add_product(states.first(slow.rows), passed.once(), slow);
  for (Index j = 0; j < columns; ++j)
    move_units(z.column(j), x.column(j).last(model_->units()), slow.column(j));
}

}  // namespace vcrit::simulation
