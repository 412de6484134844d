// What the sharing of steps leaves: sums whose terms have a factor in common, and products that are
// shorter multiplied out. Neither is seen by moves within expressions, where what is shared is no
// part of its own.
#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "shortest/steps.hpp"

namespace vcrit::symbolic::shortest {

void Steps::take_out_factors() {
  for (bool more = true; more;) {
    more = false;
    for (std::uint32_t i = 0; i < steps_.size() && !more; ++i) {
      if (steps_[i].uses == 0) continue;
      FormulaSteps before;
      const int operations = operations_;
      const bool changed = steps_[i].kind == FormulaStep::Kind::sum       ? take_out_of(i, before)
                           : steps_[i].kind == FormulaStep::Kind::product ? multiply_into(i, before)
                                                                          : false;
      if (changed) count();
      more = changed && operations_ < operations;
      if (more || before.empty()) continue;
      steps_ = std::move(before);
      if (changed) count();
    }
  }
}

void Steps::keep(FormulaSteps& before) const {
  if (before.empty()) before = steps_;
}

bool Steps::cancel_in_front(ExNode omega) {
  FormulaStep front = steps_[whole()];
  const auto leads = [this](const StepPart& part) {
    const FormulaStep& step = steps_[part.step];
    return part.sign > 0 && step.kind == FormulaStep::Kind::symbol && all_.leads(step.node);
  };
  if (front.kind != FormulaStep::Kind::product ||
      std::none_of(front.parts.begin(), front.parts.end(), leads))
    return false;
  for (StepPart& part : front.parts) {
    if (part.sign > 0 || steps_[part.step].kind != FormulaStep::Kind::symbol) continue;
    const Ex meaning = all_.meaning(steps_[part.step].node);
    if (!meaning.factor.is_one() || all_[meaning.node].kind != ExpressionKind::product) continue;
    const std::span<const Item> items = all_[meaning.node].items;
    const auto is = [&](std::size_t i, bool is_omega) {
      return items[i].exponent == 1 && (items[i].node == omega) == is_omega &&
             all_[items[i].node].kind == ExpressionKind::symbol;
    };
    if (items.size() != 2 || !((is(0, true) && is(1, false)) || (is(0, false) && is(1, true))))
      continue;
    const std::uint32_t other = of(items[is(0, true) ? 1 : 0].node);
    const auto same = [&](const StepPart& each) { return each.step == other; };
    if (std::any_of(front.parts.begin(), front.parts.end(), same)) continue;
    part.step = other;
    front.sort_parts();
    steps_[whole()] = std::move(front);
    count();
    return true;
  }
  return false;
}

bool Steps::is_used_once(std::uint32_t step, FormulaStep::Kind kind) const {
  const bool is_line = std::find(wholes_.begin(), wholes_.end(), step) != wholes_.end();
  return steps_[step].kind == kind && steps_[step].uses == 1 && !is_line;
}

std::uint32_t Steps::without(std::uint32_t product, const StepPart& factor) {
  FormulaStep rest;
  rest.kind = FormulaStep::Kind::product;
  for (const StepPart& part : steps_[product].parts)
    if (part != factor) rest.parts.push_back(part);
  if (rest.parts.empty()) return number(1);
  if (rest.parts.size() == 1 && rest.parts[0].sign > 0) return rest.parts[0].step;
  return put(std::move(rest));
}

std::uint32_t Steps::times(std::uint32_t step, std::uint32_t factor) {
  FormulaStep whole;
  whole.kind = FormulaStep::Kind::product;
  whole.parts = {{step, 1}};
  if (is_used_once(step, FormulaStep::Kind::product)) whole.parts = steps_[step].parts;
  whole.parts.push_back({factor, 1});
  return put(std::move(whole));
}

/// a b + a c + d = a (b + c) + d
bool Steps::take_out_of(std::uint32_t sum, FormulaSteps& before) {
  const StepParts terms = steps_[sum].parts;
  std::map<StepPart, std::size_t> found;
  for (const StepPart& term : terms)
    if (is_used_once(term.step, FormulaStep::Kind::product))
      for (const StepPart& factor : steps_[term.step].parts) ++found[factor];
  const auto best = std::max_element(
      found.begin(), found.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (best == found.end() || best->second < 2) return false;
  keep(before);
  const StepPart common = best->first;
  FormulaStep inner;
  inner.kind = FormulaStep::Kind::sum;
  StepParts rest;
  for (const StepPart& term : terms) {
    const StepParts& factors = steps_[term.step].parts;
    const bool has = is_used_once(term.step, FormulaStep::Kind::product) &&
                     std::find(factors.begin(), factors.end(), common) != factors.end();
    if (has)
      inner.parts.push_back({without(term.step, common), term.sign});
    else
      rest.push_back(term);
  }
  const int sign = std::any_of(inner.parts.begin(), inner.parts.end(),
                               [](const StepPart& part) { return part.sign > 0; })
                       ? 1
                       : -1;
  for (StepPart& part : inner.parts) part.sign *= sign;
  if (rest.empty() && sign < 0) return false;
  FormulaStep product;
  product.kind = FormulaStep::Kind::product;
  product.parts = {{put(std::move(inner)), 1}, common};
  if (rest.empty()) {
    product.sort_parts();
    steps_[sum] = std::move(product);
    return true;
  }
  rest.push_back({put(std::move(product)), sign});
  steps_[sum].parts = std::move(rest);
  steps_[sum].sort_parts();
  return true;
}

bool Steps::multiply_into(std::uint32_t product, FormulaSteps& before) {
  const StepParts factors = steps_[product].parts;
  for (const StepPart& sum : factors)
    for (const StepPart& factor : factors)
      if (sum.sign > 0 && factor.sign > 0 && multiply_into(product, sum.step, factor.step, before))
        return true;
  return false;
}

/// a (b + c/a) = a b + c
bool Steps::multiply_into(std::uint32_t product, std::uint32_t sum, std::uint32_t factor,
                          FormulaSteps& before) {
  if (!is_used_once(sum, FormulaStep::Kind::sum) || steps_[sum].parts.size() != 2) return false;
  const StepPart below{factor, -1};
  const auto has = [&](const StepPart& term) {
    const StepParts& parts = steps_[term.step].parts;
    return is_used_once(term.step, FormulaStep::Kind::product) &&
           std::find(parts.begin(), parts.end(), below) != parts.end();
  };
  StepParts terms = steps_[sum].parts;
  const auto is_power = [&](const StepPart& term) {
    const StepParts& parts = steps_[term.step].parts;
    return is_used_once(term.step, FormulaStep::Kind::product) &&
           std::find(parts.begin(), parts.end(), StepPart{factor, 1}) != parts.end();
  };
  if (std::none_of(terms.begin(), terms.end(), has) ||
      std::any_of(terms.begin(), terms.end(), is_power))
    return false;
  keep(before);
  for (StepPart& term : terms)
    term.step = has(term) ? without(term.step, below) : times(term.step, factor);
  StepParts rest;
  for (const StepPart& part : steps_[product].parts)
    if (part.step != sum && part.step != factor) rest.push_back(part);
  if (rest.empty()) return become_sum(product, terms);
  FormulaStep inner;
  inner.kind = FormulaStep::Kind::sum;
  inner.parts = std::move(terms);
  rest.push_back({put(std::move(inner)), 1});
  steps_[product].parts = std::move(rest);
  steps_[product].sort_parts();
  return true;
}

/// Within another sum its terms are terms of that.
bool Steps::become_sum(std::uint32_t product, const StepParts& terms) {
  const bool within = is_used_once(product, FormulaStep::Kind::product);
  steps_[product].kind = FormulaStep::Kind::sum;
  steps_[product].parts = terms;
  steps_[product].sort_parts();
  if (!within) return true;
  for (FormulaStep& step : steps_) {
    if (step.kind != FormulaStep::Kind::sum || step.uses == 0) continue;
    const auto part = std::find_if(step.parts.begin(), step.parts.end(),
                                   [&](const StepPart& each) { return each.step == product; });
    if (part == step.parts.end()) continue;
    const int sign = part->sign;
    step.parts.erase(part);
    for (const StepPart& term : terms) {
      const bool twice = std::any_of(step.parts.begin(), step.parts.end(),
                                     [&](const StepPart& each) { return each.step == term.step; });
      if (twice) return false;
      step.parts.push_back({term.step, term.sign * sign});
    }
    step.sort_parts();
  }
  return true;
}

}  // namespace vcrit::symbolic::shortest
