// A scene prepared for derivation, and its formula in a limit or without one.
#pragma once

#include <ginac/ginac.h>

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "derivation/balance.hpp"
#include "derivation/factors.hpp"
#include "derivation/stiffness_forms.hpp"
#include "network/reduction.hpp"
#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// What is changed before the formula is made.
struct Change {
  GrowthExponents rates;
  bool rigid = false;              ///< the drive, after everything in `rates`
  bool massless = false;           ///< m to 0
  std::optional<GiNaC::ex> ratio;  ///< K_t = ratio K_n
  GiNaC::exmap scale = {};         ///< symbols written in others

  /// Whether the letters stay as they are.
  bool keeps_letters() const { return !ratio && scale.empty(); }
};

struct Formula {
  GiNaC::ex velocity;
  std::vector<Line> definitions;  ///< empty where velocity is multiplied out
  std::string equation;           ///< number in the paper, if it is one of its special cases
};

/// The amplitude's leading term amplitude s^power, where omega goes to a limit.
struct Asymptotic {
  int power = 0;
  GiNaC::ex amplitude;            ///< with s as it is: homogeneous
  std::vector<Line> definitions;  ///< of its stiffnesses' leading terms, as in Formula
};

/// One of the networks, "K_n", "K_t", "K_d" or "K_m".
struct NamedNetwork {
  std::string name;
  ReducedNetwork network;
};

class SymbolicModel {
 public:
  explicit SymbolicModel(const Problem& problem);

  const Balance& balance() const { return balance_; }
  /// The amplitude B after isotropy and equal networks have been put in.
  GiNaC::ex amplitude(const Change& change) const;
  /// The same; with a mount, what resonates along the normal is a factor of its own.
  const Factors& factors(const Change& change) const;
  /// B/(mu0 du_z) without a limit.
  const GiNaC::ex& per_friction() const;
  /// Nothing where the limit cuts a network in two, makes the normal network rigid or unable to
  /// carry the mean load, or leaves no motion.
  std::optional<Formula> formula(const Change& change) const;
  /// The amplitude B as polynomials in s, if it is then short enough to be read.
  std::optional<Factors> multiplied_out_amplitude(const Change& change = {}) const;
  /// The formula in terms of K_n, K_t, K_d and K_m, however small it is.
  Formula nested_formula() const;
  /// What the amplitude tends to as omega goes to infinity (`direction` 1) or to zero (-1).
  Asymptotic asymptotic(int direction, Change change = {}) const;
  /// "K_t = r K_n", "K_d = K_n" and "K_d = 1/R_d", as far as they hold in the scene.
  const std::vector<Line>& identities() const { return identities_; }
  /// K_t/K_n of an isotropic contact.
  const std::optional<GiNaC::ex>& isotropic_ratio() const { return ratio_; }
  bool has_drive() const { return surrounding_.drive; }
  bool has_mount() const { return surrounding_.mount; }
  /// K_n, K_t, K_d and K_m, in this order, as far as they have a network of their own.
  const std::vector<NamedNetwork>& networks() const { return networks_; }
  /// K_n, K_t, K_d and K_m of `expression` as ratios of polynomials in s, if it then stays
  /// readable.
  std::optional<GiNaC::exmap> multiplied_out(const GiNaC::ex& expression,
                                             const Change& change = {}) const;

 private:
  void put_drive(const ReducedNetwork& drive);
  Factors new_factors(const Change& change) const;
  bool is_small(const GiNaC::ex& amplitude, const Change& change) const;
  std::map<std::string, int> powers(const Change& change) const;
  bool unloads_contact(const Change& change) const;
  /// Of each network; powers and sizes of one change are asked for one after the other.
  const std::vector<Leading<TermCount>>& counts(const GrowthExponents& rates) const;
  Leading<Factors> leading_amplitude(const std::map<std::string, int>& powers,
                                     const Change& change) const;
  Leading<Factors> new_leading_amplitude(const std::map<std::string, int>& powers,
                                         const Change& change) const;
  /// The networks that are small enough, as ratios of polynomials; without the change's scale they
  /// are kept for the next one.
  std::map<std::string, Fraction> fractions(const Change& change) const;
  Factors multiplied_out(const Factors& amplitude,
                         const std::map<std::string, Fraction>& fractions) const;
  Formula nested_in(const Factors& amplitude, const Change& change) const;
  std::vector<Line> definitions(const GiNaC::ex& formula, const Change& change) const;
  std::string equation(const std::map<std::string, Fraction>& networks,
                       const std::map<std::string, int>& powers, const Change& change) const;

  Surrounding surrounding_;
  Balance balance_;
  std::vector<NamedNetwork> networks_;
  std::vector<Line> identities_;
  std::optional<GiNaC::ex> ratio_;
  bool loaded_ = false;
  mutable std::pair<GrowthExponents, std::vector<Leading<TermCount>>> counted_;
  mutable std::optional<std::pair<GrowthExponents, std::map<std::string, Fraction>>> fractions_;
  /// In a document several lines ask for those of each of a few changes. Their places are kept.
  mutable std::deque<std::pair<Change, Factors>> factors_;
  mutable std::optional<GiNaC::ex> per_friction_;  ///< asked for at each point of a proof
  /// By powers, and whether the drive is rigid, where nothing else changes: hundreds of limits of a
  /// large network share one.
  mutable std::map<std::pair<std::map<std::string, int>, bool>, Leading<Factors>> leading_;
};

using Symbols = std::set<GiNaC::ex, GiNaC::ex_is_less>;
Symbols free_symbols(const GiNaC::ex& expression);

/// Those of the definitions, each of earlier ones, that the formula needs.
std::vector<Line> used_in(const GiNaC::ex& formula, std::vector<Line> definitions);

/// K_t/K_n of an isotropic contact: an exact fraction, or a formula in its symbol.
GiNaC::ex isotropic_ratio(const Isotropic& isotropic);

}  // namespace vcrit::symbolic
