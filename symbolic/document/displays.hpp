// The equations of a block as displays: folded where they are a series, broken where they are too
// wide, printed in one dialect.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "document/content.hpp"
#include "document/fitted.hpp"
#include "formula/dialect.hpp"

namespace vcrit::symbolic {

/// left = right, right in rows.
struct PrintedEquation {
  std::string left, sign;
  std::vector<std::string> rows;
  std::string range;  ///< "j = 1..10", or empty
};

/// Equations that stand below each other, their signs aligned.
using Display = std::vector<PrintedEquation>;

class Displays {
 public:
  Displays(const Dialect& dialect, const PageMeasure& measure);

  std::vector<Display> of(const DocumentBlock& block);

 private:
  struct Less {
    using Sides = std::pair<GiNaC::ex, GiNaC::ex>;
    bool operator()(const Sides& a, const Sides& b) const;
  };
  /// An equation with what it is known by, if that may come again.
  struct Asked {
    Statement statement;
    FittedEquation::IndexRange range;
    std::optional<Less::Sides> sides;
  };

  std::vector<Asked> asked(const DocumentBlock& block);
  Display printed(const Asked& equation, double column);
  PrintedEquation print(const FittedEquation& equation) const;

  const Dialect& dialect_;
  const PageMeasure& measure_;
  Fitting fitting_;
  /// Those of a large network's limits are largely the same, hundreds of times.
  std::map<Less::Sides, PrintedEquation, Less> known_;
};

}  // namespace vcrit::symbolic
