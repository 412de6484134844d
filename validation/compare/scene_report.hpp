// What is known of one scene after everything has been compared with everything: plain data, with
// no way to compute it and no way to show it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "answers/effect.hpp"
#include "base/numbers.hpp"
#include "problem/problem.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::validation {

using vcrit::to_text;  // beside that of an outcome

/// Two numbers for one thing, and how far they may be apart.
struct Comparison {
  enum class Measure { relative, absolute };
  enum class Outcome { passed, failed, not_run };

  std::string key;        ///< one word, for report.json: "formula", "simulation", ...
  std::string name;       ///< what is compared, for people
  std::string reference;  ///< what it is compared with
  std::string unit;       ///< of both numbers, empty for ratios
  Measure measure = Measure::relative;
  double expected = 0;  ///< by the reference
  double found = 0;
  double tolerance = 0;  ///< greatest difference that passes
  std::string reason;    ///< why this tolerance
  std::string detail;  ///< where the worst value was found; why it was not run or broke, else empty
  bool not_run = false;  ///< nothing was compared, `detail` says why
  bool broken = false;   ///< one side gave no number, `detail` says why: counts as failed
};

/// |found - expected|, over |expected| if relative; 0 for equal numbers, infinite for a NaN.
double difference(const Comparison& comparison);
Comparison::Outcome outcome(const Comparison& comparison);
const char* to_text(Comparison::Outcome outcome);  ///< "passed", "failed", "not run"

/// Mathematics as the page shows it and as it can be copied.
struct ShownFormula {
  std::string mathml, latex, text;
};

/// left = right, and the words that lead to it.
struct ShownEquation {
  std::string words;
  ShownFormula left, right;
  std::string markup = {};  ///< the words with MathML
};

/// v* as its readers are shown it.
struct ShownVelocity {
  ShownFormula formula;
  std::vector<ShownEquation> definitions;  ///< of names in it
  std::string ratio;                       ///< where K_n/K_t comes from; else empty
  bool is_real = false;                    ///< the shortest form; else in complex stiffnesses
  std::string ratio_markup = {};           ///< with MathML
};

/// What the formula says; see symbolic::Fact.
struct ShownFact {
  std::string key, words;
  std::vector<ShownEquation> lines;
  std::string markup = {};  ///< the words with MathML
};

struct LimitLine {
  std::string name, equation;  ///< see symbolic::Limit
  std::string mathml_name;
  ShownFormula result;
  std::vector<ShownEquation> definitions;  ///< of names in `result`
};

/// One number of the scene.
struct ValueLine {
  Symbol symbol;
  ShownFormula name;
  double value = 0;     ///< SI
  std::string unit;     ///< of it, empty for a ratio
  std::string meaning;  ///< "spring", "angular frequency", ...
};

/// What v* makes of one number of the scene, of an array of all entries at once.
struct Influence {
  std::string name;  ///< as the scene has it
  ShownFormula sign;
  std::string meaning;  ///< as of its values
  bool array = false;
  double share = 0;  ///< (p/v*) dv*/dp
};

/// Of the contact as if its surfaces could pull, N: where the amplitude is above the mean they
/// open.
struct NormalForce {
  double mean = 0, amplitude = 0;
};

/// Steady friction at one speed, come to from sliding and from rest.
struct ComparedPoint {
  double ratio = 0;                   ///< speed over the critical speed of the drive
  double velocity = 0;                ///< m/s
  double from_sliding = 0;            ///< mu_macro/mu0
  double from_rest = 0;               ///< mu_macro/mu0
  double error = 0;                   ///< the simulator's estimate for both
  std::string regime;                 ///< "stick-slip", ...
  std::optional<double> closed_form;  ///< mu_macro/mu0 where physics has a closed form
};

/// One oscillation period of the steady motion.
struct Cycle {
  double ratio = 0, velocity = 0;  ///< as in ComparedPoint
  double friction_ratio = 0;
  std::string regime;
  std::vector<simulation::CyclePoint> points;
  std::vector<simulation::Event> events;
};

/// mu_macro/mu0 by the paper's reduced model and by the full motion (reduced_difference.hpp).
struct ReducedAndFull {
  double reduced = 0, full = 0;
  double difference() const { return reduced - full; }
};

/// Over delta = omega c/k and v0/v*, at one amplitude a of the normal force.
struct ReducedTable {
  double a = 0;                ///< F_n = mean (1 + a cos)
  std::vector<double> ratios;  ///< v0/v*, increasing: columns
  std::vector<double> deltas;  ///< increasing: rows
  std::vector<std::vector<ReducedAndFull>> rows;
};

/// What the reduced model means for one scene.
struct ReducedModel {
  double delta = 0;                   ///< of the scene, among those of the table
  double tolerance = 0;               ///< of mu_macro/mu0
  std::optional<double> usable_from;  ///< v0/v* from which on it keeps the tolerance
  ReducedTable table;                 ///< at the scene's a
};

/// Friction by one method beside the exact one.
struct MethodPoint {
  double ratio = 0;           ///< as in ComparedPoint
  double friction_ratio = 0;  ///< mu_macro/mu0
  double difference = 0;      ///< |it less the exact method's|
  std::string reason;         ///< why there is none, else empty
};

struct MethodCurve {
  std::string method, setting;
  std::vector<MethodPoint> points;
};

/// The scene at another angular frequency; N/m and m/s.
struct ResponsePoint {
  double omega = 0;                   ///< rad/s
  double normal = 0, tangential = 0;  ///< |K_n|, |K_t|
  std::optional<double> drive;        ///< |K_d| of a drive network
  double velocity = 0;                ///< v* by Eq. 24
  bool applies = true;  ///< that is v*: (3) and (4) hold, or it holds where the contact opens
};

/// v* ~ coefficient omega^power.
struct AsymptoteLine {
  bool low = true;  ///< as omega -> 0; else as omega -> infinity
  int power = 0;
  double coefficient = 0;
  ShownFormula formula;
  std::vector<ShownEquation> definitions;  ///< of names in it
};

/// Where the drive makes v* largest (resonance) or smallest (antiresonance).
struct ResonanceMark {
  double omega = 0;  ///< rad/s
  bool resonance = true;
};

struct FrequencyResponse {
  double omega = 0;                   ///< the scene's own, rad/s
  std::vector<ResponsePoint> points;  ///< by increasing omega
  std::vector<AsymptoteLine> asymptotes;
  std::vector<ResonanceMark> marks;
};

/// Friction over speed at another amplitude or of another shape.
struct FrictionCurve {
  std::string name;
  bool own = false;              ///< the scene as it is
  std::vector<double> ratios;    ///< v0 over v* by Eq. 24 at its amplitude
  std::vector<double> friction;  ///< mu_macro/mu0; no_friction where there is no answer
};
inline constexpr double no_friction = std::numeric_limits<double>::quiet_NaN();

/// What the contact does over one period, for each of `rows`.
struct StateMap {
  std::vector<double> rows;    ///< increasing
  std::vector<double> phases;  ///< omega t, increasing
  std::vector<std::optional<simulation::Motion>>
      motions;  ///< of each row over all phases, row after row; none: no steady state
};

/// A scene whose contact may open.
struct Separation {
  bool opens = false;
  bool closed_form = true;       ///< v* is Eq. 24, else simulated
  double critical_velocity = 0;  ///< of the motion, m/s; may be infinite
  double drive_velocity = 0;     ///< the same of the drive
  double border = 0;             ///< du_z/u_z0 beyond which the contact opens
  std::vector<ShownEquation>
      derivation;                     ///< of v* where the contact opens; empty without closed form
  std::vector<FrictionCurve> curves;  ///< by increasing amplitude
  StateMap map;                       ///< rows: v0 over v* by Eq. 24
};

/// A scene with an indenter.
struct Indented {
  bool closed_form = true;       ///< v* is Eq. 24, else simulated
  double critical_velocity = 0;  ///< m/s
  double radius = 0, edge = 0;   ///< of contact, under the mean and the largest indentation, m
  double normal_force = 0;       ///< mean, N
  std::vector<FrictionCurve> amplitudes;  ///< of this shape, by increasing du_z/u_z0
  std::vector<FrictionCurve> shapes;      ///< at this du_z/u_z0
  double map_ratio = 0;                   ///< v0 over v* of the map
  StateMap map;                           ///< rows: x over `edge`
};

struct SceneReport {
  explicit SceneReport(Problem of) : problem(std::move(of)) {}

  Problem problem;
  std::string
      failure;  ///< why all that follows is missing but for one broken comparison, else empty
  std::vector<std::string> reasons;  ///< why the scene is not admissible; empty when it is
  bool formula_applies = true;       ///< admissible, and v* is Eq. 24
  std::vector<int> free_harmonics;   ///< n > 1 where an undamped drive swings freely at n omega
  double sliding_from = 0;           ///< m/s; below v* where there are such n, NaN where not known
  double critical_velocity = 0;      ///< m/s, certified; may be infinite
  double relative_error_bound = 0;   ///< of it
  /// m/s, of the doubles next to the numbers as they were typed: evaluators and simulators take
  /// doubles, and what they find is compared with this.
  double velocity_of_doubles = 0;
  std::string infinite_reason;  ///< why it is infinite, else empty
  double condition = 0;         ///< condition number of Eq. 24 on its inputs
  double creep_velocity = 0;    ///< m/s, 0 unless a network on the path creeps
  std::vector<ValueLine> values;
  std::vector<Influence> influences;        ///< the largest first, without those of no influence
  std::optional<NormalForce> normal_force;  ///< none where no load is carried
  ShownVelocity formula;
  std::vector<ShownFact> facts;
  std::optional<Effect> effect;  ///< what vibration does to this contact
  std::string equation;          ///< number of the formula in the paper
  std::vector<ShownEquation> derivation;
  std::vector<LimitLine> limits;
  std::string compiler;  ///< that compiled the generated evaluator, with version; else empty
  std::vector<Comparison> comparisons;
  std::vector<ComparedPoint> curve;  ///< by increasing speed; empty when nothing was simulated
  std::vector<MethodCurve> methods;  ///< beside the exact one, on the same curve
  std::optional<Cycle> cycle;
  FrequencyResponse response;
  std::optional<ReducedModel> reduced_model;  ///< where the paper's reduced model applies
  std::optional<Separation> separation;       ///< of a contact that may open
  std::optional<Indented> indented;           ///< below an indenter, in place of curve and cycle
};

std::size_t count(const std::vector<Comparison>& comparisons, Comparison::Outcome what);
/// The comparison nearest to (or farthest beyond) its tolerance; none if none was run.
const Comparison* tightest(const std::vector<Comparison>& comparisons);

/// No comparison failed. Those not run neither pass nor fail: see count().
bool passed(const SceneReport& report);
std::size_t count(const SceneReport& report, Comparison::Outcome what);
const Comparison* tightest(const SceneReport& report);

}  // namespace vcrit::validation
