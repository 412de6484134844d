#include "formula/order.hpp"

#include <map>
#include <string>

#include "formula/text.hpp"

namespace vcrit::symbolic {

std::vector<GiNaC::ex> in_order_of_text(const GiNaC::ex& sum_or_product) {
  std::multimap<std::string, GiNaC::ex> by_text;
  for (const GiNaC::ex& part : sum_or_product) by_text.emplace(to_text(part), part);
  std::vector<GiNaC::ex> parts;
  for (const auto& [text, part] : by_text) parts.push_back(part);
  return parts;
}

}  // namespace vcrit::symbolic
