#include "shortest/shortest.hpp"

#include <fmt/core.h>

#include <memory>

#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "network/law.hpp"
#include "shortest/alphabet.hpp"
#include "shortest/critical.hpp"
#include "shortest/search.hpp"

namespace vcrit::symbolic {

namespace {

using namespace shortest;

// Elements that a formula on a page has, and operations: some forty-five lines.
constexpr std::size_t elements_on_page = 48;
constexpr int operations_on_page = 170;

/// Throws TooLarge.
FoundForm found_form(Alphabet& alphabet, const Thrift& thrift) {
  Expressions& all = alphabet.expressions();
  Presentations presentations = alphabet.presentations(thrift);
  all.allow(work_of_beginning);
  const std::vector<Ex> starts = critical_velocities(all, presentations, alphabet.parts());
  all.allow(2 * search_effort.work);
  const Ex best = shortest_of(all, starts, search_effort);
  const int length = operations(all, best);
  if (length > operations_on_page)
    return {{},
            fmt::format("the shortest real formula that was found has {} operations, more than the "
                        "{} that fit a page",
                        length, operations_on_page)};
  return {alphabet.written(best), ""};
}

std::size_t elements_of(const Problem& problem) {
  std::size_t elements = 0;
  for_each_element(problem, [&elements](const Element&) { ++elements; });
  return elements;
}

FoundForm shorter(FoundForm a, FoundForm b) {
  const bool second = b.form && (!a.form || b.form->operations < a.form->operations);
  return second ? std::move(b) : std::move(a);
}

FoundForm find_form(const Problem& problem, const DimensionlessGroups* groups) {
  const AlgebraLock lock;
  if (problem->receptance() != nullptr)
    return {{}, "a measured drive has a complex receptance, which no real formula holds"};
  if (const std::size_t elements = elements_of(problem); elements > elements_on_page)
    return {{},
            fmt::format("of {} elements, more than {}, no formula fits a page", elements,
                        elements_on_page)};
  const auto with = [&](OmegaPlace omega) {
    return first_that_fits([&](const Thrift& thrift) {
      Alphabet alphabet(problem, groups, omega);
      return found_form(alphabet, thrift);
    });
  };
  FoundForm usual = with(OmegaPlace::in_front);
  if (groups != nullptr) return usual;  // where omega is 1
  return shorter(std::move(usual), with(OmegaPlace::anywhere));
}

}  // namespace

// Documents of one problem in several forms all ask for it.
FoundForm find_shortest_form(const Problem& problem) {
  struct Found {
    Problem problem;
    FoundForm form;
  };
  static auto* const last = new std::unique_ptr<Found>;  // never ended: GiNaC may end before it
  const AlgebraLock lock;
  if (!*last || &*(*last)->problem != &*problem)
    *last = std::make_unique<Found>(Found{problem, find_form(problem, nullptr)});
  return (*last)->form;
}

FoundForm find_dimensionless_form(const Problem& problem, const DimensionlessGroups& groups) {
  return find_form(problem, &groups);
}

std::optional<ShortestForm> shortest_form(const Problem& problem) {
  return find_shortest_form(problem).form;
}

}  // namespace vcrit::symbolic
