#include "stiffness/relaxation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "network/law.hpp"
#include "network/wiring.hpp"
#include "stiffness/condensation.hpp"
#include "stiffness/graph_relaxation.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit {

namespace {

void check_there_are(std::size_t parts) {
  if (parts == 0) throw InputError(argument("parts"), "none", "one at least");
}

double positive_value(const Values& values, const Symbol& symbol) {
  const double value = value_of(values, symbol);
  if (value > 0 && std::isfinite(value)) return value;
  throw InputError(argument("values"), fmt::format("{} = {}", to_text(symbol), value),
                   "a finite value above 0");
}

/// The algebra of an element's law.
struct ElementForms {
  using Value = Relaxation;
  const Values& values;
  Relaxation of(const Symbol& symbol) const { return {positive_value(values, symbol), 0, {}}; }
  static Relaxation constant(const TypedNumber& number) { return {number.value, 0, {}}; }
  static Relaxation plus(const Relaxation& a, const Relaxation& b) {
    return {a.equilibrium + b.equilibrium, 0, {}};
  }
  static Relaxation times(const Relaxation& a, const Relaxation& b) {
    return {a.equilibrium * b.equilibrium, 0, {}};
  }
  static Relaxation over(const Relaxation& a, const Relaxation& b) {
    return {a.equilibrium / b.equilibrium, 0, {}};
  }
  static Relaxation times_s(const Relaxation& k) {
    if (k.damper != 0)
      throw InputError(argument("network"), "a mass", "springs and dampers, which alone relax");
    return {0, k.equilibrium, {}};
  }
  static Relaxation relaxing(const Relaxation& k, const Relaxation& tau) {
    return {0, 0, {{k.equilibrium, tau.equilibrium}}};
  }
};

// Rates closer than a few rounding errors act as one: moving a rate by that much moves K no more.
bool same_rate(double a, double b) { return b - a <= 4 * epsilon * b; }

struct Pole {
  double rate, weight;
};

PoleSum sum_of(const std::vector<PoleSum>& parts) {
  PoleSum sum;
  std::size_t most = 0;
  for (const PoleSum& part : parts) most += part.rates.size();
  std::vector<Pole> poles;
  poles.reserve(most);
  sum.rates.reserve(most);
  sum.weights.reserve(most);
  for (const PoleSum& part : parts) {
    sum.direct += part.direct;
    for (std::size_t j = 0; j < part.rates.size(); ++j)
      poles.push_back({part.rates[j], part.weights[j]});
  }
  // Sorting takes memory, also where there is nothing to sort.
  if (!std::ranges::is_sorted(poles, {}, &Pole::rate))
    std::ranges::stable_sort(poles, {}, &Pole::rate);
  for (const Pole& pole : poles) {
    if (!sum.rates.empty() && same_rate(sum.rates.back(), pole.rate)) {
      sum.weights.back() += pole.weight;
    } else {
      sum.rates.push_back(pole.rate);
      sum.weights.push_back(pole.weight);
    }
  }
  return sum;
}

PoleSum pole_sum(const DualPoles& dual_poles) {
  PoleSum sum{dual_poles.direct, {}, {}};
  if (dual_poles.at_rest > 0) {
    sum.rates.push_back(0);
    sum.weights.push_back(dual_poles.at_rest);
  }
  for (std::size_t j = 0; j < dual_poles.rates.size(); ++j) {
    if (dual_poles.weights[j] == 0) continue;  // it underflowed
    const double rate = dual_poles.rates[j].value();
    if (!sum.rates.empty() && sum.rates.back() >= rate) {
      sum.weights.back() += dual_poles.weights[j];  // two rates that round to one double
      continue;
    }
    sum.rates.push_back(rate);
    sum.weights.push_back(dual_poles.weights[j]);
  }
  return sum;
}

PoleSum compliance_poles(const Relaxation& relaxation) {
  return pole_sum(dual(stiffness_poles(relaxation)));
}

Relaxation relaxed(const Network& network, const Values& values);

std::vector<Relaxation> forms_of(const std::vector<Network>& parts, const Values& values) {
  std::vector<Relaxation> forms;
  forms.reserve(parts.size());
  for (const Network& part : parts) forms.push_back(relaxed(part, values));
  return forms;
}

struct FormOf {
  const Values& values;
  Relaxation operator()(const Element& element) const { return law(element, ElementForms{values}); }
  Relaxation operator()(const Series& s) const { return series(forms_of(s.parts, values)); }
  Relaxation operator()(const Parallel& p) const { return parallel(forms_of(p.parts, values)); }
  Relaxation operator()(const Graph& graph) const {
    return graph_relaxation(
        condensed({graph.nodes.size(), graph.wires, forms_of(graph.parts, values)}));
  }
};

Relaxation relaxed(const Network& network, const Values& values) {
  return std::visit(FormOf{values}, network.form);
}

}  // namespace

PoleSum stiffness_poles(const Relaxation& relaxation) {
  PoleSum sum{relaxation.damper, {}, {}};
  if (relaxation.equilibrium > 0) {
    sum.rates.push_back(0);
    sum.weights.push_back(relaxation.equilibrium);
  }
  for (auto branch = relaxation.branches.rbegin(); branch != relaxation.branches.rend(); ++branch) {
    sum.rates.push_back(1 / branch->time);
    sum.weights.push_back(branch->stiffness);
  }
  return sum;
}

Relaxation relaxation_of(const PoleSum& stiffness) {
  Relaxation form{0, stiffness.direct, {}};
  for (std::size_t j = stiffness.rates.size(); j-- > 0;) {
    if (stiffness.rates[j] == 0)
      form.equilibrium = stiffness.weights[j];
    else
      form.branches.push_back({stiffness.weights[j], 1 / stiffness.rates[j]});
  }
  return form;
}

DualPoles dual(const PoleSum& sum) {
  check_weights(sum.rates.size(), sum.weights.size());
  if (sum.rates.size() > most_rates)
    throw InputError({"a network"}, fmt::format("{} different relaxation times", sum.rates.size()),
                     fmt::format("at most {} where networks are in series", most_rates));
  DualPoles result;
  if (sum.direct == 0)
    result.direct = 1 / std::accumulate(sum.weights.begin(), sum.weights.end(), 0.0);
  if (sum.rates.empty() || sum.rates.front() > 0) {
    double at_zero = sum.direct;
    for (std::size_t j = 0; j < sum.rates.size(); ++j) at_zero += sum.weights[j] / sum.rates[j];
    result.at_rest = 1 / at_zero;
  }
  result.rates = positive_roots({0, sum.direct, sum.rates, sum.weights});
  for (const OffsetRate& rate : result.rates) {
    double slope = 0;
    for (std::size_t j = 0; j < sum.rates.size(); ++j) {
      const double distance = rate.minus(sum.rates[j]);
      slope += sum.weights[j] / distance * (rate.value() / distance);
    }
    result.weights.push_back(1 / slope);
  }
  return result;
}

Relaxation parallel(const std::vector<Relaxation>& parts) {
  check_there_are(parts.size());
  if (parts.size() == 1) return parts[0];
  std::vector<PoleSum> stiffnesses;
  stiffnesses.reserve(parts.size());
  for (const Relaxation& part : parts) stiffnesses.push_back(stiffness_poles(part));
  return relaxation_of(sum_of(stiffnesses));
}

// All compliances are added before the one way back: each crossing costs rounding errors.
Relaxation series(const std::vector<Relaxation>& parts) {
  check_there_are(parts.size());
  if (parts.size() == 1) return parts[0];
  std::vector<PoleSum> compliances;
  for (const Relaxation& part : parts) compliances.push_back(compliance_poles(part));
  return relaxation_of(pole_sum(dual(sum_of(compliances))));
}

Relaxation relaxation_form(const Network& network, const Values& values) {
  check_wiring(network);
  return relaxed(network, values);
}

std::complex<double> dynamic_stiffness(const Relaxation& relaxation, double omega) {
  std::complex<double> sum{relaxation.equilibrium, relaxation.damper * omega};
  for (const MaxwellBranch& branch : relaxation.branches) {
    const double x = omega * branch.time;
    if (x > 1)
      sum +=
          std::complex<double>{branch.stiffness / (1 + 1 / x / x), branch.stiffness / (x + 1 / x)};
    else
      sum += std::complex<double>{branch.stiffness * x / (1 + x * x) * x,
                                  branch.stiffness * x / (1 + x * x)};
  }
  return sum;
}

Relaxation scaled(Relaxation relaxation, double factor) {
  relaxation.equilibrium *= factor;
  relaxation.damper *= factor;
  for (MaxwellBranch& branch : relaxation.branches) branch.stiffness *= factor;
  return relaxation;
}

}  // namespace vcrit
