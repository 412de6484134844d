#include "report/extremes_tables.hpp"

#include <fmt/core.h>

#include <cmath>

#include "report/html.hpp"
#include "report/number_table.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using extremes::BadAnswer;
using extremes::Extremes;
using extremes::FamilyResult;
using extremes::Region;
using extremes::Tally;

template <class Visit>
void for_each_region(const Extremes& extremes, const std::string& key, const Visit& visit) {
  for (const FamilyResult& family : extremes.families)
    for (const Region& region : family.regions)
      if (key.empty() || region.key == key) visit(family, region);
}

std::string counted(std::size_t count) {
  return count == 0 ? "0" : fmt::format("<strong>{}</strong>", count);
}

/// "6 not certified, 2 no number, 3 lose up to 1.5 digits", or that nothing is lost.
std::string losses(const Tally& tally) {
  std::string text;
  const auto add = [&](std::size_t count, const std::string& words) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counted(count), words);
  };
  add(tally.violated, "beyond the bound");
  add(tally.uncertified, "not certified");
  add(tally.no_number, "no number");
  add(tally.lost, fmt::format("lose up to {:.1f} digits", tally.worst_lost));
  return text.empty() ? "none" : text;
}

Cells loss_row(const FamilyResult& family, const Region& region) {
  Cells cells{family.key, std::to_string(region.tallies.front().values)};
  for (const Tally& tally : region.tallies) {
    if (tally.way != "library" && tally.way != "fast" && tally.way != "accurate") continue;
    cells.push_back(losses(tally));
    if (tally.way != "library") cells.push_back(fmt::format("{:.2f}", tally.over_bound));
  }
  return cells;
}

std::string speed_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : fmt::format("{}", value);
}

Cells worst_row(const std::string& family, const std::string& way, const BadAnswer& answer) {
  return {escape(family),           escape(way),
          escape(answer.words),     speed_text(answer.found),
          speed_text(answer.right), "<code>" + escape(answer.inputs) + "</code>"};
}

std::string folded(const std::string& summary, const std::string& content) {
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", summary, content);
}

const Cells& worst_headings() {
  static const Cells headings{"scene", "by", "what", "found, m/s", "right, m/s", "inputs"};
  return headings;
}

const char* const worst_caption =
    "Inputs in SI units as hexadecimal doubles, which are exact; at most three of each.";

}  // namespace

std::string loss_table(const Extremes& extremes, const std::string& key) {
  Cells headings{"scene", "values", "in doubles"};
  if (!extremes.compiler.empty())
    headings.insert(headings.end(), {"fast", "error / bound", "accurate", "error / bound"});
  std::vector<Cells> rows;
  for_each_region(extremes, key, [&](const FamilyResult& family, const Region& region) {
    rows.push_back(loss_row(family, region));
  });
  return number_table(
      headings, rows,
      "Losses among so many values, the cells in which v* is a normal double. Digits count as lost "
      "beyond what conditioning explains. Error / bound: the largest; above 1 the bound is wrong.");
}

std::string worst_table(const Extremes& extremes, const std::string& key) {
  std::vector<Cells> rows;
  for_each_region(extremes, key, [&](const FamilyResult& family, const Region& region) {
    for (const Tally& tally : region.tallies)
      if (!tally.way.ends_with("_batch"))
        for (const BadAnswer& answer : tally.worst)
          rows.push_back(worst_row(family.key, extremes::way_name(tally.way), answer));
  });
  if (rows.empty()) return {};
  return folded("Worst inputs", number_table(worst_headings(), rows, worst_caption));
}

std::string simulator_table(const Extremes& extremes) {
  std::vector<Cells> rows;
  for_each_region(extremes, {}, [&](const FamilyResult& family, const Region& region) {
    if (!region.simulated) return;
    const extremes::Simulated& s = *region.simulated;
    rows.push_back({family.key, region.key, std::to_string(s.asked), std::to_string(s.right),
                    counted(s.wrong), counted(s.silent), std::to_string(s.left_out)});
  });
  return number_table(
      {"scene", "extreme", "asked", "right", "wrong", "no answer", "not asked"}, rows,
      "Each question is two: at (1 − 10⁻⁶) v* the contact must stick, at (1 + 10⁻⁶) "
      "v* it must slide.");
}

std::string silence_table(const Extremes& extremes) {
  std::vector<Cells> rows;
  for_each_region(extremes, {}, [&](const FamilyResult& family, const Region& region) {
    if (!region.simulated) return;
    for (const BadAnswer& answer : region.simulated->worst)
      rows.push_back(worst_row(family.key, region.key, answer));
  });
  if (rows.empty()) return {};
  Cells headings = worst_headings();
  headings[1] = "extreme";
  headings[3] = "threshold of sliding, m/s";
  return folded("Wrong and missing answers", number_table(headings, rows, worst_caption));
}

}  // namespace vcrit::validation::report
