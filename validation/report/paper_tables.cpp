#include "report/paper_tables.hpp"

#include <fmt/core.h>

#include <cmath>

#include "report/number_table.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

std::string plain(double value) { return fmt::format("{:g}", value); }
std::string places(double value, int digits) { return fmt::format("{:.{}f}", value, digits); }

/// What a method is off, as "−1.4 × 10⁻⁸".
std::string off(double value, double reference) {
  const double apart = value - reference;
  return (apart < 0 ? "−" : "") + magnitude(std::abs(apart));
}

}  // namespace

std::string jump_table(const paper::JumpLimits& limits) {
  std::vector<Cells> rows;
  for (const paper::JumpLimit& row : limits.rows)
    rows.push_back({plain(row.delta), plain(row.printed), places(row.formula, 15),
                    places(row.by_admissibility, 15), places(row.by_simulator, 15)});
  return number_table(
      {"δ", "printed", "1/√(1 + δ²)", "bisection, admissibility", "bisection, simulator"}, rows,
      "The largest D at which the normal force stays positive.");
}

std::string static_table(const paper::StaticLimit& limit) {
  Cells headings{"δ", "model"};
  for (const double ratio : limit.ratios) headings.push_back(fmt::format("v₀/v* = {:g}", ratio));
  headings.insert(headings.end(), {"limit", "power"});
  std::vector<Cells> rows;
  for (const paper::StaticRow& row : limit.rows) {
    Cells full{plain(row.delta), "full"}, reduced{plain(row.delta), "reduced"};
    for (const double value : row.full) full.push_back(places(value, 6));
    for (const double value : row.reduced) reduced.push_back(places(value, 6));
    full.insert(full.end(), {places(row.limit, 6), places(row.slopes.back(), 3)});
    reduced.insert(reduced.end(), {places(row.reduced_limit, 6), "1"});
    rows.push_back(full);
    rows.push_back(reduced);
  }
  return number_table(
      headings, rows,
      "Friction ratio with F<sub>n</sub> = mean × (1 ± 0.9). Power: of v₀/v*, with which "
      "it comes near "
      "its limit, between the last two speeds; of the reduced model as derived.");
}

std::string crossing_table(const paper::Viscosity& viscosity) {
  std::vector<Cells> rows;
  for (const paper::Crossing& row : viscosity.crossings) {
    const std::string delta = row.delta == 0          ? "→ 0"
                              : std::isinf(row.delta) ? "→ ∞"
                                                      : plain(row.delta);
    rows.push_back(
        {delta, places(row.ratio, 10), places(row.weakening, 10), places(row.strengthening, 10)});
  }
  return number_table({"δ", "v<sub>c</sub>/v*", "most weakening", "most strengthening"}, rows,
                      "At equal relative amplitude: the speed v<sub>c</sub> at which viscosity "
                      "changes nothing; how much of μ/μ₀ it takes from the reduction below that "
                      "speed, and adds above, at most, per a.");
}

std::string punch_table(const paper::FlatPunch& punch) {
  std::vector<Cells> rows;
  for (const paper::PunchRow& row : punch.rows)
    rows.push_back({plain(row.ratio), places(row.reference, 15), off(row.simulated, row.reference),
                    off(row.closed_form, row.reference), off(row.fit, row.reference)});
  return number_table({"v₀/v*", "G, 20 digits", "simulation", "closed form", "fit"}, rows,
                      "G of the friction ratio 1 − D G, and how far from it each is.");
}

std::string witness_table(const paper::Evidence& evidence) {
  Cells headings{"δ", "v₀/v*", "25 digits", "reduced", "exact"};
  for (const int steps : evidence.steps) headings.push_back(fmt::format("Moreau {}", steps));
  headings.emplace_back("rk8pd");
  std::vector<Cells> rows;
  for (const paper::Witness& row : evidence.rows) {
    Cells cells{plain(row.delta), plain(row.ratio), places(row.reference, 12),
                fmt::format("<strong>{:+.6f}</strong>", row.reduced - row.reference),
                off(row.exact, row.reference)};
    for (const double value : row.moreau) cells.push_back(off(value, row.reference));
    cells.push_back(off(row.adaptive, row.reference));
    rows.push_back(cells);
  }
  return number_table(
      headings, rows,
      "Friction ratio with F<sub>n</sub> = mean × (1 ± 0.9) in 25 digits (12 of them "
      "here), and how "
      "far from it each is. Moreau’s method with so many steps a period.");
}

}  // namespace vcrit::validation::report
