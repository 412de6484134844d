// Words with formulas in them: "sliding ends where the contact velocity v0 - ... first touches
// zero". They are kept apart until a dialect writes them, so that a formula in a sentence is
// mathematics in every document.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "formula/form.hpp"

namespace vcrit::symbolic {

class Dialect;

/// A formula, or two of them in relation.
struct Statement {
  enum class Relation { none, equal, asymptotic, tends };
  Signed left;
  Relation relation = Relation::none;
  Signed right = {};  ///< of no relation: of no meaning
};

Statement stated(const GiNaC::ex& left, const GiNaC::ex& right);
/// left = a number that a scene gives, as people write it.
Statement stated_number(const GiNaC::ex& left, double value);
/// left -> 0 or left -> infinity.
Statement tends(const GiNaC::ex& left, bool infinite);

class Prose {
 public:
  struct Part {
    Part(const char* text) : words(text) {}                     // NOLINT(*-explicit-*)
    Part(std::string text) : words(std::move(text)) {}          // NOLINT(*-explicit-*)
    Part(const GiNaC::ex& formula);                             // NOLINT(*-explicit-*)
    Part(Statement formula) : statement{std::move(formula)} {}  // NOLINT(*-explicit-*)
    std::string words;
    std::vector<Statement> statement;  ///< one, or none where there are words
  };

  Prose() = default;
  Prose(const char* words) : Prose(std::string(words)) {}  // NOLINT(*-explicit-*)
  Prose(std::string words);                                // NOLINT(*-explicit-*)
  Prose(std::initializer_list<Part> parts) : parts_(parts) {}

  bool empty() const { return parts_.empty(); }
  const std::vector<Part>& parts() const { return parts_; }
  Prose& operator+=(const Prose& more);

  /// As plain text.
  std::string text() const;
  /// With every formula between `open` and `close`; words go through `escape`.
  std::string written(const Dialect& dialect, const std::string& open, const std::string& close,
                      std::string (*escape)(std::string_view)) const;

 private:
  std::vector<Part> parts_;
};

}  // namespace vcrit::symbolic
