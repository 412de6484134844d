#include "shortest/steps.hpp"

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <optional>

namespace vcrit::symbolic::shortest {

namespace {

std::uint64_t bit(std::uint32_t step) { return std::uint64_t{1} << (step % 64); }

bool has_bits(std::uint64_t mask, std::size_t least) {
  for (; least > 1 && mask != 0; --least) mask &= mask - 1;
  return mask != 0;
}

/// How many parts two steps of a kind have in common: with equal signs, and with opposite ones.
struct Common {
  std::size_t same = 0, opposite = 0;
  std::size_t larger() const { return std::max(same, opposite); }
};

/// Calls `visit` with each part of `a` that `b` has, and whether its sign is the same there.
template <class Visit>
void for_each_common(const FormulaStep& a, const FormulaStep& b, const Visit& visit) {
  for (auto i = a.parts.begin(), j = b.parts.begin(); i != a.parts.end() && j != b.parts.end();) {
    if (i->step < j->step)
      ++i;
    else if (j->step < i->step)
      ++j;
    else {
      visit(*i, i->sign == j->sign);
      ++i, ++j;
    }
  }
}

Common count_common(const FormulaStep& a, const FormulaStep& b) {
  Common count;
  for_each_common(a, b,
                  [&](const StepPart&, bool same) { ++(same ? count.same : count.opposite); });
  return count;
}

/// What two steps of a kind have in common, as it stands in `a`: the larger of both.
StepParts common_parts(const FormulaStep& a, const FormulaStep& b, const Common& count) {
  StepParts parts;
  for_each_common(a, b, [&](const StepPart& part, bool same) {
    if (same == (count.opposite <= count.same)) parts.push_back(part);
  });
  return parts;
}

/// The sign with which `step` holds all of `parts`, whose mask is given, if it does.
std::optional<int> sign_in(const FormulaStep& step, const StepParts& parts, std::uint64_t mask) {
  if ((mask & ~step.mask) != 0) return std::nullopt;  // nearly always
  int sign = 0;
  auto i = step.parts.begin();
  for (const StepPart& part : parts) {
    while (i != step.parts.end() && i->step < part.step) ++i;
    if (i == step.parts.end() || i->step != part.step) return std::nullopt;
    const int here = i->sign == part.sign ? 1 : -1;
    if (sign != 0 && sign != here) return std::nullopt;
    sign = here;
  }
  return sign;
}

}  // namespace

void FormulaStep::sort_parts() {
  std::sort(parts.begin(), parts.end());
  mask = 0, distinct = true;
  for (const StepPart& part : parts) {
    distinct = distinct && (mask & bit(part.step)) == 0;
    mask |= bit(part.step);
  }
}

int step_operations(const FormulaStep& step, const Expressions& all) {
  const int size = static_cast<int>(step.parts.size());
  switch (step.kind) {
    case FormulaStep::Kind::symbol:
      return all.operations(step.node);
    case FormulaStep::Kind::number:
      return 0;
    case FormulaStep::Kind::sum:
      return size - 1;
    case FormulaStep::Kind::product: {
      const bool over = std::any_of(step.parts.begin(), step.parts.end(),
                                    [](const StepPart& part) { return part.sign > 0; });
      return over ? size - 1 : size;
    }
    default:
      return 1;
  }
}

Steps::Steps(const Expressions& all, std::span<const Ex> wholes) : all_(all) {
  for (std::size_t i = 0; i + 1 < wholes.size(); ++i) wholes_.push_back(definition(wholes[i]));
  wholes_.push_back(of(wholes.back().factor, wholes.back().node));
  sharing_ = true;
  share(FormulaStep::Kind::sum);
  share(FormulaStep::Kind::product);
  count();
  all.spend(20 * steps_.size());
}

/// What is negative is a sum of one term.
std::uint32_t Steps::definition(const Ex& meaning) {
  const std::uint32_t size = of(meaning.factor, meaning.node);
  if (!meaning.factor.negative()) return size;
  FormulaStep step;
  step.kind = FormulaStep::Kind::sum;
  step.parts = {{size, -1}};
  return put(std::move(step));
}

std::uint32_t Steps::put(FormulaStep&& step) {
  step.sort_parts();
  // Until steps are shared each stands behind its parts.
  const std::uint32_t first = sharing_ || step.parts.empty() ? 0 : step.parts.back().step + 1;
  for (std::uint32_t i = first; i < steps_.size(); ++i) {
    const FormulaStep& old = steps_[i];
    if (old.mask == step.mask && old.kind == step.kind && old.node == step.node &&
        old.number == step.number && old.exponent == step.exponent && old.parts == step.parts) {
      all_.spend(steps_.size() / 16);
      return i;
    }
  }
  return append(std::move(step));
}

std::uint32_t Steps::append(FormulaStep&& step) {
  all_.spend(steps_.size() / 16);
  steps_.push_back(std::move(step));
  return static_cast<std::uint32_t>(steps_.size() - 1);
}

std::uint32_t Steps::number(std::int64_t value) {
  FormulaStep step;
  step.kind = FormulaStep::Kind::number;
  step.number = value;
  return put(std::move(step));
}

std::uint32_t Steps::of(const SmallFraction& factor, ExNode node) {
  const SmallFraction size = absolute(factor);
  if (size.is_one()) return of(node);
  if (all_[node].kind == ExpressionKind::product) return product(size, all_[node].items);
  if (node == 0) return size.under == 1 ? number(size.over) : product(size, {});
  return product(size, std::array{Item{node, 1, {}}});
}

std::uint32_t Steps::product(const SmallFraction& factor, std::span<const Item> items) {
  FormulaStep step;
  step.kind = FormulaStep::Kind::product;
  if (factor.over != 1) step.parts.push_back({number(factor.over), 1});
  if (factor.under != 1) step.parts.push_back({number(factor.under), -1});
  for (const Item& item : items)
    if (item.exponent == 1 || item.exponent == -1)
      step.parts.push_back({of(item.node), item.exponent});
  // (a b)^2 rather than a^2 b^2.
  int highest = 1;
  for (const Item& item : items) highest = std::max(highest, std::abs(item.exponent));
  for (int exponent = 2; exponent <= highest; ++exponent) {
    FormulaStep base;
    base.kind = FormulaStep::Kind::product;
    for (const Item& item : items)
      if (std::abs(item.exponent) == exponent)
        base.parts.push_back({of(item.node), item.exponent > 0 ? 1 : -1});
    if (base.parts.empty()) continue;
    int sign = 1;
    if (std::none_of(base.parts.begin(), base.parts.end(),
                     [](const StepPart& part) { return part.sign > 0; })) {
      sign = -1;
      for (StepPart& part : base.parts) part.sign = 1;
    }
    FormulaStep power;
    power.kind = FormulaStep::Kind::power;
    power.exponent = exponent;
    power.parts = {{base.parts.size() == 1 ? base.parts[0].step : put(std::move(base)), 1}};
    step.parts.push_back({put(std::move(power)), sign});
  }
  if (step.parts.size() == 1 && step.parts[0].sign == 1) return step.parts[0].step;
  return put(std::move(step));
}

std::uint32_t Steps::of(ExNode node) {
  const std::size_t remainder = node % last_known_.size();
  for (std::uint32_t at = last_known_[remainder]; at != 0; at = known_[at - 1].before)
    if (known_[at - 1].node == node) return known_[at - 1].step;
  const NodeData& data = all_[node];
  FormulaStep step;
  std::uint32_t made = 0;
  switch (data.kind) {
    case ExpressionKind::one:
      made = number(1);
      break;
    case ExpressionKind::symbol:  // of which there is no step yet, nor of a sum
      step.node = node;
      made = append(std::move(step));
      break;
    case ExpressionKind::product:
      made = product({}, data.items);
      break;
    case ExpressionKind::sum:
      step.kind = FormulaStep::Kind::sum;
      for (const Item& item : data.items)
        step.parts.push_back({of(item.factor, item.node), item.factor.negative() ? -1 : 1});
      step.sort_parts();
      made = append(std::move(step));
      break;
    case ExpressionKind::root:
    case ExpressionKind::magnitude:
      step.kind = data.kind == ExpressionKind::root ? FormulaStep::Kind::root
                                                    : FormulaStep::Kind::magnitude;
      step.parts = {{of(data.items[0].factor, data.items[0].node), 1}};
      made = put(std::move(step));
      break;
  }
  known_.push_back({node, made, last_known_[remainder]});
  last_known_[remainder] = static_cast<std::uint32_t>(known_.size());
  return made;
}

void Steps::replace(std::uint32_t in, const StepParts& common, std::uint64_t mask,
                    std::uint32_t by) {
  const std::optional<int> sign = sign_in(steps_[in], common, mask);
  if (!sign) return;
  StepParts& parts = steps_[in].parts;
  const auto is_common = [&](const StepPart& part) {
    return std::any_of(common.begin(), common.end(),
                       [&](const StepPart& each) { return each.step == part.step; });
  };
  parts.erase(std::remove_if(parts.begin(), parts.end(), is_common), parts.end());
  parts.push_back({by, *sign});
  steps_[in].sort_parts();
}

StepParts Steps::most_shared(const StepNumbers& sets) const {
  boost::container::small_vector<std::uint64_t, 64> masks;
  for (const std::uint32_t set : sets) masks.push_back(steps_[set].mask);
  StepParts best;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    // Two parts in common are two bits, unless they have the same one.
    const FormulaStep& a = steps_[sets[i]];
    const auto one = static_cast<std::uint64_t>(a.distinct);
    std::uint64_t any = 0;  // of most sets none, which is found without a branch
    for (std::size_t j = i + 1; j < sets.size(); ++j) {
      const std::uint64_t both = masks[i] & masks[j];
      any |= both & (both - one);
    }
    for (std::size_t j = i + 1; any != 0 && j < sets.size(); ++j) {
      const std::size_t least = std::max<std::size_t>(2, best.size() + 1);
      if (!has_bits(masks[i] & masks[j], a.distinct ? least : 1)) continue;
      const FormulaStep& b = steps_[sets[j]];
      const Common common = count_common(a, b);
      if (common.larger() >= least) best = common_parts(a, b, common);
    }
  }
  return best;
}

bool Steps::share_best(StepNumbers& sets) {
  all_.spend(sets.size() * sets.size() / 8);
  StepParts best = most_shared(sets);
  if (best.empty()) return false;
  std::uint64_t mask = 0;
  for (const StepPart& part : best) mask |= bit(part.step);
  // Where it is all of a step, that step is it.
  std::uint32_t shared = static_cast<std::uint32_t>(steps_.size());
  for (const std::uint32_t set : sets)
    if (steps_[set].parts.size() == best.size() && sign_in(steps_[set], best, mask)) {
      shared = set;
      best = steps_[set].parts;
      break;
    }
  if (shared == steps_.size()) {
    FormulaStep step;
    step.kind = steps_[sets[0]].kind;
    const bool turned = step.kind == FormulaStep::Kind::sum
                            ? best.front().sign < 0
                            : std::none_of(best.begin(), best.end(),
                                           [](const StepPart& part) { return part.sign > 0; });
    if (turned)
      for (StepPart& part : best) part.sign = -part.sign;
    step.parts = best;
    step.sort_parts();
    steps_.push_back(std::move(step));
  }
  for (const std::uint32_t set : sets)
    if (set != shared && (mask & ~steps_[set].mask) == 0) replace(set, best, mask, shared);
  if (shared > sets.back()) sets.push_back(shared);
  const auto is_one_part = [this](std::uint32_t set) { return steps_[set].parts.size() < 2; };
  sets.erase(std::remove_if(sets.begin(), sets.end(), is_one_part), sets.end());
  return true;
}

void Steps::share(FormulaStep::Kind kind) {
  StepNumbers sets;
  for (std::uint32_t i = 0; i < steps_.size(); ++i)
    if (steps_[i].kind == kind && i != whole() && steps_[i].parts.size() >= 2) sets.push_back(i);
  while (sets.size() >= 2 && share_best(sets)) continue;
}

std::uint32_t Steps::halve(std::uint32_t sum) {
  FormulaStep half;
  half.kind = FormulaStep::Kind::sum;
  half.uses = 1;
  StepParts& parts = steps_[sum].parts;
  const auto middle = parts.begin() + static_cast<std::ptrdiff_t>((parts.size() + 1) / 2);
  half.parts.assign(parts.begin(), middle);
  // A sum begins with what is added.
  const int sign = std::any_of(half.parts.begin(), half.parts.end(),
                               [](const StepPart& part) { return part.sign > 0; })
                       ? 1
                       : -1;
  for (StepPart& part : half.parts) part.sign *= sign;
  parts.erase(parts.begin(), middle);
  const auto made = static_cast<std::uint32_t>(steps_.size());
  parts.push_back({made, sign});
  steps_.push_back(std::move(half));
  return made;
}

void Steps::count() {
  operations_ = shared_ = 0;
  for (FormulaStep& step : steps_) step.uses = 0;
  StepNumbers open;
  for (const std::uint32_t each : wholes_)
    if (steps_[each].uses++ == 0) open.push_back(each);
  while (!open.empty()) {
    const FormulaStep& step = steps_[open.back()];
    open.pop_back();
    operations_ += step_operations(step, all_);
    for (const StepPart& part : step.parts) {
      FormulaStep& used = steps_[part.step];
      if (used.uses++ == 0) open.push_back(part.step);
      if (used.uses == 2 && step_operations(used, all_) > 0) ++shared_;
    }
  }
}

}  // namespace vcrit::symbolic::shortest
