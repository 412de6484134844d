// The pages of one scene: the answer, and the evidence for it.
#pragma once

#include <string>

#include "report/origin.hpp"
#include "report/scene_contents.hpp"

namespace vcrit::validation::report {

/// The files of a scene's pages, in one folder.
struct SceneFiles {
  std::string page = "index.html", evidence = "evidence.html";
  bool in_suite = false;  ///< there is an index of other scenes, too
};

std::string scene_page(const SceneContents& contents, const Origin& origin,
                       const SceneFiles& files = {});

/// All checks, differences of methods, error against time, and what made the page.
std::string evidence_page(const SceneContents& contents, const Origin& origin,
                          const SceneFiles& files = {});

}  // namespace vcrit::validation::report
