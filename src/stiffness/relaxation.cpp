#include "stiffness/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/errors.hpp"
#include "stiffness/graph_relaxation.hpp"

namespace vcrit {

namespace {

double positive_value(const Values& values, const Symbol& symbol) {
  const double value = values.at(symbol);
  ensure(value > 0 && std::isfinite(value), "elements of a relaxation form have positive values");
  return value;
}

Relaxation form_of(const Element& element, const Values& values) {
  ensure(element.kind != ElementKind::mass, "a relaxation form is of springs and dampers only");
  const double coefficient = positive_value(values, element.coefficient);
  if (element.kind == ElementKind::spring) return {coefficient, 0, {}};
  if (element.kind == ElementKind::damper) return {0, coefficient, {}};
  return {0, 0, {{coefficient, positive_value(values, element.time)}}};
}

// Rates closer than a few rounding errors act as one: moving a rate by that much moves K no more.
bool same_rate(double a, double b) {
  return b - a <= 4 * std::numeric_limits<double>::epsilon() * b;
}

PoleSum sum_of(const PoleSum& a, const PoleSum& b) {
  PoleSum sum{a.direct + b.direct, {}, {}};
  std::size_t i = 0, j = 0;
  while (i < a.rates.size() || j < b.rates.size()) {
    const bool from_a = j == b.rates.size() || (i < a.rates.size() && a.rates[i] <= b.rates[j]);
    const double rate = from_a ? a.rates[i] : b.rates[j];
    const double weight = from_a ? a.weights[i++] : b.weights[j++];
    if (!sum.rates.empty() && same_rate(sum.rates.back(), rate)) {
      sum.weights.back() += weight;
    } else {
      sum.rates.push_back(rate);
      sum.weights.push_back(weight);
    }
  }
  return sum;
}

PoleSum plain(const DualPoles& dual_poles) {
  PoleSum sum{dual_poles.direct, {}, {}};
  if (dual_poles.at_rest > 0) {
    sum.rates.push_back(0);
    sum.weights.push_back(dual_poles.at_rest);
  }
  for (std::size_t j = 0; j < dual_poles.rates.size(); ++j) {
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
  return plain(dual(stiffness_poles(relaxation)));
}

template <class Combine>
Relaxation fold(const std::vector<Network>& parts, const Values& values, const Combine& combine) {
  Relaxation form = relaxation_form(parts.at(0), values);
  for (std::size_t i = 1; i < parts.size(); ++i)
    form = combine(form, relaxation_form(parts[i], values));
  return form;
}

// All compliances are added before the one way back: each crossing costs rounding errors.
Relaxation series_of(const std::vector<Network>& parts, const Values& values) {
  PoleSum compliance = compliance_poles(relaxation_form(parts.at(0), values));
  for (std::size_t i = 1; i < parts.size(); ++i)
    compliance = sum_of(compliance, compliance_poles(relaxation_form(parts[i], values)));
  return relaxation_of(plain(dual(compliance)));
}

struct FormOf {
  const Values& values;
  Relaxation operator()(const Element& element) const { return form_of(element, values); }
  Relaxation operator()(const Series& s) const { return series_of(s.parts, values); }
  Relaxation operator()(const Parallel& p) const {
    return fold(p.parts, values,
                [](const Relaxation& a, const Relaxation& b) { return parallel(a, b); });
  }
  Relaxation operator()(const Graph& graph) const {
    std::vector<Relaxation> edges;
    for (const Network& part : graph.parts) edges.push_back(relaxation_form(part, values));
    return graph_relaxation(graph.nodes.size(), graph.wires, edges);
  }
};

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

Relaxation parallel(const Relaxation& a, const Relaxation& b) {
  return relaxation_of(sum_of(stiffness_poles(a), stiffness_poles(b)));
}

Relaxation series(const Relaxation& a, const Relaxation& b) {
  return relaxation_of(plain(dual(sum_of(compliance_poles(a), compliance_poles(b)))));
}

Relaxation relaxation_form(const Network& network, const Values& values) {
  return std::visit(FormOf{values}, network.form);
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
