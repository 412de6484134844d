#include "report/claims.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace vcrit::validation::report {

namespace {

struct ClaimRow {
  std::string_view key;
  ComparisonWords claim;
};

constexpr const char* same_formula = "the formula itself, Eq. (24)";
constexpr const char* same_motion = "the law of motion of the networks";
constexpr const char* same_model = "the model alone: which elements there are, and Coulomb’s law";

constexpr std::array claim_rows{
    ClaimRow{"formula",
             {"v* in double precision = v* correctly rounded", "interval arithmetic (Arb)",
              same_formula}},
    ClaimRow{"derived",
             {"v* of the derived formula = v* of Eq. (24)",
              "computer algebra, evaluated with 50 digits", "the equations of motion"}},
    ClaimRow{"generated",
             {"v* of the generated C++ code = v* of Eq. (24)", "compiled and run by itself",
              same_formula}},
    ClaimRow{"generated_batch",
             {"v* of the generated batch call = v* of Eq. (24)", "compiled and run by itself",
              same_formula}},
    ClaimRow{"generated_fast",
             {"v* of the generated fast call = v* of Eq. (24)", "compiled and run by itself",
              same_formula}},
    ClaimRow{"generated_certified",
             {"v* of the generated certified call = v* of Eq. (24)", "compiled and run by itself",
              same_formula}},
    ClaimRow{"balance",
             {"continuous sliding begins at v* of Eq. (24)",
              "harmonic balance of the simulator’s own model",
              "the same linear response, from networks in another form"}},
    ClaimRow{"simulation",
             {"v* from the formula = v* from stick-slip simulation",
              "motion between events in closed form, started at rest", same_model}},
    ClaimRow{"harmonics",
             {"v* as a maximum over the phase = the same by harmonics",
              "Fourier’s series of the normal force and the drive’s answer to each harmonic",
              "the numbers of the system"}},
    ClaimRow{"creep",
             {"v* with creep = the same from simulation", "motion between events in closed form",
              same_model}},
    ClaimRow{"evaluators",
             {"the worst of all evaluators = v* from simulation",
              "motion between events in closed form, started at rest", same_model}},
    ClaimRow{"marched",
             {"sticks just below v*, slides just above it",
              "another method in time, with steps of its own", "the numbers of the system"}},
    ClaimRow{
        "periodic",
        {"sticks end at v*", "periodic motion on a grid, all networks solved as one", same_model}},
    ClaimRow{"starts",
             {"friction from rest = friction from sliding", "the same simulator, another start",
              same_motion}},
    ClaimRow{"closed_form",
             {"the friction curve = its closed form", "a formula of elastic contacts", same_model}},
    ClaimRow{"energy",
             {"heat over a cycle = work of the drive", "the balance of energy", same_motion}},
    ClaimRow{"small_amplitude",
             {"a small amplitude lowers friction in proportion",
              "the simulation at half the amplitude", same_motion}},
    ClaimRow{"static_limit",
             {"friction at vanishing speed = its limit", "the least normal force, without motion",
              same_model}},
    ClaimRow{"quasi_static",
             {"friction at a very low frequency = that of an elastic contact",
              "the elastic contact of the stiffness at rest", same_motion}},
};

}  // namespace

ComparisonWords claim_of(const Comparison& comparison) {
  const auto* const found =
      std::find_if(claim_rows.begin(), claim_rows.end(),
                   [&](const ClaimRow& row) { return row.key == comparison.key; });
  if (found != claim_rows.end()) return found->claim;
  return {comparison.name.c_str(), comparison.reference.c_str(), ""};
}

}  // namespace vcrit::validation::report
