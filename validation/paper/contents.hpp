// The paper checked, as plain data: what was derived, drawn and compared, with no way to
// compute it and no way to show it. Equation numbers are the paper's.
//
// Motions are without dimensions: k = omega = mu0 <F_n> = 1, delta = omega c/k, F_n = mean
// (1 + a cos), D = du_z/u_z0 = a/sqrt(1 + delta^2); speeds are v0/v*, friction is mu_macro/mu0.
#pragma once

#include <string>
#include <vector>

#include "compare/scene_report.hpp"
#include "figures/figure.hpp"

namespace vcrit::validation::paper {

using validation::to_text;  // beside that of a verdict

/// An equation of the paper, derived from a scene and written by hand.
struct EquationProof {
  std::string equation;  ///< "(29)"
  std::string words;     ///< of which scene, or in which limit
  ShownFormula derived;  ///< v*
  ShownFormula by_hand;  ///< v*, typed in
  bool legible = false;  ///< in the source at hand; else worked out by hand
};

struct Proofs {
  std::vector<EquationProof> proofs;
  std::vector<std::string> rheologies;  ///< for which the rigidly driven isotropic v* was derived
  std::vector<Comparison> comparisons;
};

struct Figure4 {
  std::vector<figures::Figure> reduced, full;  ///< panels a to d
  std::vector<Comparison> comparisons;
};

/// Comparisons without more to show.
struct PaperPart {
  std::vector<Comparison> comparisons;
};

/// Where viscosity changes nothing at equal a, and by how much of mu/mu0, per a, at most.
struct Crossing {
  double delta = 0;  ///< 0 and infinity are limits
  double ratio = 0;  ///< v_c/v*
  double weakening = 0, strengthening = 0;
};

struct Viscosity {
  std::vector<Crossing> crossings;
  std::vector<figures::Figure> figures;  ///< at equal a, at equal D
  std::vector<Comparison> comparisons;
};

/// What (41) and (43) say where it should be 0.
struct Misprints {
  double velocity_as_printed = 0, force_as_printed = 0;
  std::vector<Comparison> comparisons;
};

/// Reduced model less full motion.
struct DifferenceMap {
  figures::Figure figure;
  double allowed = 0;     ///< where the line is drawn
  double safe_delta = 0;  ///< up to which delta it is kept at all speeds, between grid values
  std::vector<Comparison> comparisons;
};

/// The largest D without loss of contact.
struct AmplitudeLimit {
  double delta = 0;
  double printed = 0;           ///< in the paper
  double formula = 0;           ///< 1/sqrt(1 + delta^2), (52)
  double by_admissibility = 0;  ///< bisection on the check of scenes
  double by_simulator = 0;      ///< bisection on what the simulator accepts
};

struct AmplitudeLimits {
  std::vector<AmplitudeLimit> rows;
  std::vector<Comparison> comparisons;
};

/// Friction at one vanishing speed after the other.
struct StaticRow {
  double delta = 0;
  double limit = 0;             ///< min F_n/<F_n>
  std::vector<double> full;     ///< one for each speed
  std::vector<double> slopes;   ///< d ln(full - limit)/d ln speed between one speed and the next
  std::vector<double> reduced;  ///< one for each speed
  double reduced_limit = 0;     ///< what the reduced model tends to
};

struct StaticLimit {
  double a = 0;
  std::vector<double> ratios;
  std::vector<StaticRow> rows;
  std::vector<Comparison> comparisons;
};

/// G of mu_macro/mu0 = 1 - D G(v0/v*), elastic contact.
struct PunchRow {
  double ratio = 0, reference = 0, closed_form = 0, simulated = 0, fit = 0;
};

struct FlatPunch {
  std::vector<PunchRow> rows;
  figures::Figure figure;
  std::vector<Comparison> comparisons;
};

/// One steady state by all methods.
struct Witness {
  double delta = 0, ratio = 0;
  double reference = 0;  ///< 25 digits, tests/data/paper_friction.csv
  double exact = 0, exact_error = 0;
  std::vector<double> moreau;  ///< by each number of steps
  double adaptive = 0, adaptive_error = 0;
  double reduced = 0;
};

struct Evidence {
  double a = 0;
  std::vector<int> steps;  ///< of Moreau's method a period, each half as long as before
  std::vector<Witness> rows;
  std::vector<Comparison> comparisons;
};

/// What the paper says, and what the comparisons show of it.
struct Claim {
  enum class Verdict { holds, in_part, fails, not_legible, not_shown };
  int number = 0;
  std::string where;  ///< in the paper: "4.2, (52)"
  std::string words, evidence;
  std::vector<std::string> keys;  ///< of the comparisons that decide it; none: nothing to compare
  Verdict verdict = Verdict::not_shown;
};
/// "holds", "in part", "fails", "not legible", "not shown".
const char* to_text(Claim::Verdict verdict);

struct Paper {
  Proofs proofs;
  PaperPart range;
  Figure4 figure4;
  DifferenceMap map;
  AmplitudeLimits amplitudes;
  StaticLimit slow;
  Viscosity viscosity;
  FlatPunch punch;
  PaperPart shapes;
  Misprints misprints;
  Evidence evidence;
  std::vector<Claim> claims;
};

/// Of all parts, in their order.
std::vector<Comparison> all_comparisons(const Paper& paper);
std::vector<figures::Figure> all_figures(const Paper& paper);

}  // namespace vcrit::validation::paper
