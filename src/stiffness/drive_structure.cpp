// Masses, springs and dampers are put together node by node. What is between masses alone stays as
// it is written; the other nodes are eliminated by one symmetric eigenproblem. With S and D the
// springs and dampers of the nodes p to eliminate, S + D = L L^T and L^-1 S L^-T = U mu U^T,
//   z = U^T L^T p,   (mu + s (1 - mu)) z = -(k + s c).q    for each of them,
// with k, c rows of U^T L^-1 S_pq and U^T L^-1 D_pq. What it takes off K + s C is
//   (k + s c)(k + s c)^T/(mu + s (1 - mu))
//     = k k^T/mu + s c c^T/(1 - mu) - (1/mu) d d^T s/(s + a),   a = mu/(1 - mu), d = k - a c,
// without the second and third part where mu = 1 (springs alone: c = 0), and without the first and
// third where mu = 0 (dampers alone: k = 0).
#include "stiffness/drive_structure.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "linear/elimination.hpp"
#include "linear/orthogonal.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit {

namespace {

using StructureReal = long double;
using DenseStructure = linear::DenseMatrix<StructureReal>;
using StructureColumn = linear::DenseVector<StructureReal>;

constexpr std::size_t body_node = 0, far_node = 1;

// The share of a sum within which an eigenvalue of it is 0: of some dozen nodes, in these numbers.
constexpr StructureReal no_share = 1e-16L;

// Parts that hold the body's end move it in proportion if they do so to this share: what rounding
// leaves of doubles.
constexpr StructureReal same_proportion = 1e-13L;

struct HeldEdge {
  std::size_t from, to;
  Relaxation form;
};

struct InertialNode {
  std::vector<NamedMass> named;
  double mass = 0;
};

/// A drive's network as nodes with masses, and edges without.
class MassGraph {
 public:
  MassGraph(const Values& values) : nodes_(2), values_(values) {}

  void add(const Network& part, std::size_t from, std::size_t to) {
    if (!has_masses(part)) {
      edges_.push_back({from, to, relaxation_form(part, values_)});
      return;
    }
    std::visit([&](const auto& form) { add_form(form, from, to); }, part.form);
  }

  void add_mass(std::size_t node, double mass, const Symbol& symbol) {
    nodes_[node].mass += mass;
    nodes_[node].named.push_back({symbol, node});
  }

  const std::vector<InertialNode>& nodes() const { return nodes_; }
  const std::vector<HeldEdge>& edges() const { return edges_; }

 private:
  void add_form(const Element& element, std::size_t from, std::size_t to) {
    const auto mass = amount_value(element.coefficient, values_);
    const std::string name = to_text(element.coefficient.name());
    if (!mass) throw InputError(argument("values"), name + " without a value", "a mass");
    if (!(*mass > 0 && std::isfinite(*mass)))
      throw InputError(argument("values"), fmt::format("{} = {}", name, *mass),
                       "a finite value above 0");
    const std::size_t node = from == far_node ? to : from;
    if (node != far_node) add_mass(node, *mass, element.coefficient.name());
  }
  void add_form(const Series& series, std::size_t from, std::size_t to) {
    for (std::size_t i = 0; i + 1 < series.parts.size(); ++i) {
      const std::size_t next = new_node();
      add(series.parts[i], from, next);
      from = next;
    }
    add(series.parts.back(), from, to);
  }
  void add_form(const Parallel& parallel, std::size_t from, std::size_t to) {
    for (const Network& part : parallel.parts) add(part, from, to);
  }
  void add_form(const Graph& graph, std::size_t from, std::size_t to) {
    std::vector<std::size_t> place{from, to};
    while (place.size() < graph.nodes.size()) place.push_back(new_node());
    for (std::size_t i = 0; i < graph.parts.size(); ++i)
      add(graph.parts[i], place[static_cast<std::size_t>(graph.wires[i].from)],
          place[static_cast<std::size_t>(graph.wires[i].to)]);
  }

  std::size_t new_node() {
    nodes_.emplace_back();
    return nodes_.size() - 1;
  }

  std::vector<InertialNode> nodes_;
  std::vector<HeldEdge> edges_;
  const Values& values_;
};

/// Springs, dampers and relaxing branches over numbered places; first those that stay.
struct NodalForms {
  NodalForms(std::size_t kept, std::size_t all)
      : staying(kept),
        springs(
            DenseStructure::Zero(static_cast<Eigen::Index>(all), static_cast<Eigen::Index>(all))),
        dampers(springs) {}

  static void link(DenseStructure& matrix, std::optional<std::size_t> a,
                   std::optional<std::size_t> b, StructureReal value) {
    const auto at = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    if (a) matrix(at(*a), at(*a)) += value;
    if (b) matrix(at(*b), at(*b)) += value;
    if (!a || !b) return;
    matrix(at(*a), at(*b)) -= value;
    matrix(at(*b), at(*a)) -= value;
  }

  void eliminate();

  std::size_t staying;
  DenseStructure springs, dampers;
  std::vector<DriveBranch> branches;
};

// What elimination leaves of a number that it should take off all of is rounding.
void clean(DenseStructure& matrix, const DenseStructure& before) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      if (std::abs(matrix(i, j)) <= no_share * std::sqrt(before(i, i) * before(j, j)))
        matrix(i, j) = 0;
}

void NodalForms::eliminate() {
  const auto n = static_cast<Eigen::Index>(staying), m = springs.rows() - n;
  DenseStructure k = springs.topLeftCorner(n, n), c = dampers.topLeftCorner(n, n);
  if (m > 0) {
    const DenseStructure inner = springs.bottomRightCorner(m, m);
    const DenseStructure all = inner + dampers.bottomRightCorner(m, m);
    const linear::Cholesky lower(all);
    const DenseStructure half = lower.solve_lower(inner);
    const DenseStructure shares = lower.solve_lower(half.transpose());
    const auto eigen = linear::symmetric_eigen(DenseStructure((shares + shares.transpose()) / 2));
    const DenseStructure to = eigen.vectors.transpose();
    const DenseStructure springs_to = to * lower.solve_lower(springs.bottomLeftCorner(m, n));
    const DenseStructure dampers_to = to * lower.solve_lower(dampers.bottomLeftCorner(m, n));
    for (Eigen::Index i = 0; i < m; ++i) {
      const StructureReal mu = eigen.values[i], nu = 1 - mu;
      const StructureColumn ki = springs_to.row(i).transpose(), ci = dampers_to.row(i).transpose();
      if (mu > no_share) k -= ki * ki.transpose() / mu;
      if (nu > no_share) c -= ci * ci.transpose() / nu;
      if (!(mu > no_share && nu > no_share)) continue;
      const StructureColumn d = ki - mu / nu * ci;
      branches.push_back({1 / mu, nu / mu, std::vector<StructureReal>(d.begin(), d.end())});
    }
    clean(k, springs);
    clean(c, dampers);
  }
  springs = std::move(k);
  dampers = std::move(c);
}

// In units in which springs and dampers are alike, any time will do; one of the network's own keeps
// the eigenvalues apart.
StructureReal time_unit(const std::vector<HeldEdge>& edges) {
  StructureReal springs = 0, dampers = 0;
  for (const HeldEdge& edge : edges) {
    springs += edge.form.equilibrium;
    dampers += edge.form.damper;
    for (const auto& [stiffness, time] : edge.form.branches) {
      springs += stiffness;
      dampers += static_cast<StructureReal>(stiffness) * time;
    }
  }
  return springs > 0 && dampers > 0 ? dampers / springs : 1;
}

class StructureOf {
 public:
  explicit StructureOf(const MassGraph& graph) : graph_(graph) {
    place_.resize(graph.nodes().size());
    const auto number = [&](auto stays) {
      for (std::size_t node = 0; node < place_.size(); ++node)
        if (node != far_node && stays(node)) place_[node] = count_++;
    };
    number([&](std::size_t node) { return graph.nodes()[node].mass > 0; });
    masses_ = count_;
    number([&](std::size_t node) { return node == body_node && !(graph.nodes()[node].mass > 0); });
    kept_ = count_;
    number([&](std::size_t node) { return node != body_node && !(graph.nodes()[node].mass > 0); });
  }

  DriveStructure structure() {
    DriveStructure result;
    for (std::size_t node = 0; node < place_.size(); ++node) {
      const InertialNode& each = graph_.nodes()[node];
      if (node == far_node || !(each.mass > 0)) continue;
      result.mass.push_back(each.mass);
      for (const NamedMass& one : each.named) result.named.push_back({one.symbol, *place_[node]});
    }
    NodalForms forms = eliminated();
    result.port.assign(masses_, 0);
    result.together.assign(masses_, 1);
    if (kept_ == masses_)
      result.port[*place_[body_node]] = 1;
    else
      take_off_lead(forms, result);
    result.stiffness = of(forms.springs);
    result.damping = of(forms.dampers);
    result.branches = std::move(forms.branches);
    return result;
  }

 private:
  // A branch beside an inner node becomes a spring, a node and a damper.
  NodalForms eliminated() const {
    std::size_t all = count_;
    for (const HeldEdge& edge : graph_.edges())
      if (!between_kept(edge)) all += edge.form.branches.size();
    NodalForms forms(kept_, all);
    const StructureReal unit = time_unit(graph_.edges());
    std::size_t inner = count_;
    for (const HeldEdge& edge : graph_.edges()) {
      const auto from = place_[edge.from], to = place_[edge.to];
      NodalForms::link(forms.springs, from, to, edge.form.equilibrium);
      NodalForms::link(forms.dampers, from, to, edge.form.damper / unit);
      for (const auto& [stiffness, time] : edge.form.branches) {
        if (between_kept(edge)) {
          forms.branches.push_back({stiffness, time / unit, pull(from, to)});
          continue;
        }
        NodalForms::link(forms.springs, from, inner, stiffness);
        NodalForms::link(forms.dampers, inner++, to,
                         static_cast<StructureReal>(stiffness) * time / unit);
      }
    }
    forms.eliminate();
    forms.dampers *= unit;
    for (DriveBranch& branch : forms.branches) branch.time *= unit;
    return forms;
  }

  bool between_kept(const HeldEdge& edge) const {
    return std::max(place_[edge.from].value_or(0), place_[edge.to].value_or(0)) < kept_;
  }

  std::vector<StructureReal> pull(std::optional<std::size_t> from,
                                  std::optional<std::size_t> to) const {
    std::vector<StructureReal> result(kept_, 0);
    if (from) result[*from] += 1;
    if (to) result[*to] -= 1;
    return result;
  }

  // The body's end without a mass is the last one that was kept. What holds it to the others, in
  // proportions p, is K_L(s) (x - p.q)^2/2: a network of its own in series with the contact, and
  // nothing else between the others.
  void take_off_lead(NodalForms& forms, DriveStructure& result) const {
    const auto n = static_cast<Eigen::Index>(masses_);
    Relaxation lead{
        static_cast<double>(forms.springs(n, n)), static_cast<double>(forms.dampers(n, n)), {}};
    std::vector<StructureReal>& port = result.port;
    bool first = true;
    const auto hear = [&](const auto& row, StructureReal own) {
      for (std::size_t i = 0; i < masses_; ++i) {
        const StructureReal share = -row(i) / own;
        if (first)
          port[i] = share;
        else if (std::abs(share - port[i]) > same_proportion)
          throw ModelError(
              "the drive's end at the body has no mass, and several parts hold it that move it in "
              "different proportions: its motion is none of the simulator's forms",
              "give the body a mass, [body] mass");
      }
      first = false;
    };
    const auto row_of = [n](const DenseStructure& matrix) {
      return [&matrix, n](std::size_t i) { return matrix(n, static_cast<Eigen::Index>(i)); };
    };
    if (lead.equilibrium > 0) hear(row_of(forms.springs), forms.springs(n, n));
    if (lead.damper > 0) hear(row_of(forms.dampers), forms.dampers(n, n));
    std::vector<Relaxation> parts{lead};
    std::vector<DriveBranch> left;
    for (DriveBranch& branch : forms.branches) {
      const StructureReal own = branch.pull.back();
      branch.pull.pop_back();
      if (std::abs(own) <= same_proportion * size_of(branch.pull)) {
        left.push_back(std::move(branch));
        continue;
      }
      hear([&](std::size_t i) { return branch.pull[i]; }, own);
      parts.push_back({0,
                       0,
                       {{static_cast<double>(branch.stiffness * own * own),
                         static_cast<double>(branch.time)}}});
    }
    result.lead = parallel(parts);
    const StructureColumn p = Eigen::Map<const StructureColumn>(port.data(), n);
    const auto rest = [&](const DenseStructure& matrix) {
      return DenseStructure(matrix.topLeftCorner(n, n) - matrix(n, n) * p * p.transpose());
    };
    forms.springs = rest(forms.springs);
    forms.dampers = rest(forms.dampers);
    forms.branches = std::move(left);
  }

  static StructureReal size_of(const std::vector<StructureReal>& pull) {
    StructureReal sum = 0;
    for (const StructureReal each : pull) sum += std::abs(each);
    return sum;
  }

  static Dense<StructureReal> of(const DenseStructure& matrix) {
    Dense<StructureReal> result(static_cast<std::size_t>(matrix.rows()),
                                static_cast<std::size_t>(matrix.cols()));
    for (std::size_t i = 0; i < result.rows(); ++i)
      for (std::size_t j = 0; j < result.columns(); ++j)
        result(i, j) = matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    return result;
  }

  const MassGraph& graph_;
  std::vector<std::optional<std::size_t>> place_;  // of each node; the far end has none
  std::size_t count_ = 0, masses_ = 0, kept_ = 0;
};

}  // namespace

DriveStructure drive_structure(const Network& drive, const Values& values, double body,
                               const Symbol& body_symbol) {
  if (!(body >= 0 && std::isfinite(body)))
    throw InputError(argument("body"), fmt::format("{} kg", body), "a finite mass of at least 0");
  MassGraph graph(values);
  if (body > 0) graph.add_mass(body_node, body, body_symbol);
  graph.add(drive, body_node, far_node);
  return StructureOf(graph).structure();
}

DriveStructure stiffer(DriveStructure structure, double times) {
  for (long double& number : structure.stiffness.numbers()) number *= times;
  for (long double& number : structure.damping.numbers()) number *= times;
  for (DriveBranch& branch : structure.branches) branch.stiffness *= times;
  return structure;
}

}  // namespace vcrit
