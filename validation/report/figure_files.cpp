#include "report/figure_files.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "figures/gnuplot.hpp"
#include "run/compiler.hpp"

namespace vcrit::validation::report {

namespace {

constexpr std::chrono::minutes drawing_limit{1};  // gnuplot takes a second

std::filesystem::path program(const std::string& asked_by) {
  if (const auto found = find_program("gnuplot")) return *found;
  throw InputError(argument(asked_by), "no gnuplot on the PATH",
                   "gnuplot, which draws the figures");
}

/// What gnuplot makes of a script: the contents of these files, in one text with a zero between.
std::string plotted(const std::string& script, const std::vector<std::string>& files) {
  const PrivateFolder folder;
  write_file(folder.path() / "figure.gp", script);
  const ProgramResult result =
      run_program({program("figures"), "figure.gp"}, folder.path(), drawing_limit);
  if (!result.succeeded())
    throw std::runtime_error("gnuplot failed on " + files.front() + ": " +
                             result.output.substr(0, 400));
  std::string all;
  for (const std::string& file : files) {
    if (!all.empty()) all += '\0';
    all += read_file(folder.path() / file);
  }
  return all;
}

}  // namespace

void require_gnuplot(const std::string& asked_by) { program(asked_by); }

std::string pdf_of(const std::vector<figures::Figure>& figures) {
  return plotted(figures::gnuplot_pages(figures, "figure.pdf"), {"figure.pdf"});
}

std::vector<NewFile> draw_figures(const std::vector<FigureFile>& files,
                                  const std::filesystem::path& directory, const Watch& watch) {
  std::vector<std::string> names;
  for (const FigureFile& file : files) names.push_back(file.name);
  const std::vector<std::string> pictures = in_processes(
      names, std::thread::hardware_concurrency(),
      [&](std::size_t i, const Progress& step) {
        step("drawing");
        return plotted(files[i].script, {files[i].name + ".svg", files[i].name + ".pdf"});
      },
      watch);
  std::vector<NewFile> result;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::filesystem::path target = directory / files[i].folder;
    const std::size_t end = pictures[i].find('\0');
    result.push_back({target / (files[i].name + ".svg"), pictures[i].substr(0, end)});
    result.push_back({target / (files[i].name + ".pdf"), pictures[i].substr(end + 1)});
    result.push_back({target / (files[i].name + ".gp"), files[i].script});
  }
  return result;
}

}  // namespace vcrit::validation::report
