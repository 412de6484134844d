#include "critical/drive_response.hpp"

#include <acb_mat.h>

#include <algorithm>
#include <vector>

#include "network/masses.hpp"
#include "network/reduction.hpp"
#include "rules/kinds.hpp"

namespace vcrit {

namespace {

/// Springs and dampers only: the reduction never divides by zero.
class Massless : public DriveInBalls {
 public:
  explicit Massless(ReducedNetwork drive) : drive_(std::move(drive)) {}
  DriveResponse at(Balls& balls) const override {
    return {evaluate(drive_.reduction(), balls), Ball(1)};
  }
  std::size_t steps() const override { return drive_.reduction().steps.size(); }

 private:
  ReducedNetwork drive_;
};

/// A matrix of balls that frees itself.
class BallMatrix {
 public:
  explicit BallMatrix(std::size_t size) {
    acb_mat_init(matrix_, static_cast<slong>(size), static_cast<slong>(size));
  }
  BallMatrix(const BallMatrix&) = delete;
  BallMatrix& operator=(const BallMatrix&) = delete;
  ~BallMatrix() { acb_mat_clear(matrix_); }

  acb_ptr at(std::size_t row, std::size_t column) {
    return acb_mat_entry(matrix_, static_cast<slong>(row), static_cast<slong>(column));
  }
  Ball determinant(slong precision) const {
    Ball result;
    acb_mat_det(result.get(), matrix_, precision);
    return result;
  }

 private:
  acb_mat_t matrix_{};
};

/// The drive as a graph whose edges are massless networks and masses, and its nodal stiffness
/// matrix with the far end held. Pivots of an elimination may vanish at the resonances of its
/// parts; determinants are polynomials.
///
///   K_d = det(body and inner nodes)/det(inner nodes)
class WithMasses : public DriveInBalls {
 public:
  explicit WithMasses(const Network& drive) { place(drive, body, far_end); }

  DriveResponse at(Balls& balls) const override {
    std::vector<Ball> stiffness;
    for (const Edge& edge : edges_) stiffness.push_back(evaluate(edge.reduction, balls));
    return {determinant(body, stiffness, balls), determinant(first_inner, stiffness, balls)};
  }

  std::size_t steps() const override {
    std::size_t total = 0;
    for (const Edge& edge : edges_) total += edge.reduction.steps.size() + 1;
    return total;
  }

 private:
  static constexpr std::size_t far_end = 0, body = 1, first_inner = 2;  // nodes
  struct Edge {
    std::size_t from, to;
    Reduction reduction;
  };

  void place(const Network& network, std::size_t from, std::size_t to) {
    const auto* series = std::get_if<Series>(&network.form);
    const auto* parallel = std::get_if<Parallel>(&network.form);
    const auto* graph = std::get_if<Graph>(&network.form);
    if (!has_masses(network) || std::holds_alternative<Element>(network.form))
      edges_.push_back({from, to, reduce(network)});
    else if (series != nullptr)
      place_series(series->parts, from, to);
    else if (parallel != nullptr)
      for (const Network& part : parallel->parts) place(part, from, to);
    else
      place_graph(*graph, from, to);
  }

  void place_series(const std::vector<Network>& parts, std::size_t from, std::size_t to) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::size_t next = i + 1 == parts.size() ? to : nodes_++;
      place(parts[i], from, next);
      from = next;
    }
  }

  void place_graph(const Graph& graph, std::size_t from, std::size_t to) {
    std::vector<std::size_t> names{from, to};
    while (names.size() < graph.nodes.size()) names.push_back(nodes_++);
    for (std::size_t i = 0; i < graph.parts.size(); ++i)
      place(graph.parts[i], names[static_cast<std::size_t>(graph.wires[i].from)],
            names[static_cast<std::size_t>(graph.wires[i].to)]);
  }

  /// Of the nodal stiffness matrix of the nodes from `first` on, all others held.
  Ball determinant(std::size_t first, const std::vector<Ball>& stiffness,
                   const Balls& balls) const {
    BallMatrix matrix(nodes_ - first);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const auto [from, to] = std::minmax(edges_[i].from, edges_[i].to);
      if (to < first) continue;
      acb_srcptr k = stiffness[i].get();
      const auto put = [&](auto* operation, std::size_t row, std::size_t column) {
        acb_ptr entry = matrix.at(row - first, column - first);
        operation(entry, entry, k, balls.precision);
      };
      put(acb_add, to, to);
      if (from < first) continue;
      put(acb_add, from, from);
      put(acb_sub, from, to);
      put(acb_sub, to, from);
    }
    return matrix.determinant(balls.precision);
  }

  std::vector<Edge> edges_;
  std::size_t nodes_ = first_inner;
};

/// A table's row, or the linear interpolation between two rows times their distance, which is what
/// the force is measured in.
class Measured : public DriveInBalls {
 public:
  explicit Measured(const Bracket& bracket) : below_(bracket.below), above_(bracket.above) {}

  DriveResponse at(Balls& balls) const override {
    if (below_.omega == above_.omega) return {Ball(1), receptance(below_)};
    const Ball up = balls.subtract(balls.omega, Ball(below_.omega));
    const Ball down = balls.subtract(Ball(above_.omega), balls.omega);
    return {balls.subtract(Ball(above_.omega), Ball(below_.omega)),
            balls.add(balls.multiply(receptance(below_), down),
                      balls.multiply(receptance(above_), up))};
  }
  std::size_t steps() const override { return 8; }

 private:
  static Ball receptance(const Receptance::Row& row) {
    Ball ball;
    acb_set_d_d(ball.get(), row.re, row.im);
    return ball;
  }

  Receptance::Row below_, above_;
};

}  // namespace

std::unique_ptr<const DriveInBalls> drive_in_balls(const Problem& problem) {
  using Drive = std::unique_ptr<const DriveInBalls>;
  return std::visit(Overloaded{[](const Rigid&) -> Drive { return nullptr; },
                               [&](const ReducedNetwork& drive) -> Drive {
                                 if (rules::drive_resonates(problem))
                                   return std::make_unique<WithMasses>(drive.network());
                                 return std::make_unique<Massless>(drive);
                               },
                               [&](const Receptance& drive) -> Drive {
                                 return std::make_unique<Measured>(
                                     bracket(drive, problem.value(problem->angular_frequency)));
                               }},
                    problem->drive);
}

}  // namespace vcrit
