// Formulas as other systems read them: operators and functions are a row, the walk is Dialect's.
#pragma once

#include "document/systems/names.hpp"
#include "document/systems/system.hpp"
#include "formula/dialect.hpp"

namespace vcrit::symbolic {

/// Both arguments have to outlive it.
class SystemDialect : public Dialect {
 public:
  SystemDialect(const Syntax& syntax, const SystemNames& names) : syntax_(syntax), names_(names) {}

 private:
  std::string number(const std::string& digits) const override;
  std::string name(const std::string& symbol) const override;
  std::string negative(const std::string& term) const override { return "-" + term; }
  std::string added(const std::string& left, bool minus, const std::string& right) const override;
  std::string product(const std::vector<std::string>& factors) const override;
  PrintedPart fraction(const std::vector<PrintedPart>& over,
                       const std::vector<PrintedPart>& under) const override;
  std::string power(const std::string& base, int exponent) const override;
  std::string root(const std::string& argument) const override;
  std::string call(const std::string& function, const std::string& argument) const override;
  std::string wrapped(const std::string& text) const override { return "(" + text + ")"; }
  /// Templates write equations.
  std::string related(const std::string& left, bool, const std::string& right) const override {
    return left + " = " + right;
  }

  static std::string applied(const Around& function, const std::string& argument);

  const Syntax& syntax_;
  const SystemNames& names_;
};

}  // namespace vcrit::symbolic
