// K(s) of any network from its nodal equations, inner nodes eliminated with 100 decimal digits: a
// reference that shares nothing with the library but the network's structure.
#pragma once

#include <boost/multiprecision/cpp_complex.hpp>
#include <cstddef>
#include <vector>

#include "network/network.hpp"

namespace vcrit::reference {

using Real = boost::multiprecision::cpp_bin_float_100;
using Complex = boost::multiprecision::cpp_complex_100;

class NodalEquations {
 public:
  NodalEquations(const Network& network, const Values& values, const Complex& s)
      : values_(values), s_(s) {
    add_node();
    add_node();
    stamp(network, 0, 1);
  }

  // Node 1 is held, so row and column 1 stay out of it.
  Complex stiffness() {
    for (std::size_t n = matrix_.size(); n-- > 2;)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          if (i != 1 && j != 1) matrix_[i][j] -= matrix_[i][n] * matrix_[n][j] / matrix_[n][n];
    return matrix_[0][0];
  }

 private:
  std::size_t add_node() {
    for (auto& row : matrix_) row.emplace_back(0);
    matrix_.emplace_back(matrix_.size() + 1, Complex(0));
    return matrix_.size() - 1;
  }
  void edge(std::size_t a, std::size_t b, const Complex& value) {
    matrix_[a][a] += value;
    matrix_[b][b] += value;
    matrix_[a][b] -= value;
    matrix_[b][a] -= value;
  }
  void stamp(const Network& network, std::size_t a, std::size_t b) {
    if (const auto* element = std::get_if<Element>(&network.form)) stamp(*element, a, b);
    if (const auto* parts = std::get_if<Parallel>(&network.form))
      for (const Network& part : parts->parts) stamp(part, a, b);
    if (const auto* parts = std::get_if<Series>(&network.form)) {
      std::size_t from = a;
      for (std::size_t i = 0; i < parts->parts.size(); ++i) {
        const std::size_t to = i + 1 == parts->parts.size() ? b : add_node();
        stamp(parts->parts[i], from, to);
        from = to;
      }
    }
    if (const auto* graph = std::get_if<Graph>(&network.form)) {
      std::vector<std::size_t> nodes{a, b};
      while (nodes.size() < graph->nodes.size()) nodes.push_back(add_node());
      for (std::size_t i = 0; i < graph->parts.size(); ++i)
        stamp(graph->parts[i], nodes[static_cast<std::size_t>(graph->wires[i].from)],
              nodes[static_cast<std::size_t>(graph->wires[i].to)]);
    }
  }
  void stamp(const Element& element, std::size_t a, std::size_t b) {
    const Complex coefficient = values_.at(element.coefficient);
    if (element.kind == ElementKind::spring) edge(a, b, coefficient);
    if (element.kind == ElementKind::damper) edge(a, b, coefficient * s_);
    if (element.kind == ElementKind::maxwell) {
      const Complex x = s_ * Real(values_.at(element.time));
      edge(a, b, coefficient * x / (Real(1) + x));
    }
  }

  const Values& values_;
  Complex s_;
  std::vector<std::vector<Complex>> matrix_;
};

inline Complex stiffness(const Network& network, const Values& values, double omega) {
  return NodalEquations(network, values, Complex(0, omega)).stiffness();
}

}  // namespace vcrit::reference
