#include "paper/proofs.hpp"

#include <fmt/core.h>

#include "analysis/limits.hpp"
#include "compare/formulas.hpp"
#include "derivation/derivation.hpp"
#include "formula/symbols.hpp"
#include "formula/value.hpp"
#include "network/catalogue.hpp"
#include "paper/comparing.hpp"

namespace vcrit::validation::paper {

namespace {

using GiNaC::ex;

// Typed in. (30) is legible in the source at hand; there (29) lacks its roots and the factor
// k_n/k_t, and (31) is blank: these two, and (27), are worked out by hand.
ex of(const char* name) { return symbolic::symbol({name}); }
ex friction_speed() { return of("mu0") * of("omega") * of("du_z"); }
ex reach() { return of("kd") - of("m") * GiNaC::pow(of("omega"), 2); }  // k_d - m omega^2
bool is_legible(const std::string& equation) { return equation == "(30)"; }
/// Kelvin contact with damping of its own along and across: |K_n/K_t|, |K_t + K_d - m omega^2|.
ex equation_27() {
  const auto amount = [](const ex& real, const ex& loss) {
    return GiNaC::sqrt(GiNaC::pow(real, 2) + GiNaC::pow(of("omega") * loss, 2));
  };
  return friction_speed() * amount(of("kn"), of("cn")) / amount(of("kt"), of("ct")) *
         amount(of("kt") + reach(), of("ct")) / GiNaC::abs(reach());
}
ex equation_29() {
  const ex loss = of("omega") * of("cn"), storage = of("kn") / of("kt") * (of("kt") + reach());
  return friction_speed() / GiNaC::abs(reach()) *
         GiNaC::sqrt(GiNaC::pow(loss, 2) + GiNaC::pow(storage, 2));
}
ex equation_30() {
  return friction_speed() * of("kn") / of("kt") * GiNaC::abs(of("kt") + reach()) /
         GiNaC::abs(reach());
}
ex equation_31() { return friction_speed() * of("kn") / of("kt"); }

/// In a square absolute values do not matter.
struct WithoutAbs : GiNaC::map_function {
  ex operator()(const ex& e) override {
    if (GiNaC::is_a<GiNaC::function>(e)) return e.op(0).map(*this);
    return e.map(*this);
  }
};

/// Numbers without meaning, for people to see: the n-th symbol is the n-th prime over 7.
std::map<Symbol, GiNaC::numeric> sample() {
  std::map<Symbol, GiNaC::numeric> values;
  long prime = 7;
  for (const char* name : {"mu0", "omega", "du_z", "kn", "cn", "kt", "kd", "m", "ct"}) {
    do ++prime;
    while (!GiNaC::is_prime(prime));
    values[{name}] = GiNaC::numeric(prime, 7);
  }
  return values;
}

Problem problem_of(const std::string& contact, const std::string& rest = {}) {
  return parse_problem("[contact]\n" + contact + "\n" + rest, "paper");
}
const char* const elastic = "normal = \"kn\"\ntangential = \"kt\"";
const char* const surroundings = "[drive]\nnetwork = \"kd\"\n[body]\nmass = \"m\"\n";

class Prover {
 public:
  /// `derived` must be `equation` as written by hand.
  void prove(const std::string& equation, const std::string& words, const ex& derived,
             const ex& by_hand) {
    proofs_.proofs.push_back(
        {equation, words, formula_of(derived), formula_of(by_hand), is_legible(equation)});
    const auto value = [](const ex& v) { return symbolic::value_at(v, {}, sample()).to_double(); };
    Comparison result =
        comparison({"equation", equation + ", " + words, "the formula typed in",
                    "proved equal for all values; these are at one point, each of them rounded "
                    "by 17 digits of arithmetic",
                    Comparison::Measure::relative},
                   {value(by_hand), value(derived), 1e-15, ""});
    result.broken = !equal_velocities(derived, by_hand);
    if (result.broken) result.detail = "the two formulas are different functions";
    proofs_.comparisons.push_back(result);
  }

  void prove_limit(const std::string& equation, const std::string& words, const Problem& problem,
                   const std::string& name, const ex& by_hand, const GiNaC::exmap& names = {}) {
    for (const symbolic::Limit& limit : symbolic::limits(symbolic::derive(problem)))
      if (limit.name == name) return prove(equation, words, limit.result.subs(names), by_hand);
    throw Bug("no limit " + name);
  }

  Proofs take() { return std::move(proofs_); }
  Proofs& proofs() { return proofs_; }

 private:
  Proofs proofs_;
};

/// An isotropic contact has k_t = r k_n: written in k_n and k_t, as the paper does.
GiNaC::exmap ratio_of_springs() { return {{of("r"), of("kt") / of("kn")}}; }

void prove_by_scenes(Prover& prover) {
  const Problem kelvin =
      problem_of("normal = \"kelvin(kn, cn)\"\ntangential_ratio = \"r\"", surroundings);
  const Problem driven = problem_of(elastic, surroundings), rigid = problem_of(elastic);
  const auto names = ratio_of_springs();
  const Problem two_kelvins =
      problem_of("normal = \"kelvin(kn, cn)\"\ntangential = \"kelvin(kt, ct)\"", surroundings);
  prover.prove("(27)", "Kelvin contact, elastic drive, body",
               symbolic::derive(two_kelvins).critical_velocity, equation_27());
  prover.prove("(29)", "isotropic Kelvin contact, elastic drive, body",
               symbolic::derive(kelvin).critical_velocity.subs(names), equation_29());
  prover.prove_limit("(30)", "isotropic Kelvin contact, elastic drive, body; dampers to zero",
                     kelvin, "cn -> 0", equation_30(), names);
  prover.prove("(30)", "elastic contact, elastic drive, body",
               symbolic::derive(driven).critical_velocity, equation_30());
  prover.prove_limit("(31)", "elastic contact, drive to rigid, which leaves no mass", driven,
                     "kd -> infinity", equation_31());
  prover.prove_limit("(31)", "Kelvin contact, dampers to zero and drive to rigid", kelvin,
                     "cn -> 0, kd -> infinity", equation_31(), names);
  prover.prove("(31)", "elastic contact, rigid drive", symbolic::derive(rigid).critical_velocity,
               equation_31());
}

/// Limits taken here once more, by putting values into the formulas typed in.
void prove_on_paper(Prover& prover) {
  const auto bare = [](const ex& e) { return WithoutAbs()(GiNaC::pow(e, 2)); };
  const ex no_dampers = bare(equation_29()).subs(of("cn") == 0);
  prover.prove("(30)", "(29) with c_n = 0", GiNaC::sqrt(no_dampers), equation_30());
  const ex softness = of("x");  // 1/k_d
  const ex massless = bare(equation_30()).subs(GiNaC::lst{of("m") == 0, of("kd") == 1 / softness});
  prover.prove("(31)", "(30) with m = 0 and then 1/k_d = 0",
               GiNaC::sqrt(massless.normal().subs(softness == 0)), equation_31());
}

/// mu0 omega du_z/r whatever the contact is made of.
void prove_constant(Prover& prover) {
  constexpr int branches = 3;
  const ex constant = friction_speed() / of("r");
  Comparison result =
      comparison({"no_rheology", "v* of isotropic contacts under a rigid drive, by derivation",
                  "mu0 omega du_z K_n/K_t for each named rheology", "a count of proved equalities"},
                 {});
  for (const Rheology& rheology : catalogue()) {
    std::string call = rheology.signature();
    if (rheology.has_arrays()) call.insert(call.size() - 1, fmt::format(", {}", branches));
    if (rheology.in_drives_only()) continue;
    const Problem problem = problem_of("normal = \"" + call + "\"\ntangential_ratio = \"r\"");
    ++result.expected;
    prover.proofs().rheologies.push_back(call);
    if (equal_velocities(symbolic::derive(problem).critical_velocity, constant)) ++result.found;
  }
  prover.proofs().comparisons.push_back(result);
}

}  // namespace

// Equal squares make them equal; the squares are rational functions, of which the normal form
// decides.
bool equal_velocities(const ex& a, const ex& b) {
  WithoutAbs bare;
  return (bare(GiNaC::pow(a, 2)) - bare(GiNaC::pow(b, 2))).normal().is_zero();
}

Proofs prove_equations() {
  Prover prover;
  prove_by_scenes(prover);
  prove_on_paper(prover);
  prove_constant(prover);
  return prover.take();
}

}  // namespace vcrit::validation::paper
