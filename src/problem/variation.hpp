// One problem with ever new values of some parameters, as if its scene were read again each time,
// but without reading where no element appears or vanishes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit {

class Variation {
 public:
  /// `names` as for --set. Throws InputError for names that the scene does not have and for two
  /// names of one quantity.
  Variation(Problem problem, std::vector<std::string> names);

  /// The problem with one value (SI) for each name. Throws InputError as reading with these
  /// settings does. May be called from several threads at once.
  Problem at(std::span<const double> values) const;
  /// Throws what at() throws, and makes no problem of values that any scene may have.
  void refuse(std::span<const double> values) const;

  /// What a name stands for: a number of the problem times a factor.
  struct Target {
    Symbol symbol;
    double factor = 1;         ///< 2 pi for a frequency
    bool is_poisson = false;   ///< the one quantity that need not be positive
    bool is_left_out = false;  ///< the scene has no such quantity
  };
  const std::vector<Target>& targets() const { return targets_; }

 private:
  static const Symbol& symbol_of(const Target& target);
  Target target(const std::string& name) const;
  bool fit(std::span<const double> values) const;

  Problem problem_;
  std::vector<std::string> names_;
  Settings settings_;  // but those of the targets
  std::vector<Target> targets_;
  Values changes_;  // any, of what the targets are to the problem
};

/// What one name stands for, as there.
Variation::Target target_of(const Problem& problem, const std::string& name);

}  // namespace vcrit
