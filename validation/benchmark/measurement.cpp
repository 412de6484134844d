#include "benchmark/measurement.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/errors.hpp"

namespace vcrit::benchmark {

namespace {

// Errors of single steps add up over hundreds of them and some periods. An error of more than so
// many times what was asked for has another cause.
constexpr double accumulation = 1e3;
// Methods of fixed step and idealised ones ask for nothing; this is wrong by any measure.
constexpr double wrong_by_any_measure = 0.05;

Verdict judged(const Peer& peer, const Peer::Setting& setting, const Case& row,
               const Answer& answer, double error) {
  const bool sliding = answer.events == 0 && row.events > 0 && !peer.idealised;
  if (sliding && row.grazing) return Verdict::missed_grazing;
  const double allowed =
      setting.tolerance ? accumulation * *setting.tolerance : wrong_by_any_measure;
  if (!sliding && error <= std::min(allowed, wrong_by_any_measure)) return Verdict::right;
  return peer.cycles ? Verdict::drift : Verdict::wrong;
}

Verdict refused(const std::string& words) {
  return words.find("chatter") != words.npos ? Verdict::chattering : Verdict::not_finished;
}

Point measured(const Case& row, const Peer& peer, const Peer::Setting& setting,
               const Budget& budget) {
  const Run run =
      run_limited([&] { return setting.solve(row); }, std::chrono::duration<double>(budget.solve),
                  std::chrono::duration<double>(budget.repeat));
  Point point{&row, &peer, &setting};
  point.words = run.words;
  if (run.ending != Ending::answered) {
    point.verdict = refused(run.words);
    return point;
  }
  point.answered = true;
  point.seconds = run.seconds;
  point.friction_ratio = run.answer.friction_ratio;
  point.error = std::abs(run.answer.friction_ratio - row.friction_ratio);
  if (std::isnan(point.error)) point.error = HUGE_VAL;
  point.verdict = judged(peer, setting, row, run.answer, point.error);
  return point;
}

void measure_peer(const Case& row, const Peer& peer, const Budget& budget,
                  std::vector<Point>& points) {
  bool out_of_time = false;
  for (const Peer::Setting& setting : peer.settings) {
    if (out_of_time) {
      points.push_back({&row, &peer, &setting, Verdict::not_finished, false, 0, 0, 0,
                        "not tried: a less accurate setting was out of time"});
      continue;
    }
    points.push_back(measured(row, peer, setting, budget));
    out_of_time = points.back().words == "out of time";
  }
}

}  // namespace

const char* to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return "right";
    case Verdict::missed_grazing:
      return "missed grazing";
    case Verdict::drift:
      return "drift";
    case Verdict::wrong:
      return "wrong value";
    case Verdict::chattering:
      return "chattering";
    case Verdict::not_finished:
      return "not finished";
  }
  throw Bug("a verdict is one of six");
}

std::vector<Point> measure(const std::vector<Case>& cases, const std::vector<Peer>& peers,
                           const Budget& budget, const Progress& progress) {
  std::vector<Point> points;
  for (const Case& row : cases) {
    progress(row.name);
    for (const Peer& peer : peers)
      if (peer.applies(row)) measure_peer(row, peer, budget, points);
  }
  return points;
}

}  // namespace vcrit::benchmark
