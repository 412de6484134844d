#include "formula/symbols.hpp"

#include <cmath>
#include <map>

#include "base/errors.hpp"
#include "base/numbers.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

GiNaC::ex symbol(const Symbol& symbol) {
  const AlgebraLock lock;
  static std::map<std::string, GiNaC::possymbol> known;
  const std::string name = to_text(symbol);
  return known.try_emplace(name, name).first->second;
}

GiNaC::ex poisson_ratio(const Symbol& symbol) {
  const AlgebraLock lock;
  static std::map<std::string, GiNaC::realsymbol> known;
  const std::string name = to_text(symbol);
  return known.try_emplace(name, name).first->second;
}

GiNaC::ex quantity(const std::string& name) {
  const AlgebraLock lock;
  static std::map<std::string, GiNaC::symbol> known;
  return known.try_emplace(name, own_name(name)).first->second;
}

GiNaC::ex positive_quantity(const std::string& name) {
  const AlgebraLock lock;
  static std::map<std::string, GiNaC::possymbol> known;
  return known.try_emplace(name, own_name(name)).first->second;
}

GiNaC::ex real_quantity(const std::string& name) {
  const AlgebraLock lock;
  static std::map<std::string, GiNaC::realsymbol> known;
  return known.try_emplace(name, own_name(name)).first->second;
}

GiNaC::ex omega() {
  const AlgebraLock lock;
  return symbol({"omega"});
}
GiNaC::ex laplace() {
  const AlgebraLock lock;
  return quantity("s");
}

GiNaC::numeric exact_decimal(double value) {
  const AlgebraLock lock;
  ensure(std::isfinite(value), "only finite numbers have a fraction");
  return exact_decimal(to_text(value));
}

GiNaC::numeric exact_decimal(const std::string& text) {
  const AlgebraLock lock;
  const std::size_t e = text.find('e');
  std::string digits = text.substr(0, e);
  long exponent = e == std::string::npos ? 0 : std::stol(text.substr(e + 1));
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return GiNaC::numeric(digits.c_str()) * GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(exponent));
}

GiNaC::numeric exact_binary(double value) {
  const AlgebraLock lock;
  ensure(std::isfinite(value), "only finite numbers have a fraction");
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(value, &exponent), 53);
  return GiNaC::numeric(static_cast<long>(mantissa)) *
         GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(exponent - 53));
}

}  // namespace vcrit::symbolic
