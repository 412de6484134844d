// Decimal numbers as balls, each read once: rows of a sweep have most of them in common.
#pragma once

#include <map>
#include <string>

#include "critical/balls.hpp"
#include "critical/certified.hpp"

namespace vcrit {

/// Held by who evaluates many scenes of the same numbers; not by several threads at once.
class ReadDecimals {
 public:
  const Ball& of(const TypedNumber& number, slong precision) {
    const auto [read, is_new] = read_[number.decimal].try_emplace(precision);
    if (is_new) read->second = read_decimal(number, precision);
    return read->second;
  }

 private:
  std::map<std::string, std::map<slong, Ball>> read_;
};

/// The same number as without.
CertifiedVelocity certified_critical_velocity(const Problem& problem, ReadDecimals& decimals);

}  // namespace vcrit
