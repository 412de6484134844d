#include "simulators/measurement.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/errors.hpp"
#include "harness/child.hpp"
#include "harness/timing.hpp"

namespace vcrit::simulators {

namespace {

// Errors of single steps add up over hundreds of them and some periods. An error of more than so
// many times what was asked for has another cause.
constexpr double accumulation = 1e3;
// Methods of fixed step and idealised ones ask for nothing; this is wrong by any measure.
constexpr double wrong_by_any_measure = 0.05;

RunVerdict judged(const Peer& peer, const Peer::Setting& setting, const Case& row,
                  const PeerAnswer& answer, double error) {
  const bool sliding = answer.events == 0 && row.events > 0 && !peer.idealised;
  if (sliding && row.grazing) return RunVerdict::missed_grazing;
  const double allowed =
      setting.tolerance ? accumulation * *setting.tolerance : wrong_by_any_measure;
  if (!sliding && error <= std::min(allowed, wrong_by_any_measure)) return RunVerdict::right;
  return peer.cycles ? RunVerdict::drift : RunVerdict::wrong;
}

RunVerdict refused(const std::string& words) {
  return words.find("chatter") != words.npos ? RunVerdict::chattering : RunVerdict::not_finished;
}

// In a process of its own. The time limit is that of the first solve.
bench::ChildNumbers solved(const Case& row, const Peer::Setting& setting, double repeat) {
  const double begin = bench::processor_time();
  const PeerAnswer answer = setting.solve(row);
  const double first = bench::processor_time() - begin;
  bench::lift_time_limit();
  const double seconds = bench::settled_time([&] { setting.solve(row); }, first, repeat);
  return {answer.friction_ratio, static_cast<double>(answer.events), seconds};
}

PeerSolve measured(const Case& row, const Peer& peer, const Peer::Setting& setting,
                   const Budget& budget) {
  const bench::Report report =
      bench::in_child({.time = std::chrono::duration<double>(budget.solve)},
                      [&] { return solved(row, setting, budget.repeat); });
  PeerSolve point{&row, &peer, &setting};
  point.words = report.words;
  if (report.ending != bench::Ending::answered) {
    point.verdict = refused(report.words);
    return point;
  }
  const auto [friction_ratio, events, seconds] = report.numbers;
  point.answered = true;
  point.seconds = seconds;
  point.friction_ratio = friction_ratio;
  point.error = std::abs(friction_ratio - row.friction_ratio);
  if (std::isnan(point.error)) point.error = HUGE_VAL;
  const PeerAnswer answer{friction_ratio, static_cast<std::size_t>(events)};
  point.verdict = judged(peer, setting, row, answer, point.error);
  return point;
}

void measure_peer(const Case& row, const Peer& peer, const Budget& budget,
                  std::vector<PeerSolve>& points) {
  bool out_of_time = false;
  for (const Peer::Setting& setting : peer.settings) {
    if (out_of_time) {
      points.push_back({&row, &peer, &setting, RunVerdict::not_finished, false, 0, 0, 0,
                        "not tried: a less accurate setting was out of time"});
      continue;
    }
    points.push_back(measured(row, peer, setting, budget));
    out_of_time = points.back().words == "out of time";
  }
}

}  // namespace

const char* to_text(RunVerdict verdict) {
  switch (verdict) {
    case RunVerdict::right:
      return "right";
    case RunVerdict::missed_grazing:
      return "missed grazing";
    case RunVerdict::drift:
      return "drift";
    case RunVerdict::wrong:
      return "wrong value";
    case RunVerdict::chattering:
      return "chattering";
    case RunVerdict::not_finished:
      return "not finished";
  }
  throw Bug("a verdict is one of six");
}

std::vector<PeerSolve> measure(const std::vector<Case>& cases, const std::vector<Peer>& peers,
                               const Budget& budget, const PeerProgress& progress) {
  std::vector<PeerSolve> points;
  for (const Case& row : cases) {
    progress(row.name);
    for (const Peer& peer : peers)
      if (peer.applies(row)) measure_peer(row, peer, budget, points);
  }
  return points;
}

}  // namespace vcrit::simulators
