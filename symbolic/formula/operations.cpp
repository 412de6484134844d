// The length of a formula.
#include <algorithm>

#include "formula/form.hpp"

namespace vcrit::symbolic {

namespace {

int operations_in_all(const std::vector<Form>& forms) {
  int sum = 0;
  for (const Form& form : forms) sum += operations_in(form);
  return sum;
}

/// Of a product of them.
int multiplications(const std::vector<Form>& forms) {
  return std::max(static_cast<int>(forms.size()) - 1, 0);
}

}  // namespace

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
