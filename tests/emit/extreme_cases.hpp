// The rows of data/vstar_extreme.csv as calls of evaluators, one evaluator for each shape of scene.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "emit/library.hpp"
#include "support/reference_scene.hpp"

namespace vcrit::test {

struct ExtremeCase {
  std::size_t shape;
  Scene scene;
  double expected;  ///< nearest double, off by 2^-53 itself
};

struct ExtremeCases {
  std::vector<Scene> shapes;
  std::vector<ExtremeCase> rows;
};

inline bool have_one_shape(const Scene& a, const Scene& b) {
  return a.normal == b.normal &&
         std::get<Network>(a.tangential) == std::get<Network>(b.tangential) && a.drive == b.drive &&
         a.mass.has_value() == b.mass.has_value();
}

/// Of scenes with `least` to `most` elements, `expected` rows.
inline ExtremeCases extreme_cases(std::size_t least, std::size_t most, std::size_t expected) {
  ExtremeCases cases;
  std::vector<Scene>& shapes = cases.shapes;
  for (const ReferenceRow& row : extreme_rows()) {
    if (!row.scene || row.scene->elements.size() < least || row.scene->elements.size() > most)
      continue;
    const auto same = std::find_if(shapes.begin(), shapes.end(), [&](const Scene& shape) {
      return have_one_shape(shape, *row.scene);
    });
    const auto shape = static_cast<std::size_t>(same - shapes.begin());
    if (same == shapes.end()) shapes.push_back(*row.scene);
    cases.rows.push_back({shape, *row.scene, row.velocity});
  }
  require_rows(cases.rows.size(), expected, "vstar_extreme.csv");
  return cases;
}

inline std::vector<Call> calls_of(const ExtremeCases& cases) {
  std::vector<Call> calls;
  for (const ExtremeCase& row : cases.rows) {
    calls.emplace_back();
    calls.back().library = row.shape;
    calls.back().scene = row.scene;
  }
  return calls;
}

/// Whether a value keeps its relative bound, where that is finite.
inline bool holds(double value, double bound, double expected) {
  return !std::isfinite(bound) ||
         std::abs(value - expected) <= (bound + 0x1p-52) * std::abs(expected);
}

}  // namespace vcrit::test
