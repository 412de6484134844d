#include "document/displays.hpp"

#include <algorithm>

#include "formula/series.hpp"

namespace vcrit::symbolic {

namespace {

// A left-hand side that takes more of a page is not aligned with others.
constexpr double widest_column = 0.17;

/// Definitions that differ by a number, as one.
struct Definitions {
  std::vector<Equation> members;
  std::optional<SeriesMember> first;
};

std::optional<SeriesMember> member_of(const Equation& equation) {
  Form both{Form::Kind::product, "", {equation.left, equation.right.form}, {}, {}, 1};
  return equation.right.minus ? std::nullopt : series_member(both);
}

/// Consecutive definitions of one pattern and consecutive numbers.
std::vector<Definitions> runs_of(const std::vector<Equation>& equations) {
  std::vector<Definitions> runs;
  for (const Equation& each : equations) {
    auto member = member_of(each);
    const bool goes_on =
        !runs.empty() && member && runs.back().first &&
        runs.back().first->pattern == member->pattern &&
        runs.back().first->number + static_cast<int>(runs.back().members.size()) == member->number;
    if (!goes_on) runs.push_back({{}, std::move(member)});
    runs.back().members.push_back(each);
  }
  return runs;
}

Statement statement_of(const Equation& equation) {
  return {{false, equation.left},
          Statement::Relation::equal,
          {equation.right.minus, with_series(equation.right.form)}};
}

}  // namespace

bool Displays::Less::operator()(const Sides& a, const Sides& b) const {
  const int order = a.first.compare(b.first);
  return order != 0 ? order < 0 : a.second.compare(b.second) < 0;
}

Displays::Displays(const Dialect& dialect, const PageMeasure& measure)
    : dialect_(dialect), measure_(measure), fitting_(measure) {}

std::vector<Displays::Asked> Displays::asked(const DocumentBlock& block) {
  std::vector<Asked> result;
  for (const Line& line : block.lines) {
    const bool asymptotic = block.asymptotic && &line == &block.lines.back();
    Less::Sides sides{line.left, line.right};
    if (!asymptotic && known_.contains(sides)) {
      result.push_back({{}, {}, std::move(sides)});
      continue;
    }
    Signed left = form_of(line.left), right = form_of(line.right);
    left.form = with_series(std::move(left.form));
    right.form = with_series(std::move(right.form));
    const auto relation = asymptotic ? Statement::Relation::asymptotic : Statement::Relation::equal;
    result.push_back({{std::move(left), relation, std::move(right)},
                      {},
                      asymptotic ? std::nullopt : std::optional(std::move(sides))});
  }
  for (const Definitions& run : runs_of(block.equations)) {
    const int count = static_cast<int>(run.members.size());
    if (count < shortest_series) {
      for (const Equation& each : run.members)
        result.push_back({statement_of(each), each.range, {}});
      continue;
    }
    const SeriesMember& first = *run.first;
    const std::vector<Form>& sides = first.general.over;
    result.push_back({statement_of({sides[0], {false, sides[1]}, {}}),
                      {series_index(), first.number, first.number + count - 1},
                      {}});
  }
  return result;
}

PrintedEquation Displays::print(const FittedEquation& equation) const {
  PrintedEquation result{dialect_.print(equation.left), dialect_.sign(equation.relation), {}, ""};
  for (const std::vector<Signed>& row : equation.rows)
    result.rows.push_back(dialect_.terms(row, &row != &equation.rows.front()));
  const FittedEquation::IndexRange& range = equation.range;
  if (!range.index.empty()) result.range = dialect_.range(range.index, range.first, range.last);
  return result;
}

Display Displays::printed(const Asked& equation, double column) {
  if (equation.sides)
    if (const auto known = known_.find(*equation.sides); known != known_.end())
      return {known->second};
  std::vector<FittedEquation> fitted = fitting_.fitted(equation.statement, column);
  fitted.back().range = equation.range;
  Display result;
  for (const FittedEquation& each : fitted) result.push_back(print(each));
  if (equation.sides) known_.emplace(*equation.sides, result.back());
  return result;
}

std::vector<Display> Displays::of(const DocumentBlock& block) {
  const std::vector<Asked> equations = asked(block);
  const auto width = [this](const Asked& each) { return measure_.of(each.statement.left.form); };
  const double widest = widest_column * measure_.width;
  double column = 0;
  for (const Asked& each : equations)
    if (width(each) <= widest) column = std::max(column, width(each));
  std::vector<Display> displays;
  bool aligned = false;
  for (const Asked& each : equations) {
    const bool narrow = width(each) <= widest;
    if (!aligned || !narrow) displays.emplace_back();
    for (PrintedEquation& row : printed(each, narrow ? column : 0))
      displays.back().push_back(std::move(row));
    aligned = narrow;
  }
  return displays;
}

}  // namespace vcrit::symbolic
