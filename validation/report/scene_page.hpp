// The page of one scene: everything in one file, readable without a network, on a phone and on
// paper.
#pragma once

#include <string>

#include "report/origin.hpp"
#include "report/scene_contents.hpp"

namespace vcrit::validation::report {

/// `in_suite`: with a way back to the index of all scenes, index.html beside it.
std::string scene_page(const SceneContents& contents, const Origin& origin, bool in_suite = false);

}  // namespace vcrit::validation::report
