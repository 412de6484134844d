#include "rules/cells.hpp"

#include <array>

#include "network/law.hpp"

namespace vcrit::rules {

namespace {

constexpr Cell refused(const char* reason, const char* advice = "") {
  return {Ruling::refused, reason, advice};
}
constexpr Cell left_out(const char* reason) { return {Ruling::left_out, reason}; }
constexpr Cell yes{Ruling::yes};

// As no_law, but nothing here asks for a rational function.
constexpr const char* not_causal =
    "lossy(k, eta) is not causal: a stiffness k (1 + i eta) at one frequency defines no motion in "
    "time";
constexpr const char* not_causal_advice =
    "a Zener body or a Prony series fitted around that frequency has a motion";
constexpr Cell lossy_motion = refused(not_causal, not_causal_advice);
constexpr Cell lossy_law = refused(no_law, no_law_advice);
constexpr Cell each_place =
    refused("an indenter has no single contact motion: each place below it moves differently",
            "vcrit simulate answers for one set of numbers, vcrit sweep for many");
constexpr Cell no_cells = refused("the scene has no [indenter]");
constexpr Cell no_methods = refused("does not support [indenter]", "use `method exact`");

constexpr Cell without_memory_code = refused(
    "this contact opens (separation = true), so v* follows Eq. (24) only while it is closed where "
    "the indentation grows fastest, and an evaluator cannot tell whether it is",
    "use vcrit eval, or leave out separation = true for an evaluator of the closed contact");
constexpr Cell memory_code =
    refused("no closed form of v* where this contact opens (separation = true)",
            "leave out separation = true for an evaluator of the closed contact");
constexpr Cell measured_polynomial =
    refused("a measured receptance is a table, so v* has no rational form");
constexpr Cell lossy_polynomial = refused(
    "lossy(k, eta) is no rational function of s, from which the rational form of v* is made",
    "`form expanded` has v* multiplied out");
constexpr Cell contact_polynomial =
    refused("a measured stiffness is a table, so v* has no rational form");
constexpr Cell no_symbols = refused(
    "where the contact opens (separation = true) v* has no formula of all symbols to compare with");
constexpr Cell no_comparison =
    refused("no closed form of v* where this contact opens, so there is nothing to compare with",
            "vcrit eval gives the simulated v*, and vcrit validate compares it with the motion");

constexpr Cell no_load = refused("the normal network carries no static load: K_n(0) = 0");
constexpr Cell no_modulus = refused("the half-space carries no static load: E(0) = 0");
constexpr Cell no_friction = refused("with {mu0} = 0 there is no friction to compare with");
constexpr Cell no_indentation =
    refused("without an indentation {u_z0} the contact carries no load");
constexpr Cell never_closes = refused("the contact never closes");
constexpr Cell never_closed =
    refused("without an indentation {u_z0} the contact opens at every amplitude");
// What keeps a contact closed that must not open, and what lets it.
constexpr const char* let_it_open =
    "take {what_keeps_it_closed}, or let the contact open: separation = true in [contact]";
constexpr Cell too_large = refused(
    "the amplitude {du_z} = {amplitude} is not below the indentation {u_z0} = {indentation} "
    "(Eq. 3)",
    let_it_open);
// The same of a contact that may open, asked where it stays closed.
constexpr Cell too_large_anywhere = refused(too_large.reason);
constexpr Cell opens_closed = refused(
    "the contact opens: the normal force oscillates by {du_z} |K_n| = {oscillating} about a mean "
    "of {load} = {mean} (Eq. 4)",
    let_it_open);
constexpr Cell opens_moving =
    refused("the contact opens: F_n oscillates by {oscillating} about a mean of {mean} (Eq. 4)",
            let_it_open);
constexpr Cell opens_all_over = refused(
    "the whole contact opens: even at its centre the pressure oscillates by more than its mean "
    "(Eq. 4)",
    let_it_open);
constexpr Cell opens_at_tip =
    refused("the whole contact opens: at the tip F_n oscillates by {share} times its mean (Eq. 4)",
            let_it_open);

// Of a contact that creeps as long as it is loaded.
constexpr Cell sinks_opening = refused(
    "the contact opens (separation = true) and its normal network creeps, K_n(0) = 0: under a load "
    "it sinks for ever, so it has no mean depth",
    "take {what_keeps_it_closed}, or add a spring in parallel to the normal network");

// Height and force of a contact that opens below a mount.
constexpr Cell mounted = refused(
    "below a mount, a contact that may open (separation = true) needs a load for its mean force, "
    "and none is given",
    "give [load] force instead of the indentation, or leave out separation = true");
constexpr Cell reacting = refused(
    "below a mount with mass, a contact that may open (separation = true) can have several steady "
    "motions: height and force react on each other",
    "leave out separation = true");
constexpr Cell mounted_then = left_out("v* is not known for a contact that opens below a mount");
constexpr Cell mounted_frequency = left_out(
    "below a mount the contact's amplitude depends on the frequency, so there is no largest "
    "frequency up to which it stays closed");

constexpr Cell sinks_as_it_opens =
    left_out("under its load the contact sinks for ever and opens in each cycle");

constexpr Cell memory = left_out(
    "the contact opens, and its tangential deformation depends on more than the normal one at that "
    "instant");
constexpr Cell open_then = left_out("the contact is open where the indentation grows fastest");
constexpr Cell table_alone = left_out("v* is known only at the frequencies of the table");
constexpr Cell one_frequency = left_out("lossy(k, eta) is known at one frequency at a time");
constexpr Cell no_lossy_motion = left_out(not_causal);
constexpr Cell closed_alone = left_out("available only for a contact that stays closed");
constexpr Cell one_contact = left_out("available only for a single contact, not below an indenter");
constexpr Cell networks_alone =
    left_out("available only for networks of springs and dampers, without masses or tables");
constexpr Cell inadmissible = left_out("available only inside the model");

// Of an indenter on a compliant drive.
constexpr Cell by_phase = left_out(
    "with an indenter on a compliant drive, v* is the largest value of a speed over one period");
constexpr Cell no_formula = refused(
    "with an indenter on a compliant drive, v* has no formula: it is the largest value of a speed "
    "over one period",
    "vcrit eval gives v*, and vcrit simulate the friction below it");
constexpr Cell measured_holder = refused(
    "below an indenter the drive must be a network of springs and dampers, and this one is a "
    "measured receptance",
    "give [drive] network = \"...\", or leave out [drive]");
constexpr Cell masses_hold = refused(
    "below an indenter the drive must be a network of springs and dampers, and this one has masses",
    "leave the masses out, or give the body's own mass in [body]");

// Of a contact that was measured.
constexpr Cell measured_motion = refused(measured_law, measured_law_advice);
constexpr Cell measured_code = refused(
    "the contact's stiffness is measured: an evaluator would keep it fixed while omega varies",
    "vcrit sweep follows the table; vcrit fit turns it into a network, which has an evaluator");
constexpr Cell measured_symbols = refused(
    "the contact's stiffness is a table, so v* has no formula of all symbols to compare with",
    "compare numbers instead: vcrit sweep follows the table");
constexpr Cell measured_frequencies =
    refused("the contact's stiffness is known only at the frequencies of its table");
constexpr Cell measured_still = left_out(measured_law);

struct Row {
  Question question;
  std::array<Cell, kinds> cells;
};

// In the order of Kind:
//   measured, masses, lossy | indenter, none | separating, without memory, with memory
//   no load, below indenter, no friction, no indentation, tapping, never closing
//   (3), deep | (4), below indenter | opening with memory, open where steepest
//   sinking, and opening | mount, separating, with mass
//   indenter on a compliant drive, viscoelastic | measured contact
constexpr Cell y = yes;
// clang-format off
constexpr std::array<Row, questions> table{{
    {Question::admissible,
     {y, y, y, y, y, y, y, y,
      no_load, no_load, y, no_indentation, y, never_closes,
      too_large, y, opens_closed, opens_all_over, y, y,
      y, sinks_opening,
      y, mounted, reacting,
      y, y,
      y}},
    {Question::formula,
     {y, y, y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y, y, y, memory, open_then,
      y, sinks_as_it_opens,
      y, mounted_then, mounted_then,
      by_phase, by_phase,
      y}},
    {Question::closed_form,
     {y, y, y, y, y, y, y, memory,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, mounted_then, mounted_then,
      by_phase, by_phase,
      y}},
    {Question::formula_of_all_values,
     {y, y, y, y, y, y, no_symbols, no_symbols,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, no_symbols, no_symbols,
      no_formula, no_formula,
      measured_symbols}},
    {Question::evaluator,
     {y, y, y, y, y, y, without_memory_code, memory_code,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, mounted, reacting,
      no_formula, no_formula,
      measured_code}},
    {Question::rational_form,
     {measured_polynomial, y, lossy_polynomial, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, y, y,
      no_formula, no_formula,
      contact_polynomial}},
    {Question::all_frequencies,
     {table_alone, y, one_frequency, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, y, y,
      y, y,
      table_alone}},
    {Question::motion,
     {y, y, lossy_motion, each_place, y, y, y, y,
      no_load, y, no_friction, y, y, never_closes,
      too_large, y, opens_moving, y, y, y,
      y, sinks_opening,
      y, mounted, reacting,
      y, y,
      measured_motion}},
    {Question::motion_below_indenter,
     {measured_holder, masses_hold, lossy_law, y, no_cells, y, y, y,
      y, no_modulus, no_friction, y, y, never_closes,
      too_large, y, y, opens_at_tip, y, y,
      y, y,
      y, y, y,
      y, y,
      measured_motion}},
    {Question::normal_motion,
     {y, y, lossy_motion, y, y, y, y, y,
      no_load, no_modulus, y, y, y, y,
      y, y, y, y, y, y,
      y, sinks_opening,
      y, mounted, reacting,
      y, y,
      measured_motion}},
    {Question::motion_in_time,
     {y, y, lossy_motion, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, mounted, reacting,
      y, y,
      measured_motion}},
    {Question::comparison,
     {y, y, lossy_motion, y, y, y, y, y,
      no_load, no_modulus, no_friction, y, y, never_closes,
      y, y, y, y, no_comparison, no_comparison,
      y, sinks_opening,
      y, mounted, reacting,
      no_formula, no_formula,
      measured_motion}},
    {Question::other_methods,
     {y, y, y, no_methods, y, y, y, y,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, y, y,
      y, y,
      y}},
    {Question::report_simulation,
     {y, y, no_lossy_motion, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, closed_alone, closed_alone,
      y, y,
      measured_still}},
    {Question::report_explorer,
     {y, y, y, each_place, y, y, y, y,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, closed_alone, closed_alone,
      y, y,
      table_alone}},
    {Question::report_stability,
     {networks_alone, networks_alone, no_lossy_motion, one_contact, y, closed_alone, y, y,
      inadmissible, inadmissible, y, inadmissible, y, inadmissible,
      inadmissible, y, inadmissible, inadmissible, y, y,
      y, inadmissible,
      y, inadmissible, inadmissible,
      y, y,
      measured_still}},
    {Question::mean_load,
     {y, y, y, y, y, y, y, y,
      no_load, no_load, y, no_indentation, y, y,
      y, y, y, y, y, y,
      y, y,
      y, y, y,
      y, y,
      y}},
    {Question::closed_range,
     {y, y, y, y, y, y, y, y,
      y, y, y, y, never_closed, never_closed,
      too_large_anywhere, too_large_anywhere, y, y, y, y,
      y, y,
      mounted_frequency, y, y,
      y, y,
      measured_frequencies}},
    {Question::closed_amplitude,
     {y, y, y, y, y, y, y, y,
      y, y, y, y, never_closed, never_closed,
      y, y, y, y, y, y,
      y, y,
      y, y, y,
      y, y,
      y}},
    {Question::derivation,
     {y, y, y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y, y, y, y, y,
      y, y,
      y, y, y,
      no_formula, no_formula,
      y}},
}};
// clang-format on

// A question or a kind without its cell is no program.
constexpr bool complete() {
  for (std::size_t row = 0; row < questions; ++row) {
    if (table[row].question != static_cast<Question>(row)) return false;
    for (const Cell& each : table[row].cells)
      if (each.verdict == Ruling::unset) return false;
  }
  return true;
}
static_assert(complete());

}  // namespace

const Cell& table_entry(Question question, SceneKind kind) {
  return table[static_cast<std::size_t>(question)].cells[static_cast<std::size_t>(kind)];
}

}  // namespace vcrit::rules
