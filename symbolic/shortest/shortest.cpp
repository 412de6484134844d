#include "shortest/shortest.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "shortest/critical.hpp"
#include "shortest/lines.hpp"
#include "shortest/search.hpp"

namespace vcrit::symbolic {

namespace {

using namespace shortest;

// Elements that a formula on a page has, and operations: some forty-five lines.
constexpr std::size_t elements_on_page = 48;
constexpr int operations_on_page = 170;

// Some 0.1 s each.
constexpr std::size_t work_of_beginning = 5'000'000;
constexpr SearchEffort effort{60, 5'000'000};

/// What is tried one after the other until the beginning takes no more work than that.
constexpr std::array<Thrift, 3> thrifts{{{48, 3}, {6, 1}, {1, 1}}};

/// The symbols of a problem as expressions, with what each measures.
class Alphabet {
 public:
  explicit Alphabet(Problem problem) : problem_(std::move(problem)) {
    parts_.prefactor = all_.symbol("", 2, true);
    parts_.omega = symbol({"omega"}, {0, -1});
    parts_.normal = &problem_->normal.network();
    if (const auto* own = std::get_if<ReducedNetwork>(&problem_->tangential))
      parts_.tangential = &own->network();
    if (const auto* drive = problem_->drive_network()) parts_.drive = &drive->network();
    for (const Network* network : {parts_.normal, parts_.tangential, parts_.drive})
      if (network != nullptr) add(*network);
    if (problem_->mass) parts_.mass = symbol(problem_->mass->symbol, {1, 2});
    if (isotropic() != nullptr) parts_.ratio = ratio(*isotropic());
  }

  /// Throws TooLarge.
  std::optional<ShortestForm> shortest(const Thrift& thrift) {
    Presentations presentations(
        all_, parts_.omega, [this](const Symbol& symbol) { return symbols_.at(symbol); }, thrift);
    all_.allow(work_of_beginning);
    const std::vector<Ex> starts = critical_velocities(all_, presentations, parts_);
    all_.allow(2 * effort.work);
    const Ex best = shortest_of(all_, starts, effort);
    if (operations(all_, best) > operations_on_page) return std::nullopt;
    ShortestForm form = Lines(all_, measures_, best).form();
    if (isotropic() != nullptr) form.ratio = ratio_words(form);
    return form;
  }

 private:
  const Isotropic* isotropic() const { return std::get_if<Isotropic>(&problem_->tangential); }

  Ex symbol(const Symbol& symbol, const Measure& measure) {
    const auto [known, is_new] = symbols_.try_emplace(symbol);
    if (is_new) {
      known->second = all_.symbol(to_text(symbol));
      measures_[known->second.node] = measure;
    }
    return known->second;
  }

  void add(const Network& network) {
    static const std::map<NumberRole, Measure> measures{{NumberRole::stiffness, {1, 0}},
                                                        {NumberRole::damping, {1, 1}},
                                                        {NumberRole::time, {0, 1}},
                                                        {NumberRole::mass, {1, 2}},
                                                        {NumberRole::loss_factor, {0, 0}},
                                                        {NumberRole::factor, {0, 0}}};
    for_each_element(network, [&](const Element& element) {
      for_each_number(
          element, [&](const Symbol& each, NumberRole role) { symbol(each, measures.at(role)); });
    });
  }

  /// g = K_n/K_t: Mindlin's (2 - nu)/(2 (1 - nu)), or a number.
  Ex ratio(const Isotropic& isotropic) {
    const bool poisson = isotropic.by == Isotropic::By::poisson;
    if (isotropic.quantity.value) return number_ratio(isotropic);
    const Ex given = symbol(isotropic.quantity.symbol, {});
    if (!poisson) return all_.power(given, -1);
    const Ex two = Expressions::number(2), one = Expressions::number(1);
    const Ex meaning =
        all_.product({{all_.subtract(two, given), 1}, {two, -1}, {all_.subtract(one, given), -1}});
    return all_.named("g", meaning, operations(all_, meaning), true);
  }

  Ex number_ratio(const Isotropic& isotropic) {
    const GiNaC::ex inverse = 1 / isotropic_ratio(isotropic);
    if (inverse.is_equal(1)) return Expressions::number(1);
    std::ostringstream digits;
    digits << inverse;
    ratio_ = digits.str();
    const bool whole = inverse.info(GiNaC::info_flags::integer);
    const Ex number = all_.symbol(digits.str(), whole ? 0 : 1);
    measures_[number.node] = {};
    return all_.named("g", number, 1, true);
  }

  /// "g = K_n/K_t (Mindlin) for nu = 0.3", or by its number where that has no line.
  Prose ratio_words(const ShortestForm& form) const {
    const Quantity& given_ratio = isotropic()->quantity;
    const bool poisson = isotropic()->by == Isotropic::By::poisson;
    std::optional<Form> name;
    if (given_ratio.value && !ratio_.empty())
      name = Form{Form::Kind::number, ratio_, {}, {}, {}, 1};
    for (const ShortestForm::Definition& definition : form.definitions)
      if (all_.name(parts_.ratio.node) == "g" && definition.name.text.starts_with("g"))
        name = definition.name;
    if (!name) return {};
    const GiNaC::ex normal = quantity("K_n"), other = quantity("K_t");
    Prose words{Statement{{false, *name}, Statement::Relation::equal, form_of(normal / other)},
                poisson ? " (Mindlin)" : ""};
    if (given_ratio.value)
      words += {" for ", stated_number(poisson ? quantity("nu") : other / normal, *given_ratio.value)};
    return words;
  }

  Problem problem_;
  Expressions all_;
  Parts parts_;
  std::map<Symbol, Ex> symbols_;
  Measures measures_;
  std::string ratio_;  ///< K_n/K_t where it is a number other than 1
};

int operations_in_all(const std::vector<Form>& forms) {
  int sum = 0;
  for (const Form& form : forms) sum += operations_in(form);
  return sum;
}

/// Of a product of them.
int multiplications(const std::vector<Form>& forms) {
  return std::max(static_cast<int>(forms.size()) - 1, 0);
}

bool too_many_elements(const Problem& problem) {
  std::size_t elements = 0;
  for_each_element(problem, [&elements](const Element&) { ++elements; });
  return elements > elements_on_page;
}

}  // namespace

std::optional<ShortestForm> shortest_form(const Problem& problem) {
  const AlgebraLock lock;
  if (too_many_elements(problem) || problem->receptance() != nullptr) return std::nullopt;
  for (const Thrift& thrift : thrifts) {
    try {
      return Alphabet(problem).shortest(thrift);
    } catch (const TooLarge&) {
      continue;
    }
  }
  return std::nullopt;
}

int operations_in(const Form& form) {
  switch (form.kind) {
    case Form::Kind::number:
      return form.text.find('/') == std::string::npos ? 0 : 1;
    case Form::Kind::name:
      return 0;
    case Form::Kind::sum: {
      int sum = static_cast<int>(form.terms.size()) - (form.terms.front().minus ? 0 : 1);
      for (const Signed& term : form.terms) sum += operations_in(term.form);
      return sum;
    }
    case Form::Kind::product: {
      const int bar = form.under.empty() ? 0 : 1;
      return operations_in_all(form.over) + operations_in_all(form.under) +
             multiplications(form.over) + multiplications(form.under) + bar;
    }
    case Form::Kind::power:
    case Form::Kind::root:
      return 1 + operations_in_all(form.over);
    case Form::Kind::call:
    case Form::Kind::series:
      break;
  }
  return 1 + operations_in(form.terms.front().form);
}

}  // namespace vcrit::symbolic
