// The nodal analysis, compiled once: numbers of 250 digits take the compiler long.
#include "support/nodal.hpp"

#include <boost/multiprecision/complex_adaptor.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <ios>
#include <vector>

#include "support/numbers.hpp"

namespace vcrit::test {

namespace {

using Binary = boost::multiprecision::mpfr_float_backend<250>;
using ManyDigits = boost::multiprecision::number<Binary>;
using ComplexDigits = boost::multiprecision::number<boost::multiprecision::complex_adaptor<Binary>>;

}  // namespace

struct Real::Digits {
  ManyDigits value;
};

namespace {

const ManyDigits& inside(const Real& a) { return a.digits().value; }

ComplexDigits inside(const Complex& a) { return {inside(a.real()), inside(a.imag())}; }

Real outside(const ManyDigits& value) {
  return Real(std::make_shared<const Real::Digits>(Real::Digits{value}));
}

Complex outside(const ComplexDigits& value) {
  return {outside(ManyDigits(value.real())), outside(ManyDigits(value.imag()))};
}

class Admittances {
 public:
  Admittances(const Values& values, const ManyDigits& omega) : values_(values), omega_(omega) {}

  ComplexDigits stiffness(const Network& network) {
    place(network, 0, 1);
    return eliminate(assemble());
  }

 private:
  using Matrix = std::vector<std::vector<ComplexDigits>>;
  struct Edge {
    std::size_t from, to;
    ComplexDigits stiffness;
  };

  ManyDigits value(const Amount& amount) const {
    return amount.is_symbol() ? ManyDigits(values_.at(amount.symbol()))
                              : value(*amount.expression());
  }

  ManyDigits value(const AmountTree& e) const {
    if (e.kind == AmountTree::Kind::symbol) return ManyDigits(values_.at(e.symbol));
    if (e.kind == AmountTree::Kind::number) return ManyDigits(e.number.decimal);
    const ManyDigits a = value(*e.first), b = value(*e.second);
    if (e.kind == AmountTree::Kind::sum) return a + b;
    return e.kind == AmountTree::Kind::product ? ManyDigits(a * b) : ManyDigits(a / b);
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
    const ComplexDigits spring(value(e.coefficient), ManyDigits(0));
    const ComplexDigits dashpot(ManyDigits(0), value(e.coefficient) * omega_);
    if (e.kind == ElementKind::spring) edges_.push_back({a, b, spring});
    if (e.kind == ElementKind::lossy)
      edges_.push_back({a, b, spring * ComplexDigits(ManyDigits(1), value(e.second))});
    if (e.kind == ElementKind::damper) edges_.push_back({a, b, dashpot});
    if (e.kind == ElementKind::mass)
      edges_.push_back({a, b, dashpot * ComplexDigits(ManyDigits(0), omega_)});  // -m omega^2
    if (e.kind == ElementKind::maxwell) {
      const std::size_t inner = nodes_++;
      edges_.push_back({a, inner, spring});
      edges_.push_back({inner, b, dashpot * ComplexDigits(value(e.second), ManyDigits(0))});
    }
  }

  Matrix assemble() const {
    Matrix k(nodes_, std::vector<ComplexDigits>(nodes_));
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
        if (edge.stiffness != ComplexDigits() && (is_held[edge.from] || is_held[edge.to]))
          is_held[edge.from] = is_held[edge.to] = true;
    return is_held;
  }

  // Schur complement of all inner nodes, the last one first; -K_01 is the stiffness. What nothing
  // holds carries no load.
  ComplexDigits eliminate(Matrix k) const {
    const std::vector<bool> is_held = held();
    for (std::size_t n = k.size() - 1; n >= 2; --n)
      for (std::size_t i = 0; is_held[n] && i < n; ++i) {
        const ComplexDigits factor = k[i][n] / k[n][n];
        for (std::size_t j = 0; j < n; ++j) k[i][j] -= factor * k[n][j];
      }
    return -k[0][1];
  }

  const Values& values_;
  ManyDigits omega_;
  std::size_t nodes_ = 2;
  std::vector<Edge> edges_;
};

}  // namespace

Real::Real(double value) : Real(outside(ManyDigits(value))) {}
Real::Real(const std::string& decimal) : Real(outside(ManyDigits(decimal))) {}
Real::operator double() const { return static_cast<double>(digits_->value); }
std::string Real::str(int figures) const {
  return digits_->value.str(figures, std::ios::scientific);
}

Real operator-(const Real& a) { return outside(ManyDigits(-inside(a))); }
Real operator+(const Real& a, const Real& b) { return outside(ManyDigits(inside(a) + inside(b))); }
Real operator-(const Real& a, const Real& b) { return outside(ManyDigits(inside(a) - inside(b))); }
Real operator*(const Real& a, const Real& b) { return outside(ManyDigits(inside(a) * inside(b))); }
Real operator/(const Real& a, const Real& b) { return outside(ManyDigits(inside(a) / inside(b))); }
Real& operator+=(Real& a, const Real& b) { return a = a + b; }
bool operator<(const Real& a, const Real& b) { return inside(a) < inside(b); }
bool operator<=(const Real& a, const Real& b) { return inside(a) <= inside(b); }
bool operator>(const Real& a, const Real& b) { return b < a; }
bool isfinite(const Real& a) { return isfinite(inside(a)); }
Real abs(const Real& a) { return outside(ManyDigits(abs(inside(a)))); }
Real sqrt(const Real& a) { return outside(ManyDigits(sqrt(inside(a)))); }
Real atan2(const Real& y, const Real& x) {
  return outside(ManyDigits(atan2(inside(y), inside(x))));
}
Real ldexp(const Real& a, int exponent) { return outside(ManyDigits(ldexp(inside(a), exponent))); }

Complex operator-(const Complex& a) { return {-a.real(), -a.imag()}; }
Complex operator+(const Complex& a, const Complex& b) {
  return {a.real() + b.real(), a.imag() + b.imag()};
}
Complex operator-(const Complex& a, const Complex& b) {
  return {a.real() - b.real(), a.imag() - b.imag()};
}
Complex operator*(const Complex& a, const Complex& b) {
  return outside(ComplexDigits(inside(a) * inside(b)));
}
Complex operator/(const Complex& a, const Complex& b) {
  return outside(ComplexDigits(inside(a) / inside(b)));
}
Complex& operator+=(Complex& a, const Complex& b) { return a = a + b; }
Complex& operator-=(Complex& a, const Complex& b) { return a = a - b; }
Real abs(const Complex& a) { return outside(ManyDigits(abs(inside(a)))); }

Complex Nodal::stiffness(const Network& network) const {
  return outside(Admittances(values_, inside(omega_)).stiffness(network));
}

double relative_error(std::complex<double> value, const Complex& exact) {
  const Complex difference = Complex(Real(value.real()), Real(value.imag())) - exact;
  return static_cast<double>(Real(abs(difference)) / Real(abs(exact)));
}

double relative_error(double value, const Real& exact) {
  return static_cast<double>(abs(Real(value) / exact - 1));
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
    result = result * abs(mount) / abs(whole);
  }
  if (!scene.drive) return result;
  Complex dynamic = nodal.stiffness(*scene.drive);
  if (scene.mass) dynamic -= Complex(Real(values.at(scene.mass->symbol)) * omega * omega, Real(0));
  return result * Real(abs(Complex(tangential + dynamic))) / Real(abs(dynamic));
}

}  // namespace vcrit::test
