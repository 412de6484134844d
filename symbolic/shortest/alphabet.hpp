// The symbols of a problem as expressions, with what each measures: in the scene's names, or in
// dimensionless groups.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "analysis/dimensionless.hpp"
#include "problem/problem.hpp"
#include "shortest/critical.hpp"
#include "shortest/letters.hpp"
#include "shortest/lines.hpp"
#include "shortest/presentations.hpp"
#include "shortest/search.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::symbolic::shortest {

// Some 0.1 s each.
inline constexpr std::size_t work_of_beginning = 5'000'000;
inline constexpr SearchEffort search_effort{60, 5'000'000};

/// Where omega stands: with mu0 and du_z in front of v*, and in letters (W = omega c); or as a
/// factor like others, so that forms multiplied through by omega, where it cancels, are found.
enum class OmegaPlace { in_front, anywhere };

class Alphabet {
 public:
  /// In `groups` where they are given, with the reference and omega put to 1.
  explicit Alphabet(const Problem& problem, const DimensionlessGroups* groups = nullptr,
                    OmegaPlace omega = OmegaPlace::in_front);

  Expressions& expressions() { return all_; }
  const Parts& parts() const { return parts_; }
  Presentations presentations(const Thrift& thrift);
  /// A symbol for a stiffness; K'' is the loss.
  Ex stiffness(const std::string& name, bool positive);
  /// A symbol of the networks, by its text.
  Ex element(const std::string& name) const;
  /// A symbol of the problem that is in no network.
  Ex quantity(const Symbol& symbol) { return this->symbol(symbol, {}); }

  /// Letters of a formula beside that of v* have this behind them.
  void mark_letters(const std::string& mark) { measures_.mark = mark; }

  /// What begins with the prefactor of v*, as lines.
  ShortestForm written(const Ex& velocity, const std::vector<NamedLine>& definitions = {}) const;

 private:
  const Isotropic* isotropic() const { return std::get_if<Isotropic>(&problem_->tangential); }
  Ex symbol(const Symbol& symbol, const Measure& measure);
  Ex in_groups(const GiNaC::ex& product);
  void add(const Network& network);
  Ex ratio(const Isotropic& isotropic);
  Ex number_ratio(const Isotropic& isotropic);
  Prose ratio_words(const ShortestForm& form) const;

  Problem problem_;
  const DimensionlessGroups* groups_;
  OmegaPlace omega_;
  Expressions all_;
  Parts parts_;
  std::map<Symbol, Ex> symbols_;
  std::map<std::string, Ex> group_symbols_;
  Measures measures_;
  std::string ratio_;  ///< K_n/K_t where it is a number other than 1
};

/// What is tried one after the other until the beginning takes no more work than that.
inline constexpr std::array<Thrift, 3> thrifts{{{48, 3}, {6, 1}, {1, 1}}};

/// What `attempt` finds with the first thrift that is not beyond its work.
template <class Attempt>
FoundForm first_that_fits(const Attempt& attempt) {
  for (const Thrift& thrift : thrifts) {
    try {
      return attempt(thrift);
    } catch (const TooLarge&) {
      continue;
    }
  }
  return {{}, "a real formula takes more work than is allowed for one that fits a page"};
}

}  // namespace vcrit::symbolic::shortest
