#include "formula/form.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <tuple>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "base/sort_stably.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

namespace {

Form number_form(const GiNaC::numeric& value) {
  std::ostringstream digits;
  digits << value;
  return {Form::Kind::number, digits.str(), {}, {}, {}, 1};
}

Form named(const std::string& name) { return {Form::Kind::name, name, {}, {}, {}, 1}; }

/// The power of omega (or s) in a term, by which sums are ordered first.
int frequency_degree(const Form& form) {
  const auto total = [](const std::vector<Form>& factors) {
    int sum = 0;
    for (const Form& factor : factors) sum += frequency_degree(factor);
    return sum;
  };
  switch (form.kind) {
    case Form::Kind::name:
      return form.text == "omega" || form.text == own_name("s") ? 1 : 0;
    case Form::Kind::power:
      return form.exponent * frequency_degree(form.over[0]);
    case Form::Kind::product:
      return total(form.over) - total(form.under);
    default:
      return 0;
  }
}

std::string key(const Form& form) { return text_dialect().print({false, form}); }

/// g = K_n/K_t and Z = k_d - m omega^2 are the drive's share: behind the contact, k_0 + g Z.
bool is_of_drive(const Form& form) {
  switch (form.kind) {
    case Form::Kind::name:
      return form.text == own_name("g") || form.text == own_name("Z");
    case Form::Kind::power:
      return is_of_drive(form.over[0]);
    case Form::Kind::product:
      return std::any_of(form.over.begin(), form.over.end(), is_of_drive);
    default:
      return false;
  }
}

/// By rank, those of one rank by the text of the key, which only these need.
template <class T, class RankOf, class TextOf>
void sort_by_rank(std::vector<T>& all, const RankOf& rank_of, const TextOf& text_of) {
  struct Ranked {
    decltype(rank_of(all.front())) rank;
    std::string text;
    T value;
  };
  std::map<decltype(rank_of(all.front())), int> sharing;
  std::vector<Ranked> ranked;
  for (T& each : all) {
    ranked.push_back({rank_of(each), "", std::move(each)});
    ++sharing[ranked.back().rank];
  }
  for (Ranked& each : ranked)
    if (sharing.at(each.rank) > 1) each.text = text_of(each.value);
  sort_stably(ranked, [](const Ranked& a, const Ranked& b) {
    return a.rank != b.rank ? a.rank < b.rank : natural_less(a.text, b.text);
  });
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::move(ranked[i].value);
}

void sort_terms(std::vector<Signed>& terms) {
  if (terms.size() < 2) return;
  const auto rank_of = [](const Signed& term) {
    return std::tuple(frequency_degree(term.form), holds_sum(term.form), is_of_drive(term.form));
  };
  sort_by_rank(terms, rank_of, [](const Signed& term) { return key(term.form); });
}

bool has_base(const Form& factor, const char* name) {
  const Form& base = factor.kind == Form::Kind::power ? factor.over[0] : factor;
  return base.kind == Form::Kind::name && base.text == name;
}

/// Where a factor stands in its product: numbers, i, then what a reader expects first: omega c, but
/// m omega^2. The physical prefactor mu0 omega du_z keeps its order, in v*^2 as well.
int rank(const Form& form, bool prefactor) {
  static const std::map<std::string, int> names{
      {own_name("i"), -9},  {"mu0", -3},         {"du_z", -1},       {own_name("x"), 2},
      {own_name("y"), 2},   {own_name("A"), 2},  {own_name("B"), 2}, {"omega", -2},
      {own_name("g"), -1},  {own_name("Z"), 1},  {own_name("s"), 4}, {own_name("t"), 5},
      {own_name("pi"), -4}, {own_name("R_d"), 0}};
  switch (form.kind) {
    case Form::Kind::number:
      return -10;
    case Form::Kind::power:
      return !prefactor && has_base(form, "omega") ? 3 : rank(form.over[0], prefactor);
    case Form::Kind::sum:
    case Form::Kind::product:
    case Form::Kind::series:
      return 6;
    case Form::Kind::call: {
      const bool of_name = form.terms[0].form.kind == Form::Kind::name;
      return form.text != "abs" ? 9 : of_name ? 7 : 8;
    }
    case Form::Kind::root:
      return 10;
    case Form::Kind::name:
      break;
  }
  if (form.text.starts_with("K_") || form.text.starts_with("L_")) return 1;
  if (form.text.starts_with("dK_")) return 2;
  if (const auto found = names.find(form.text); found != names.end()) return found->second;
  // Names of steps stand behind elements: k_0 P_3.
  return is_own(form.text) ? 1 : 0;
}

void sort_factors(std::vector<Form>& factors) {
  if (factors.size() < 2) return;
  const bool prefactor =
      std::any_of(factors.begin(), factors.end(), [](const Form& f) { return has_base(f, "mu0"); });
  sort_by_rank(
      factors, [&](const Form& factor) { return rank(factor, prefactor); }, key);
}

/// A sum whose first term is negative, turned round.
Signed lead_positive(Signed expression) {
  if (expression.form.kind != Form::Kind::sum || !expression.form.terms.front().minus)
    return expression;
  for (Signed& term : expression.form.terms) term.minus = !term.minus;
  return {!expression.minus, std::move(expression.form)};
}

Signed sum_form(const GiNaC::ex& sum) {
  Form form{Form::Kind::sum, "", {}, {}, {}, 1};
  for (const GiNaC::ex& term : sum) form.terms.push_back(form_of(term));
  sort_terms(form.terms);
  return {false, std::move(form)};
}

/// The expression with its sign inside.
Form with_sign(Signed expression) {
  if (!expression.minus) return std::move(expression.form);
  Form sum{Form::Kind::sum, "", {}, {}, {}, 1};
  sum.terms.push_back(std::move(expression));
  return sum;
}

/// Collects the factors of a product above and below the bar.
class ProductForm {
 public:
  void multiply(const GiNaC::ex& factor) {
    if (GiNaC::is_a<GiNaC::numeric>(factor))
      coefficient_ *= GiNaC::ex_to<GiNaC::numeric>(factor);
    else if (GiNaC::is_a<GiNaC::power>(factor))
      power(factor.op(0), GiNaC::ex_to<GiNaC::numeric>(factor.op(1)));
    else
      put(lead_positive(form_of(factor)), 1);
  }

  Signed result() {
    take_coefficient();
    sort_factors(over_);
    sort_factors(under_);
    if (under_.empty() && over_.empty()) return {minus_, number_form(1)};
    if (under_.empty() && over_.size() == 1) return {minus_, std::move(over_.front())};
    return {minus_, {Form::Kind::product, "", std::move(over_), std::move(under_), {}, 1}};
  }

 private:
  void power(const GiNaC::ex& base, const GiNaC::numeric& exponent) {
    if (exponent.is_integer()) return put(lead_positive(form_of(base)), exponent.to_int());
    const GiNaC::numeric twice = exponent * 2;
    ensure(twice.is_integer(), "only square roots occur");
    const Form root{Form::Kind::root, "", {with_sign(form_of(base))}, {}, {}, 1};
    put({false, root}, twice.to_int());
  }

  void put(Signed factor, int exponent) {
    if (exponent % 2 != 0 && factor.minus) minus_ = !minus_;
    std::vector<Form>& place = exponent > 0 ? over_ : under_;
    const int size = std::abs(exponent);
    if (size == 1)
      place.push_back(std::move(factor.form));
    else
      place.push_back({Form::Kind::power, "", {std::move(factor.form)}, {}, {}, size});
  }

  void take_coefficient() {
    GiNaC::numeric size = coefficient_;
    if (!size.is_real()) {
      ensure(size.real().is_zero(), "coefficients are real or imaginary");
      size = size.imag();
      over_.push_back(named(own_name("i")));
    }
    if (size.is_negative()) minus_ = !minus_;
    size = GiNaC::abs(size);
    // A fraction stands in front, unless there is something else below the bar anyway.
    if (under_.empty() && !size.is_integer()) return over_.push_back(number_form(size));
    if (!size.numer().is_equal(1)) over_.push_back(number_form(size.numer()));
    if (!size.denom().is_equal(1)) under_.push_back(number_form(size.denom()));
  }

  GiNaC::numeric coefficient_ = 1;
  std::vector<Form> over_, under_;
  bool minus_ = false;
};

Signed call_form(const GiNaC::ex& call) {
  const std::string name = GiNaC::ex_to<GiNaC::function>(call).get_name();
  Signed argument = form_of(call.op(0));
  if (name == "abs") argument = {false, lead_positive(std::move(argument)).form};
  return {false, {Form::Kind::call, name, {}, {}, {std::move(argument)}, 1}};
}

/// The sign of a number, symbol or power of one, or of a product of such.
std::optional<bool> plain_minus(const GiNaC::ex& term) {
  if (GiNaC::is_a<GiNaC::numeric>(term)) {
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(term);
    return number.is_real() ? std::optional(number.is_negative()) : std::nullopt;
  }
  if (GiNaC::is_a<GiNaC::symbol>(term)) return false;
  if (GiNaC::is_a<GiNaC::power>(term) && GiNaC::is_a<GiNaC::symbol>(term.op(0))) return false;
  if (!GiNaC::is_a<GiNaC::mul>(term)) return std::nullopt;
  bool minus = false;
  for (const GiNaC::ex& factor : term) {
    const std::optional<bool> part = plain_minus(factor);
    if (!part) return std::nullopt;
    minus = minus != *part;
  }
  return minus;
}

/// The sign of all terms where it is one: it needs no order of terms then.
std::optional<bool> minus_of_all(const GiNaC::ex& expression) {
  if (!GiNaC::is_a<GiNaC::add>(expression)) return plain_minus(expression);
  const std::optional<bool> first = plain_minus(expression.op(0));
  for (const GiNaC::ex& term : expression)
    if (!first || plain_minus(term) != first) return std::nullopt;
  return first;
}

}  // namespace

Signed form_of(const GiNaC::ex& expression) {
  hear_interruption();
  if (GiNaC::is_a<GiNaC::symbol>(expression))
    return {false, named(GiNaC::ex_to<GiNaC::symbol>(expression).get_name())};
  if (GiNaC::is_a<GiNaC::add>(expression)) return sum_form(expression);
  if (GiNaC::is_a<GiNaC::function>(expression)) return call_form(expression);
  if (expression.is_zero()) return {false, number_form(0)};
  ProductForm product;
  if (GiNaC::is_a<GiNaC::mul>(expression))
    for (const GiNaC::ex& factor : expression) product.multiply(factor);
  else
    product.multiply(expression);
  return product.result();
}

bool holds_sum(const Form& form) {
  const auto any = [](const std::vector<Form>& forms) {
    return std::any_of(forms.begin(), forms.end(), holds_sum);
  };
  return form.kind == Form::Kind::sum || any(form.over) || any(form.under);
}

bool leads_with_minus(const GiNaC::ex& expression) {
  if (const std::optional<bool> minus = minus_of_all(expression)) return *minus;
  const Signed form = form_of(expression);
  return form.form.kind == Form::Kind::sum ? form.form.terms.front().minus : form.minus;
}

bool natural_less(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!digit(a[i]) || !digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    std::size_t end_a = i, end_b = j;
    while (end_a < a.size() && digit(a[end_a])) ++end_a;
    while (end_b < b.size() && digit(b[end_b])) ++end_b;
    if (end_a - i != end_b - j) return end_a - i < end_b - j;
    if (const int order = a.compare(i, end_a - i, b, j, end_b - j); order != 0) return order < 0;
    i = end_a, j = end_b;
  }
  return a.size() - i < b.size() - j;
}

}  // namespace vcrit::symbolic
