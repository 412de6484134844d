#include "shortest/letters.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "formula/names.hpp"

namespace vcrit::symbolic::shortest {

namespace {

class Measuring {
 public:
  Measuring(const Expressions& all, const Measures& symbols, const Steps& steps)
      : all_(all), symbols_(symbols), steps_(steps) {}

  Measure of(std::uint32_t step) {
    if (const auto known = known_.find(step); known != known_.end()) return known->second;
    return known_[step] = measured(steps_.steps()[step]);
  }

 private:
  Measure measured(const FormulaStep& step) {
    if (step.kind == FormulaStep::Kind::symbol) return of_symbol(step.node);
    if (step.kind == FormulaStep::Kind::number) return {};
    if (step.kind == FormulaStep::Kind::sum || step.kind == FormulaStep::Kind::magnitude)
      return of(step.parts[0].step);
    Measure whole;
    for (const StepPart& part : step.parts) {
      const Measure each = of(part.step);
      whole.stiffness += part.sign * each.stiffness;
      whole.time += part.sign * each.time;
    }
    const double power = step.kind == FormulaStep::Kind::power  ? step.exponent
                         : step.kind == FormulaStep::Kind::root ? 0.5
                                                                : 1;
    return {whole.stiffness * power, whole.time * power};
  }

  Measure of_symbol(ExNode node) const {
    const auto found = symbols_.symbols.find(node);
    if (found != symbols_.symbols.end()) return found->second;
    if (symbols_.dimensionless) return {};
    // A letter is a number (g, T) or a stiffness.
    const std::string& letter = all_.name(node);
    return letter == "T" || letter == "g" ? Measure{} : Measure{1, 0};
  }

  const Expressions& all_;
  const Measures& symbols_;
  const Steps& steps_;
  std::map<std::uint32_t, Measure> known_;
};

/// omega c/k
bool is_turn(const Expressions& all, const Steps& steps, const FormulaStep& step,
             const Measure& measure) {
  if (std::abs(measure.stiffness) > 0.1) return false;
  const auto symbol = [&](const StepPart& part) -> const FormulaStep& {
    return steps.steps()[part.step];
  };
  const auto holds = [&](const auto& which) {
    return std::any_of(step.parts.begin(), step.parts.end(), which);
  };
  return step.kind == FormulaStep::Kind::product && !holds([&](const StepPart& part) {
           return symbol(part).kind != FormulaStep::Kind::symbol;
         }) &&
         holds([&](const StepPart& part) { return all.name(symbol(part).node) == "W"; }) &&
         holds([](const StepPart& part) { return part.sign < 0; });
}

std::string letter_of(const FormulaStep& step, const Measure& measure) {
  if (std::abs(measure.time) > 0.1) return "X";
  const bool sum = step.kind == FormulaStep::Kind::sum;
  switch (static_cast<int>(std::lround(2 * measure.stiffness))) {
    case 0:
      return "R";
    case 2:
      return sum ? "S" : "G";
    case 4:
      return "Q";
    case -2:
      return "J";
    default:
      return "X";
  }
}

/// `letter` where all are numbers.
std::string greek_letter(const std::string& letter, const FormulaStep& step) {
  static const std::map<std::string, std::string> greek{
      {"T", "theta"}, {"Z", "zeta"}, {"W", "xi"}, {"V", "chi"}, {"M", "beta"}};
  if (letter == "R") return step.kind == FormulaStep::Kind::sum ? "sigma" : "rho";
  const auto found = greek.find(letter);
  return found == greek.end() ? letter : found->second;
}

}  // namespace

std::vector<std::string> letters(const Expressions& all, const Measures& measures,
                                 const Steps& steps, const std::vector<std::uint32_t>& named) {
  Measuring measuring(all, measures, steps);
  std::vector<std::string> result;
  std::map<std::string, int> count, next;
  for (const std::uint32_t i : named) {
    const FormulaStep& step = steps.steps()[i];
    const bool symbol = step.kind == FormulaStep::Kind::symbol;
    const Measure measure = symbol ? Measure{} : measuring.of(i);
    result.push_back(symbol                               ? all.name(step.node)
                     : is_turn(all, steps, step, measure) ? "T"
                                                          : letter_of(step, measure));
    if (measures.dimensionless) result.back() = greek_letter(result.back(), step);
    ++count[result.back()];
  }
  std::set<std::string> given;
  for (std::string& name : result) {
    const std::string letter = name;
    const auto numbered = [&] { return letter + std::to_string(++next[letter]) + measures.mark; };
    name = count[letter] > 1 ? numbered() : letter + measures.mark;
    // An element of the scene may have that name.
    while (is_taken(name) || given.contains(name)) name = numbered();
    given.insert(name);
  }
  return result;
}

}  // namespace vcrit::symbolic::shortest
