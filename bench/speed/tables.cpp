#include "speed/tables.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "record/json_text.hpp"
#include "run/machine.hpp"

namespace vcrit::speed {

namespace {

using Row = bench::TextRow;

const char* name_of(CallMode mode) { return mode == CallMode::sweep ? "sweep" : "all varying"; }

const Result* find(const SpeedComparison& all, CallMode mode, const std::string& subject,
                   const std::string& method) {
  for (const Result& each : all.results)
    if (each.mode == mode && each.subject == subject && each.method == method) return &each;
  return nullptr;
}

std::string time_text(double nanoseconds) {
  return fmt::format(fmt::runtime(nanoseconds < 10 ? "{:.2f}" : "{:.0f}"), nanoseconds);
}

std::string error_text(double ulp) {
  return fmt::format(fmt::runtime(ulp < 10 ? "{:.2g}" : ulp < 1e4 ? "{:.0f}" : "{:.0e}"), ulp);
}

std::string cell(const Result* result) {
  if (result == nullptr) return "-";
  if (result->wrong()) return "wrong";
  if (result->family == MethodFamily::machine) return time_text(result->nanoseconds);
  return fmt::format("{}, {}", time_text(result->nanoseconds), error_text(result->error));
}

const Result* best_peer(const SpeedComparison& all, CallMode mode, const std::string& subject) {
  const Result* best = nullptr;
  for (const Result& each : all.results)
    if (each.mode == mode && each.subject == subject && each.family == MethodFamily::peer &&
        !each.wrong() && (best == nullptr || each.nanoseconds < best->nanoseconds))
      best = &each;
  return best;
}

/// Best peer's time over ours.
Row ratios(const SpeedComparison& all, CallMode mode, const std::string& grade) {
  Row row{"best other / vcrit " + grade};
  for (const std::string& subject : all.subjects) {
    const Result* best = best_peer(all, mode, subject);
    const Result* own = find(all, mode, subject, "vcrit " + grade + ", batch");
    const bool known = best != nullptr && own != nullptr;
    row.push_back(known ? fmt::format("{:.2g}x", best->nanoseconds / own->nanoseconds) : "-");
  }
  return row;
}

Row best_row(const SpeedComparison& all, CallMode mode) {
  Row row{"best other"};
  for (const std::string& subject : all.subjects) {
    const Result* best = best_peer(all, mode, subject);
    row.push_back(best == nullptr ? "-" : best->method);
  }
  return row;
}

std::vector<Row> rows(const SpeedComparison& all, CallMode mode) {
  std::vector<Row> result{{name_of(mode)}};
  for (const std::string& subject : all.subjects) result.front().push_back(subject);
  for (const std::string& method : all_methods()) {
    Row row{method};
    for (const std::string& subject : all.subjects)
      row.push_back(cell(find(all, mode, subject, method)));
    result.push_back(row);
  }
  for (const char* grade : {"accurate", "fast"}) result.push_back(ratios(all, mode, grade));
  return result;
}

std::vector<std::pair<std::string, std::string>> all_flags() {
  return {{"std::complex, SymPy", to_text(Flags::scalar())},
          {"fast-math", to_text(Flags::unsafe())},
          {"by hand", to_text(Flags::by_hand())},
          {"vcrit", to_text(Flags::generated())},
          {"GiNaC", "gcc without flags; -O3: -O3 -march=native"}};
}

}  // namespace

std::string heading(const SpeedComparison& all) {
  const validation::Machine machine = validation::this_machine();
  std::string out = fmt::format("{}, {} cores, one used; {}\n{}\n", machine.processor,
                                machine.cores, machine.system, all.compiler);
  for (const auto& [name, flags] : all_flags()) out += fmt::format("  {}: {}\n", name, flags);
  out += fmt::format(
      "nanoseconds a value, worst error in ulp, over arrays of {}; the best of repeated runs\n",
      all.plan.values);
  return out;
}

std::string table(const SpeedComparison& all, CallMode mode, TableStyle style) {
  const std::vector<Row> body = rows(all, mode);
  std::string out = "\n" + bench::text_table(body, style) + "\n";
  const Row best = best_row(all, mode);
  for (std::size_t j = 1; j < best.size(); ++j)
    out += fmt::format("{}best other on {}: {}\n", style == TableStyle::text ? "" : "* ",
                       all.subjects[j - 1], best[j]);
  return out;
}

std::string notes(const SpeedComparison& all) {
  std::string out;
  for (const MissingMethod& each : all.missing)
    out += fmt::format("{}, {}: {}\n", each.subject, each.method, each.reason);
  return out.empty() ? out : "\nnot measured\n" + out;
}

std::string as_json(const SpeedComparison& all) {
  using Json = nlohmann::ordered_json;
  const validation::Machine machine = validation::this_machine();
  Json json{{"processor", machine.processor}, {"system", machine.system},
            {"compiler", all.compiler},       {"flags", Json::object()},
            {"values", all.plan.values},      {"results", Json::array()},
            {"missing", Json::array()}};
  for (const auto& [name, flags] : all_flags()) json["flags"][name] = flags;
  for (const auto& [name, version] : machine.versions) json["versions"][name] = version;
  for (const Result& each : all.results)
    json["results"].push_back({{"problem", each.subject},
                               {"mode", name_of(each.mode)},
                               {"method", each.method},
                               {"nanoseconds", each.nanoseconds},
                               {"ulp", each.error},
                               {"wrong", each.wrong()}});
  for (const MissingMethod& each : all.missing)
    json["missing"].push_back(
        {{"problem", each.subject}, {"method", each.method}, {"reason", each.reason}});
  return record::json_text(json, 1);
}

}  // namespace vcrit::speed
