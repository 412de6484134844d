#include "document/fitted.hpp"

#include <algorithm>
#include <utility>

#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/width.hpp"

namespace vcrit::symbolic {

namespace {

// Rows after the first are indented, in pt.
constexpr double indent = 22;

// Narrower parts get no name, in pt.
constexpr double least_part = 50;

// U with an index of two digits, in pt.
constexpr double width_of_name = 18;

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

std::string part_key(const Form& form) { return text_dialect().print({false, form}); }

/// A product with half of its factors as one, for products of nothing but names.
bool halve_factors(std::vector<Form>& factors, Form& half) {
  if (factors.size() < 4) return false;
  const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
  half = {Form::Kind::product, "", {middle, factors.end()}, {}, {}, 1};
  factors.erase(middle, factors.end());
  return true;
}

}  // namespace

Form Fitting::name_of(const Form& part) {
  const std::string key = part_key(part);
  if (const auto known = names_.find(key); known != names_.end()) return known->second;
  // Parts of the part are named first, so that names are in the order of reading.
  auto meaning = rows({false, part}, width_of_name + width_of_relation);
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
  const auto widest = std::max_element(
      sums.begin(), sums.end(), [](Form* a, Form* b) { return width_of(*a) < width_of(*b); });
  if (widest != sums.end() && width_of(**widest) > least_part) {
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

Form Fitting::narrowed(Form form, double width) {
  while (width_of(form) > width && name_a_part(form)) {
  }
  return form;
}

std::vector<std::vector<Signed>> Fitting::rows(Signed right, double left) {
  if (width_of(right) <= width_ - left) return {{std::move(right)}};
  if (right.form.kind != Form::Kind::sum)
    return {{{right.minus, narrowed(std::move(right.form), width_ - left - width_of_sign)}}};
  std::vector<std::vector<Signed>> result;
  double used = 0;
  for (Signed& term : right.form.terms) {
    term.form = narrowed(std::move(term.form), width_ - left - indent - width_of_sign);
    const double more = width_of(term.form) + width_of_sign;
    if (result.empty() || used + more > width_) {
      used = result.empty() ? left : left + indent;
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
  if (right.form.kind == Form::Kind::number && width_of(equation) > width_) std::swap(left, right);
  if (width_of(left) > least_right * width_)
    left.form = narrowed(std::move(left.form), least_right * width_);
  const double beside = std::max(width_of(left), column) + width_of_relation;
  FittedEquation whole{left, equation.relation, rows(std::move(right), beside), {}};
  std::vector<FittedEquation> result = std::exchange(fresh_, {});
  result.push_back(std::move(whole));
  return result;
}

}  // namespace vcrit::symbolic
