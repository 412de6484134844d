#include "simulation/motion/flow.hpp"

#include <algorithm>

namespace vcrit::simulation {

Flow::Flow(const Model& model, bool stuck, double duration)
    : model_(&model), stuck_(stuck), factors_(phase().modes.spectrum, duration) {
  if (stuck) filter_units();
}

// r_j after the duration: its own decay, and the integral of psi_j F' e^{-beta_j (t - x)}.
void Flow::filter_units() {
  const Spectrum& spectrum = phase().modes.spectrum;
  const double t = duration();
  unit_answer_ = Matrix(model_->units(), spectrum.size());
  for (Index j = 0; j < model_->units(); ++j) {
    const double rate = model_->contact.unit_rates[j], own = std::exp(-rate * t);
    const double fluidity = model_->contact.unit_fluidity[j];
    unit_decay_.push_back(own);
    const Index n = spectrum.singles();
    for (Index i = 0; i < n; ++i)
      unit_answer_(j, i) = fluidity * phase().event[i] *
                           convolution(-spectrum.rates[i], factors_.single(i)[0], -rate, own, t);
    if (!spectrum.pair) continue;
    const PairNumber answer =
        spectrum.weight(phase().event) * fluidity *
        convolution(spectrum.pair->exponent, factors_.pair()[0], -rate, own, t);
    unit_answer_(j, n) = answer.b;
    unit_answer_(j, n + 1) = answer.a;
  }
}

void Flow::move(ConstView z, View x, View integrals) const {
  const Index own = phase().own.rows(), levels = integrals.size();
  for (Index i = 0; i < levels; ++i) integrals[i] += x[i] * duration();
  const View contact = x.subspan(levels, own);
  std::fill(contact.begin(), contact.end(), 0.0);
  factors_.apply(z, [&](Index mode, const Integrals<double>& passed) {
    const ConstView rate = phase().levels.column(mode);
    for (Index i = 0; i < levels; ++i) {
      x[i] += rate[i] * passed[1];
      integrals[i] += rate[i] * passed[2];
    }
    add(phase().own.column(mode), passed[0], contact);
  });
  if (!stuck_) return;
  const View units = x.last(model_->units());
  for (Index j = 0; j < units.size(); ++j) units[j] *= unit_decay_[j];
  add_product(unit_answer_, z, units);
}

void Flow::carry(Changes& changes) const {
  for (Index j = 0; j < changes.state.columns(); ++j) {
    const View x = changes.state.column(j);
    Vector z(phase().modes.to_modes.rows());
    add_product(phase().modes.to_modes, model_->rates(x, stuck_), z);
    move(z, x, changes.integrals.column(j));
  }
}

}  // namespace vcrit::simulation
