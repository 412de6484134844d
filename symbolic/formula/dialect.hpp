// One printer for each dialect over one walk of a Form.
#pragma once

#include <string>
#include <vector>

#include "formula/form.hpp"

namespace vcrit::symbolic {

/// A printed part, and how tightly it holds together.
struct Piece {
  enum class Tightness { sum, product, atom };
  std::string text;
  Tightness tightness = Tightness::atom;
};

class Dialect {
 public:
  virtual ~Dialect() = default;
  std::string print(const Signed& expression) const;
  std::string equation(const Signed& left, const Signed& right) const;
  /// left ~ right.
  std::string asymptote(const Signed& left, const Signed& right) const;

 protected:
  /// A natural number or a fraction a/b.
  virtual std::string number(const std::string& digits) const = 0;
  virtual std::string name(const std::string& text) const = 0;
  virtual std::string negative(const std::string& term) const = 0;
  /// `right` behind `left`, after a plus or minus.
  virtual std::string added(const std::string& left, bool minus,
                            const std::string& right) const = 0;
  virtual std::string product(const std::vector<std::string>& factors) const = 0;
  /// The parts are not wrapped yet.
  virtual Piece fraction(const std::vector<Piece>& over, const std::vector<Piece>& under) const = 0;
  virtual std::string power(const std::string& base, int exponent) const = 0;
  virtual std::string root(const std::string& argument) const = 0;
  virtual std::string call(const std::string& function, const std::string& argument) const = 0;
  virtual std::string wrapped(const std::string& text) const = 0;
  /// left = right, or left ~ right.
  virtual std::string related(const std::string& left, bool asymptotic,
                              const std::string& right) const = 0;

  /// The factors' texts, sums in parentheses; a lone one as it is if `lone_is_bare`.
  std::vector<std::string> factors(const std::vector<Piece>& pieces, bool lone_is_bare) const;

 private:
  Piece piece(const Form& form) const;
  std::vector<Piece> pieces(const std::vector<Form>& forms) const;
};

const Dialect& text_dialect();
const Dialect& latex_dialect();
const Dialect& mathml_dialect();

}  // namespace vcrit::symbolic
