// K(i omega) of the systems' networks, written down for each kind by hand. The arithmetic is a
// template parameter: balls for the value, integers modulo a prime for whether it is zero.
//
// An arithmetic has Value, element(x) = x, rate(x) = i omega x, add, multiply, divide and is_zero.
// Elements may be 0. What they leave without a hold carries no load: two in series of stiffness 0
// are as stiff, and a point without an edge goes without one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "bounds/systems.hpp"

namespace vcrit::bounds {

template <class Arithmetic>
class Formulas {
 public:
  using Value = typename Arithmetic::Value;
  using Numbers = std::span<const double>;

  explicit Formulas(Arithmetic& arithmetic) : a_(arithmetic) {}

  Value stiffness(NetworkShape shape, Numbers x) {
    switch (shape) {
      case NetworkShape::spring:
        return a_.element(x[0]);
      case NetworkShape::kelvin:
        return kelvin(x[0], x[1]);
      case NetworkShape::maxwell:
        return series(a_.element(x[0]), a_.rate(x[1]));
      case NetworkShape::zener:
        return a_.add(a_.element(x[0]), series(a_.element(x[1]), a_.rate(x[2])));
      case NetworkShape::burgers:
        return series(series(a_.element(x[0]), a_.rate(x[1])), kelvin(x[2], x[3]));
      case NetworkShape::prony:
        return prony(x);
      case NetworkShape::ladder:
        return ladder(x);
      case NetworkShape::bridge:
        return bridge(x);
      case NetworkShape::grid:
        break;
    }
    return grid(x);
  }

 private:
  Value kelvin(double k, double c) { return a_.add(a_.element(k), a_.rate(c)); }

  Value series(const Value& p, const Value& q) {
    const Value sum = a_.add(p, q);
    return a_.is_zero(sum) ? a_.element(0) : a_.divide(a_.multiply(p, q), sum);
  }

  // k0 + sum k_j x/(1 + x), x = i omega tau_j
  Value prony(Numbers x) {
    const std::size_t count = x.size() / 2;
    Value sum = a_.element(x[0]);
    for (std::size_t j = 1; j <= count; ++j) {
      const Value rate = a_.rate(x[count + j]);
      const Value above = a_.multiply(a_.element(x[j]), rate);
      sum = a_.add(sum, a_.divide(above, a_.add(a_.element(1), rate)));
    }
    return sum;
  }

  // K_j = i omega c_j + 1/(1/k_j + 1/K_(j+1))
  Value ladder(Numbers x) {
    const std::size_t count = x.size() / 2;
    Value inner = kelvin(x[count - 1], x[2 * count - 1]);
    for (std::size_t j = count - 1; j-- > 0;)
      inner = a_.add(a_.rate(x[count + j]), series(a_.element(x[j]), inner));
    return inner;
  }

  // Stiffnesses between points 0 and 1, the ends, and others.
  static constexpr std::size_t most_points = 9;
  using Edges = std::array<std::array<std::optional<Value>, most_points>, most_points>;

  void connect(Edges& edges, std::size_t from, std::size_t to, const Value& value) {
    auto& edge = edges[std::min(from, to)][std::max(from, to)];
    edge = edge ? a_.add(*edge, value) : value;
  }

  // The forces on the last point balance: what it held is held by edges z_i z_j/(sum of z).
  void eliminate(Edges& edges, std::size_t last) {
    std::optional<Value> total;
    for (std::size_t i = 0; i < last; ++i)
      if (const auto& edge = edges[i][last]) total = total ? a_.add(*total, *edge) : *edge;
    if (!total || a_.is_zero(*total)) return;
    for (std::size_t i = 0; i < last; ++i) {
      if (!edges[i][last] || a_.is_zero(*edges[i][last])) continue;
      const Value share = a_.divide(*edges[i][last], *total);
      for (std::size_t j = i + 1; j < last; ++j)
        if (edges[j][last]) connect(edges, i, j, a_.multiply(share, *edges[j][last]));
    }
  }

  Value between_ends(Edges& edges, std::size_t points) {
    for (std::size_t last = points; last-- > 2;) eliminate(edges, last);
    return edges[0][1] ? *edges[0][1] : a_.element(0);
  }

  Value bridge(Numbers x) {
    constexpr std::size_t ends[5][2] = {{0, 2}, {0, 3}, {2, 1}, {3, 1}, {2, 3}};
    Edges edges;
    for (std::size_t j = 0; j < 5; ++j)
      connect(edges, ends[j][0], ends[j][1], kelvin(x[j], x[5 + j]));
    return between_ends(edges, 4);
  }

  // From each point to the right, then down; springs and dampers by turns, from corner to corner.
  Value grid(Numbers x) {
    constexpr std::array<std::size_t, 9> point{0, 2, 3, 4, 5, 6, 7, 8, 1};
    Edges edges;
    std::size_t number = 0;
    const auto edge = [&](std::size_t from, std::size_t to) {
      const double value = x[number];
      connect(edges, point[from], point[to], number % 2 == 0 ? a_.element(value) : a_.rate(value));
      ++number;
    };
    for (std::size_t here = 0; here < 9; ++here) {
      if (here % 3 < 2) edge(here, here + 1);
      if (here < 6) edge(here, here + 3);
    }
    return between_ends(edges, 9);
  }

  Arithmetic& a_;
};

}  // namespace vcrit::bounds
