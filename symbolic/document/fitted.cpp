#include "document/fitted.hpp"

#include <algorithm>
#include <utility>

#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/width.hpp"

namespace vcrit::symbolic {

namespace {

// Of a page: what stands left of an equals sign leaves as much.
constexpr double least_right = 0.5;

/// The widest sums within a form that no other sum is around; none of the form itself.
void outermost_sums(Form& form, std::vector<Form*>& found) {
  const auto visit = [&found](Form& part) {
    if (part.kind == Form::Kind::sum)
      found.push_back(&part);
    else
      outermost_sums(part, found);
  };
  for (Form& part : form.over) visit(part);
  for (Form& part : form.under) visit(part);
  for (Signed& term : form.terms) visit(term.form);
}

bool has_bar(const Form& form) {
  const auto any = [](const std::vector<Form>& forms) {
    return std::any_of(forms.begin(), forms.end(), has_bar);
  };
  return (form.kind == Form::Kind::product && !form.under.empty()) || any(form.over) ||
         any(form.under) ||
         std::any_of(form.terms.begin(), form.terms.end(),
                     [](const Signed& term) { return has_bar(term.form); });
}

std::string part_key(const Form& form) { return text_dialect().print({false, form}); }

/// A product with half of its factors as one, for products of nothing but names.
bool halve_factors(std::vector<Form>& factors, Form& half) {
  if (factors.size() < 4) return false;
  const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
  half = {Form::Kind::product, "", {middle, factors.end()}, {}, {}, 1};
  factors.erase(middle, factors.end());
  return true;
}

double characters(const Form& form) {
  return static_cast<double>(text_dialect().print({false, form}).size());
}

}  // namespace

const PageMeasure measure_of_page{
    safe_text_width, symbolic::width_of, width_of_sign, width_of_relation, 22, 50, 18};
// Lines are indented by four.
const PageMeasure measure_of_terminal{96, characters, 3, 3, 4, 16, 4};

double Fitting::width_of(const Signed& expression) const {
  return measure_.of(expression.form) + (expression.minus ? measure_.sign : 0);
}

Form Fitting::name_of(const Form& part) {
  const std::string key = part_key(part);
  if (const auto known = names_.find(key); known != names_.end()) return known->second;
  // Parts of the part are named first, so that names are in the order of reading.
  auto meaning = rows({false, part}, measure_.name + measure_.relation);
  std::string name;
  do name = "U_" + std::to_string(++last_);
  while (is_taken(name));
  const Form form{Form::Kind::name, own_name(name), {}, {}, {}, 1};
  fresh_.push_back({{false, form}, Statement::Relation::equal, std::move(meaning), {}});
  return names_[key] = form;
}

bool Fitting::name_a_part(Form& form) {
  std::vector<Form*> sums;
  outermost_sums(form, sums);
  const auto widest = std::max_element(sums.begin(), sums.end(), [this](Form* a, Form* b) {
    return measure_.of(*a) < measure_.of(*b);
  });
  if (widest != sums.end() && measure_.of(**widest) > measure_.least_part) {
    **widest = name_of(**widest);
    return true;
  }
  Form half;
  for (std::vector<Form>* factors : {&form.over, &form.under})
    if (halve_factors(*factors, half)) {
      factors->push_back(name_of(half));
      return true;
    }
  return false;
}

/// Gives a name to what would be set in the smallest letters: sums with fractions below two bars.
void Fitting::name_small_parts(Form& form, int bars) {
  if (form.kind == Form::Kind::sum && bars > 1 && has_bar(form)) {
    form = name_of(form);
    return;
  }
  const int within = bars + (form.kind == Form::Kind::product && !form.under.empty() ? 1 : 0);
  // A root above the outermost bar is set beside it.
  for (Form& part : form.over)
    name_small_parts(part, bars == 0 && part.kind == Form::Kind::root ? 0 : within);
  for (Form& part : form.under) name_small_parts(part, within);
  for (Signed& term : form.terms) name_small_parts(term.form, within);
}

Form Fitting::narrowed(Form form, double width) {
  while (measure_.of(form) > width && name_a_part(form)) {
  }
  return form;
}

std::vector<std::vector<Signed>> Fitting::rows(Signed right, double left) {
  name_small_parts(right.form, 0);
  if (width_of(right) <= measure_.width - left) return {{std::move(right)}};
  if (right.form.kind != Form::Kind::sum)
    return {
        {{right.minus, narrowed(std::move(right.form), measure_.width - left - measure_.sign)}}};
  std::vector<std::vector<Signed>> result;
  double used = 0;
  for (Signed& term : right.form.terms) {
    term.form =
        narrowed(std::move(term.form), measure_.width - left - measure_.indent - measure_.sign);
    const double more = measure_.of(term.form) + measure_.sign;
    if (result.empty() || used + more > measure_.width) {
      used = result.empty() ? left : left + measure_.indent;
      result.emplace_back();
    }
    used += more;
    result.back().push_back(std::move(term));
  }
  return result;
}

std::vector<FittedEquation> Fitting::fitted(const Statement& equation, double column) {
  Signed left = equation.left, right = equation.right;
  // What is 0 is broken behind the equals sign.
  const bool is_number = right.form.kind == Form::Kind::number;
  if (is_number && width_of(left) + measure_.relation + width_of(right) > measure_.width)
    std::swap(left, right);
  if (!is_number && width_of(left) > least_right * measure_.width)
    left.form = narrowed(std::move(left.form), least_right * measure_.width);
  const double beside = std::max(width_of(left), column) + measure_.relation;
  FittedEquation whole{left, equation.relation, rows(std::move(right), beside), {}};
  std::vector<FittedEquation> result = std::exchange(fresh_, {});
  result.push_back(std::move(whole));
  return result;
}

}  // namespace vcrit::symbolic
