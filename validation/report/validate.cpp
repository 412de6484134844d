#include "validate.hpp"

#include <nlohmann/json.hpp>
#include <thread>

#include "accuracy/accuracy.hpp"
#include "base/output_places.hpp"
#include "compare/agreement.hpp"
#include "compare/velocity_comparisons.hpp"
#include "compare/without_formula.hpp"
#include "figures/gnuplot.hpp"
#include "paper/paper.hpp"
#include "problem/input_files.hpp"
#include "record/json_text.hpp"
#include "report/figure_files.hpp"
#include "report/index_page.hpp"
#include "report/paper_page.hpp"
#include "report/report_json.hpp"
#include "report/scene_figures.hpp"
#include "report/scene_page.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::validation::report {

namespace {

using nlohmann::ordered_json;

/// Missing values are the reader's fault, and are told before the first long computation.
std::vector<Problem> read_all(const std::vector<std::string>& files) {
  std::vector<Problem> problems;
  for (const std::string& file : files) {
    problems.push_back(read_problem(file));
    problems.back().values();
  }
  return problems;
}

void refuse_lost_inputs(const std::filesystem::path& place, const std::vector<Problem>& problems) {
  for (const Problem& problem : problems) refuse_input_as_output(place, input_files(problem));
}

/// What a worker hands over of its scene.
std::string handed_over(const SceneContents& contents, const Machine& machine,
                        const Request& request, const SceneFiles& files) {
  const SceneReport& report = contents.report;
  const Origin origin{machine, command({report.problem->source->file})};
  ordered_json all{{"line", record::json_of(scene_line(report))},
                   {"page", scene_page(contents, origin, files)},
                   {"evidence", evidence_page(contents, origin, files)},
                   {"data", scene_json(contents)},
                   {"figures", ordered_json::object()}};
  if (!request.figures.empty() && report.failure.empty())
    for (const figures::Figure& figure : scene_figures(contents))
      all["figures"][figure.name] = gnuplot(figure);
  return record::json_text(all);
}

// A scene whose comparisons came to no end: its line is red, and the others are finished.
SceneReport failed_report(const Problem& problem, const std::string& why) {
  SceneReport report(problem);
  report.failure = why;
  Comparison all;
  all.key = "scene";
  all.name = "the scene as a whole";
  all.reference = "all comparisons";
  report.comparisons = {broken(all, why)};
  return report;
}

void summarise(const ordered_json& scene, Validation& validation) {
  const SceneLine line = scene_line(scene.at("line"));
  validation.warnings.insert(validation.warnings.end(), line.warnings.begin(), line.warnings.end());
  for (const ordered_json& comparison : scene.at("data").at("comparisons"))
    validation.add(
        {line.file, comparison.at("key"), comparison.at("name"), comparison.at("outcome")});
}

std::vector<SceneFiles> page_files(const std::vector<std::string>& names) {
  std::vector<SceneFiles> all;
  const bool in_suite = names.size() > 1;
  for (const std::string& name : names)
    all.push_back({in_suite ? name + ".html" : "index.html", name + ".evidence.html", in_suite});
  return all;
}

/// The index comes last: whoever sees it finds the pages that it names.
void add_pages(const std::vector<ordered_json>& scenes, const std::vector<SceneFiles>& pages,
               const Origin& origin, const std::filesystem::path& index,
               std::vector<NewFile>& files) {
  std::vector<IndexEntry> entries;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    files.push_back({index.parent_path() / pages[i].evidence, scenes[i].at("evidence")});
    files.push_back({index.parent_path() / pages[i].page, scenes[i].at("page")});
    entries.push_back({scene_line(scenes[i].at("line")), pages[i].page});
  }
  if (scenes.size() > 1) files.push_back({index, index_page(entries, origin)});
}

std::vector<FigureFile> figure_files(const std::vector<ordered_json>& scenes,
                                     const std::vector<std::string>& names) {
  std::vector<FigureFile> files;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (const auto& [name, script] : scenes[i].at("figures").items())
      files.push_back({scenes.size() > 1 ? names[i] : "", name, script});
  return files;
}

std::vector<ordered_json> work_on(const std::vector<Problem>& problems, const Request& request,
                                  const std::vector<SceneFiles>& pages, const Machine& machine,
                                  const Watch& watch) {
  const auto work = [&](std::size_t i, const Progress& step) {
    return handed_over(compare(problems[i], step), machine, request, pages[i]);
  };
  const auto in_place = [&](std::size_t i, const std::string& why) {
    return handed_over({failed_report(problems[i], why), {}}, machine, request, pages[i]);
  };
  std::vector<ordered_json> all;
  for (const std::string& answer :
       in_processes(request.files, std::thread::hardware_concurrency(), work, watch, in_place))
    all.push_back(record::read_json(answer));
  return all;
}

}  // namespace

void check_places(const Request& request) {
  check_folder(request.directory / "report.json");
  if (request.figures.empty()) return;
  require_gnuplot("figures");
  check_folder(request.figures / "figure.svg");
}

SceneContents compare(const Problem& problem, const Progress& step) {
  if (const rules::Answer derived = rules::answer(rules::Question::derivation, problem); !derived)
    return {report_without_formula(problem, derived.reason), {}};
  Driver driver(symbolic::derive(problem));
  SceneReport report = agree(driver, driver.derivation(), step);
  // Accuracy is shown at numbers drawn one by one, and at frequencies beyond any table.
  if (!problem->measured.empty()) return {std::move(report), {}};
  return {std::move(report), accuracy::measure(driver, step)};
}

Validation validate(const Request& request, const Watch& watch) {
  const std::vector<Problem> problems = read_all(request.files);
  check_places(request);
  const Origin origin{this_machine(), command(request.files)};
  const std::vector<std::string> names = page_names(request.files);
  const std::vector<SceneFiles> pages = page_files(names);
  Validation validation;
  validation.page = request.directory / "index.html";
  const std::filesystem::path data_file = request.directory / "report.json";
  refuse_lost_inputs(validation.page, problems);
  refuse_lost_inputs(data_file, problems);
  for (const SceneFiles& scene : pages)
    for (const std::string& page : {scene.page, scene.evidence})
      refuse_lost_inputs(request.directory / page, problems);
  const std::vector<ordered_json> all = work_on(problems, request, pages, origin.machine, watch);
  std::vector<ordered_json> data;
  for (const ordered_json& scene : all) {
    data.push_back(scene.at("data"));
    summarise(scene, validation);
  }
  std::vector<NewFile> files = draw_figures(figure_files(all, names), request.figures, watch);
  files.push_back({data_file, report_json(origin, data)});
  add_pages(all, pages, origin, validation.page, files);
  // Which figures there are is known only now.
  for (const NewFile& file : files) refuse_lost_inputs(file.place, problems);
  validation.write(files);
  return validation;
}

Validation validate_paper(const Request& request, const Watch& watch) {
  check_places(request);
  const auto progress = [&](const std::string& step) { watch({0, 1, {{"the paper", step}}}); };
  return report_paper({{this_machine(), paper_command}, paper::go_through(progress)}, request,
                      watch);
}

Validation report_paper(const PaperContents& contents, const Request& request, const Watch& watch) {
  Validation validation;
  validation.add("the paper", all_comparisons(contents.paper));
  validation.page = request.directory / "index.html";
  std::vector<FigureFile> figures;
  if (!request.figures.empty())
    for (const figures::Figure& figure : all_figures(contents.paper))
      figures.push_back({"", figure.name, gnuplot(figure)});
  std::vector<NewFile> files = draw_figures(figures, request.figures, watch);
  files.push_back({request.directory / "report.json", paper_json(contents)});
  files.push_back({validation.page, paper_page(contents)});
  validation.write(files);
  return validation;
}

}  // namespace vcrit::validation::report
