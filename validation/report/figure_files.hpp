// `vcrit validate --figures DIR`: the page's figures as files for papers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "figures/figure.hpp"
#include "run/workers.hpp"

namespace vcrit::validation::report {

/// A figure on its way to a file.
struct FigureFile {
  std::string folder;  ///< below DIR; empty: DIR itself
  std::string name;    ///< of the files, without ending
  std::string script;  ///< for gnuplot
};

/// Throws InputError, which names the argument that asks for it, unless gnuplot is on the PATH.
void require_gnuplot(const std::string& asked_by);

/// A page each, in one PDF. Throws std::runtime_error where gnuplot fails.
std::string pdf_of(const std::vector<figures::Figure>& figures);

/// FOLDER/NAME.svg, .pdf and .gp (the script, for changes) of each below `directory`, drawn several
/// at a time, to be written. Throws std::runtime_error where gnuplot fails.
std::vector<NewFile> draw_figures(const std::vector<FigureFile>& files,
                                  const std::filesystem::path& directory, const Watch& watch);

}  // namespace vcrit::validation::report
