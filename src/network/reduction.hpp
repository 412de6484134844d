// A network walked once, as a straight-line program without subtraction: series and parallel parts
// by composition, what is left of a graph by star-mesh elimination of inner nodes, lowest degree
// first. Numbers, intervals, symbols and generated code all come from running this one program.
#pragma once

#include <cstddef>
#include <vector>

#include "base/errors.hpp"
#include "network/law.hpp"
#include "network/network.hpp"

namespace vcrit {

/// One named intermediate result: a dynamic stiffness.
struct Step {
  enum class Kind {
    element,   ///< the stiffness of `element`
    parallel,  ///< a + b
    series,    ///< a b/(a + b)
    mesh       ///< a b/total: the edge between two neighbours of an eliminated node
  };
  Kind kind = Kind::element;
  Element element;
  std::size_t a = 0, b = 0, total = 0;  ///< earlier steps
};

struct Reduction {
  std::vector<Step> steps;  ///< the last step is the network's stiffness; each step is used
};

/// The elimination of a graph's inner nodes can make far more edges than the graph has.
constexpr std::size_t most_reduction_steps = 4'000'000;

/// Throws InputError beyond `most_reduction_steps`, and for a network that is none (wiring.hpp),
/// or a graph with edges off all paths between its terminals.
Reduction reduce(const Network& network);

/// Runs the program. `Algebra` gives what law() asks for, or element(const Element&) of its own,
/// and
///   Value parallel(a, b), series(a, b), mesh(a, b, total).
template <class Algebra>
typename Algebra::Value evaluate(const Reduction& reduction, Algebra& algebra) {
  std::vector<typename Algebra::Value> values;
  values.reserve(reduction.steps.size());
  for (const Step& step : reduction.steps) {
    switch (step.kind) {
      case Step::Kind::element:
        if constexpr (requires { algebra.element(step.element); })
          values.push_back(algebra.element(step.element));
        else
          values.push_back(law(step.element, algebra));
        break;
      case Step::Kind::parallel:
        values.push_back(algebra.parallel(values[step.a], values[step.b]));
        break;
      case Step::Kind::series:
        values.push_back(algebra.series(values[step.a], values[step.b]));
        break;
      case Step::Kind::mesh:
        values.push_back(algebra.mesh(values[step.a], values[step.b], values[step.total]));
        break;
    }
  }
  ensure(!values.empty(), "a reduction has at least one step");
  return values.back();
}

}  // namespace vcrit
