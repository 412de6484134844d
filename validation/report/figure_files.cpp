#include "report/figure_files.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "run/compiler.hpp"

namespace vcrit::validation::report {

namespace {

constexpr std::chrono::minutes drawing_limit{1};  // gnuplot takes a second

std::filesystem::path program() {
  if (const auto found = find_program("gnuplot")) return *found;
  throw InputError({"--figures"}, "no gnuplot on the PATH", "gnuplot, which draws the figures");
}

/// The SVG, a zero, the PDF.
std::string plotted(const FigureFile& file) {
  const PrivateFolder folder;
  write_file(folder.path() / "figure.gp", file.script);
  const ProgramResult result = run_program({program(), "figure.gp"}, folder.path(), drawing_limit);
  if (!result.succeeded())
    throw std::runtime_error("gnuplot failed on " + file.name + ": " +
                             result.output.substr(0, 400));
  return read_file(folder.path() / (file.name + ".svg")) + '\0' +
         read_file(folder.path() / (file.name + ".pdf"));
}

}  // namespace

void require_gnuplot() { program(); }

std::vector<NewFile> draw_figures(const std::vector<FigureFile>& files,
                                  const std::filesystem::path& directory, const Watch& watch) {
  std::vector<std::string> names;
  for (const FigureFile& file : files) names.push_back(file.name);
  const std::vector<std::string> pictures = in_processes(
      names, std::thread::hardware_concurrency(),
      [&](std::size_t i, const Progress& step) {
        step("drawing");
        return plotted(files[i]);
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
