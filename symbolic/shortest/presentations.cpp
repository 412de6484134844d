#include "shortest/presentations.hpp"

#include <algorithm>
#include <string>

#include "base/interruption.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "shortest/graphs.hpp"
#include "shortest/search.hpp"
#include "shortest/trees.hpp"

namespace vcrit::symbolic::shortest {

namespace {

/// Its kinds of elements and how they are connected, without names.
std::string shape(const Network& network) {
  const auto of_parts = [](const char* sign, const std::vector<Network>& parts) {
    std::string text = "(";
    for (const Network& part : parts) text += shape(part) + sign;
    return text + ")";
  };
  if (const auto* e = std::get_if<Element>(&network.form))
    return std::to_string(static_cast<int>(e->kind));
  if (const auto* s = std::get_if<Series>(&network.form)) return of_parts("-", s->parts);
  if (const auto* p = std::get_if<Parallel>(&network.form)) return of_parts("|", p->parts);
  return of_parts("*", std::get<Graph>(network.form).parts);
}

std::vector<ComplexQuotient> inverses(const std::vector<ComplexQuotient>& all) {
  std::vector<ComplexQuotient> result;
  for (const ComplexQuotient& each : all) result.push_back(reciprocal(each));
  return result;
}

/// Amounts as expressions, in the algebra of law(). Throws TooLarge for a number of many digits.
struct Numbers {
  using Value = Ex;
  Expressions& all;
  const std::function<Ex(const Symbol&)>& symbol;

  Ex of(const Symbol& name) const { return symbol(name); }
  static Ex constant(const TypedNumber& number) {
    const GiNaC::numeric exact = exact_decimal(number.decimal);
    constexpr long most = 1'000'000'000;
    if (exact.numer() > most || exact.denom() > most) throw TooLarge{};
    return Expressions::number(exact.numer().to_long(), exact.denom().to_long());
  }
  Ex plus(const Ex& a, const Ex& b) const { return all.add(a, b); }
  Ex times(const Ex& a, const Ex& b) const { return all.multiply(a, b); }
  Ex over(const Ex& a, const Ex& b) const { return all.divide(a, b); }
};

Network joined_network(const Network& network) {
  const auto* graph = std::get_if<Graph>(&network.form);
  return graph == nullptr ? network : series_parallel(*graph);
}

/// 0: nothing below the bar; 1: nothing above it; 2: something on both sides.
int sort_of(const ComplexQuotient& q) {
  if (q.under.is_real()) return 0;
  return q.over.is_real() ? 1 : 2;
}

}  // namespace

std::vector<int> alike(const std::vector<Network>& parts) {
  std::vector<std::string> shapes;
  std::vector<int> numbers;
  for (const Network& part : parts) {
    const auto found = std::find(shapes.begin(), shapes.end(), shape(part));
    numbers.push_back(static_cast<int>(found - shapes.begin()));
    if (found == shapes.end()) shapes.push_back(shape(part));
  }
  return numbers;
}

std::vector<ComplexQuotient> Presentations::of(const Network& network) {
  const Network joined = joined_network(network);
  return std::visit([this](const auto& form) { return of(form); }, joined.form);
}

Ex Presentations::named(const char* letter, const Ex& meaning) {
  return all_.named(letter, meaning, operations(all_, meaning), all_.is_positive(meaning));
}

Ex Presentations::inertia(const Ex& mass) {
  return named("M", all_.multiply(mass, all_.power(omega_, 2)));
}

Ex Presentations::number(const Amount& amount) {
  Numbers numbers{all_, symbol_};
  return in_algebra(amount, numbers);
}

ComplexQuotient Presentations::damper(const Ex& c, const char* letter) {
  const Ex loss = all_.multiply(omega_, c);
  return {from_imaginary(dampers_named_ ? named(letter, loss) : loss)};
}

std::vector<ComplexQuotient> Presentations::of(const Element& e) {
  const Ex k = number(e.coefficient);
  switch (e.kind) {
    case ElementKind::spring:
      return {{from_real(k)}};
    case ElementKind::damper:
      return {damper(k, "W")};
    case ElementKind::mass:
      return {{from_real(Expressions::negative(inertia(k)))}};
    case ElementKind::lossy:
    case ElementKind::measured:
      return {{{k, all_.multiply(k, number(e.second))}}};
    case ElementKind::maxwell:
      break;
  }
  return maxwell(k, named("T", all_.multiply(omega_, number(e.second))));
}

/// k i T/(1 + i T): K'' = A = k/(T + 1/T), K' = A T.
std::vector<ComplexQuotient> Presentations::maxwell(const Ex& k, const Ex& turn) {
  const Ex one = Expressions::number(1);
  const Ex loss = all_.divide(k, all_.add(turn, all_.divide(one, turn)));
  return {{{all_.multiply(loss, turn), loss}},
          {from_imaginary(all_.multiply(k, turn)), {one, turn}}};
}

Gathered Presentations::gathered(const std::vector<Network>& parts, bool inverse) {
  Gathered result;
  std::vector<Ex> springs, dampers, masses;
  for (const Network& part : parts) {
    const auto* e = std::get_if<Element>(&part.form);
    if (e != nullptr && e->kind == ElementKind::spring)
      springs.push_back(number(e->coefficient));
    else if (e != nullptr && e->kind == ElementKind::damper)
      dampers.push_back(number(e->coefficient));
    else if (e != nullptr && e->kind == ElementKind::mass && !inverse)
      masses.push_back(number(e->coefficient));
    else
      result.others.push_back(part);
  }
  result.spring = joined(springs, inverse);
  result.damper = joined(dampers, inverse);
  result.mass = joined(masses, inverse);
  return result;
}

/// a + b + c or, one behind the other, a b/(a + b), 1/(1/a + 1/b + 1/c).
std::optional<Ex> Presentations::joined(const std::vector<Ex>& values, bool inverse) {
  if (values.empty()) return std::nullopt;
  if (!inverse || values.size() == 1) return all_.sum(values);
  if (values.size() == 2)
    return all_.divide(all_.multiply(values[0], values[1]), all_.add(values[0], values[1]));
  std::vector<Ex> compliances;
  for (const Ex& value : values) compliances.push_back(all_.power(value, -1));
  return all_.power(all_.sum(compliances), -1);
}

Presentations::Terms Presentations::side_by_side(const std::vector<Network>& parts) {
  const Gathered all = gathered(parts, false);
  Terms terms{{}, alike(all.others)};
  for (const Network& part : all.others) terms.choices.push_back(of(part));
  ComplexEx rest;
  if (all.spring) rest.re = *all.spring;
  if (all.mass) rest.re = all_.subtract(rest.re, inertia(*all.mass));
  if (all.damper) rest.im = damper(*all.damper, "W").over.im;
  if (!rest.is_zero()) terms.choices.push_back({{rest}}), terms.groups.push_back(-1);
  return terms;
}

Presentations::Terms Presentations::one_behind_another(const std::vector<Network>& parts) {
  const Gathered all = gathered(parts, true);
  if (all.others.empty() && all.spring && all.damper) {
    Ex time = all_.product({{omega_, 1}, {*all.damper, 1}, {*all.spring, -1}});
    // In groups several dampers are theta_1 theta_2/(theta_1 + theta_2) times the same stiffness.
    if (omega_.is_number()) time = shortest_of(all_, std::vector{time}, {20, 100'000});
    const Ex turn = named("T", time);
    const ComplexQuotient compliance = reciprocal(ComplexQuotient{{*all.spring}});
    const ComplexQuotient simple = sum({compliance, reciprocal(damper(*all.damper, "W"))}, false);
    std::vector<ComplexQuotient> choices = inverses(maxwell(*all.spring, turn));
    choices.push_back(simple);
    return {{choices}, {0}};
  }
  Terms terms{{}, alike(all.others)};
  for (const Network& part : all.others) terms.choices.push_back(inverses(of(part)));
  for (const auto& each :
       {all.spring ? std::optional(ComplexQuotient{{*all.spring}}) : std::nullopt,
        all.damper ? std::optional(damper(*all.damper, "W")) : std::nullopt})
    if (each) terms.choices.push_back({reciprocal(*each)}), terms.groups.push_back(-1);
  return terms;
}

std::vector<ComplexQuotient> Presentations::of(const Parallel& parallel) {
  const Terms terms = side_by_side(parallel.parts);
  return sums(terms.choices, terms.groups);
}

std::vector<ComplexQuotient> Presentations::of(const Series& series) {
  const Terms terms = one_behind_another(series.parts);
  if (terms.choices.size() == 1) return inverses(terms.choices[0]);
  return inverses(sums(terms.choices, terms.groups));
}

std::vector<ComplexQuotient> Presentations::swinging(const Network& drive,
                                                     const std::optional<Ex>& mass) {
  const auto* parallel = std::get_if<Parallel>(&drive.form);
  Gathered parts = gathered(parallel != nullptr ? parallel->parts : std::vector{drive}, false);
  if (!parts.others.empty()) {
    if (!mass) return of(drive);
    return beside(drive, {from_real(Expressions::negative(inertia(*mass)))});
  }
  Ex z = parts.spring.value_or(Expressions::number(0));
  if (mass) parts.mass = parts.mass ? all_.add(*parts.mass, *mass) : *mass;
  if (parts.mass && parts.spring && omega_.is_number())
    // kappa_d (1 - beta)
    z = all_.multiply(z, all_.subtract(Expressions::number(1), all_.divide(*parts.mass, z)));
  else if (parts.mass)
    z = all_.subtract(z, all_.multiply(*parts.mass, all_.power(omega_, 2)));
  if (parts.spring)
    z = named("Z", z);
  else if (parts.mass)
    z = Expressions::negative(inertia(*parts.mass));
  if (!parts.damper) return {{from_real(z)}};
  return {{{z, damper(*parts.damper, "V").over.im}}};
}

std::vector<ComplexQuotient> Presentations::of(const Graph& graph) {
  std::vector<ComplexEx> edges;
  for (const Network& part : graph.parts) edges.push_back(complex_.cartesian(of(part)[0]).over);
  std::vector<ComplexQuotient> all;
  for (const Trees::Order order :
       {Trees::Order::inner_first, Trees::Order::as_written, Trees::Order::backwards})
    offer(all, Trees(complex_, graph, edges, order).stiffness());
  return best(std::move(all));
}

std::vector<ComplexQuotient> Presentations::beside(const Network& network,
                                                   const ComplexQuotient& other) {
  const Network joined = joined_network(network);
  const auto* parallel = std::get_if<Parallel>(&joined.form);
  Terms terms = parallel != nullptr ? side_by_side(parallel->parts) : Terms{{of(joined)}, {0}};
  terms.choices.push_back({other});
  terms.groups.push_back(-1);
  return sums(terms.choices, terms.groups);
}

std::vector<ComplexQuotient> Presentations::behind(const Network& network,
                                                   const ComplexQuotient& other) {
  const Network joined = joined_network(network);
  const auto* series = std::get_if<Series>(&joined.form);
  Terms terms =
      series != nullptr ? one_behind_another(series->parts) : Terms{{inverses(of(joined))}, {0}};
  terms.choices.push_back({other});
  terms.groups.push_back(-1);
  return sums(terms.choices, terms.groups);
}

ComplexQuotient Presentations::sum(const std::vector<ComplexQuotient>& parts,
                                   bool one_denominator) {
  ComplexEx whole;
  std::vector<ComplexQuotient> left;
  for (const ComplexQuotient& part : parts) {
    if (part.under.is_one() || (part.under.is_real() && !one_denominator)) {
      whole = complex_.add(whole, complex_.cartesian(part).over);
      continue;
    }
    const auto same = std::find_if(left.begin(), left.end(), [&](const ComplexQuotient& each) {
      return each.under == part.under;
    });
    if (same == left.end())
      left.push_back(part);
    else
      same->over = complex_.add(same->over, part.over);
  }
  ComplexQuotient result{whole};
  for (const ComplexQuotient& part : left)
    result = {complex_.add(complex_.multiply(result.over, part.under),
                           complex_.multiply(part.over, result.under)),
              complex_.multiply(result.under, part.under)};
  return result;
}

std::vector<ComplexQuotient> Presentations::sums(const Choices& parts,
                                                 const std::vector<int>& groups) {
  for (const Summed& known : summed_)
    if (known.groups == groups && known.parts == parts) {
      all_.spend(known.work);
      return known.found;
    }
  const std::size_t before = all_.work();
  std::vector<ComplexQuotient> found = found_sums(parts, groups);
  summed_.push_back({parts, groups, found, all_.work() - before});
  return found;
}

std::vector<ComplexQuotient> Presentations::found_sums(const Choices& parts,
                                                       const std::vector<int>& groups) {
  std::vector<ComplexQuotient> all;
  // The choice of each group, as digits of a number.
  int most = 0;
  for (const int group : groups) most = std::max(most, group);
  std::vector<std::size_t> choice(static_cast<std::size_t>(most) + 1, 0);
  for (std::size_t combination = 0; combination < thrift_.combinations; ++combination) {
    hear_interruption();
    std::vector<ComplexQuotient> chosen;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::size_t at = groups[i] < 0 ? 0 : choice[static_cast<std::size_t>(groups[i])];
      chosen.push_back(parts[i][std::min(at, parts[i].size() - 1)]);
    }
    for (const bool one_denominator : {false, true}) offer(all, sum(chosen, one_denominator));
    std::size_t digit = 0;
    for (; digit < choice.size(); ++digit) {
      std::size_t options = 0;
      for (std::size_t i = 0; i < parts.size(); ++i)
        if (groups[i] == static_cast<int>(digit)) options = std::max(options, parts[i].size());
      if (++choice[digit] < options) break;
      choice[digit] = 0;
    }
    if (digit == choice.size()) break;
  }
  for (const ComplexQuotient& each : std::vector<ComplexQuotient>(all)) {
    for (const ComplexQuotient& other : complex_.cartesians(each)) offer(all, other);
    for (const ComplexQuotient& other : complex_.cartesians(reciprocal(each)))
      offer(all, reciprocal(other));
  }
  return best(std::move(all));
}

void Presentations::offer(std::vector<ComplexQuotient>& all, const ComplexQuotient& quotient) {
  if (std::find(all.begin(), all.end(), quotient) == all.end()) all.push_back(quotient);
}

std::vector<ComplexQuotient> Presentations::best(std::vector<ComplexQuotient> all) {
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t i = 0; i < all.size(); ++i)
    order.emplace_back(operations(all_, complex_.modulus(all[i])), i);
  std::sort(order.begin(), order.end());
  std::vector<ComplexQuotient> result;
  std::vector<std::size_t> of_sort(3);
  for (const auto& [cost, i] : order)
    if (of_sort[static_cast<std::size_t>(sort_of(all[i]))]++ < thrift_.kept)
      result.push_back(all[i]);
  return result;
}

}  // namespace vcrit::symbolic::shortest
