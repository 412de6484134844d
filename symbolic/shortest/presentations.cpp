#include "shortest/presentations.hpp"

#include <algorithm>
#include <string>

#include "shortest/search.hpp"
#include "shortest/trees.hpp"

namespace vcrit::symbolic::shortest {

namespace {

constexpr std::size_t most_combinations = 48;
constexpr std::size_t kept = 3;  ///< presentations of each sort

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

std::vector<Quotient> inverses(const std::vector<Quotient>& all) {
  std::vector<Quotient> result;
  for (const Quotient& each : all) result.push_back(inverse(each));
  return result;
}

/// 0: nothing below the bar; 1: nothing above it; 2: something on both sides.
int sort_of(const Quotient& q) {
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

std::vector<Quotient> Presentations::of(const Network& network) {
  return std::visit([this](const auto& form) { return of(form); }, network.form);
}

std::vector<Quotient> Presentations::of(const Element& e) {
  const Ex k = symbol_(e.coefficient);
  switch (e.kind) {
    case ElementKind::spring:
      return {{real(k)}};
    case ElementKind::damper:
      return {{imaginary(all_.multiply(omega_, k))}};
    case ElementKind::mass:
      return {{real(Expressions::negative(all_.multiply(k, all_.power(omega_, 2))))}};
    case ElementKind::lossy:
      return {{{k, all_.multiply(k, symbol_(e.second))}}};
    case ElementKind::maxwell:
      break;
  }
  const Ex turn = all_.multiply(omega_, symbol_(e.second));
  const Quotient quotient{imaginary(all_.multiply(k, turn)), {Expressions::number(1), turn}};
  return {complex_.cartesian(quotient), quotient};
}

std::vector<Quotient> Presentations::of(const Parallel& parallel) {
  Choices parts;
  for (const Network& part : parallel.parts) parts.push_back(of(part));
  return sums(parts, alike(parallel.parts));
}

std::vector<Quotient> Presentations::of(const Series& series) {
  Choices parts;
  for (const Network& part : series.parts) parts.push_back(inverses(of(part)));
  return inverses(sums(parts, alike(series.parts)));
}

std::vector<Quotient> Presentations::of(const Graph& graph) {
  std::vector<Complex> edges;
  for (const Network& part : graph.parts) edges.push_back(complex_.cartesian(of(part)[0]).over);
  std::vector<Quotient> all;
  for (const Trees::Order order : {Trees::Order::inner_first, Trees::Order::as_written,
                                   Trees::Order::backwards})
    offer(all, Trees(complex_, graph, edges, order).stiffness());
  return best(std::move(all));
}

std::vector<Quotient> Presentations::beside(const Network& network, const Quotient& other) {
  Choices parts;
  std::vector<int> groups;
  if (const auto* parallel = std::get_if<Parallel>(&network.form)) {
    for (const Network& part : parallel->parts) parts.push_back(of(part));
    groups = alike(parallel->parts);
  } else {
    parts.push_back(of(network));
    groups = {0};
  }
  parts.push_back({other});
  groups.push_back(-1);
  return sums(parts, groups);
}

std::vector<Quotient> Presentations::behind(const Network& network, const Quotient& other) {
  Choices parts;
  std::vector<int> groups;
  if (const auto* series = std::get_if<Series>(&network.form)) {
    for (const Network& part : series->parts) parts.push_back(inverses(of(part)));
    groups = alike(series->parts);
  } else {
    parts.push_back(inverses(of(network)));
    groups = {0};
  }
  parts.push_back({other});
  groups.push_back(-1);
  return sums(parts, groups);
}

Quotient Presentations::sum(const std::vector<Quotient>& parts, bool one_denominator) {
  Complex whole;
  std::vector<Quotient> left;
  for (const Quotient& part : parts) {
    if (part.under.is_one() || (part.under.is_real() && !one_denominator)) {
      whole = complex_.add(whole, complex_.cartesian(part).over);
      continue;
    }
    const auto same = std::find_if(left.begin(), left.end(), [&](const Quotient& each) {
      return each.under == part.under;
    });
    if (same == left.end()) left.push_back(part);
    else same->over = complex_.add(same->over, part.over);
  }
  Quotient result{whole};
  for (const Quotient& part : left)
    result = {complex_.add(complex_.multiply(result.over, part.under),
                           complex_.multiply(part.over, result.under)),
              complex_.multiply(result.under, part.under)};
  return result;
}

std::vector<Quotient> Presentations::sums(const Choices& parts, const std::vector<int>& groups) {
  std::vector<Quotient> all;
  // The choice of each group, as digits of a number.
  int most = 0;
  for (const int group : groups) most = std::max(most, group);
  std::vector<std::size_t> choice(static_cast<std::size_t>(most) + 1, 0);
  for (std::size_t combination = 0; combination < most_combinations; ++combination) {
    std::vector<Quotient> chosen;
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
  for (const Quotient& each : std::vector<Quotient>(all)) {
    offer(all, complex_.cartesian(each));
    offer(all, inverse(complex_.cartesian(inverse(each))));
  }
  return best(std::move(all));
}

void Presentations::offer(std::vector<Quotient>& all, const Quotient& quotient) {
  if (std::find(all.begin(), all.end(), quotient) == all.end()) all.push_back(quotient);
}

std::vector<Quotient> Presentations::best(std::vector<Quotient> all) {
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t i = 0; i < all.size(); ++i)
    order.emplace_back(operations(all_, complex_.modulus(all[i])), i);
  std::sort(order.begin(), order.end());
  std::vector<Quotient> result;
  std::vector<std::size_t> of_sort(3);
  for (const auto& [cost, i] : order)
    if (of_sort[static_cast<std::size_t>(sort_of(all[i]))]++ < kept) result.push_back(all[i]);
  return result;
}

}  // namespace vcrit::symbolic::shortest
