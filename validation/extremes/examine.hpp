// One family of scenes at all its extremes.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "compare/agreement.hpp"
#include "extremes/contents.hpp"
#include "extremes/families.hpp"
#include "extremes/regions.hpp"
#include "extremes/simulated.hpp"

namespace vcrit::validation::extremes {

/// Answers of all ways in the cells.
using Evaluate = std::function<std::vector<Claimed>(const accuracy::Cells& cells)>;

/// What is examined, replaceable one by one.
struct Subjects {
  Evaluate evaluate;
  Ask ask;
  bool generated = true;  ///< whether there are generated evaluators among them
};

/// The library's own evaluator, the generated ones (with a compiler; takes seconds to compile) and
/// the exact simulator. Throws std::runtime_error when a generated evaluator
/// does not compile.
Subjects subjects_of(const symbolic::Derivation& derivation,
                     const std::optional<std::filesystem::path>& compiler);

FamilyResult examine(const Family& family, const symbolic::Derivation& derivation,
                     const Subjects& subjects, const Fineness& fineness, const Progress& progress);

}  // namespace vcrit::validation::extremes
