#include "shortest/lines.hpp"

#include <algorithm>

#include "base/sort_stably.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/series.hpp"
#include "shortest/search.hpp"

namespace vcrit::symbolic::shortest {

namespace {

constexpr std::size_t longest_line = 90, least_part = 16;  // characters of plain text

// Operations of a letter that has a line although it is used once.
constexpr int least_named_once = 4;

Form digits_form(std::int64_t value) {
  return {Form::Kind::number, std::to_string(value), {}, {}, {}, 1};
}

Form name_form(const std::string& name) { return {Form::Kind::name, name, {}, {}, {}, 1}; }

/// The order of factors: numbers, the prefactor, our letters behind the scene's names, then what is
/// not a name.
int factor_rank(const Form& form) {
  static const std::map<std::string, int> leading{{"mu0", 1}, {"omega", 2}, {"du_z", 3}};
  switch (form.kind) {
    case Form::Kind::number:
      return 0;
    case Form::Kind::name: {
      if (form.text == own_name("g")) return 4;
      const auto found = leading.find(form.text);
      return found != leading.end() ? found->second : is_own(form.text) ? 6 : 5;
    }
    case Form::Kind::power:
      return 7 + (form.over[0].kind == Form::Kind::name ? 0 : 1);
    case Form::Kind::product:
      return !form.over.empty() && factor_rank(form.over[0]) <= 4 ? 9 : 10;
    case Form::Kind::sum:
    case Form::Kind::series:
      return 10;
    case Form::Kind::call:
      return 11;
    case Form::Kind::root:
      return 12;
  }
  return 13;
}

bool before(const Form& a, const Form& b) {
  const int first = factor_rank(a), second = factor_rank(b);
  if (first != second) return first < second;
  return natural_less(text_dialect().print({false, a}), text_dialect().print({false, b}));
}

/// sqrt(x) of a factor sqrt(1/x), which stands on the other side of a bar.
std::optional<Form> root_below(const Form& factor) {
  if (factor.kind != Form::Kind::root) return std::nullopt;
  Form inside = factor.over[0];
  if (inside.kind != Form::Kind::product || !inside.over.empty()) return std::nullopt;
  if (inside.under.size() == 1)
    return Form{Form::Kind::root, "", std::move(inside.under), {}, {}, 1};
  std::swap(inside.over, inside.under);
  return Form{Form::Kind::root, "", {inside}, {}, {}, 1};
}

/// (b/a)^2 of (a/b)^2 below a bar.
std::optional<Form> power_above(const Form& below) {
  if (below.kind != Form::Kind::power || below.over[0].kind != Form::Kind::product ||
      below.over[0].under.empty())
    return std::nullopt;
  Form turned = below;
  std::swap(turned.over[0].over, turned.over[0].under);
  return turned;
}

/// omega^2 of the omega that leads v* and that of a damper c omega: equal names, neighbours once
/// sorted, are one power.
void join_equal_names(std::vector<Form>& factors) {
  for (std::size_t i = 0; i + 1 < factors.size(); ++i) {
    const auto equal = [&](std::size_t j) {
      return j < factors.size() && factors[j].kind == Form::Kind::name &&
             factors[j].text == factors[i].text;
    };
    std::size_t end = i;
    while (equal(end)) ++end;
    if (end < i + 2) continue;
    Form power{Form::Kind::power, "", {factors[i]}, {}, {}, static_cast<int>(end - i)};
    factors.erase(factors.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                  factors.begin() + static_cast<std::ptrdiff_t>(end));
    factors[i] = std::move(power);
  }
}

/// mu0 omega^2 du_z
void put_behind_mu0(std::vector<Form>& factors) {
  const auto is_power = [](const Form& factor) {
    return factor.kind == Form::Kind::power && factor.over[0].text == "omega";
  };
  const auto power = std::find_if(factors.begin(), factors.end(), is_power);
  const auto is_mu0 = [](const Form& factor) { return factor.text == "mu0"; };
  const auto mu0 = std::find_if(factors.begin(), power, is_mu0);
  if (power != factors.end() && mu0 != power) std::rotate(mu0 + 1, power, power + 1);
}

ExLines meanings_and(const Ex& velocity, const std::vector<NamedLine>& definitions) {
  ExLines lines;
  for (const NamedLine& each : definitions) lines.push_back(each.meaning);
  lines.push_back(velocity);
  return lines;
}

/// A term of a sum and whether it is the square of an imaginary part.
struct PlacedTerm {
  bool imaginary = false;
  Signed text;
};

/// What is added before what is taken away, real parts before imaginary ones, 1/k0 before 1/(k1 +
/// k2); omega has no place of its own.
bool before_in_sum(const PlacedTerm& a, const PlacedTerm& b) {
  if (a.text.minus != b.text.minus) return b.text.minus;
  if (a.imaginary != b.imaginary) return b.imaginary;
  const int first = factor_rank(a.text.form), second = factor_rank(b.text.form);
  if (first != second) return first < second;
  const bool has_sum = holds_sum(a.text.form), other_has = holds_sum(b.text.form);
  return has_sum != other_has ? other_has : before(a.text.form, b.text.form);
}

}  // namespace

Lines::Lines(const Expressions& all, const Measures& measures, const Ex& velocity,
             const std::vector<NamedLine>& definitions)
    : all_(all),
      measures_(measures),
      definitions_(definitions),
      steps_(all, meanings_and(velocity, definitions)),
      parity_(all, steps_, measures.odd) {
  steps_.take_out_factors();
  for (const ExNode symbol : measures.odd)
    if (all.name(symbol) == "omega") omega_cancels_ = steps_.cancel_in_front(symbol);
}

ShortestForm Lines::form() {
  do give_names();
  while (divide_long_line());
  ShortestForm result;
  for (const Index line : lines_) {
    result.definitions.push_back({name_form(own_name(names_.at(line))), written(line)});
    result.operations += operations_in(result.definitions.back().meaning);
  }
  result.velocity = written(steps_.whole());
  result.operations += operations_in(result.velocity);
  return result;
}

/// A letter that is used once stands as what it means; a long one, within a sum, does not.
bool Lines::has_line(Index i) const {
  const FormulaStep& step = steps_.steps()[i];
  if (step.kind == FormulaStep::Kind::number) return false;
  if (step.kind == FormulaStep::Kind::symbol) {
    if (step.uses > 1) return all_.operations(step.node) > 0;
    const StepParts& factors = steps_.steps()[steps_.whole()].parts;
    const bool factor = std::find(factors.begin(), factors.end(), StepPart{i, 1}) != factors.end();
    return all_.operations(step.node) >= least_named_once && !factor;
  }
  return step.uses > 1 || is_defined(i) ||
         std::find(divided_.begin(), divided_.end(), i) != divided_.end();
}

bool Lines::is_defined(Index i) const {
  const StepNumbers& wholes = steps_.wholes();
  return std::find(wholes.begin(), wholes.end() - 1, i) != wholes.end() - 1;
}

std::vector<Lines::Index> Lines::needs(Index i) const {
  const FormulaStep& step = steps_.steps()[i];
  std::vector<Index> result;
  for (const StepPart& part : step.parts) result.push_back(part.step);
  for (std::size_t at = 0; at < definitions_.size(); ++at)
    if (step.kind == FormulaStep::Kind::symbol && step.node == definitions_[at].symbol.node)
      result.push_back(steps_.wholes()[at]);
  return result;
}

void Lines::collect(Index i) {
  if (std::find(lines_.begin(), lines_.end(), i) != lines_.end()) return;
  for (const Index each : needs(i)) collect(each);
  if (i != steps_.whole() && has_line(i)) lines_.push_back(i);
}

void Lines::give_names() {
  lines_.clear(), names_.clear();
  for (const Index each : steps_.wholes()) collect(each);
  put_in_order();
  std::vector<Index> nameless;
  for (std::size_t at = 0; at < definitions_.size(); ++at)
    names_[steps_.wholes()[at]] = base_name(all_.name(definitions_[at].symbol.node));
  for (const Index line : lines_)
    if (!names_.contains(line)) nameless.push_back(line);
  const std::vector<std::string> names = letters(all_, measures_, steps_, nameless);
  for (std::size_t i = 0; i < nameless.size(); ++i) names_[nameless[i]] = names[i];
}

/// Letters first, in the order in which they were given; the others as they were made, each behind
/// those that it needs.
void Lines::put_in_order() {
  const auto is_letter = [&](Index i) {
    return steps_.steps()[i].kind == FormulaStep::Kind::symbol;
  };
  const auto rest = std::stable_partition(lines_.begin(), lines_.end(), is_letter);
  std::sort(lines_.begin(), rest,
            [&](Index a, Index b) { return steps_.steps()[a].node < steps_.steps()[b].node; });
  std::set<Index> placed(lines_.begin(), rest), open(rest, lines_.end());
  for (auto next = rest; next != lines_.end(); ++next) {
    const auto is_ready = [&](Index line) { return needs_only(line, placed, open); };
    auto ready = std::find_if(open.begin(), open.end(), is_ready);
    if (next != rest) {
      const auto more = std::find_if(ready, open.end(), [&](Index line) {
        return is_of_series(*(next - 1), line) && is_ready(line);
      });
      if (more != open.end()) ready = more;
    }
    *next = *ready;
    placed.insert(*ready);
    open.erase(ready);
  }
}

/// Whether there are enough lines like these two for a series, which is printed as one.
bool Lines::is_of_series(Index a, Index b) const {
  const auto like = [&](Index line) { return is_like(a, line); };
  return like(b) && std::count_if(lines_.begin(), lines_.end(), like) >= shortest_series;
}

/// Whether they differ in names alone.
bool Lines::is_like(Index a, Index b) const {
  const FormulaStep &first = steps_.steps()[a], &second = steps_.steps()[b];
  return first.kind == second.kind && first.exponent == second.exponent &&
         std::equal(first.parts.begin(), first.parts.end(), second.parts.begin(),
                    second.parts.end(), [this](const StepPart& x, const StepPart& y) {
                      return x.sign == y.sign && has_line(x.step) == has_line(y.step) &&
                             (has_line(x.step) || is_like(x.step, y.step));
                    });
}

bool Lines::needs_only(Index step, const std::set<Index>& placed,
                       const std::set<Index>& open) const {
  const std::vector<Index> needed = needs(step);
  return std::all_of(needed.begin(), needed.end(), [&](const Index each) {
    if (placed.contains(each)) return true;
    return !open.contains(each) && needs_only(each, placed, open);
  });
}

bool Lines::divide_long_line() {
  std::vector<Index> all = lines_;
  all.push_back(steps_.whole());
  for (const Index line : all) {
    if (length(line) <= longest_line) continue;
    std::optional<Index> part = longest_part(line, longest_line);
    if (!part) part = longest_part(line, std::string::npos);
    const FormulaStep& step = steps_.steps()[line];
    if (!part && step.kind == FormulaStep::Kind::sum && step.parts.size() > 3)
      part = steps_.halve(line);
    if (!part) continue;
    divided_.push_back(*part);
    return true;
  }
  return false;
}

std::size_t Lines::length(Index step) const {
  return text_dialect().print({false, with_series(written(step))}).size();
}

/// A sum within the line.
std::optional<Lines::Index> Lines::longest_part(Index line, std::size_t most) const {
  std::size_t longest = least_part;
  std::optional<Index> result;
  std::vector<Index> open{line};
  while (!open.empty()) {
    const Index at = open.back();
    open.pop_back();
    for (const StepPart& part : steps_.steps()[at].parts) {
      if (names_.contains(part.step)) continue;
      open.push_back(part.step);
      if (steps_.steps()[part.step].kind != FormulaStep::Kind::sum) continue;
      const std::size_t size = length(part.step);
      if (size > longest && size <= most) longest = size, result = part.step;
    }
  }
  return result;
}

Form Lines::of(Index i) const {
  const auto name = names_.find(i);
  return name == names_.end() ? written(i) : name_form(own_name(name->second));
}

/// mu0 omega du_z, or without omega where that cancels or is a factor like others.
std::vector<const char*> Lines::leading_names(ExNode leading) const {
  if (omega_cancels_ || all_.operations(leading) < 2) return {"mu0", "du_z"};
  return {"mu0", "omega", "du_z"};
}

// What leads v* is several names, v* itself where both stiffnesses are equal and the drive is
// rigid.
Form Lines::symbol(ExNode node) const {
  if (all_.leads(node)) {
    std::vector<Form> factors;
    for (const char* name : leading_names(node)) factors.push_back(name_form(name));
    return {Form::Kind::product, "", std::move(factors), {}, {}, 1};
  }
  if (!all_.meaning(node).is_zero()) return meaning(node);
  const std::string& name = all_.name(node);
  const bool digits = name.find_first_not_of("0123456789/") == std::string::npos;
  return digits ? Form{Form::Kind::number, name, {}, {}, {}, 1} : name_form(name);
}

Form Lines::meaning(ExNode node) const {
  const Lines lines(all_, measures_, all_.meaning(node));
  return lines.written(lines.steps_.whole());
}

Form Lines::written(Index i) const {
  const FormulaStep& step = steps_.steps()[i];
  switch (step.kind) {
    case FormulaStep::Kind::symbol:
      return symbol(step.node);
    case FormulaStep::Kind::number:
      return digits_form(step.number);
    case FormulaStep::Kind::sum:
      return sum(step);
    case FormulaStep::Kind::product:
      return product(step);
    case FormulaStep::Kind::power:
      return {Form::Kind::power, "", {of(step.parts[0].step)}, {}, {}, step.exponent};
    case FormulaStep::Kind::root:
      return {Form::Kind::root, "", {of(step.parts[0].step)}, {}, {}, 1};
    case FormulaStep::Kind::magnitude:
      break;
  }
  return {Form::Kind::call, "abs", {}, {}, {{false, of(step.parts[0].step)}}, 1};
}

// A sum that has no line of its own, -(a - b), gives its terms.
Form Lines::sum(const FormulaStep& step) const {
  Form form{Form::Kind::sum, "", {}, {}, {}, 1};
  std::vector<PlacedTerm> terms;
  for (const StepPart& part : step.parts) {
    const bool minus = part.sign < 0, imaginary = parity_.is_square_of_odd(part.step);
    Form term = of(part.step);
    if (term.kind != Form::Kind::sum) term.terms = {{false, Form(term)}};
    for (Signed& each : term.terms)
      terms.push_back({imaginary, {each.minus != minus, std::move(each.form)}});
  }
  sort_stably(terms, before_in_sum);
  for (PlacedTerm& term : terms) form.terms.push_back(std::move(term.text));
  return form;
}

Form Lines::product(const FormulaStep& step) const {
  std::vector<Form> over, under;
  const auto put = [&](Form factor, bool below) {
    (below ? under : over).push_back(std::move(factor));
  };
  for (const StepPart& part : step.parts) {
    const FormulaStep& inner = steps_.steps()[part.step];
    if (inner.kind == FormulaStep::Kind::symbol && all_.leads(inner.node)) {
      for (const char* name : leading_names(inner.node)) put(name_form(name), part.sign < 0);
      continue;
    }
    Form factor = of(part.step);
    if (std::optional<Form> below = root_below(factor)) {
      put(std::move(*below), part.sign > 0);
      continue;
    }
    if (factor.kind != Form::Kind::product) {
      put(std::move(factor), part.sign < 0);
      continue;
    }
    for (Form& each : factor.over) put(std::move(each), part.sign < 0);
    for (Form& each : factor.under) put(std::move(each), part.sign > 0);
  }
  std::sort(over.begin(), over.end(), before);
  std::sort(under.begin(), under.end(), before);
  join_equal_names(over);
  join_equal_names(under);
  put_behind_mu0(over);
  if (over.empty() && under.size() == 1)
    if (std::optional<Form> turned = power_above(under[0])) return *std::move(turned);
  if (under.empty() && over.size() == 1) return over[0];
  return {Form::Kind::product, "", std::move(over), std::move(under), {}, 1};
}

}  // namespace vcrit::symbolic::shortest
