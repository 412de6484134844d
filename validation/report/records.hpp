// What the findings say of themselves, in report.json and to the templates of the pages. The keys
// of report.json are those of docs/report.md.
#pragma once

#include "figures/figure.hpp"
#include "record/fields.hpp"
#include "report/extremes_record.hpp"
#include "report/origin.hpp"
#include "report/paper_record.hpp"
#include "report/scene_contents.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::record {

void fields(Fields& f, const simulation::Event& event);
void fields(Fields& f, const validation::Comparison& comparison);
void fields(Fields& f, const validation::ShownFormula& formula);
void fields(Fields& f, const validation::ShownEquation& equation);
void fields(Fields& f, const validation::ShownVelocity& velocity);
void fields(Fields& f, const validation::ShownFact& fact);
void fields(Fields& f, const validation::LimitLine& limit);
void fields(Fields& f, const validation::figures::Figure& figure);
void fields(Fields& f, const validation::Machine& machine);
void fields(Fields& f, const validation::accuracy::Accuracy& accuracy);
void fields(Fields& f, const validation::Separation& separation);
void fields(Fields& f, const validation::Indented& indented);
void fields(Fields& f, const validation::report::SceneContents& contents);
void fields(Fields& f, const validation::paper::Paper& paper);
void fields(Fields& f, const validation::extremes::BadAnswer& answer);
void fields(Fields& f, const validation::extremes::Tally& tally);
void fields(Fields& f, const validation::extremes::Simulated& simulated);
void fields(Fields& f, const validation::extremes::FamilyResult& family);
void fields(Fields& f, const validation::extremes::Extremes& extremes);

}  // namespace vcrit::record

namespace vcrit::validation::report {

/// `program`, `version`, `passed`, `command`, `machine`, with which every report.json begins.
record::Json report_head(const Origin& origin, bool passed);

/// What the end of every page says: `version`, `command`, `machine`.
void add_origin(const Origin& origin, record::Json& page);

/// A part's comparisons, and how they came out.
void add_comparisons(record::Fields& f, const std::vector<Comparison>& comparisons);

/// The same in short, for the head of a page: `verdict`.
void add_verdict(const std::vector<Comparison>& comparisons, record::Json& page);

/// Longer lists are folded: they would push the numbers out of sight.
inline constexpr std::size_t shown_limits = 8;

/// As the file has it.
std::string text_of(const record::Json& report);

}  // namespace vcrit::validation::report
