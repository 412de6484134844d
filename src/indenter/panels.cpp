#include "indenter/panels.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "normal/quadrature_rules.hpp"

namespace vcrit::indenter {

namespace {

constexpr std::size_t nodes = 21;  // with 10 of Gauss: the usual pair of QUADPACK

// Of a panel's integral: differences of its two sums below this say nothing.
constexpr double force_rounding = 16 * epsilon;
constexpr int most_cells = 200'000;

// Times the difference of both sums, as an unseen kink between the nodes may fool them alike.
constexpr double caution = 2;

struct Node {
  double place = 0;               // in (0, 1)
  double kronrod = 0, gauss = 0;  // weights; no Gauss node: 0
};

std::array<Node, nodes> all_nodes() {
  std::array<Node, nodes> result;
  const auto [places, weights] = kronrod_21();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double kronrod = 0.5 * weights[i];
    const double gauss = i % 2 == 1 ? 0.5 * gauss_10().weights[i / 2] : 0;
    result[nodes / 2 - i] = {0.5 * (1 - places[i]), kronrod, gauss};
    result[nodes / 2 + i] = {0.5 * (1 + places[i]), kronrod, gauss};
  }
  return result;
}

struct SummedPanel {
  SummedPanel(double from, double to) : low(from), high(to) {}

  double low, high;  // m
  double friction = 0, normal_force = 0;
  double friction_fault = 0, normal_force_fault = 0;  // Kronrod's sum less Gauss's
  double cell_error = 0;

  double x(double s) const { return low + (high - low) * s * s * (3 - 2 * s); }
  double slope(double s) const { return (high - low) * 6 * s * (1 - s); }
  double ratio_error(double ratio) const {
    return caution * std::abs(friction_fault - ratio * normal_force_fault);
  }
  double normal_force_error() const { return caution * std::abs(normal_force_fault); }
};

class Quadrature {
 public:
  Quadrature(const HalfSpace& half_space, double velocity)
      : half_space_(half_space), velocity_(velocity), nodes_(all_nodes()) {}

  PanelIntegrals run(const std::vector<double>& breaks, double tolerance) {
    std::vector<SummedPanel> fresh;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      fresh.emplace_back(breaks[i], breaks[i + 1]);
    while (true) {
      evaluate(fresh);
      const PanelIntegrals sum = summed();
      if (done(sum, tolerance) || sum.cells > most_cells) return sum;
      fresh = split(sum, tolerance);
      if (fresh.empty()) return sum;
    }
  }

 private:
  void evaluate(const std::vector<SummedPanel>& fresh) {
    std::vector<CellFriction> cells(fresh.size() * nodes);
    tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t i) {
      cells[i] = cell_friction(half_space_, fresh[i / nodes].x(nodes_[i % nodes].place), velocity_);
    });
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      panels_.push_back(fresh[i]);
      for (std::size_t j = 0; j < nodes; ++j) add(nodes_[j], cells[i * nodes + j], panels_.back());
    }
    cells_ += static_cast<int>(cells.size());
    std::sort(panels_.begin(), panels_.end(),
              [](const SummedPanel& a, const SummedPanel& b) { return a.low < b.low; });
  }

  void add(const Node& node, const CellFriction& cell, SummedPanel& panel) {
    const double force = panel.slope(node.place) * cell.normal_force;
    const double friction = force * cell.ratio;
    panel.friction += node.kronrod * friction;
    panel.normal_force += node.kronrod * force;
    panel.friction_fault += (node.kronrod - node.gauss) * friction;
    panel.normal_force_fault += (node.kronrod - node.gauss) * force;
    panel.cell_error += node.kronrod * std::abs(force) * cell.error;
    disagreement_ = std::max(disagreement_, cell.disagreement);
    motions_.add(cell.motions);
  }

  PanelIntegrals summed() const {
    PanelIntegrals sum;
    for (const SummedPanel& panel : panels_) {
      sum.friction += panel.friction;
      sum.normal_force += panel.normal_force;
      sum.normal_force_error += panel.normal_force_error();
      sum.cell_error += panel.cell_error;
    }
    const double ratio = sum.friction / sum.normal_force;
    for (const SummedPanel& panel : panels_) sum.ratio_error += panel.ratio_error(ratio);
    sum.ratio_error /= sum.normal_force;
    sum.disagreement = disagreement_;
    sum.motions = motions_;
    sum.cells = cells_;
    return sum;
  }

  static bool done(const PanelIntegrals& sum, double tolerance) {
    return sum.ratio_error <= tolerance && sum.normal_force_error <= tolerance * sum.normal_force;
  }

  // Takes out panels with more than their share of the error and returns their halves.
  std::vector<SummedPanel> split(const PanelIntegrals& sum, double tolerance) {
    const double ratio = sum.friction / sum.normal_force;
    const double share = tolerance * sum.normal_force / static_cast<double>(panels_.size());
    std::vector<SummedPanel> kept, halves;
    for (const SummedPanel& panel : panels_) {
      const double error = std::max(panel.ratio_error(ratio), panel.normal_force_error());
      const double least = std::max(panel.cell_error, force_rounding * panel.normal_force);
      const double middle = 0.5 * (panel.low + panel.high);
      if (error <= std::max(share, least) || middle <= panel.low || middle >= panel.high) {
        kept.push_back(panel);
        continue;
      }
      halves.emplace_back(panel.low, middle);
      halves.emplace_back(middle, panel.high);
    }
    panels_ = std::move(kept);
    return halves;
  }

  const HalfSpace& half_space_;
  double velocity_;
  std::array<Node, nodes> nodes_;
  std::vector<SummedPanel> panels_;  // by place
  int cells_ = 0;
  double disagreement_ = 0;
  Motions motions_;
};

}  // namespace

PanelIntegrals integrals(const HalfSpace& half_space, double velocity,
                         const std::vector<double>& breaks, double tolerance) {
  return Quadrature(half_space, velocity).run(breaks, tolerance);
}

}  // namespace vcrit::indenter
