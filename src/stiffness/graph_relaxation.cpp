#include "stiffness/graph_relaxation.hpp"

#include <fmt/core.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>
#include <numeric>

#include "base/errors.hpp"

namespace vcrit {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                           boost::multiprecision::et_off>;

}  // namespace vcrit

// What Eigen 3.4 asks of a scalar; Boost 1.74's own header for this is older than that.
template <>
struct Eigen::NumTraits<vcrit::Real> : Eigen::GenericNumTraits<vcrit::Real> {
  enum { RequireInitialization = 1, ReadCost = 20, AddCost = 40, MulCost = 200 };
  static int digits10() { return std::numeric_limits<vcrit::Real>::digits10; }
};

namespace vcrit {

namespace {

using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

// Which nodes hang together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t node) const {
    while (parent_[node] != node) node = parent_[node];
    return node;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parent_;
};

// The nodes, and one in the middle of each branch.
std::size_t size_of(const RelaxationGraph& graph) {
  std::size_t count = graph.nodes;
  for (const Relaxation& edge : graph.edges) count += edge.branches.size();
  return count;
}

// Springs and dampers between nodes; node 1, a terminal, is held and has no row.
class NodalPair {
 public:
  explicit NodalPair(const RelaxationGraph& graph) : springs_(graph.nodes), dampers_(graph.nodes) {
    const auto& [nodes, wires, edges] = graph;
    const auto size = static_cast<Eigen::Index>(size_of(graph));
    stiffness_ = damping_ = RealMatrix::Zero(size, size);
    std::size_t inner = nodes;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto from = static_cast<std::size_t>(wires[i].from);
      const auto to = static_cast<std::size_t>(wires[i].to);
      if (edges[i].equilibrium > 0) springs_.join(from, to);
      if (edges[i].damper > 0) dampers_.join(from, to);
      stamp(stiffness_, from, to, edges[i].equilibrium);
      stamp(damping_, from, to, edges[i].damper);
      for (const MaxwellBranch& branch : edges[i].branches) {
        stamp(stiffness_, from, inner, branch.stiffness);
        stamp(damping_, inner++, to, Real(branch.stiffness) * branch.time);
      }
    }
  }

  // Branches are open between springs as well as between dampers, so they join nothing.
  bool springs_connect() const { return springs_.of(0) == springs_.of(1); }
  bool dampers_connect() const { return dampers_.of(0) == dampers_.of(1); }

  RealMatrix inner(const RealMatrix& m) const {
    return m.bottomRightCorner(m.rows() - 2, m.cols() - 2);
  }
  RealVector column(const RealMatrix& m) const { return m.col(0).tail(m.rows() - 2); }
  const RealMatrix& stiffness() const { return stiffness_; }
  const RealMatrix& damping() const { return damping_; }

 private:
  static void stamp(RealMatrix& m, std::size_t from, std::size_t to, const Real& value) {
    const auto i = static_cast<Eigen::Index>(from), j = static_cast<Eigen::Index>(to);
    m(i, i) += value;
    m(j, j) += value;
    m(i, j) -= value;
    m(j, i) -= value;
  }

  Groups springs_, dampers_;
  RealMatrix stiffness_, damping_;
};

struct Branch {
  Real stiffness, rate;
};

// K(s) collected term by term: equilibrium stiffness, direct damper, branches.
class Collected {
 public:
  Collected(const Real& a00, const Real& c00) : equilibrium_(a00), damper_(c00) {}

  // (p + s q)^2/(mu + s nu), taken off.
  void take_off(const Real& p, const Real& q, const Real& mu, const Real& nu) {
    if (mu > tiny()) equilibrium_ -= p * p / mu;
    if (nu <= tiny()) return;
    damper_ -= q * q / nu;
    if (mu <= tiny()) return;
    const Real rate = mu / nu, force = p - q * rate;
    branches_.push_back({force * force / mu, rate});
  }

  Relaxation form(bool springs_connect, bool dampers_connect) {
    if (!springs_connect) equilibrium_ = 0;
    if (!dampers_connect) damper_ = 0;
    std::sort(branches_.begin(), branches_.end(),
              [](const Branch& a, const Branch& b) { return a.rate > b.rate; });
    Relaxation result{equilibrium_.convert_to<double>(), damper_.convert_to<double>(), {}};
    for (const Branch& branch : branches_)
      if (branch.stiffness > 1e-30 * stiffness_at(branch.rate)) add(result, branch);
    return result;
  }

  // Eigenvalues of the scaled pair lie in [0, 1]; below this they are the rounding of zeros.
  static Real tiny() { return Real("1e-85"); }

 private:
  Real stiffness_at(const Real& s) const {
    Real sum = equilibrium_ + damper_ * s;
    for (const Branch& branch : branches_) sum += branch.stiffness * s / (s + branch.rate);
    return sum;
  }
  static void add(Relaxation& form, const Branch& branch) {
    const auto stiffness = branch.stiffness.convert_to<double>();
    const auto time = Real(1 / branch.rate).convert_to<double>();
    if (!form.branches.empty() && time - form.branches.back().time <= 1e-15 * time)
      form.branches.back().stiffness += stiffness;
    else
      form.branches.push_back({stiffness, time});
  }

  Real equilibrium_, damper_;
  std::vector<Branch> branches_;
};

// A rate within the range of the pair's own: it only has to keep both parts of the sum in sight.
Real middle_rate(const RealMatrix& stiffness, const RealMatrix& damping) {
  const Real a = stiffness.trace(), c = damping.trace();
  return a > 0 && c > 0 ? Real(a / c) : Real(1);
}

}  // namespace

Relaxation graph_relaxation(const RelaxationGraph& graph) {
  if (graph.edges.size() == 1) return graph.edges[0];
  if (const std::size_t modes = size_of(graph) - 2; modes > most_modes)
    throw InputError({"a graph"},
                     fmt::format("{} inner nodes and branches after series and parallel", modes),
                     fmt::format("at most {}", most_modes));
  const NodalPair pair(graph);
  Collected collected(pair.stiffness()(0, 0), pair.damping()(0, 0));
  if (pair.stiffness().rows() > 2) {
    const Real alpha = middle_rate(pair.stiffness(), pair.damping());
    const RealMatrix a = pair.inner(pair.stiffness()) / alpha, c = pair.inner(pair.damping());
    const Eigen::GeneralizedSelfAdjointEigenSolver<RealMatrix> modes(a, a + c);
    ensure(modes.info() == Eigen::Success, "the nodal eigenproblem has a solution");
    const RealVector p = modes.eigenvectors().transpose() * pair.column(pair.stiffness());
    const RealVector q = modes.eigenvectors().transpose() * pair.column(pair.damping());
    for (Eigen::Index j = 0; j < p.size(); ++j) {
      const Real share = modes.eigenvalues()(j);  // A x/alpha = share (A/alpha + C) x
      collected.take_off(p(j), q(j), share > Collected::tiny() ? Real(share * alpha) : Real(0),
                         1 - share);
    }
  }
  return collected.form(pair.springs_connect(), pair.dampers_connect());
}

}  // namespace vcrit
