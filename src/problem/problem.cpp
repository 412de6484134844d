#include "problem/problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <mutex>
#include <string_view>

#include "base/constants.hpp"
#include "base/joined.hpp"
#include "problem/parts.hpp"
#include "problem/placing.hpp"
#include "scene/members.hpp"
#include "scene/range.hpp"
#include "scene/scene.hpp"

namespace vcrit {

namespace {

Symbol called(const std::map<std::string, std::string>& names, const Symbol& symbol) {
  const auto name = names.find(symbol.name);
  return name == names.end() ? symbol : Symbol{name->second, symbol.entry};
}

/// A frequency that has a name is asked for by that.
std::string missing_name(const Resolved& parts, const Symbol& symbol) {
  const auto frequency = parts.names.find(frequency_symbol.name);
  if (frequency != parts.names.end() && symbol == parts.angular_frequency.symbol)
    return frequency->second;
  return to_text(called(parts.names, symbol));
}

/// As scenes call it; empty for what has no other name than its symbol.
std::string_view key_of(const Resolved& parts, const Quantity& quantity) {
  if (&quantity == &parts.coefficient) return "coefficient";
  if (&quantity == &parts.angular_frequency) return "frequency";
  if (&quantity == &parts.amplitude) return "amplitude";
  if (&quantity == &parts.indentation) return "indentation";
  return parts.mass && &quantity == &*parts.mass ? "mass" : "";
}

/// "mu0 (coefficient)": who has not read the theory does not know the symbol.
std::string with_key(const std::string& name, std::string_view key) {
  return key.empty() || key == name ? name : fmt::format("{} ({})", name, key);
}

const Range& range_of(const Resolved& parts, const Quantity& quantity) {
  const auto is = [&quantity](const std::optional<Quantity>& part) {
    return part && &quantity == &*part;
  };
  if (&quantity == &parts.angular_frequency || is(parts.mass) || is(parts.mount_mass) ||
      is(parts.load))
    return positive;
  const auto* isotropic = std::get_if<Isotropic>(&parts.tangential);
  if (isotropic != nullptr && &quantity == &isotropic->quantity)
    return isotropic->by == Isotropic::By::poisson ? poisson_range : positive;
  return nonnegative;
}

}  // namespace

/// The parts, and their values checked.
struct Problem::Checked {
  Checked(Resolved resolved, const Values& numbers) : parts(std::move(resolved)), values(numbers) {
    check();
  }

  /// With these values in place of others. A sweep makes a problem a row: parts are copied once,
  /// and what stays as it is is not checked again.
  Checked(const Checked& other, const Values& changed) : parts(other.parts), values(other.values) {
    bool fits = true;
    for (const auto& [symbol, value] : changed)
      if (symbol != frequency_symbol) fits = put(symbol, value) && fits;
    if (const double* const frequency = changed.find(frequency_symbol)) {
      fits = put(parts.angular_frequency.symbol, two_pi * *frequency) && fits;
      parts.frequency = TypedNumber{*frequency, {}};
    }
    if (shares_mass(parts)) parts.mount_mass->value = parts.mass->value;
    if (fits && parts.measured.empty() && other.missing.empty())
      check_expressions();
    else
      check();
  }

  void check() {
    follow_tables();
    const Values given = std::exchange(values, Values::beside(values));
    // Reading leaves elements of value 0 out of the networks.
    for (const Symbol& symbol : *parts.elements) {
      const double* const value = given.find(symbol);
      if (!parts.of_table(symbol))
        add(symbol, value == nullptr ? std::nullopt : std::optional(*value), positive);
      else if (value != nullptr)
        values[symbol] = *value;  // a loss factor may be 0
    }
    for_each_quantity(std::as_const(parts), [&](const Quantity& quantity) {
      add(quantity.symbol, quantity.value, range_of(parts, quantity), key_of(parts, quantity));
    });
    check_expressions();
  }

  /// What follows omega by a table has its numbers there; outside the table it has none.
  void follow_tables() {
    const std::optional<double>& omega = parts.angular_frequency.value;
    for (const MeasuredStiffness& measured : parts.measured) {
      values.erase(measured.storage);
      values.erase(measured.loss_factor);
      const auto numbers = omega ? numbers_at(measured, *omega) : std::nullopt;
      if (!numbers) continue;
      values[measured.storage] = numbers->storage;
      values[measured.loss_factor] = numbers->loss_factor;
    }
  }

  void check_expressions() const {
    for (const Amount& amount : parts.expressions)
      if (const auto value = amount_value(amount, values))
        within(positive, *value, [&] { return text_of(amount); });
  }

  /// Whether the scene may have it: check() says why not.
  bool put(const Symbol& symbol, double value) {
    const Range* range = values.contains(symbol) || is_element(symbol) ? &positive : nullptr;
    for_each_quantity(parts, [&](Quantity& quantity) {
      if (quantity.symbol != symbol) return;
      quantity.value = value;
      range = &range_of(parts, quantity);
    });
    if (range == nullptr)
      throw InputError(argument("values"), "one for " + to_text(symbol),
                       "values of symbols that the scene has");
    values[symbol] = value;
    return range->holds(value);
  }

  bool is_element(const Symbol& symbol) const {
    return std::ranges::find(*parts.elements, symbol) != parts.elements->end();
  }

  void add(const Symbol& symbol, const std::optional<double>& value, const Range& range,
           std::string_view key = "") {
    if (value)
      values[symbol] = within(range, *value, [&] { return to_text(called(parts.names, symbol)); });
    else
      missing.push_back(with_key(missing_name(parts, symbol), key));
  }

  /// The value. The name is made for who has to hear it.
  template <class Name>
  double within(const Range& range, double value, Name name) const {
    return range.holds(value) ? value : checked(value, range, name(), {parts.source->file});
  }

  /// Neither by an indentation, of which the scene does not even give the name, nor by a load.
  bool not_pressed() const {
    return !parts.load && !parts.indentation.value &&
           called(parts.names, parts.indentation.symbol) == parts.indentation.symbol;
  }

  /// What gives the numbers that are missing, where that is no element or key of their name.
  std::string advice() const {
    if (not_pressed())
      return "what presses the contact is indentation in [oscillation] or force in [load]";
    for (const MeasuredStiffness& measured : parts.measured)
      if (!measured.rest.name.empty() && !values.contains(measured.rest))
        return fmt::format("{} is static_stiffness in [contact]", measured.rest.name);
    return "";
  }

  std::string text_of(const Amount& amount) const {
    const std::string text = to_text(
        amount, [this](const Symbol& symbol) { return to_text(called(parts.names, symbol)); });
    const std::string name = to_text(amount.name());
    return name.empty() ? text : fmt::format("{} = {}", name, text);
  }

  Resolved parts;
  Values values;
  std::vector<std::string> missing;
  mutable std::mutex finding;
  mutable std::optional<double> indentation;  // of a load
};

Problem::Problem(Resolved resolved, const Values& numbers)
    : checked_(std::make_shared<const Checked>(std::move(resolved), numbers)) {}

Problem::Problem(const Scene& scene) {
  const Values numbers = element_numbers(scene);
  checked_ = std::make_shared<const Checked>(placed_parts(scene, numbers), numbers);
  Values elements = Values::beside(numbers);
  for (const auto& [symbol, value] : elements_with_values(*this))
    if (value) elements[symbol] = *value;
  if (elements.size() == scene.elements.size()) check_members(scene, elements);
}

const Resolved& Problem::resolved() const { return checked_->parts; }

const Values& Problem::known_values() const& { return checked_->values; }

const Values& Problem::values() const& {
  if (!checked_->missing.empty())
    throw InputError({checked_->parts.source->file},
                     fmt::format("no value for {}", joined(checked_->missing, ", ")),
                     "a number for each, in the scene or by `set NAME=VALUE`", checked_->advice());
  for (const MeasuredStiffness& measured : checked_->parts.measured)
    if (!checked_->values.contains(measured.storage))
      throw ModelError(outside_words(measured, *checked_->parts.angular_frequency.value));
  return checked_->values;
}

double Problem::found_indentation(const std::function<double()>& find) const {
  const std::lock_guard lock(checked_->finding);
  if (!checked_->indentation) checked_->indentation = find();
  return *checked_->indentation;
}

Problem Problem::with(const Values& values) const {
  Problem changed = *this;
  changed.checked_ = std::make_shared<const Checked>(*checked_, values);
  return changed;
}

Problem resolve(const Scene& scene) { return scene; }

Problem read_problem(const std::string& file, const Settings& settings) {
  return read_scene(file, settings);
}

Problem parse_problem(const std::string& text, const std::string& file, const Settings& settings) {
  return parse_scene(text, file, settings);
}

const Quantity& pressing(const Problem& problem) {
  return problem->load ? *problem->load : problem->indentation;
}

std::vector<Quantity> quantities(const Problem& problem) {
  std::vector<Quantity> all;
  for_each_quantity(*problem, [&](const Quantity& quantity) { all.push_back(quantity); });
  return all;
}

std::vector<Quantity> elements_with_values(const Problem& problem) {
  std::vector<Quantity> all;
  for (const Symbol& symbol : *problem->elements) {
    const double* const value = problem.known_values().find(symbol);
    all.push_back({symbol, value == nullptr ? std::nullopt : std::optional(*value)});
  }
  return all;
}

void for_each_element(const Problem& problem, const std::function<void(const Element&)>& visit) {
  for_each_network(*problem,
                   [&visit](const Network& network) { for_each_element(network, visit); });
}

std::optional<std::string> beyond_fitted_range(const Problem& problem, double from, double to) {
  return beyond_fitted_range(problem->fitted_range, problem->source->file, from, to);
}

Symbol as_called(const Problem& problem, const Symbol& symbol) {
  return called(problem->names, symbol);
}

std::string name_in(const Problem& problem, const Quantity& quantity) {
  return to_text(as_called(problem, quantity.symbol));
}

ScaledNetwork tangential_network(const Problem& problem) {
  if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential))
    return {problem->normal, tangential_ratio(*isotropic)};
  return {std::get<ReducedNetwork>(problem->tangential), 1};
}

}  // namespace vcrit
