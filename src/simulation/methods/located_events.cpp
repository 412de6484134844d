#include "simulation/methods/located_events.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.hpp"

namespace vcrit::simulation::methods {

namespace {

// Halving alone comes to the last of the 53 bits of a step.
constexpr int most_probes = 60;

double inside(double candidate, double low, double high) {
  return candidate > low && candidate < high ? candidate : (low + high) / 2;
}

}  // namespace

EventFinder::Value EventFinder::here() const {
  const double t = integrator_.time();
  const double* y = integrator_.state().data();
  return {ode_.event(t, y), ode_.event_rate(t, y, integrator_.rates())};
}

EventFinder::Value EventFinder::at(double tau) {
  integrator_.shorten(integrator_.step_begin() + tau);
  return here();
}

bool EventFinder::find(const Rise& rise) {
  const Value end = here();
  const double length = integrator_.time() - integrator_.step_begin();
  if (end.value <= 0) {
    close_in(0, length, end, rise);
    return true;
  }
  if (rise.order > 0) return false;
  const double t0 = integrator_.step_begin();
  const Value begin{
      ode_.event(t0, integrator_.state_at_begin()),
      ode_.event_rate(t0, integrator_.state_at_begin(), integrator_.rates_at_begin())};
  return begin.slope < 0 && end.slope > 0 && dips(begin, end);
}

// Newton on g/tau^order; the bracket's lower end is positive, its upper end not.
void EventFinder::close_in(double low, double high, const Value& end, const Rise& rise) {
  Value g = end;
  double tau = high;
  for (int i = 0; i < most_probes && std::abs(g.value) > zero_; ++i) {
    const double slope = g.slope - rise.order * g.value / tau;
    const double next = inside(tau - g.value / slope, low, high);
    if (std::abs(next - tau) <= epsilon * integrator_.time() && i > 0) return;
    tau = next;
    g = at(tau);
    if (g.value > 0)
      low = tau, integrator_.keep();
    else
      high = tau;
  }
}

// The zero of the slope, by secants in a bracket, until the function is below 0 there or cannot be
// in what remains of the bracket.
bool EventFinder::dips(const Value& begin, const Value& end) {
  const double length = integrator_.time() - integrator_.step_begin();
  // Minimum of the cubic through both ends; far above 0 nothing else is looked at.
  const double chord = (end.value - begin.value) / length;
  const double a = 3 * (begin.slope + end.slope - 2 * chord),
               b = 2 * (3 * chord - 2 * begin.slope - end.slope);
  const double root = std::sqrt(std::max(0.0, b * b - 4 * a * begin.slope));
  double s = -2 * begin.slope / (b + std::copysign(root, b > 0 ? 1.0 : -1.0));
  if (!(s > 0 && s < 1)) s = begin.slope / (begin.slope - end.slope);
  const double x = s * length;
  const double lowest = begin.value + x * (begin.slope + s * (b / 2 + s * a / 3));
  if (lowest > 0.1 * std::min(begin.value, end.value)) return false;

  double low = 0, high = length, tau = x;
  Value left = begin, right = end;
  for (int i = 0; i < most_probes; ++i) {
    const Value g = at(tau);
    if (g.value <= 0) {
      close_in(low, tau, g, {});
      return true;
    }
    if (g.value - std::abs(g.slope) * (high - low) > 0 || high - low < epsilon * length) break;
    if (g.slope < 0)
      low = tau, left = g, integrator_.keep();
    else
      high = tau, right = g;
    tau = inside(low + (high - low) * left.slope / (left.slope - right.slope), low, high);
  }
  integrator_.lengthen();
  return false;
}

}  // namespace vcrit::simulation::methods
