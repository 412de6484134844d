#include "simulators/peers.hpp"

#include <fmt/core.h>

#include "simulation/methods/methods.hpp"
#include "simulation/steady/exact.hpp"
#include "simulators/cvode.hpp"

namespace vcrit::simulators {

namespace {

using simulation::Method;
using simulation::MethodOptions;

// Limits that no method reaches before its time is over.
constexpr int period_limit = 1'000'000'000;
constexpr long step_limit = 1'000'000'000'000;

Peer exact() {
  Peer peer{.name = exact_name};
  peer.settings.push_back({"", {}, [](const Case& row) {
                             const auto found = simulation::steady_state(row.system, row.velocity);
                             return PeerAnswer{found.friction_ratio, found.events.size()};
                           }});
  return peer;
}

std::string named(const std::string& method, bool newton) {
  return method + (newton ? ", Newton" : ", cycles");
}

Peer cvode(const std::string& name, Multistep formula, bool newton,
           const std::vector<double>& tolerances) {
  Peer peer{.name = named(name, newton), .cycles = !newton};
  for (const double tolerance : tolerances)
    peer.settings.push_back(
        {fmt::format("{:.0e}", tolerance), tolerance, [=](const Case& row) {
           const auto found = cvode_steady_state(row.system, row.velocity,
                                                 {formula, tolerance, newton, period_limit});
           return PeerAnswer{found.friction_ratio, static_cast<std::size_t>(found.events)};
         }});
  return peer;
}

Peer::Setting setting(const std::string& name, Method method, const MethodOptions& options,
                      std::optional<double> tolerance = {}) {
  return {name, tolerance, [=](const Case& row) {
            const auto found = simulation::steady_state(method, row.system, row.velocity, options);
            return PeerAnswer{found.friction_ratio, found.events.size()};
          }};
}

MethodOptions options(bool newton) {
  MethodOptions result;
  result.newton = newton;
  // From sliding, periods may repeat for long before the first stick.
  if (!newton) result.start = simulation::Start::rest;
  result.most_periods = period_limit;
  result.most_steps = step_limit;
  return result;
}

Peer gsl(Method method, bool newton, const std::vector<double>& tolerances) {
  Peer peer{.name = named(fmt::format("GSL {}", to_text(method)), newton), .cycles = !newton};
  for (const double tolerance : tolerances) {
    MethodOptions chosen = options(newton);
    chosen.tolerance = tolerance;
    peer.settings.push_back(setting(fmt::format("{:.0e}", tolerance), method, chosen, tolerance));
  }
  return peer;
}

Peer moreau(double theta, bool newton, const std::vector<int>& steps) {
  Peer peer{.name = named(fmt::format("Moreau, theta {}", theta), newton), .cycles = !newton};
  for (const int count : steps) {
    MethodOptions chosen = options(newton);
    chosen.steps_per_period = count;
    chosen.theta = theta;
    peer.settings.push_back(setting(fmt::format("{} steps", count), Method::moreau, chosen));
  }
  return peer;
}

Peer tanh(bool newton, const std::vector<double>& widths) {
  Peer peer{.name = named("tanh", newton), .cycles = !newton, .idealised = true};
  for (const double width : widths) {
    MethodOptions chosen = options(newton);
    chosen.tolerance = 1e-2 * width;
    chosen.regularisation = width;
    peer.settings.push_back(setting(fmt::format("width {:.0e}", width), Method::tanh, chosen));
  }
  return peer;
}

Peer reduced() {
  Peer peer{.name = "reduced model", .idealised = true};
  peer.applies = [](const Case& row) {
    return !row.system.drive && row.system.contact.branches.empty();
  };
  peer.settings.push_back(setting("", Method::reduced, {}));
  return peer;
}

}  // namespace

std::vector<Peer> all_peers(bool quick) {
  const std::vector<double> few{1e-6, 1e-11}, some{1e-6, 1e-8, 1e-10, 1e-12},
      many{1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13};
  const auto tolerances = [&](bool newton) { return quick ? few : newton ? many : some; };
  const std::vector<int> steps = quick ? std::vector{1000} : std::vector{200, 2000, 20'000};
  const std::vector<double> widths = quick ? std::vector{1e-3} : std::vector{1e-2, 1e-3, 1e-4};
  std::vector<Peer> peers{exact()};
  for (const Method method : {Method::rkf45, Method::rk8pd, Method::msbdf})
    for (const bool newton : {true, false})
      peers.push_back(gsl(method, newton, tolerances(newton)));
  for (const bool newton : {true, false}) {
    peers.push_back(cvode("CVODE BDF", Multistep::bdf, newton, tolerances(newton)));
    peers.push_back(cvode("CVODE Adams", Multistep::adams, newton, tolerances(newton)));
  }
  for (const double theta : {1.0, 0.5})
    for (const bool newton : {true, false}) peers.push_back(moreau(theta, newton, steps));
  for (const bool newton : {true, false}) peers.push_back(tanh(newton, widths));
  peers.push_back(reduced());
  return peers;
}

}  // namespace vcrit::simulators
