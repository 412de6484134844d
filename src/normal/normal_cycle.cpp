#include "normal/normal_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "modes/linear_solver.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit::simulation {

namespace {

// The fixed point of the period map, from a state in the middle of the longest separation on, by
// Newton's method. The energy distance between two motions never grows, so plain periods are the
// safe way where a step misses.
class NormalCycleSearch {
 public:
  NormalCycleSearch(const ContactModes& network, const Indentation& indentation, Effort& effort)
      : network_(network),
        indentation_(indentation),
        effort_(effort),
        contact_(network, indentation, effort) {}

  NormalCycle run() {
    auto found = run([](const Period&) {});
    return found ? *std::move(found) : closed();
  }

  PressedCycle run_with_slope() {
    double slope = network_.branch_stiffness[0];
    auto found = run([&](const Period& now) { slope = std::clamp(slope_at(now), 0.0, slope); });
    return {found ? *std::move(found) : closed(), slope};
  }

 private:
  struct Period;

  // Nothing where the contact stays closed; use(period) of the one that is found.
  template <class Use>
  std::optional<NormalCycle> run(const Use& use) {
    const NormalState start = contact_.start();
    // As by far not |K(i)| amplitude > K(0) mean.
    if (!(contact_.gap(start) > 0)) return std::nullopt;
    try {
      const Period found = searched(start);
      use(found);
      return finished(found);
    } catch (const ModelError&) {
      if (beyond_closed() > hardly * closed_mean()) throw;
      return std::nullopt;
    }
  }

  Period searched(const NormalState& start) {
    auto from = settled(start, 1);
    std::optional<Period> now = mapped(from);
    for (int plain = 1; now && plain < most_periods; plain *= 2) {
      now = newton(*std::move(now));
      if (now->size <= nearly) return *std::move(now);
      from = settled(now->start, plain);
      now = mapped(from);
    }
    throw ModelError(
        "no steady normal force found: the contact still creeps after many periods, or recovers so "
        "slowly that its short touches are lost in rounding");
  }

  // A contact that opens by less than this share of the mean force is taken for closed where
  // rounding hides how it opens: for how long goes with its root, and how far with its power of
  // 3/2.
  static constexpr double hardly = 1e-4;
  static constexpr int most_periods = 2000;
  static constexpr std::size_t most_stays = 10'000;
  // A residual of so many rounding errors may be rounding itself where no step makes it smaller.
  static constexpr double nearly = 1e3;

  // Newton's steps, some tens of which are needed over twenty decades of impulse; less than this of
  // one leads nowhere.
  static constexpr int most_steps = 200;
  static constexpr double least_share = 1e-6;

  struct Period {
    NormalState start;
    List<NormalStay, 4> stays;
    NormalIntegrals sums;
    Vector residual, unit;  ///< and the rounding error of each
    double size = 0;        ///< of the residual, in rounding errors
  };

  // Stays from a separated state on over a duration, and on to where the last one ends by an event.
  template <class Use>
  void follow(NormalState state, double end, NormalIntegrals& sums, bool to_event,
              const Use& use) const {
    bool closed = false;
    NormalStay stay{};
    for (std::size_t i = 0; i < most_stays; ++i) {
      const NormalState before = state;
      const double limit = to_event ? state.time + 2 * two_pi : end;
      const bool event = closed ? contact_.stay_closed(state, limit, stay, sums)
                                : contact_.stay_apart(state, limit, stay, sums);
      use(stay, before, state);
      if (!event || (to_event && state.time >= end)) return;
      closed = !closed;
    }
    throw ModelError("the contact closes and opens without end within one period");
  }

  // The middle of the longest separation after some periods; nothing if the contact never opens.
  std::optional<NormalState> settled(NormalState start, int periods) const {
    start.strains = first_column(start.strains);
    const double end = start.time + two_pi * periods;
    NormalIntegrals ignored(contact_.units(), 1);
    std::optional<NormalState> result;
    double longest = 0;
    follow(start, end, ignored, true,
           [&](const NormalStay& stay, const NormalState& before, const NormalState&) {
             if (stay.closed || !before.released || stay.begin < end - 1.01 * two_pi) return;
             if (stay.duration <= longest) return;
             longest = stay.duration;
             result = before;
           });
    if (!result) return result;
    for (Index j = 0; j < contact_.units(); ++j)
      result->strains(j, 0) *= std::exp(-network_.unit_rates[j] * 0.5 * longest);
    result->time += 0.5 * longest;
    result->time -= two_pi * std::round(result->time / two_pi);
    result->released = false;
    return result;
  }

  static Matrix first_column(const Matrix& strains) {
    Matrix result(strains.rows(), 1);
    std::copy(strains.column(0).begin(), strains.column(0).end(), result.column(0).begin());
    return result;
  }

  // One period; nothing unless it begins and ends separated. What a strain changes by in it is
  // psi_j times the impulse less beta_j times its integral: with a slow unit a small part of the
  // strain.
  std::optional<Period> mapped(const std::optional<NormalState>& start, bool deeper = false) const {
    if (!start || !(contact_.gap(*start) > 0)) return std::nullopt;
    const Index n = contact_.units(), columns = n + (deeper ? 2 : 1);
    Period result{*start, {}, NormalIntegrals(n, columns), {}, {}, 0};
    NormalState state = *start;
    state.strains = Matrix(n, columns);
    if (deeper) state.deeper = n + 1;
    for (Index j = 0; j < n; ++j) {
      state.strains(j, 0) = start->strains(j, 0);
      state.strains(j, j + 1) = 1;
    }
    follow(state, state.time + two_pi, result.sums, false,
           [&](const NormalStay& stay, const NormalState&, const NormalState&) {
             result.stays.push_back(stay);
           });
    if (result.stays.back().closed) return std::nullopt;
    for (Index j = 0; j < n; ++j) {
      const double rate = network_.unit_rates[j], fluidity = network_.unit_fluidity[j];
      const double kept = std::min(1.0, two_pi * rate) * std::abs(start->strains(j, 0));
      result.residual.push_back(fluidity * result.sums.impulse[0] -
                                rate * result.sums.strains(j, 0));
      result.unit.push_back(8 * epsilon * (fluidity * result.sums.size + kept));
    }
    result.size = in_units(result.residual, result.unit);
    return result;
  }

  LinearSolver solver(const Period& now) const {
    const Index n = contact_.units();
    effort_.spend(Effort::of_products(LinearSolver::work(n)));
    Matrix derivative(n, n);
    Vector sizes;
    for (Index j = 0; j < n; ++j) {
      const double rate = network_.unit_rates[j], fluidity = network_.unit_fluidity[j];
      sizes.push_back(fluidity / rate * std::abs(contact_.swing()));
      for (Index k = 0; k < n; ++k)
        derivative(j, k) = rate * now.sums.strains(j, k + 1) - fluidity * now.sums.impulse[k + 1];
    }
    return {std::move(derivative), sizes};
  }

  Period newton(Period now) const {
    for (int i = 0; i < most_steps && now.size > 1; ++i) {
      auto trial = stepped(now);
      if (!trial) break;
      now = *std::move(trial);
    }
    return now;
  }

  // As much of Newton's step as brings half of what it promises: where the contact is closed for a
  // short time, the impulse goes with the depth to the power of 3/2, and from no touch at all a
  // whole step leads into a long one.
  std::optional<Period> stepped(const Period& now) const {
    const Vector step = solver(now).solve(now.residual);
    for (double share = 1; share > least_share; share /= 4) {
      NormalState next = now.start;
      add(step, share, next.strains.column(0));
      auto trial = mapped(next);
      if (trial && in_units(trial->residual, now.unit) < (1 - 0.5 * share) * now.size) return trial;
    }
    return std::nullopt;
  }

  static double in_units(const Vector& residual, const Vector& unit) {
    double size = 0;
    for (Index j = 0; j < residual.size(); ++j)
      if (residual[j] != 0) size = std::max(size, std::abs(residual[j]) / unit[j]);
    return size;
  }

  // One more period, which tells what the impulse and the strains at its end change by; the steady
  // strains then change so that they close again.
  double slope_at(const Period& steady) const {
    const auto now = mapped(steady.start, true);
    ensure(now.has_value(), "a steady period begins and ends separated");
    const Index n = contact_.units();
    double change = now->sums.impulse[n + 1];
    if (n == 0) return change / two_pi;
    Vector opened;
    for (Index j = 0; j < n; ++j)
      opened.push_back(network_.unit_fluidity[j] * now->sums.impulse[n + 1] -
                       network_.unit_rates[j] * now->sums.strains(j, n + 1));
    const Vector strains = solver(steady).solve(opened);
    for (Index j = 0; j < n; ++j) change += steady.sums.impulse[j + 1] * strains[j];
    return change / two_pi;
  }

  // One more step, and rounding as the steady state amplifies it.
  NormalCycle finished(const Period& now) const {
    NormalCycle result{
        now.sums.impulse[0] / two_pi, 8 * epsilon * now.sums.size, contact_.swing(), {}};
    if (contact_.units() > 0) {
      const ConstView all = now.sums.impulse, changes = all.subspan(1);
      const Vector gain = solver(now).solve_transposed(changes);
      for (Index j = 0; j < gain.size(); ++j)
        result.error += std::abs(gain[j]) * (now.unit[j] + std::abs(now.residual[j]));
    }
    result.error /= two_pi;
    for (const NormalStay& stay : now.stays)
      if (stay.closed)
        result.touches.push_back(
            {stay.begin < 0 ? stay.begin + two_pi : stay.begin, stay.duration, stay.decays});
    return result;
  }

  // By how much a closed contact would pull.
  double beyond_closed() const { return std::abs(contact_.swing()) - closed_mean(); }
  double closed_mean() const { return network_.branch_stiffness[0] * indentation_.mean; }

  NormalCycle closed() const {
    Vector decays(network_.branch_rates.size());
    decays[0] = closed_mean();
    const double error = std::max(2 * epsilon * decays[0], beyond_closed());
    return {decays[0], error, contact_.swing(), {{0, two_pi, decays}}};
  }

  const ContactModes& network_;
  Indentation indentation_;
  Effort& effort_;
  NormalStays contact_;
};

constexpr const char* beyond_effort =
    "the steady normal force is not found within the bound on the work for it: the normal network "
    "has too many branches, or the contact closes and opens too often";

bool never_closes(const ContactModes& network, const Indentation& indentation) {
  ensure(!network.branch_rates.empty() && network.branch_rates[0] == 0,
         "a spring of the normal network carries the static load");
  ensure(indentation.amplitude > 0, "the indentation oscillates");
  return indentation.mean + indentation.amplitude <= 0;
}

// Squares of forces are taken, and sums of a few of them.
void require_squares(const ContactModes& network, const Indentation& indentation) {
  double stiffness = network.damper;
  for (const double branch : network.branch_stiffness) stiffness += branch;
  const double force = stiffness * (std::abs(indentation.mean) + indentation.amplitude);
  require_si_doubles(force * force > 0 && std::isfinite(16 * force * force));
}

}  // namespace

NormalCycle normal_cycle(const ContactModes& network, const Indentation& indentation,
                         SharedEffort* whole) {
  if (never_closes(network, indentation)) return {};
  require_squares(network, indentation);
  Effort effort(effort_of_normal_force, whole, beyond_effort);
  return NormalCycleSearch(network, indentation, effort).run();
}

PressedCycle pressed_cycle(const ContactModes& network, const Indentation& indentation,
                           SharedEffort* whole) {
  if (never_closes(network, indentation)) return {};
  require_squares(network, indentation);
  Effort effort(effort_of_normal_force, whole, beyond_effort);
  return NormalCycleSearch(network, indentation, effort).run_with_slope();
}

}  // namespace vcrit::simulation
