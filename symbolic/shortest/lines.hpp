// Steps as lines that people read.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "shortest/letters.hpp"
#include "shortest/parity.hpp"
#include "shortest/shortest.hpp"
#include "shortest/steps.hpp"

namespace vcrit::symbolic::shortest {

/// A line that is there in any case: what the symbol stands for, in the formula and in later ones.
struct NamedLine {
  Ex symbol, meaning;
};

/// What is used more than once has a line of its own; so have parts of a line that would be too
/// long, and `definitions`.
class Lines {
 public:
  Lines(const Expressions& all, const Measures& measures, const Ex& velocity,
        const std::vector<NamedLine>& definitions = {});
  ShortestForm form();

 private:
  using Index = std::uint32_t;
  bool has_line(Index step) const;
  bool is_defined(Index step) const;
  /// The parts that have to stand in front of a step: of a defined symbol its meaning.
  std::vector<Index> needs(Index step) const;
  void collect(Index step);
  void give_names();
  void put_in_order();
  bool is_of_series(Index a, Index b) const;
  bool is_like(Index a, Index b) const;
  bool needs_only(Index step, const std::set<Index>& placed, const std::set<Index>& open) const;
  bool divide_long_line();
  std::size_t length(Index step) const;
  std::optional<Index> longest_part(Index line, std::size_t most) const;
  Form of(Index step) const;
  Form written(Index step) const;
  Form sum(const FormulaStep& step) const;
  Form product(const FormulaStep& step) const;
  Form meaning(ExNode symbol) const;
  Form symbol(ExNode node) const;
  std::vector<const char*> leading_names(ExNode leading) const;

  const Expressions& all_;
  const Measures& measures_;
  std::vector<NamedLine> definitions_;
  Steps steps_;
  Parity parity_;
  bool omega_cancels_ = false;  ///< in front of the whole
  std::vector<Index> lines_;    ///< in their order
  std::vector<Index> divided_;
  std::map<Index, std::string> names_;
};

}  // namespace vcrit::symbolic::shortest
