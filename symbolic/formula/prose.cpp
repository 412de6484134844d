#include "formula/prose.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "base/numbers.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/dialect.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

std::string words_as_they_are(std::string_view text) { return std::string(text); }

}  // namespace

Statement stated(const GiNaC::ex& left, const GiNaC::ex& right) {
  const AlgebraLock lock;
  return {form_of(left), Statement::Relation::equal, form_of(right)};
}

Statement stated_number(const GiNaC::ex& left, double value) {
  const AlgebraLock lock;
  const Signed number{value < 0, {Form::Kind::number, to_text(std::abs(value)), {}, {}, {}, 1}};
  return {form_of(left), Statement::Relation::equal, number};
}

Statement tends(const GiNaC::ex& left, bool infinite) {
  const AlgebraLock lock;
  const GiNaC::ex end = infinite ? quantity("infinity") : GiNaC::ex(0);
  return {form_of(left), Statement::Relation::tends, form_of(end)};
}

Prose::Part::Part(const GiNaC::ex& formula) : statement{{form_of(formula)}} {}

Prose::Prose(std::string words) {
  if (!words.empty()) parts_.emplace_back(std::move(words));
}

Prose& Prose::operator+=(const Prose& more) {
  parts_.insert(parts_.end(), more.parts_.begin(), more.parts_.end());
  return *this;
}

std::string Prose::text() const { return written(text_dialect(), "", "", words_as_they_are); }

std::string Prose::written(const Dialect& dialect, const std::string& open,
                           const std::string& close,
                           std::string (*escape)(std::string_view)) const {
  std::string result;
  for (const Part& part : parts_) {
    if (!part.words.empty()) result += escape(part.words);
    for (const Statement& each : part.statement) result += open + dialect.written(each) + close;
  }
  return result;
}

}  // namespace vcrit::symbolic
