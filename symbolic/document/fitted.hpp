// Equations that fit a page: a long sum is broken before a plus or minus, and what cannot be broken
// (below a root, in a fraction) gets a name and a line of its own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "formula/prose.hpp"

namespace vcrit::symbolic {

/// left = right, the right-hand side in rows. A row after the first begins with the sign of its
/// first term.
struct FittedEquation {
  Signed left;
  Statement::Relation relation = Statement::Relation::equal;
  std::vector<std::vector<Signed>> rows;
  struct IndexRange {
    std::string index;
    int first = 0, last = 0;
  };
  IndexRange range = {};  ///< "j = 1..10" behind it; no index: none
};

/// What fits: points of a page, or characters of a terminal.
struct PageMeasure {
  double width;               ///< of a page
  double (*of)(const Form&);  ///< of a formula
  double sign, relation;      ///< of a plus and of an equals sign, with their spaces
  double indent;              ///< of rows after the first
  double least_part, name;    ///< narrower parts get no name; what a name takes
};

extern const PageMeasure measure_of_page, measure_of_terminal;

/// One document's: parts that have a name keep it.
class Fitting {
 public:
  explicit Fitting(const PageMeasure& measure) : measure_(measure) {}

  /// The definitions that are new, then the equation. `column`: what its block leaves on the left
  /// for the widest side, in pt.
  std::vector<FittedEquation> fitted(const Statement& equation, double column = 0);

 private:
  std::vector<std::vector<Signed>> rows(Signed right, double left);
  Form narrowed(Form form, double width);
  void name_small_parts(Form& form, int bars);
  bool name_a_part(Form& form);
  Form name_of(const Form& part);

  double width_of(const Signed& expression) const;

  const PageMeasure& measure_;
  std::map<std::string, Form> names_;
  std::vector<FittedEquation> fresh_;
  int last_ = 0;
};

}  // namespace vcrit::symbolic
