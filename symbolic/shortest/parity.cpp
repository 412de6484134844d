#include "shortest/parity.hpp"

namespace vcrit::symbolic::shortest {

bool Parity::is_odd(std::uint32_t step) const {
  if (const auto known = known_.find(step); known != known_.end()) return known->second;
  return known_[step] = of(steps_.steps()[step]);
}

bool Parity::is_square_of_odd(std::uint32_t step) const {
  const FormulaStep& power = steps_.steps()[step];
  return power.kind == FormulaStep::Kind::power && power.exponent == 2 &&
         is_odd(power.parts[0].step);
}

// All terms of a sum are as its first one is.
bool Parity::of(const FormulaStep& step) const {
  switch (step.kind) {
    case FormulaStep::Kind::symbol:
      return is_odd_node(step.node);
    case FormulaStep::Kind::product: {
      bool odd = false;
      for (const StepPart& part : step.parts) odd = odd != is_odd(part.step);
      return odd;
    }
    case FormulaStep::Kind::power:
      return step.exponent % 2 != 0 && is_odd(step.parts[0].step);
    case FormulaStep::Kind::sum:
    case FormulaStep::Kind::magnitude:
      return is_odd(step.parts[0].step);
    case FormulaStep::Kind::number:
    case FormulaStep::Kind::root:
      break;
  }
  return false;
}

bool Parity::is_odd_node(ExNode node) const {
  const NodeData& data = all_[node];
  switch (data.kind) {
    case ExpressionKind::symbol: {
      const Ex& meaning = all_.meaning(node);
      return odd_.contains(node) || (!meaning.is_zero() && is_odd_node(meaning.node));
    }
    case ExpressionKind::product: {
      bool odd = false;
      for (const Item& item : data.items)
        odd = odd != (item.exponent % 2 != 0 && is_odd_node(item.node));
      return odd;
    }
    case ExpressionKind::sum:
    case ExpressionKind::magnitude:
      return is_odd_node(data.items[0].node);
    case ExpressionKind::one:
    case ExpressionKind::root:
      break;
  }
  return false;
}

}  // namespace vcrit::symbolic::shortest
