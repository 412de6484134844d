#include "pictures/pictures.hpp"

#include "figures/figure_json.hpp"
#include "figures/svg.hpp"
#include "record/json_text.hpp"
#include "report/plots.hpp"

namespace vcrit::validation {

namespace {

std::vector<figures::Figure> pictured(const Problem& problem, const ScenePicture& picture) {
  if (picture.of == "friction") return report::friction_plot(problem, picture.to);
  if (picture.of == "frequency") return report::frequency_plot(problem);
  if (picture.of == "cycle") return report::cycle_plot(problem, picture.velocity);
  throw InputError(argument("of"), '"' + picture.of + '"', "one of friction, frequency, cycle");
}

}  // namespace

std::string picture_svg(const Problem& problem, const ScenePicture& picture) {
  return figures::svg(pictured(problem, picture));
}

std::string picture_json(const Problem& problem, const ScenePicture& picture) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const figures::Figure& figure : pictured(problem, picture))
    all.push_back(figures::figure_json(figure));
  return record::json_text(all);
}

}  // namespace vcrit::validation
