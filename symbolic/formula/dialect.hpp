// One printer for each dialect over one walk of a Form.
#pragma once

#include <string>
#include <vector>

#include "formula/form.hpp"
#include "formula/prose.hpp"

namespace vcrit::symbolic {

/// A printed part, and how tightly it holds together.
struct PrintedPart {
  enum class Tightness { sum, product, atom };
  std::string text;
  Tightness tightness = Tightness::atom;
};

class Dialect {
 public:
  virtual ~Dialect() = default;
  std::string print(const Signed& expression) const;
  std::string written(const Statement& statement) const;
  std::string equation(const Signed& left, const Signed& right) const;
  /// Some terms of a sum, the first with its sign where they go on with a line before.
  std::string terms(const std::vector<Signed>& terms, bool go_on) const;
  /// "=" or "~".
  std::string sign(Statement::Relation relation) const;
  /// "j = 1..10"
  virtual std::string range(const std::string& index, int first, int last) const;

 protected:
  /// A natural number or a fraction a/b.
  virtual std::string number(const std::string& digits) const = 0;
  /// Of a symbol by its name within the program (Form::text), which no other one has.
  virtual std::string name(const std::string& symbol) const = 0;
  virtual std::string negative(const std::string& term) const = 0;
  /// `right` behind `left`, after a plus or minus.
  virtual std::string added(const std::string& left, bool minus,
                            const std::string& right) const = 0;
  virtual std::string product(const std::vector<std::string>& factors) const = 0;
  /// The parts are not wrapped yet.
  virtual PrintedPart fraction(const std::vector<PrintedPart>& over,
                               const std::vector<PrintedPart>& under) const = 0;
  /// The same within a fraction, where letters above and below a bar would be tiny.
  virtual PrintedPart inner_fraction(const std::vector<PrintedPart>& over,
                                     const std::vector<PrintedPart>& under) const {
    return fraction(over, under);
  }
  virtual std::string power(const std::string& base, int exponent) const = 0;
  virtual std::string root(const std::string& argument) const = 0;
  virtual std::string call(const std::string& function, const std::string& argument) const = 0;
  virtual std::string wrapped(const std::string& text) const = 0;
  /// left = right, or left ~ right.
  virtual std::string related(const std::string& left, bool asymptotic,
                              const std::string& right) const = 0;
  /// left -> right, and what it may go to.
  virtual std::string tending(const std::string& left, const std::string& right) const {
    return left + " -> " + right;
  }
  /// What a line that begins with a sign begins with.
  virtual std::string nothing() const { return ""; }
  virtual std::string infinity() const { return "infinity"; }
  /// The sum of `term` over `index` from `first` to `last`.
  virtual std::string series(const std::string& term, const std::string& index, int first,
                             int last) const;
  virtual PrintedPart::Tightness series_tightness() const { return PrintedPart::Tightness::atom; }
  /// Whether a root above a bar is written behind the fraction, where it is set large.
  virtual bool roots_stand_behind() const { return false; }

  /// over/under on one line.
  PrintedPart slashed(const std::vector<PrintedPart>& over, const std::vector<PrintedPart>& under,
                      const std::string& slash) const;
  /// The factors' texts, sums in parentheses; a lone one as it is if `lone_is_bare`.
  std::vector<std::string> factors(const std::vector<PrintedPart>& pieces, bool lone_is_bare) const;

 private:
  /// Where a part stands: on its own line, or above or below a bar.
  enum class Position { free, in_fraction };
  PrintedPart piece(const Form& form, Position place) const;
  std::string printed(const Signed& expression, Position place) const;
  /// The form; a sum that is taken away stands in parentheses.
  std::string behind_sign(const Signed& term, Position place) const;
  PrintedPart quotient(const Form& form, Position place) const;
  std::vector<PrintedPart> pieces(const std::vector<Form>& forms, Position place) const;
};

const Dialect& text_dialect();
const Dialect& latex_dialect();
const Dialect& mathml_dialect();
/// With a/b for fractions: for formulas between words, where a bar would be small.
const Dialect& latex_within_words();
const Dialect& mathml_within_words();

}  // namespace vcrit::symbolic
