#include "stiffness/graph_relaxation.hpp"

#include <arb_mat.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/errors.hpp"
#include "stiffness/eigenmodes.hpp"

namespace vcrit {

namespace {

// The first is enough for most graphs. The last is more than graphs need whose elements span the
// whole range of doubles.
constexpr slong coarsest_bits = 384, finest_bits = 384 << 6;

constexpr slong product_bits = 106;  // the product of two doubles is exact with these

// The error of modes_coupled_to_last_row() is below 2^24 roundings for up to most_modes rows.
constexpr slong log2_roundings = 24;

// Nodes that are connected with each other.
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

  bool join_terminals() const { return of(0) == of(1); }
  std::size_t without_terminal() const {
    std::size_t count = 0;
    for (std::size_t node = 0; node < parent_.size(); ++node)
      if (parent_[node] == node && node != of(0) && node != of(1)) ++count;
    return count;
  }

 private:
  std::vector<std::size_t> parent_;
};

struct Link {
  std::size_t from, to;
  BigFloat value;  // exact
};

// All springs between the nodes, or all dampers.
struct Links {
  explicit Links(std::size_t nodes) : groups(nodes) {}

  void add(std::size_t from, std::size_t to, const BigFloat& value) {
    ensure(value.is_finite(), "the forms of a graph are finite");
    if (value == 0) return;
    all.push_back({from, to, value});
    groups.join(from, to);
    total += value;
  }

  std::vector<Link> all;
  Groups groups;
  BigFloat total;
};

// All nodes, counting one inside each branch.
std::size_t size_of(const RelaxationGraph& graph) {
  std::size_t count = graph.nodes;
  for (const Relaxation& edge : graph.edges) count += edge.branches.size();
  return count;
}

// The springs and dampers of a graph. A branch becomes a spring, a node and a damper.
struct NodalPair {
  explicit NodalPair(const RelaxationGraph& graph)
      : nodes(size_of(graph)), springs(nodes), dampers(nodes) {
    std::size_t middle = graph.nodes;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      const auto from = static_cast<std::size_t>(graph.wires[i].from);
      const auto to = static_cast<std::size_t>(graph.wires[i].to);
      springs.add(from, to, graph.edges[i].equilibrium);
      dampers.add(from, to, graph.edges[i].damper);
      for (const auto& [stiffness, time] : graph.edges[i].branches) {
        springs.add(from, middle, stiffness);
        dampers.add(middle++, to, BigFloat(stiffness, product_bits) * time);
      }
    }
    if (springs.total > 0 && dampers.total > 0)
      log2_alpha = (springs.total / dampers.total).exponent();
  }

  std::size_t nodes;
  Links springs, dampers;
  slong log2_alpha = 0;  // any alpha will do, but one within the range of rates needs fewest bits
};

// A matrix of real balls that frees itself. Each node has a row, except terminal 1, which is held.
// Terminal 0 has the last row.
class NodalMatrix {
 public:
  NodalMatrix(std::size_t nodes, slong bits) : size_(static_cast<slong>(nodes) - 1), bits_(bits) {
    arb_mat_init(matrix_, size_, size_);
  }
  NodalMatrix(const NodalMatrix&) = delete;
  NodalMatrix& operator=(const NodalMatrix&) = delete;
  ~NodalMatrix() { arb_mat_clear(matrix_); }

  // Adds the links, each times 2^exponent.
  void add(const Links& links, slong exponent) {
    for (const auto& [from, to, value] : links.all) {
      const BigFloat scaled = ldexp(value, exponent);
      put(arb_add_arf, from, from, scaled);
      put(arb_add_arf, to, to, scaled);
      put(arb_sub_arf, from, to, scaled);
      put(arb_sub_arf, to, from, scaled);
    }
  }

  // Replaces the matrix by its Cholesky factor L. Returns false unless it is proved to be positive
  // definite and the last entry of L is accurate to more bits than a double has.
  bool decompose() {
    return arb_mat_cho(matrix_, matrix_, bits_) != 0 &&
           arb_rel_accuracy_bits(arb_mat_entry(matrix_, size_ - 1, size_ - 1)) > 64;
  }

  // Replaces this matrix A by L^-1 A L^-T.
  void transform(const NodalMatrix& l) {
    for (int side = 0; side < 2; ++side) {
      arb_mat_solve_tril(matrix_, l.matrix_, matrix_, 0, bits_);
      arb_mat_transpose(matrix_, matrix_);
    }
  }

  BigFloat middle(slong row, slong column) const {
    return {*arb_midref(arb_mat_entry(matrix_, row, column)), bits_};
  }
  BigFloat last() const { return middle(size_ - 1, size_ - 1); }
  SymmetricRows middles() const {
    SymmetricRows rows(static_cast<std::size_t>(size_));
    for (slong i = 0; i < size_; ++i)
      for (slong k = 0; k <= i; ++k) rows[static_cast<std::size_t>(i)].push_back(middle(i, k));
    return rows;
  }

  // n, where the true matrix differs from the middles by less than 2^n in norm.
  slong log2_radius() const {
    double largest = -finest_bits;
    for (slong i = 0; i < size_; ++i)
      for (slong k = 0; k < size_; ++k)
        largest =
            std::max(largest, mag_get_d_log2_approx(arb_radref(arb_mat_entry(matrix_, i, k))));
    largest = std::min(largest, static_cast<double>(finest_bits));  // it may be infinite
    return static_cast<slong>(largest + std::log2(size_)) + 1;
  }

 private:
  using Operation = void(arb_ptr, arb_srcptr, arf_srcptr, slong);
  void put(Operation* operation, std::size_t from, std::size_t to, const BigFloat& value) {
    if (from == 1 || to == 1) return;
    arb_ptr entry = arb_mat_entry(matrix_, row_of(from), row_of(to));
    operation(entry, entry, value.get(), bits_);
  }
  slong row_of(std::size_t node) const {
    return node == 0 ? size_ - 1 : static_cast<slong>(node) - 2;
  }

  slong size_, bits_;
  arb_mat_t matrix_{};
};

struct LongBranch {
  BigFloat stiffness, rate;
};

// The relaxation form before it is rounded to doubles.
struct LongForm {
  BigFloat equilibrium, damper;
  std::vector<LongBranch> branches;  // by decreasing rate

  Relaxation rounded() const {
    Relaxation form{equilibrium.to_double(), damper.to_double(), {}};
    BigFloat together;
    for (const auto& [stiffness, rate] : branches) {
      if (stiffness <= 1e-30 * stiffness_at(rate)) continue;
      const double time = (1 / rate).to_double();
      if (form.branches.empty() || time - form.branches.back().time > 1e-15 * time) {
        form.branches.push_back({0, time});
        together = 0;
      }
      together += stiffness;
      form.branches.back().stiffness = together.to_double();
    }
    return form;
  }

 private:
  BigFloat stiffness_at(const BigFloat& s) const {
    BigFloat sum = equilibrium + damper * s;
    for (const auto& [stiffness, rate] : branches) sum += stiffness * s / (s + rate);
    return sum;
  }
};

// The form of K/l^2 as a function of x = s/alpha, where l is the last entry of L:
//   K/l^2 = corner + x (1 - corner) - (1 - x)^2 sum_j coupling_j^2/(mu_j + x (1 - mu_j)).
class ShareForm {
 public:
  ShareForm(const NodalPair& pair, const BigFloat& corner, const std::vector<Eigenmode>& modes)
      : form_{corner, 1 - corner, {}} {
    // Each group of nodes that no spring (or no damper) joins to a terminal gives mu = 0 (or 1).
    // These modes have no coupling.
    const std::size_t first = pair.springs.groups.without_terminal();
    for (std::size_t j = modes.size() - pair.dampers.groups.without_terminal(); j-- > first;)
      take_off(modes[j]);
    keep(form_.equilibrium, pair.springs.groups.join_terminals());
    keep(form_.damper, pair.dampers.groups.join_terminals());
  }

  // Whether all numbers are accurate to 60 bits. An error e of the matrix changes a rate by a
  // fraction of e/smallest. It changes the stiffness of a branch by a fraction of less than
  // 2^110 e/smallest^2 if that is 1e-30 of K or more and the next time is 1e-15 away or more.
  bool resolved(slong log2_error) const {
    return smallest_ > 0 && 2 * (smallest_.exponent() - 1) >= log2_error + 110 + 60;
  }

  LongForm with_units(const BigFloat& l, slong log2_alpha) const {
    LongForm form{l * l * form_.equilibrium, ldexp(l * l * form_.damper, -log2_alpha), {}};
    for (const auto& [stiffness, rate] : form_.branches)
      form.branches.push_back({l * l * stiffness, ldexp(rate, log2_alpha)});
    return form;
  }

 private:
  void take_off(const Eigenmode& mode) {
    const BigFloat &mu = mode.value, nu = 1 - mu;
    smallest_ = std::min({smallest_, mu, nu});
    form_.equilibrium -= mode.squared_coupling / mu;
    form_.damper -= mode.squared_coupling / nu;
    form_.branches.push_back({mode.squared_coupling / (mu * nu * nu), mu / nu});
  }
  void keep(BigFloat& part, bool there) {
    if (there)
      smallest_ = std::min(smallest_, part);
    else
      part = 0;
  }

  LongForm form_;
  BigFloat smallest_ = 1;  // of the parts, mu and 1 - mu that are not zero
};

std::optional<LongForm> form_with(const NodalPair& pair, slong bits) {
  NodalMatrix shares(pair.nodes, bits), l(pair.nodes, bits);
  shares.add(pair.springs, 0);
  l.add(pair.springs, 0);
  l.add(pair.dampers, pair.log2_alpha);
  if (!l.decompose()) return {};
  shares.transform(l);
  const auto modes = modes_coupled_to_last_row(shares.middles());
  if (!modes) return {};
  const ShareForm form(pair, shares.last(), *modes);
  if (!form.resolved(std::max(shares.log2_radius(), log2_roundings - bits) + 1)) return {};
  return form.with_units(l.last(), pair.log2_alpha);
}

}  // namespace

Relaxation graph_relaxation(const RelaxationGraph& graph) {
  if (graph.edges.size() == 1) return graph.edges[0];
  if (const std::size_t modes = size_of(graph) - 2; modes > most_modes)
    throw InputError({"a graph"},
                     fmt::format("{} inner nodes and branches after series and parallel", modes),
                     fmt::format("at most {}", most_modes));
  const NodalPair pair(graph);
  for (slong bits = coarsest_bits; bits <= finest_bits; bits *= 2)
    if (const auto form = form_with(pair, bits)) return form->rounded();
  throw Bug("a relaxation form is beyond the longest numbers");
}

}  // namespace vcrit
