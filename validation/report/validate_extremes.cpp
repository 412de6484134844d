#include "report/validate_extremes.hpp"

#include "extremes/extremes.hpp"
#include "extremes/pictures.hpp"
#include "figures/gnuplot.hpp"
#include "report/extremes_page.hpp"
#include "report/figure_files.hpp"

namespace vcrit::validation::report {

Validation validate_extremes(const Request& request, const Watch& watch) {
  check_places(request);
  return report_extremes({{this_machine(), extremes_command}, extremes::go_to_extremes(watch)},
                         request, watch);
}

Validation report_extremes(const ExtremesContents& contents, const Request& request,
                           const Watch& watch) {
  Validation validation;
  validation.add("extremes", all_comparisons(contents.extremes));
  validation.page = request.directory / "index.html";
  std::vector<FigureFile> figures;
  if (!request.figures.empty())
    for (const figures::Figure& figure : pictures(contents.extremes))
      figures.push_back({"", figure.name, gnuplot(figure)});
  std::vector<NewFile> files = draw_figures(figures, request.figures, watch);
  files.push_back({request.directory / "report.json", extremes_json(contents)});
  files.push_back({validation.page, extremes_page(contents)});
  validation.write(files);
  return validation;
}

}  // namespace vcrit::validation::report
