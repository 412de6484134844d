// What it costs to derive K(s) and v*, by the size of the network, beside GiNaC, FLINT, SymPy and
// Maxima in one run.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "harness/child.hpp"
#include "harness/commands.hpp"
#include "scaling/own.hpp"
#include "scaling/peers.hpp"

namespace vcrit::bench {

namespace {

using namespace scaling;

struct Family {
  std::string name;
  std::vector<ScalingCase> cases;
};

std::vector<Family> families() {
  return {{"ladder", {ladder(10), ladder(15), ladder(20), ladder(200)}},
          {"Prony", {prony(10), prony(20), prony(100)}},
          {"graph", {bridge(), grid(3), grid(6)}}};
}

/// Nothing where it is not back in time, has not memory enough, or fails.
std::optional<double> limited(const ScalingPeer& peer, const ScalingCase& each,
                              std::chrono::seconds limit) {
  const Report report = in_child({.time = limit, .of_programs = true},
                                 [&] { return ChildNumbers{peer.seconds(each).value()}; });
  if (report.ending != Ending::answered) return std::nullopt;
  return report.numbers[0];
}

std::string seconds_text(const std::optional<double>& seconds) {
  return seconds ? fmt::format("{:.1e}", *seconds) : "-";
}

void print_table(const std::string& title, const std::vector<ScalingPeer>& peers,
                 std::chrono::seconds limit) {
  fmt::print("\n{} (seconds; -: not within {} s, or not of its kind)\n\n{:<24}", title,
             limit.count(), "");
  const std::vector<Family> all = families();
  for (const Family& family : all)
    for (const ScalingCase& each : family.cases) fmt::print(" {:>10}", each.name);
  fmt::print("\n");
  for (const ScalingPeer& peer : peers) {
    fmt::print("{:<24}", peer.name);
    std::fflush(stdout);
    for (const Family& family : all)
      for (const ScalingCase& each : family.cases) {
        fmt::print(stderr, "{}: {}\n", peer.name, each.name);
        const auto seconds = limited(peer, each, limit);
        fmt::print(" {:>10}", seconds_text(seconds));
      }
    fmt::print("\n");
  }
}

void print_whole() {
  fmt::print("\nv* derived, K named (seconds)\n\n{:<12} {:>10} {:>10} {:>14}\n", "", "v*", "limits",
             "sensitivities");
  const auto row = [](const ScalingCase& each) {
    fmt::print("{:<12} {:>10.1e} {:>10.1e} {:>14.1e}\n", each.name, whole_derivation(each),
               all_limits(each), all_sensitivities(each));
  };
  for (const Family& family : families())
    for (const ScalingCase& each : family.cases) row(each);
  row(grid(12));
}

// Twice the elements, twice the time.
void print_growth() {
  fmt::print("\nGrowth: microseconds an element\n\n{:<12} {:>14} {:>14} {:>10}\n", "",
             "straight line", "named formula", "v*");
  const auto row = [](const ScalingCase& each, int elements) {
    const double unit = 1e6 / elements;
    fmt::print("{:<12} {:>14.3f} {:>14.2f} {:>10.2f}\n", each.name,
               unit * straight_line(each).value(), unit * named_formula(each).value(),
               unit * whole_derivation(each));
  };
  for (const int n : {50, 100, 200, 400, 800, 1600}) row(ladder(n), n);
  for (const int n : {50, 100, 200, 400, 800, 1600}) row(prony(n), n);
}

}  // namespace

void add_derivation(CLI::App& program, int&) {
  const auto limit = std::make_shared<int>(60);
  CLI::App& command = *program.add_subcommand(
      "derivation", "Cost of derivation by the size of the network, beside other algebra systems.");
  command.add_option("--limit", *limit, "seconds a derivation may take")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.callback([limit] {
    print_table("K(s) nested", nested_peers(), std::chrono::seconds(*limit));
    print_table("K(s) multiplied out", expanded_peers(), std::chrono::seconds(*limit));
    print_whole();
    print_growth();
  });
}

}  // namespace vcrit::bench
