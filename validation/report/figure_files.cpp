#include "report/figure_files.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "compiler.hpp"

namespace vcrit::validation::report {

namespace {

constexpr std::chrono::minutes limit{1};

std::filesystem::path program() {
  if (const auto found = find_program("gnuplot")) return *found;
  throw InputError({"--figures"}, "no gnuplot on the PATH", "gnuplot, which draws the figures");
}

void write(const FigureFile& file, const std::filesystem::path& directory) {
  const PrivateFolder folder;
  write_file(folder.path() / "figure.gp", file.script);
  const ProgramResult result = run_program({program(), "figure.gp"}, folder.path(), limit);
  if (!result.succeeded())
    throw std::runtime_error("gnuplot failed on " + file.name + ": " +
                             result.output.substr(0, 400));
  const std::filesystem::path target = directory / file.folder;
  for (const char* ending : {".svg", ".pdf"})
    write_file(target / (file.name + ending), read_file(folder.path() / (file.name + ending)));
  write_file(target / (file.name + ".gp"), file.script);
}

}  // namespace

void require_gnuplot() { program(); }

std::vector<std::filesystem::path> write_figures(const std::vector<FigureFile>& files,
                                                 const std::filesystem::path& directory,
                                                 const Watch& watch) {
  std::vector<std::string> names;
  for (const FigureFile& file : files) names.push_back(file.name);
  in_processes(
      names, std::thread::hardware_concurrency(),
      [&](std::size_t i, const Step& step) {
        step("drawing");
        write(files[i], directory);
        return std::string();
      },
      watch);
  std::vector<std::filesystem::path> written;
  for (const FigureFile& file : files)
    for (const char* ending : {".svg", ".pdf", ".gp"})
      written.push_back(directory / file.folder / (file.name + ending));
  return written;
}

}  // namespace vcrit::validation::report
