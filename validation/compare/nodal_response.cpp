#include "compare/nodal_response.hpp"

#include <cstdlib>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "linear/elimination.hpp"
#include "network/law.hpp"

namespace vcrit::validation {

namespace {

// Beyond this a dense matrix takes too long.
constexpr int most_nodes = 300;

// The algebra of law.hpp.
struct LongArithmetic {
  using Value = LongComplex;

  const Values& values;
  LongComplex s;

  Value of(const Symbol& symbol) const { return static_cast<long double>(values.at(symbol)); }
  static Value constant(const TypedNumber& number) {
    return std::strtold(number.decimal.c_str(), nullptr);
  }
  static Value plus(const Value& a, const Value& b) { return a + b; }
  static Value times(const Value& a, const Value& b) { return a * b; }
  static Value over(const Value& a, const Value& b) { return a / b; }
  Value times_s(const Value& k) const { return k * s; }
  Value relaxing(const Value& k, const Value& tau) const {
    return k * (tau * s) / (1.0L + tau * s);
  }
  static Value lossy(const Value& k, const Value& eta) { return k * Value(1, eta.real()); }
};

// Equations of motion of points that networks connect; the ground stands still.
class Points {
 public:
  static constexpr int ground = -1;  // no number of a node

  Points(const Values& values, double omega)
      : arithmetic_{values, {0, static_cast<long double>(omega)}} {}

  int add() {
    if (count_ == most_nodes) throw ModelError("networks with too many points for nodal analysis");
    return count_++;
  }

  void connect(int a, int b, const LongComplex& stiffness) { edges_.push_back({a, b, stiffness}); }

  void place(const Network& network, int a, int b, long double factor = 1) {
    if (const auto* e = std::get_if<Element>(&network.form))
      connect(a, b, factor * law(*e, arithmetic_));
    if (const auto* p = std::get_if<Parallel>(&network.form))
      for (const Network& part : p->parts) place(part, a, b, factor);
    if (const auto* s = std::get_if<Series>(&network.form)) {
      int from = a;
      for (std::size_t i = 0; i < s->parts.size(); ++i) {
        const int to = i + 1 == s->parts.size() ? b : add();
        place(s->parts[i], from, to, factor);
        from = to;
      }
    }
    if (const auto* g = std::get_if<Graph>(&network.form)) {
      std::vector<int> names{a, b};
      while (names.size() < g->nodes.size()) names.push_back(add());
      const auto name = [&](int node) { return names.at(static_cast<std::size_t>(node)); };
      for (std::size_t i = 0; i < g->parts.size(); ++i)
        place(g->parts[i], name(g->wires[i].from), name(g->wires[i].to), factor);
    }
  }

  // Displacement of a point for each newton on it.
  LongComplex compliance(int point) const {
    linear::DenseMatrix<LongComplex> k = linear::DenseMatrix<LongComplex>::Zero(count_, count_);
    for (const auto& [a, b, stiffness] : edges_) {
      if (a != ground) k(a, a) += stiffness;
      if (b != ground) k(b, b) += stiffness;
      if (a == ground || b == ground) continue;
      k(a, b) -= stiffness;
      k(b, a) -= stiffness;
    }
    const linear::DenseVector<LongComplex> force =
        linear::DenseVector<LongComplex>::Unit(count_, point);
    return linear::Lu<LongComplex>(k).solve(force)(point);
  }

 private:
  struct Edge {
    int a, b;
    LongComplex stiffness;
  };

  LongArithmetic arithmetic_;
  int count_ = 0;
  std::vector<Edge> edges_;
};

// 0 where it is rigid.
LongComplex measured_receptance(const Receptance& receptance, double omega) {
  if (omega < receptance.rows.front().omega || omega > receptance.rows.back().omega) return 0;
  const auto [below, above] = bracket(receptance, omega);
  const long double width = static_cast<long double>(above.omega) - below.omega;
  const long double share =
      width > 0 ? (static_cast<long double>(omega) - below.omega) / width : 0.0L;
  return LongComplex(below.re, below.im) * (1 - share) + LongComplex(above.re, above.im) * share;
}

}  // namespace

NodalResponse::NodalResponse(const Problem& problem)
    : problem_(problem), values_(problem_.values()) {}

LongComplex NodalResponse::contact_point(double omega) const {
  LongComplex receptance = 0;
  const auto* measured = problem_->receptance();
  if (measured != nullptr) receptance = measured_receptance(*measured, omega);
  const ReducedNetwork* drive = problem_->drive_network();
  if (drive == nullptr && receptance == LongComplex(0)) return contact_alone(omega);
  Points points(values_, omega);
  const int contact = points.add(), body = points.add();
  const auto [network, factor] = tangential_network(problem_);
  points.place(network.network(), contact, body, factor);
  if (drive != nullptr) points.place(drive->network(), body, Points::ground);
  if (measured != nullptr) points.connect(body, Points::ground, 1.0L / receptance);
  if (problem_->mass) {
    const long double mass = values_.at(problem_->mass->symbol);
    points.connect(body, Points::ground, -mass * omega * omega);
  }
  return points.compliance(contact);
}

LongComplex NodalResponse::contact_alone(double omega) const {
  Points points(values_, omega);
  const int contact = points.add();
  const auto [network, factor] = tangential_network(problem_);
  points.place(network.network(), contact, Points::ground, factor);
  return points.compliance(contact);
}

LongComplex NodalResponse::normal_stiffness(double omega) const {
  Points points(values_, omega);
  const int surface = points.add();
  points.place(problem_->normal.network(), surface, Points::ground);
  return 1.0L / points.compliance(surface);
}

}  // namespace vcrit::validation
