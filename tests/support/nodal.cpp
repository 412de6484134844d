// The nodal analysis, compiled once: numbers of 250 digits take the compiler long.
#include "support/nodal.hpp"
#include "support/numbers.hpp"

#include <utility>
#include <vector>

namespace vcrit::test {

namespace {

class Admittances {
 public:
  Admittances(const Values& values, const Real& omega) : values_(values), omega_(omega) {}

  Complex stiffness(const Network& network) {
    place(network, 0, 1);
    return eliminate(assemble());
  }

 private:
  using Matrix = std::vector<std::vector<Complex>>;
  struct Edge {
    std::size_t from, to;
    Complex stiffness;
  };

  Real value(const Amount& amount) const {
    return amount.is_symbol() ? Real(values_.at(amount.symbol())) : value(*amount.expression());
  }

  Real value(const AmountTree& e) const {
    if (e.kind == AmountTree::Kind::symbol) return Real(values_.at(e.symbol));
    if (e.kind == AmountTree::Kind::number) return Real(e.number.decimal);
    const Real a = value(*e.first), b = value(*e.second);
    if (e.kind == AmountTree::Kind::sum) return a + b;
    return e.kind == AmountTree::Kind::product ? Real(a * b) : Real(a / b);
  }

  void place(const Network& network, std::size_t a, std::size_t b) {
    if (const auto* e = std::get_if<Element>(&network.form)) place(*e, a, b);
    if (const auto* s = std::get_if<Series>(&network.form)) {
      std::size_t from = a;
      for (std::size_t i = 0; i < s->parts.size(); ++i) {
        const std::size_t to = i + 1 == s->parts.size() ? b : nodes_++;
        place(s->parts[i], from, to);
        from = to;
      }
    }
    if (const auto* p = std::get_if<Parallel>(&network.form))
      for (const Network& part : p->parts) place(part, a, b);
    if (const auto* g = std::get_if<Graph>(&network.form)) {
      std::vector<std::size_t> names{a, b};
      while (names.size() < g->nodes.size()) names.push_back(nodes_++);
      for (std::size_t i = 0; i < g->parts.size(); ++i)
        place(g->parts[i], names[static_cast<std::size_t>(g->wires[i].from)],
              names[static_cast<std::size_t>(g->wires[i].to)]);
    }
  }

  void place(const Element& e, std::size_t a, std::size_t b) {
    const Complex spring(value(e.coefficient), Real(0));
    const Complex dashpot(Real(0), value(e.coefficient) * omega_);
    if (e.kind == ElementKind::spring) edges_.push_back({a, b, spring});
    if (e.kind == ElementKind::lossy)
      edges_.push_back({a, b, spring * Complex(Real(1), value(e.second))});
    if (e.kind == ElementKind::damper) edges_.push_back({a, b, dashpot});
    if (e.kind == ElementKind::mass)
      edges_.push_back({a, b, dashpot * Complex(Real(0), omega_)});  // -m omega^2
    if (e.kind == ElementKind::maxwell) {
      const std::size_t inner = nodes_++;
      edges_.push_back({a, inner, spring});
      edges_.push_back({inner, b, dashpot * Complex(value(e.second), Real(0))});
    }
  }

  Matrix assemble() const {
    Matrix k(nodes_, std::vector<Complex>(nodes_));
    for (const Edge& edge : edges_) {
      k[edge.from][edge.from] += edge.stiffness;
      k[edge.to][edge.to] += edge.stiffness;
      k[edge.from][edge.to] -= edge.stiffness;
      k[edge.to][edge.from] -= edge.stiffness;
    }
    return k;
  }

  /// Nodes that edges connect with a terminal; edges may be 0.
  std::vector<bool> held() const {
    std::vector<bool> is_held(nodes_);
    is_held[0] = is_held[1] = true;
    for (std::size_t round = 0; round < nodes_; ++round)
      for (const Edge& edge : edges_)
        if (edge.stiffness != Complex() && (is_held[edge.from] || is_held[edge.to]))
          is_held[edge.from] = is_held[edge.to] = true;
    return is_held;
  }

  // Schur complement of all inner nodes, the last one first; -K_01 is the stiffness. What nothing
  // holds carries no load.
  Complex eliminate(Matrix k) const {
    const std::vector<bool> is_held = held();
    for (std::size_t n = k.size() - 1; n >= 2; --n)
      for (std::size_t i = 0; is_held[n] && i < n; ++i) {
        const Complex factor = k[i][n] / k[n][n];
        for (std::size_t j = 0; j < n; ++j) k[i][j] -= factor * k[n][j];
      }
    return -k[0][1];
  }

  const Values& values_;
  Real omega_;
  std::size_t nodes_ = 2;
  std::vector<Edge> edges_;
};

}  // namespace

Complex Nodal::stiffness(const Network& network) const {
  return Admittances(values_, omega_).stiffness(network);
}

double relative_error(std::complex<double> value, const Complex& exact) {
  const Complex difference = Complex(Real(value.real()), Real(value.imag())) - exact;
  return static_cast<double>(Real(abs(difference)) / Real(abs(exact)));
}

Real critical_velocity_by_nodes(const Scene& scene) {
  const Values values = numbers_of(scene);
  const Real omega(values.at(scene.angular_frequency.symbol));
  Nodal nodal(values, omega);
  const Complex normal = nodal.stiffness(scene.normal);
  Complex tangential;
  if (const auto* network = std::get_if<Network>(&scene.tangential)) {
    tangential = nodal.stiffness(*network);
  } else {
    const auto& isotropic = std::get<Isotropic>(scene.tangential);
    const Real given(*isotropic.quantity.value);
    const Real ratio =
        isotropic.by == Isotropic::By::poisson ? Real(2 * (1 - given) / (2 - given)) : given;
    tangential = normal * Complex(ratio, Real(0));
  }
  Real result = Real(values.at(scene.coefficient.symbol)) * omega *
                Real(values.at(scene.amplitude.symbol)) * Real(abs(normal)) / Real(abs(tangential));
  if (scene.mount) {
    const Complex mount = nodal.stiffness(*scene.mount);
    Complex whole = mount + normal;
    if (scene.mount_mass)
      whole -= Complex(Real(values.at(scene.mount_mass->symbol)) * omega * omega, Real(0));
    result *= Real(abs(mount)) / Real(abs(whole));
  }
  if (!scene.drive) return result;
  Complex dynamic = nodal.stiffness(*scene.drive);
  if (scene.mass) dynamic -= Complex(Real(values.at(scene.mass->symbol)) * omega * omega, Real(0));
  return result * Real(abs(Complex(tangential + dynamic))) / Real(abs(dynamic));
}

}  // namespace vcrit::test
