// The page about one fit: how good it is, data and series drawn, branches, and the scene.
#pragma once

#include <string>
#include <vector>

#include "fit/bounds.hpp"
#include "fit/fit.hpp"
#include "record/fields.hpp"

namespace vcrit::validation::report {

/// What was found and written, for the page and for --json.
struct FitContents {
  StiffnessTable data;
  fit::Fit fit;
  std::vector<fit::KnownStiffness> known;
  std::vector<std::string> words;  ///< fit::in_words(), with arguments as its readers know them
  std::string scene, page;         ///< the files
  std::string scene_text;          ///< what the scene's file holds
};

/// One HTML file that needs nothing else.
std::string fit_page(const FitContents& contents);

}  // namespace vcrit::validation::report

namespace vcrit::record {

/// The keys are those of docs/design.md.
void fields(Fields& f, const validation::report::FitContents& contents);

}  // namespace vcrit::record
