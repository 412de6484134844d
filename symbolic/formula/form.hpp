// The form of an expression for display and comparison. GiNaC keeps sums and products in an order
// (and with signs) that changes from run to run; here every sum and product is put into one order
// of our own, by names, and signs are fixed by the first term, so that the same expression gives
// the same bytes always.
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace vcrit::symbolic {

struct Signed;

/// A positive-looking expression; its sign stands in Signed.
struct Form {
  enum class Kind {
    number,   ///< `text`, the digits of a natural number or of a fraction a/b
    name,     ///< `text`, a symbol
    sum,      ///< `terms`
    product,  ///< `over` divided by `under`
    power,    ///< over[0] to the natural number `exponent`
    root,     ///< square root of over[0]
    call,     ///< the function `text` of terms[0]
    series    ///< sum of terms[0] over the index `text` from `exponent` to `last`
  };
  Kind kind = Kind::number;
  std::string text;
  std::vector<Form> over, under;
  std::vector<Signed> terms;
  int exponent = 1;
  int last = 0;
};

struct Signed {
  bool minus = false;
  Form form;
};

Signed form_of(const GiNaC::ex& expression);

/// Whether the form is a sum or has one among its factors.
bool holds_sum(const Form& form);

/// Each + - * / ^ sqrt abs.
int operations_in(const Form& form);

/// Whether the first term of the expression's form is negative.
bool leads_with_minus(const GiNaC::ex& expression);

/// The order of names as people count: k2 before k10.
bool natural_less(const std::string& a, const std::string& b);

}  // namespace vcrit::symbolic
