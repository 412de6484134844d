// The page about one fit: how good it is, data and series drawn, branches, and the scene.
#pragma once

#include <string>

#include "fit/bounds.hpp"
#include "fit/fit.hpp"

namespace vcrit::validation::report {

/// What a fit says in words, for page and terminal: its length, its misfit, what to mind.
std::vector<std::string> fit_in_words(const fit::Data& data, const fit::Fit& fit);

/// One HTML file that needs nothing else. `scene`: the text of the scene that was written.
std::string fit_page(const fit::Data& data, const fit::Fit& fit,
                     const std::vector<fit::KnownStiffness>& known, const std::string& scene);

}  // namespace vcrit::validation::report
